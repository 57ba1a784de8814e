#pragma once
/// What a joint, or four of them, have from the columns, and what the wall of the hole adds to their loads. Part of the
/// loop over joints (`joint_pass.hpp`).

#include "runtime/well/joint_law.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// The two segments of a joint, by their places.
struct JointPlaces {
  std::size_t joint, above;  ///< that of the joint is that of the segment below
};

/// Joint number k of one half: 0 the joints of even number, 1 those of odd number.
BITROCK_INTO_BOTH JointPlaces joint_places(const Columns& columns, std::size_t odd, std::size_t k) {
  return odd == 0 ? JointPlaces{k, columns.half + k} : JointPlaces{columns.half + k, k + 1};
}

/// The end of a segment: 1 the lower one, -1 the upper one.
template <class Real>
BITROCK_INTO_BOTH JointSide<Real> side_of(const Columns& columns, std::size_t place, double end) {
  JointSide<Real> side;
  Triple<Real> centre, d;
  Real half;
  take(columns, frame, place, side.frame);
  take(columns, position, place, centre);
  take(columns, direction, place, d);
  take(columns, rate, place, side.rate);
  take(columns, velocity, place, side.velocity);
  take(columns, half_length, place, half);
  side.arm = Real(end * half) * d;
  side.end = centre + side.arm;
  side.velocity += cross(side.rate, side.arm);
  return side;
}

/// Of the joint at a place.
template <class Real>
BITROCK_INTO_BOTH JointSprings<Real> springs_of(const Columns& columns, std::size_t place) {
  JointSprings<Real> k;
  take(columns, axial_stiffness, place, k.axial);
  take(columns, shear_stiffness, place, k.shear);
  take(columns, torsion_stiffness, place, k.torsion);
  take(columns, bending_stiffness, place, k.bending);
  take(columns, axial_damping, place, k.axial_damping);
  take(columns, shear_damping, place, k.shear_damping);
  take(columns, torsion_damping, place, k.torsion_damping);
  take(columns, bending_damping, place, k.bending_damping);
  take(columns, bend, place, k.bend);
  return k;
}

/// Where a joint is in its hole.
template <class Real>
struct InHole {
  Triple<Real> offset, tangent;  ///< [m] from the centre line; down the hole
  Real above, below;  ///< [m] how far below its upper end plane and above its lower one: both 0 or more inside
};

/// The formula of `offset_from`, for the piece that a joint is in.
template <class Real>
BITROCK_INTO_BOTH InHole<Real> in_hole(const Columns& columns, std::size_t place, const Triple<Real>& middle) {
  Triple<Real> start, tangent, normal, last;
  Real curvature, reach;
  take(columns, arc_start, place, start);
  take(columns, arc_tangent, place, tangent);
  take(columns, arc_normal, place, normal);
  take(columns, arc_curvature, place, curvature);
  take(columns, end_tangent, place, last);
  take(columns, end_reach, place, reach);
  const Triple<Real> d = middle - start, binormal = cross(tangent, normal);
  const Real aside = dot(d, binormal);
  const Triple<Real> in_plane = d - aside * binormal;
  const Triple<Real> u = curvature * in_plane - normal;
  const Real g = square_root(dot(u, u));
  const Triple<Real> outwards = Real(1.0 / g) * u;
  const Real distance = (curvature * dot(in_plane, in_plane) - 2.0 * dot(d, normal)) / (1.0 + g);
  return {.offset = distance * outwards + aside * binormal,
          .tangent = cross(binormal, outwards),
          .above = dot(d, tangent),
          .below = reach - dot(middle, last)};
}

/// Adds the wall at a joint to its load, and leaves what friction needs. The force acts half on each of the two ends.
template <class Real>
BITROCK_INTO_BOTH void add_wall(Columns& columns, std::size_t place, const WallSpring& wall, double h,
                                const JointSide<Real>& a, const JointSide<Real>& b, const InHole<Real>& hole,
                                Triple<Real>& force_a, Triple<Real>& torque_a, Triple<Real>& force_b,
                                Triple<Real>& torque_b) {
  Real room, radius, work, mu, more, pace, along, back;
  take(columns, friction, place, mu);
  take(columns, friction_more, place, more);
  take(columns, friction_pace, place, pace);
  take(columns, friction_along, place, along);
  take(columns, friction_around, place, back);
  take(columns, clearance, place, room);
  take(columns, contact_radius, place, radius);
  take(columns, wall_work, place, work);
  const Real distance = square_root(dot(hole.offset, hole.offset)) + 1e-200;
  if (!any_above_zero(Real(distance - room))) {
    constexpr Real nothing{};
    put(columns, wall_force, place, nothing);
    put(columns, friction_along, place, nothing);
    put(columns, friction_around, place, nothing);
    return;
  }
  const Triple<Real> n = Real(1.0 / distance) * hole.offset;
  const Triple<Real> v = 0.5 * (a.velocity + b.velocity);
  const WallPush<Real> push = wall_push(wall, Real(distance - room), dot(v, n));
  const Triple<Real> half = Real(-0.5 * push.force) * n;
  force_a += half;
  force_b += half;
  torque_a += cross(a.arm, half);
  torque_b += cross(b.arm, half);
  const Triple<Real> around = cross(hole.tangent, n), surface = radius * n;
  const Triple<Real> slip = v + cross(0.5 * (a.rate + b.rate), surface);
  // friction begins with that of the step before, as far as the wall still presses: what sticks then sticks exactly
  const Real slip_t = dot(slip, hole.tangent), slip_c = dot(slip, around);
  const Real now = friction_at(mu, more, pace, Real(slip_t * slip_t + slip_c * slip_c));
  const Real most = now * push.force;
  const Real cut = most / larger(most, Real(square_root(along * along + back * back) + 1e-200));
  const Triple<Real> rub = Real(0.5 * cut * along) * hole.tangent + Real(0.5 * cut * back) * around;
  force_a += rub;
  force_b += rub;
  torque_a += cross(a.arm + surface, rub);
  torque_b += cross(b.arm + surface, rub);
  put(columns, friction_along, place, Real(cut * along));
  put(columns, friction_around, place, Real(cut * back));
  put(columns, wall_normal, place, n);
  put(columns, wall_tangent, place, hole.tangent);
  put(columns, wall_force, place, push.force);
  put(columns, slip_along, place, slip_t);
  put(columns, slip_around, place, slip_c);
  put(columns, friction_now, place, now);
  put(columns, wall_work, place, Real(work + h * push.damper_power));
}

}  // namespace bitrock::runtime
