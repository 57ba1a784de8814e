#pragma once
/// Stress in the steel at one point of the string.

#include <string>

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// A point of the outer surface that turns with the pipe: what fatigue counts.
struct StressPoint {
  std::string name;        ///< for people
  double above_bit = 0.0;  ///< [m] along the string
  double angle = 0.0;      ///< [rad] in the frame of its segment, from its second axis to its third
  double outer_diameter = 0.0, inner_diameter = 0.0;  ///< [m] of the pipe there
};

/// At such a point.
struct Stress {
  double axial = 0.0;           ///< [Pa] of tension alone
  double normal = 0.0;          ///< [Pa] of tension and bending, tension positive
  double shear = 0.0;           ///< [Pa] of torque
  double von_mises = 0.0;       ///< [Pa]
  double measured_depth = 0.0;  ///< [m] of the joint below the point, and so much of the segment; along the hole
};

/// T_e / A - rho_f g z [Pa]: tension in the steel from the tension in the mud [N], for a section [m^2] in still mud
/// [kg/m^3] at a depth [m] below the table.
double axial_stress(double tension, double section_area, double fluid_density, double depth);

/// What one section of the string bears.
struct SectionLoad {
  double tension = 0.0;  ///< [N] effective, in the mud
  Vector3 moment;        ///< [N m] twist and two bending moments, about the axes of the joint, as `JointLoad` has them:
                         ///< a drive that winds the string up makes the first negative
};

/// At the joint above segment i; at the table above the uppermost.
SectionLoad load_above(const WellStringState& state, std::size_t i);
/// At the lower end: what the rock, the source and the jets push, and the torque on the bit.
SectionLoad load_at_bit(const WellString& string, const WellStringState& state);

/// **What** Stress of one fibre of the outer surface of a pipe.
/// **Equation** sigma = T / A + (D / 2I)(m2 sin psi - m3 cos psi), tau = m1 D / 4I, von Mises
/// sqrt(sigma^2 + 3 tau^2); T = T_e - p A.
/// **Symbols** T_e [N] tension in the mud, p [Pa] of still mud; m1 torque, m2, m3 [N m] bending moments about the
/// second and third axis; psi [rad] `angle`; A, I [m^2, m^4] of the ring.
/// **Differences and validity** Without the bending peak at a tool joint
/// (studies/well/bending_magnification.hpp). `measured_depth` is left 0.
Stress stress_of(const PipeSection& pipe, const SectionLoad& load, double angle, double pressure);
/// The angle [rad] at which bending adds to what tension does: the largest normal stress, whatever its sign.
double worst_angle(const PipeSection& pipe, const SectionLoad& load, double pressure);

/// **What** Stress at a point between two joints: `stress_of` with tension and moments that are linear between the two
/// joints of its segment, and the pressure rho_f g z of still mud.
Stress stress_at(const WellString& string, const WellStringState& state, const StressPoint& point,
                 double fluid_density);

}  // namespace bitrock::runtime
