#pragma once
/// Vectors of three dimensions: x north, y east, z down, right-handed; the origin is at the rotary table. Of numbers,
/// or of four numbers side by side (`lanes.hpp`): each law is written once for both.

#include <cmath>

#include "runtime/signal/vectors.hpp"

namespace bitrock::runtime {

template <class Real>
struct Triple {
  Real x{}, y{}, z{};  ///< north, east, down; or along, across, across in the frame of a segment
};

using Vector3 = Triple<double>;  ///< of one segment

/// Sum.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> operator+(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// Difference.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> operator-(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// The opposite.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> operator-(const Triple<Real>& a) {
  return {-a.x, -a.y, -a.z};
}
/// `s` times as long.
template <class Real, class Scale>
BITROCK_INTO_BOTH Triple<Real> operator*(const Scale& s, const Triple<Real>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
/// Adds.
template <class Real>
BITROCK_INTO_BOTH Triple<Real>& operator+=(Triple<Real>& a, const Triple<Real>& b) {
  return a = a + b;
}
/// Takes away.
template <class Real>
BITROCK_INTO_BOTH Triple<Real>& operator-=(Triple<Real>& a, const Triple<Real>& b) {
  return a = a - b;
}
/// Scalar product.
template <class Real>
BITROCK_INTO_BOTH Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Vector product.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The part of `a` across the unit vector `t`.
template <class Real>
BITROCK_INTO_BOTH Triple<Real> across(const Triple<Real>& a, const Triple<Real>& t) {
  return a - dot(a, t) * t;
}

/// Its length.
inline double length(const Vector3& a) {
  return std::sqrt(dot(a, a));
}
/// `a` must not be 0.
inline Vector3 unit(const Vector3& a) {
  return (1.0 / length(a)) * a;
}
/// Whether all three are.
inline bool is_finite(const Vector3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Some unit vector across the unit vector `t`, the same for the same `t`.
inline Vector3 any_across(const Vector3& t) {
  const double x = std::abs(t.x), y = std::abs(t.y), z = std::abs(t.z);
  const Vector3 axis = x <= y && x <= z ? Vector3{1.0, 0.0, 0.0}
                       : y <= z         ? Vector3{0.0, 1.0, 0.0}
                                        : Vector3{0.0, 0.0, 1.0};
  return unit(across(axis, t));
}

}  // namespace bitrock::runtime
