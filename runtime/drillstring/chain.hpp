#pragma once
/// A drill string in one direction of motion, axial or torsional: lumps in a row, a spring and a damper between
/// neighbours, and one more pair between the first lump and whatever drives it. Numbers alone: it does not know whether
/// they are masses or moments of inertia. Built from pipe sections, or given directly.

#include <vector>

namespace bitrock::runtime {

/// All four lists have one entry a lump, from top to bottom. Units: axial / torsional.
struct Chain {
  std::vector<double> inertia;       ///< [kg] / [kg m^2] above 0
  std::vector<double> stiffness;     ///< [N/m] / [N m/rad] of the spring above the lump; the first may be 0 (free top)
  std::vector<double> damping;       ///< [N s/m] / [N m s/rad] of the damper beside it
  std::vector<double> wall_damping;  ///< [N s/m] / [N m s/rad] from the lump to the wall

  /// Number of masses.
  std::size_t size() const { return inertia.size(); }
};

/// A stretch of pipe of one kind.
struct PipeSection {
  double length = 0.0;            ///< [m]
  double outer_diameter = 0.0;    ///< [m]
  double inner_diameter = 0.0;    ///< [m]
  double youngs_modulus = 200e9;  ///< [Pa]
  double shear_modulus = 79.3e9;  ///< [Pa]
  double density = 7850.0;        ///< [kg/m^3]
  double linear_mass = 0.0;  ///< [kg/m] with tool joints; 0: of the plain pipe. Changes weight and axial inertia only
};

/// Where in its stretch of pipe a lump sits. The springs run from lump to lump.
enum class Lumping {
  middle,  ///< half a stretch of spring above the first lump: closest to the continuous string
  end      ///< a whole stretch above every lump, as the closed formula for the modes has it
};

/// Cross-section [m^2] and polar moment of area [m^4] of a pipe: A = pi (D^2 - d^2) / 4, j = pi (D^4 - d^4) / 32.
double area(const PipeSection& pipe);
/// Of the cross-section [m^4].
double polar_moment(const PipeSection& pipe);
/// Stress at the outside of a unit of bending moment [1/m^3]: (D / 2) / I, I = J_p / 2.
double stress_of_moment(const PipeSection& pipe);
/// [kg/m]
double mass_per_length(const PipeSection& pipe);
/// Of a torsional wave [N m s/rad]: torque over rotation, sqrt(rho G) j.
double torsional_impedance(const PipeSection& pipe);

/// **What** The string cut into `lumps` stretches of equal length, each a lump.
/// **Equation** axial: m_i = integral of rho A, K = 1 / integral of dz / (E A) between two lumps; torsional: J_i =
/// integral of rho j, K = 1 / integral of dz / (G j). Damper: c = 2 zeta sqrt(K J) with the lump below the spring.
/// **Symbols** z [m] along the string; E, G [Pa]; zeta [1] damping ratio of a pair.
/// **Source** [BitRock2026, sec. 3.4]: K = A E / dz and K = G j / dz (its "I" is the polar moment); several sections by
/// adding compliances.
/// **Validity** The axial chain has no spring above its first lump: the hook holds it with a force, or a line by the
/// pipe of `compliance_above`.
Chain axial_chain(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping, double damping_ratio);
/// Of the pipe between the upper end and the first axial lump [m/N]: integral of dz / (E A).
double compliance_above(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping);
/// Of the pipes, in so many lumps.
Chain torsional_chain(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping, double damping_ratio);

/// **What** Weight of each lump of `axial_chain` in the fluid.
/// **Equation** g (1 - rho_m / rho) integral of the mass. **Symbols** rho_m [kg/m^3] of the fluid; g = 9.81 m/s^2.
std::vector<double> lump_weights(const std::vector<PipeSection>& pipes, int lumps, double fluid_density);

inline constexpr double gravity = 9.81;  ///< [m/s^2]

/// Position, velocity and acceleration of every lump.
struct ChainMotion {
  std::vector<double> position, velocity, acceleration;  ///< of each mass [m] or [rad], and their rates
};

/// What drives the first lump through its spring: where it is and how fast [m, m/s] / [rad, rad/s].
struct Drive {
  double position = 0.0;  ///< of the drive [m] / [rad]
  double velocity = 0.0;  ///< of the drive [m/s] / [rad/s]
};

/// Sets `force` to what springs, dampers and wall exert on the lumps at these positions and velocities. [N] / [N m].
void set_chain_forces(const Chain& chain, const std::vector<double>& position, const std::vector<double>& velocity,
                      const Drive& drive, std::vector<double>& force);

/// Force of the first spring and damper on the drive, against its motion when it pulls the chain along. [N] / [N m].
double drive_reaction(const Chain& chain, const ChainMotion& motion, const Drive& drive);

/// Energy in the springs, and power that dampers and wall take [J, W].
double spring_energy(const Chain& chain, const ChainMotion& motion, const Drive& drive);
/// Of all dampers [W].
double damper_power(const Chain& chain, const ChainMotion& motion, const Drive& drive);
/// Of all masses [J].
double kinetic_energy(const Chain& chain, const ChainMotion& motion);

}  // namespace bitrock::runtime
