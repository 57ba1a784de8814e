#pragma once
/// The strength of a rock over the pressure that confines it.
///
/// **Equation.** The Mohr-Coulomb line through the strengths s_1 along the load at the confining pressures s_3,
///
///     s_1 = s_c + k s_3      k = (1 + sin phi) / (1 - sin phi)      c = s_c / (2 sqrt k)
///
/// by least squares over all tests of one seed; mean and standard deviation over the seeds.
///
/// **Symbols.** s_1, s_3, s_c [Pa], compression positive; k [1]; phi [rad] friction angle; c [Pa] cohesion.
///
/// **Source.** [JaegerCookZimmerman2007] for the line and its constants.
///
/// **Validity.** Rock strengthens less at high pressure than at low: the line depends on the pressures that are asked,
/// and s_c comes out above the uniaxial strength. Where k is 1 or less there is no friction angle above 0: NaN.

#include <vector>

#include "base/statistics.hpp"
#include "base/units.hpp"
#include "dem2d/lab/lab_test.hpp"

namespace bitrock::studies {

/// The line of one seed.
struct Envelope {
  double strength_at_zero;  ///< s_c [Pa]
  double slope;             ///< k [1]
  double friction_angle;    ///< phi [rad]
  double cohesion;          ///< c [Pa]
};

/// A constant of the line, its name in JSON and Python, and the unit of that name.
struct EnvelopeQuantity {
  const char* key;          ///< ends in its unit
  double Envelope::*value;  ///< in SI
  double unit;              ///< SI value = value under the key * unit
};
/// In the order in which they are told.
inline constexpr EnvelopeQuantity envelope_quantities[] = {{"friction_angle_deg", &Envelope::friction_angle, base::deg},
                                                           {"cohesion_Pa", &Envelope::cohesion, 1.0},
                                                           {"strength_at_zero_Pa", &Envelope::strength_at_zero, 1.0},
                                                           {"slope", &Envelope::slope, 1.0}};

/// Of at least two tests at different pressures.
Envelope fit_envelope(const std::vector<const dem2d::LabRun*>& runs);

/// Of all seeds that were tested at two pressures or more.
struct EnvelopeOfSeeds {
  std::vector<std::uint64_t> seeds;  ///< ascending, one a line
  std::vector<Envelope> lines;       ///< one a seed

  bool empty() const { return lines.empty(); }       ///< no seed was tested at two pressures
  base::Summary of(double Envelope::*member) const;  ///< over the seeds
};
/// Of tests in any order; a seed that was tested at one pressure alone is left out.
EnvelopeOfSeeds envelope_of(const std::vector<dem2d::LabRun>& runs);

}  // namespace bitrock::studies
