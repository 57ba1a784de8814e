#pragma once
/// The loop of a step over the joints that rub on the wall, for one or for four at a time. Inlined into `step.cpp`,
/// once for each kind of machine.

#include "runtime/well/wall_pass.hpp"

namespace bitrock::runtime {

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
    take(columns, friction_now, at.joint, mu);
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

}  // namespace bitrock::runtime
