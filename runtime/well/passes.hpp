#pragma once
/// The loops of a step over joints and segments, for one or for four at a time. Inlined into `step.cpp`, once for each
/// kind of machine.

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
  Real room, radius, work, mu, along, back;
  take(columns, friction, place, mu);
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
  const Real most = mu * push.force;
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
  put(columns, slip_along, place, dot(slip, hole.tangent));
  put(columns, slip_around, place, dot(slip, around));
  put(columns, wall_work, place, Real(work + h * push.damper_power));
}

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

/// Velocities half a step after, without friction.
template <class Real>
BITROCK_INTO_BOTH void kick_segments(Columns& columns, std::size_t odd, std::size_t last, double h) {
  constexpr std::size_t width = sizeof(Real) / sizeof(double);
  for (std::size_t k = 0; k < last; k += width) {
    const std::size_t place = odd * columns.half + k;
    const std::size_t below = odd == 0 ? columns.half - 1 + k : k;  // the joint below; at the bit a place without joint
    Triple<Real> force, torque, more, v, l, d, w;
    Real mass, mass_along, inertia, inertia_along, down, across, along, turning, spinning, work;
    take(columns, force_below, place, force);
    take(columns, torque_below, place, torque);
    take(columns, force_above, below, more);
    force += more;
    take(columns, torque_above, below, more);
    torque += more;
    take(columns, velocity, place, v);
    take(columns, momentum, place, l);
    take(columns, direction, place, d);
    take(columns, rate, place, w);
    take(columns, inverse_mass, place, mass);
    take(columns, inverse_mass_along, place, mass_along);
    take(columns, inverse_inertia, place, inertia);
    take(columns, inverse_inertia_along, place, inertia_along);
    take(columns, weight, place, down);
    take(columns, drag_across, place, across);
    take(columns, drag_along, place, along);
    take(columns, drag_turning, place, turning);
    take(columns, drag_spinning, place, spinning);
    take(columns, drag_work, place, work);
    const Triple<Real> drag = across * v + Real(along * dot(v, d)) * d;
    const Triple<Real> brake = turning * w + Real(spinning * dot(w, d)) * d;
    force.z += down;
    force -= drag;
    torque -= brake;
    v += Real(h * mass) * force + Real(h * mass_along * dot(force, d)) * d;
    l += h * torque;
    put(columns, drag_work, place, Real(work + h * (dot(drag, v) + dot(brake, w))));
    put(columns, velocity, place, v);
    put(columns, momentum, place, l);
    put(columns, rate, place, inertia * l + Real(inertia_along * dot(l, d)) * d);
  }
}

/// Friction at the joints of one half.
template <class Real>
BITROCK_INTO_BOTH void rub_joints(Columns& columns, std::size_t odd, std::size_t last, double h) {
  constexpr std::size_t width = sizeof(Real) / sizeof(double);
  for (std::size_t k = 0; k < last; k += width) {
    const JointPlaces at = joint_places(columns, odd, k);
    Triple<Real> n, t, va, vb, la, lb, da, db, wa, wb;
    Real ma, mb, ea, eb, ia, ib, ja, jb, ha, hb, radius, normal, mu, before_t, before_c, given_t, given_c, work;
    take(columns, wall_force, at.joint, normal);
    if (!any_above_zero(normal)) continue;
    take(columns, friction, at.joint, mu);
    take(columns, contact_radius, at.joint, radius);
    take(columns, wall_normal, at.joint, n);
    take(columns, wall_tangent, at.joint, t);
    take(columns, slip_along, at.joint, before_t);
    take(columns, slip_around, at.joint, before_c);
    take(columns, friction_along, at.joint, given_t);
    take(columns, friction_around, at.joint, given_c);
    take(columns, friction_work, at.joint, work);
    take(columns, velocity, at.above, va);
    take(columns, velocity, at.joint, vb);
    take(columns, momentum, at.above, la);
    take(columns, momentum, at.joint, lb);
    take(columns, direction, at.above, da);
    take(columns, direction, at.joint, db);
    take(columns, rate, at.above, wa);
    take(columns, rate, at.joint, wb);
    take(columns, inverse_mass, at.above, ma);
    take(columns, inverse_mass, at.joint, mb);
    take(columns, inverse_mass_along, at.above, ea);
    take(columns, inverse_mass_along, at.joint, eb);
    take(columns, inverse_inertia, at.above, ia);
    take(columns, inverse_inertia, at.joint, ib);
    take(columns, inverse_inertia_along, at.above, ja);
    take(columns, inverse_inertia_along, at.joint, jb);
    take(columns, half_length, at.above, ha);
    take(columns, half_length, at.joint, hb);
    const Triple<Real> c = cross(t, n);
    const Triple<Real> arm_a = ha * da, arm_b = Real(-1.0 * hb) * db, surface = radius * n;
    const Triple<Real> v = 0.5 * (va + cross(wa, arm_a) + vb + cross(wb, arm_b)) + cross(0.5 * (wa + wb), surface);
    const Real slip_t = dot(v, t), slip_c = dot(v, c);
    const Real yield_t = 0.25 * (ma + ea + mb + eb);
    const Real yield_c =
        0.25 * (ma + ha * ha * ia + radius * radius * (ia + ja) + mb + hb * hb * ib + radius * radius * (ib + jb));
    given_t *= h;
    given_c *= h;
    const SlipImpulse<Real> p = slip_impulse(Real(slip_t - yield_t * given_t), Real(slip_c - yield_c * given_c),
                                             yield_t, yield_c, Real(h * mu * normal));
    const Triple<Real> half = Real(0.5 * (p.along - given_t)) * t + Real(0.5 * (p.around - given_c)) * c;
    va += ma * half + Real(ea * dot(half, da)) * da;
    vb += mb * half + Real(eb * dot(half, db)) * db;
    la += cross(arm_a + surface, half);
    lb += cross(arm_b + surface, half);
    wa = ia * la + Real(ja * dot(la, da)) * da;
    wb = ib * lb + Real(jb * dot(lb, db)) * db;
    const Triple<Real> after = 0.5 * (va + cross(wa, arm_a) + vb + cross(wb, arm_b)) + cross(0.5 * (wa + wb), surface);
    put(columns, velocity, at.above, va);
    put(columns, velocity, at.joint, vb);
    put(columns, momentum, at.above, la);
    put(columns, momentum, at.joint, lb);
    put(columns, rate, at.above, wa);
    put(columns, rate, at.joint, wb);
    put(columns, friction_along, at.joint, Real(p.along / h));
    put(columns, friction_around, at.joint, Real(p.around / h));
    put(columns, friction_work, at.joint,
        Real(work - 0.5 * (p.along * (before_t + dot(after, t)) + p.around * (before_c + dot(after, c)))));
  }
}

/// Positions at the end of the step, and what follows from them.
template <class Real>
BITROCK_INTO_BOTH void drift_segments(Columns& columns, std::size_t odd, std::size_t last, double h) {
  constexpr std::size_t width = sizeof(Real) / sizeof(double);
  for (std::size_t k = 0; k < last; k += width) {
    const std::size_t place = odd * columns.half + k;
    Triple<Real> x, v, l, d;
    Quaternion<Real> q;
    Real inertia, inertia_along, turned;
    take(columns, position, place, x);
    take(columns, velocity, place, v);
    take(columns, momentum, place, l);
    take(columns, direction, place, d);
    take(columns, frame, place, q);
    take(columns, inverse_inertia, place, inertia);
    take(columns, inverse_inertia_along, place, inertia_along);
    take(columns, turns, place, turned);
    const Real along = dot(l, d);
    const Real excess = inertia_along * along;
    x += h * v;
    const Triple<Real> precession = Real(0.5 * h * inertia) * l;
    const Triple<Real> spin{Real(0.5 * h * excess), Real(0.0 * excess), Real(0.0 * excess)};
    q = normalised(rotation_by_twice(precession) * q * rotation_by_twice(spin));
    d = direction_of(q);
    put(columns, position, place, x);
    put(columns, frame, place, q);
    put(columns, direction, place, d);
    put(columns, rate, place, inertia * l + Real(inertia_along * dot(l, d)) * d);
    put(columns, turns, place, Real(turned + h * (excess + inertia * along)));
  }
}

}  // namespace bitrock::runtime
