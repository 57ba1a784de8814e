#pragma once
/// The loops of a step over its segments, for one or for four at a time: velocities, then positions. Inlined into
/// `step.cpp`, once for each kind of machine.

#include "runtime/well/columns.hpp"

namespace bitrock::runtime {

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
