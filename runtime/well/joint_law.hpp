#pragma once
/// What two neighbouring segments of a string do to each other: springs and dampers along, across, in twist and in
/// bending. One law for one joint and for four side by side.

#include "runtime/well/rotation.hpp"

namespace bitrock::runtime {

/// The end of a segment at the joint.
template <class Real>
struct JointSide {
  Quaternion<Real> frame;  ///< of the segment
  Triple<Real> end;        ///< [m] its end at the joint
  Triple<Real> arm;        ///< [m] from its centre to that end
  Triple<Real> velocity;   ///< [m/s] of that end
  Triple<Real> rate;       ///< [rad/s] of the segment
};

/// Springs and dampers of a joint.
template <class Real>
struct JointSprings {
  Real axial, shear;                      ///< [N/m]
  Real torsion, bending;                  ///< [N m/rad]
  Real axial_damping, shear_damping;      ///< [N s/m]
  Real torsion_damping, bending_damping;  ///< [N m s/rad]
  Triple<Real> bend;                      ///< [rad] rotation vector at rest, in the frame: the pipe's own bend
};

/// What a joint does, and what is stored in it.
template <class Real>
struct JointLoad {
  Triple<Real> force;                       ///< [N] on the upper segment; the opposite on the lower one
  Triple<Real> torque_above, torque_below;  ///< [N m] about the centres of the two
  Triple<Real> section_force;               ///< [N] along, across, across in the mean frame: tension positive
  Triple<Real> section_moment;              ///< [N m] torque and two bending moments in the mean frame
  Real damper_power;                        ///< [W] taken by the dampers
  Real energy;                              ///< [J] in the springs
};

/// asin(s) / s of s^2 up to sin^2(pi/16), within 1e-16: sum of (2n)! / (4^n (n!)^2 (2n + 1)) s^(2n).
template <class Real>
BITROCK_INTO_BOTH Real arc_over_sine(const Real& y) {
  return 1.0 +
         y * (1.0 / 6 +
              y * (3.0 / 40 +
                   y * (5.0 / 112 +
                        y * (35.0 / 1152 +
                             y * (63.0 / 2816 +
                                  y * (231.0 / 13312 +
                                       y * (143.0 / 10240 + y * (6435.0 / 557056 + y * (12155.0 / 1245184 +
                                                                                        y * 46189.0 / 5505024)))))))));
}

/// **What** Force and moment of a joint between an upper segment a and a lower one b.
/// **Equation** with D = p_b - p_a, q_r = conj(q_a) q_b (w >= 0), q_m the mean of q_a and q_b, R its matrix:
///   G = R^T D,                    n = K_f G + C_f R^T (v_pb - v_pa - w_m x D),           F = R n
///   phi = 2 al e, q_r = (cos al, sin al e),  m = K_m (phi - phi0) + C_m R^T (w_b - w_a)
///   M = R [(e.m) e + al / sin al (m - (e.m) e)],  c = tan(al / 2) / 2,  H = D x F
///   on a: +F, arm_a x F + H/2 + M + c H x R e;     on b: -F, -(arm_b x F) + H/2 - M - c H x R e.
/// **Symbols** p [m], v [m/s] ends at the joint; w [rad/s]; D [m] gap; phi [rad] rotation vector between the two, the
/// same in the frames of a, b and the mean; phi0 [rad] at rest; K_f = (axial, shear, shear) [N/m]; K_m = (torsion,
/// bending, bending) [N m/rad]; n [N], m [N m] in the mean frame; w_m mean of w_a and w_b.
/// **Source** derived here, docs/theory/well.md: the forces are the exact gradient of G^T K_f G / 2 +
/// (phi - phi0)^T K_m (phi - phi0) / 2. As a beam element with one point of integration, see [SimoVuQuoc1986].
/// **Differences and validity** Torques about the two centres and the forces sum to 0: momentum is kept to rounding.
/// Angles below pi between neighbours; at pi the rotation vector turns over.
template <class Real>
BITROCK_INTO_BOTH JointLoad<Real> joint_load(const JointSide<Real>& a, const JointSide<Real>& b,
                                             const JointSprings<Real>& k) {
  const Quaternion<Real> relative = conjugate(a.frame) * b.frame;
  const Real side = sign_of(relative.w);
  const Real cosine = side * relative.w;
  const Triple<Real> v{side * relative.x, side * relative.y, side * relative.z};  // sin al e
  const Real y = dot(v, v);
  // cosines of al / 2, al / 4, al / 8; sin(al / 8) = sin al / (8 c1 c2 c3)
  const Real c1 = square_root(0.5 + 0.5 * cosine), c2 = square_root(0.5 + 0.5 * c1), c3 = square_root(0.5 + 0.5 * c2);
  const Real shrink = 1.0 / (c1 * c2 * c3);
  const Real stretch = arc_over_sine(Real(y * (shrink * shrink) / 64.0)) * shrink;  // al / sin al
  const Real half = 0.5 / c1;
  const Axes<Real> axes =
      axes_of(Quaternion<Real>{half * (a.frame.w + side * b.frame.w), half * (a.frame.x + side * b.frame.x),
                               half * (a.frame.y + side * b.frame.y), half * (a.frame.z + side * b.frame.z)});

  const Triple<Real> gap = b.end - a.end;
  const Triple<Real> strain = to_frame(axes, gap);
  const Triple<Real> rate = to_frame(axes, b.velocity - a.velocity - cross(0.5 * (a.rate + b.rate), gap));
  const Triple<Real> damping{k.axial_damping * rate.x, k.shear_damping * rate.y, k.shear_damping * rate.z};
  const Triple<Real> n{k.axial * strain.x + damping.x, k.shear * strain.y + damping.y, k.shear * strain.z + damping.z};

  const Triple<Real> bend = 2.0 * stretch * v - k.bend;
  const Triple<Real> turning = to_frame(axes, b.rate - a.rate);
  const Triple<Real> braking{k.torsion_damping * turning.x, k.bending_damping * turning.y,
                             k.bending_damping * turning.z};
  const Triple<Real> m{k.torsion * bend.x + braking.x, k.bending * bend.y + braking.y, k.bending * bend.z + braking.z};
  const Real along = (stretch - 1.0) * dot(v, m) / (y + 1e-200);  // y = 0: v is 0, too

  const Triple<Real> force = to_world(axes, n);
  const Triple<Real> moment = to_world(axes, stretch * m - along * v);
  const Triple<Real> twist = cross(gap, force);
  const Triple<Real> tilt = moment + cross(twist, to_world(axes, (0.5 / (1.0 + cosine)) * v));
  return {.force = force,
          .torque_above = cross(a.arm, force) + 0.5 * twist + tilt,
          .torque_below = 0.5 * twist - cross(b.arm, force) - tilt,
          .section_force = n,
          .section_moment = m,
          .damper_power = dot(damping, rate) + dot(braking, turning),
          .energy = 0.5 * (k.axial * strain.x * strain.x + k.shear * (strain.y * strain.y + strain.z * strain.z) +
                           k.torsion * bend.x * bend.x + k.bending * (bend.y * bend.y + bend.z * bend.z))};
}

}  // namespace bitrock::runtime
