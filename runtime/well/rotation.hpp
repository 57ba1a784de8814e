#pragma once
/// Rotations as unit quaternions, from the frame of a segment (first axis along the pipe, down the hole) to the world.

#include "runtime/well/lanes.hpp"
#include "runtime/well/vector3.hpp"

namespace bitrock::runtime {

template <class Real>
struct Quaternion {
  Real w{}, x{}, y{}, z{};  ///< cos of the half angle; sin of it times the axis
};

using Rotation = Quaternion<double>;  ///< of one segment

inline constexpr Rotation no_rotation{1.0, 0.0, 0.0, 0.0};  ///< the frame is the world

/// First b, then a.
template <class Real>
BITROCK_INTO_BOTH Quaternion<Real> operator*(const Quaternion<Real>& a, const Quaternion<Real>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The rotation back.
template <class Real>
BITROCK_INTO_BOTH Quaternion<Real> conjugate(const Quaternion<Real>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// The three columns of the rotation matrix: where the axes of the frame point in the world.
template <class Real>
struct Axes {
  Triple<Real> first, second, third;  ///< unit vectors
};

/// Of a unit quaternion.
template <class Real>
BITROCK_INTO_BOTH Axes<Real> axes_of(const Quaternion<Real>& q) {
  const Real xx = 2.0 * q.x * q.x, yy = 2.0 * q.y * q.y, zz = 2.0 * q.z * q.z;
  const Real xy = 2.0 * q.x * q.y, yz = 2.0 * q.y * q.z, zx = 2.0 * q.z * q.x;
  const Real wx = 2.0 * q.w * q.x, wy = 2.0 * q.w * q.y, wz = 2.0 * q.w * q.z;
  return {{1.0 - yy - zz, xy + wz, zx - wy}, {xy - wz, 1.0 - xx - zz, yz + wx}, {zx + wy, yz - wx, 1.0 - xx - yy}};
}

/// Direction of the pipe.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> direction_of(const Quaternion<Real>& q) {
  return {1.0 - 2.0 * (q.y * q.y + q.z * q.z), 2.0 * (q.x * q.y + q.w * q.z), 2.0 * (q.x * q.z - q.w * q.y)};
}

/// From the frame to the world.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> to_world(const Axes<Real>& axes, const Triple<Real>& a) {
  return a.x * axes.first + a.y * axes.second + a.z * axes.third;
}
/// From the world to the frame.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> to_frame(const Axes<Real>& axes, const Triple<Real>& a) {
  return {dot(axes.first, a), dot(axes.second, a), dot(axes.third, a)};
}

/// **What** Rotation by a rotation vector whose half is given.
/// **Equation** (cos h, sin h / h * half), h = |half|, by their series to h^14 and h^15.
/// **Validity** h up to 1: within 1e-13.
template <class Real>
BITROCK_INTO_BOTH Quaternion<Real> rotation_by_twice(const Triple<Real>& half) {
  const Real h = dot(half, half);
  const Real cosine =
      1.0 -
      h * (1.0 / 2) *
          (1.0 -
           h * (1.0 / 12) *
               (1.0 - h * (1.0 / 30) *
                          (1.0 - h * (1.0 / 56) *
                                     (1.0 - h * (1.0 / 90) * (1.0 - h * (1.0 / 132) * (1.0 - h * (1.0 / 182)))))));
  const Real sine =
      1.0 -
      h * (1.0 / 6) *
          (1.0 -
           h * (1.0 / 20) *
               (1.0 - h * (1.0 / 42) *
                          (1.0 - h * (1.0 / 72) *
                                     (1.0 - h * (1.0 / 110) * (1.0 - h * (1.0 / 156) * (1.0 - h * (1.0 / 210)))))));
  return {cosine, sine * half.x, sine * half.y, sine * half.z};
}

/// Of unit length; `q` must not be 0.
template <class Real>
BITROCK_INTO_BOTH Quaternion<Real> normalised(const Quaternion<Real>& q) {
  const Real scale = 1.0 / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// The shortest rotation that takes the unit vector `from` to the unit vector `to`: it does not twist.
inline Rotation rotation_between(const Vector3& from, const Vector3& to) {
  const double cosine = dot(from, to);
  if (cosine < -0.999999999) {
    const Vector3 axis = any_across(from);
    return {0.0, axis.x, axis.y, axis.z};
  }
  const Vector3 sine = cross(from, to);
  return normalised(Rotation{1.0 + cosine, sine.x, sine.y, sine.z});
}

/// The one that takes the first axis (north) to `direction`.
inline Rotation rotation_to(const Vector3& direction) {
  return rotation_between({1.0, 0.0, 0.0}, direction);
}

}  // namespace bitrock::runtime
