#pragma once
/// What the stresses of a turning, bent string do to its pipe in the long run: damage of its outer fibres.
///
/// **Equations.**
///
///     sigma(psi) = T / A + B (r / I) (m2 sin psi - m3 cos psi)       stress of the outer fibre at the angle psi
///     B = K L / tanh(K L),  T > 0      K L / tan(K L),  T < 0      K = sqrt(|T_e| / (E I))
///     S_eq = S / (1 - sigma_m / UTS)   where sigma_m > 0, else S     [Goodman]
///     D = sum n_i / N(S_eq,i)                                        [Miner]
///
/// over the cycles of range S, mean sigma_m and number n (1 or 1/2) that rainflow counting finds in sigma
/// (peaks/rainflow.hpp). The pipe is thought to fail when D = 1.
///
/// **B** is the bending that is missing between tool joints: a pipe that touches a curved hole at its tool joints only,
/// 2 L apart, and is pulled by T_e, bends more at the joints and less between them than the hole does. Segments of the
/// model that are as long as a joint of pipe do not see it.
///
/// **Symbols.** T [N] true tension, with the pressure of the mud on the ends of the section; T_e [N] effective tension;
/// A [m2], I [m4], r [m] section, second moment, outer radius of the pipe; m2, m3 [N m] bending moments in the material
/// frame of the pipe, which turns with it; psi [rad] from the first to the second axis across; E [Pa]; L [m]; UTS [Pa]
/// tensile strength of the steel.
///
/// **Source.** B: derived here, the beam-column T y'' = E I y'''' in a hole of constant curvature with y' = 0 at the
/// tool joints; known from [Lubinski1961] and [PaslayCernocky1991]. Miner's sum and Goodman's line: textbooks.
///
/// **Validity.** The body of the pipe touches the wall between its tool joints from K L of about 3 on: B is then too
/// large. In compression up to K L = pi / 2. One S-N curve for all of the pipe: threads, slip marks and corrosion need
/// curves of their own.

#include <vector>

#include "peaks/rainflow.hpp"
#include "studies/well/sn_curve.hpp"

namespace bitrock::studies {

/// B [1]: largest curvature of a pipe over that of its hole. Tension [N] effective, bending stiffness E I [N m2], half
/// distance of the tool joints L [m].
double bending_magnification(double tension, double bending_stiffness, double half_distance);

/// S_eq [Pa] of a range and a mean; infinite where the mean alone breaks the steel.
double goodman_range(double range, double mean, double tensile_strength);

/// Section of the pipe, and what it bears.
struct FatigueSection {
  double area = 0.0;              ///< A [m2]
  double section_modulus = 0.0;   ///< I / r [m3]
  double tensile_strength = 0.0;  ///< UTS [Pa]
  double magnification = 1.0;     ///< B [1]
};

/// At one instant.
struct SectionLoad {
  double tension = 0.0;       ///< T [N]
  double m2 = 0.0, m3 = 0.0;  ///< [N m]
};

/// sigma [Pa] of the outer fibre at psi [rad].
double fibre_stress(const FatigueSection& section, const SectionLoad& load, double psi);

/// Damage of evenly spread outer fibres of one section, summed while the loads come in.
class FibreDamage {
 public:
  /// `curve` must outlive it. `fibres`: 1 or more, the first at psi = 0.
  FibreDamage(const FatigueSection& section, const SnCurve& curve, int fibres);
  FibreDamage(const FibreDamage&) = delete;
  FibreDamage& operator=(const FibreDamage&) = delete;

  void add(const SectionLoad& load);                             ///< the next instant
  void finish();                                                 ///< counts what is left as half cycles
  const std::vector<double>& damage() const { return damage_; }  ///< D of each fibre so far [1]

 private:
  struct Count {
    const FibreDamage* owner;
    double* damage;
    void operator()(double range, double mean, double cycles) const;
  };
  FatigueSection section_;
  const SnCurve& curve_;
  std::vector<double> damage_, cosine_, sine_;
  std::vector<peaks::Rainflow<Count>> cycles_;
};

}  // namespace bitrock::studies
