#pragma once
/// The loop of a step over its joints, for one or for four at a time: what springs, dampers and the wall do. Inlined
/// into `step.cpp`, once for each kind of machine.

#include "runtime/well/joint_law.hpp"
#include "runtime/well/wall_pass.hpp"

namespace bitrock::runtime {

/// Loads of the joints of one half, with the wall. `renew` puts joints that left their piece of the hole into the next.
template <class Real, class Renew>
BITROCK_INTO_BOTH void load_joints(const WellString& string, Columns& columns, std::size_t odd, std::size_t last,
                                   double h, const Renew& renew) {
  constexpr std::size_t width = sizeof(Real) / sizeof(double);
  const bool walled = !string.hole.empty();
  for (std::size_t k = 0; k < last; k += width) {
    const JointPlaces at = joint_places(columns, odd, k);
    const JointSide<Real> a = side_of<Real>(columns, at.above, 1.0), b = side_of<Real>(columns, at.joint, -1.0);
    const JointLoad<Real> load = joint_load(a, b, springs_of<Real>(columns, at.joint));
    Triple<Real> force_a = load.force, torque_a = load.torque_above;
    Triple<Real> force_b = -load.force, torque_b = load.torque_below;
    Real work;
    take(columns, damper_work, at.joint, work);
    put(columns, damper_work, at.joint, Real(work + h * load.damper_power));
    if (walled) {
      const Triple<Real> middle = 0.5 * (a.end + b.end);
      InHole<Real> hole = in_hole(columns, at.joint, middle);
      if (any_below_zero(hole.above) || any_below_zero(hole.below)) {
        renew(at.joint, width);
        hole = in_hole(columns, at.joint, middle);
      }
      add_wall(columns, at.joint, string.wall, h, a, b, hole, force_a, torque_a, force_b, torque_b);
    }
    put(columns, force_above, at.joint, force_a);
    put(columns, torque_above, at.joint, torque_a);
    put(columns, force_below, at.joint, force_b);
    put(columns, torque_below, at.joint, torque_b);
  }
}

}  // namespace bitrock::runtime
