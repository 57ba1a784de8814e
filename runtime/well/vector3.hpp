#pragma once
/// Vectors of three dimensions: x north, y east, z down, right-handed; the origin is at the rotary table.

#include <cmath>

namespace bitrock::runtime {

struct Vector3 {
  double x = 0.0, y = 0.0, z = 0.0;  ///< north, east, down
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vector3 operator-(const Vector3& a) {
  return {-a.x, -a.y, -a.z};
}
constexpr Vector3 operator*(double s, const Vector3& a) {
  return {s * a.x, s * a.y, s * a.z};
}
constexpr Vector3& operator+=(Vector3& a, const Vector3& b) {
  return a = a + b;
}
constexpr Vector3& operator-=(Vector3& a, const Vector3& b) {
  return a = a - b;
}
constexpr double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vector3& a) {
  return std::sqrt(dot(a, a));
}
/// `a` must not be 0.
inline Vector3 unit(const Vector3& a) {
  return (1.0 / length(a)) * a;
}
/// The part of `a` across the unit vector `t`.
constexpr Vector3 across(const Vector3& a, const Vector3& t) {
  return a - dot(a, t) * t;
}
inline bool is_finite(const Vector3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// Some unit vector across the unit vector `t`, the same for the same `t`.
inline Vector3 any_across(const Vector3& t) {
  const Vector3 axis = std::abs(t.x) <= std::abs(t.y) && std::abs(t.x) <= std::abs(t.z) ? Vector3{1.0, 0.0, 0.0}
                       : std::abs(t.y) <= std::abs(t.z)                                 ? Vector3{0.0, 1.0, 0.0}
                                                                                        : Vector3{0.0, 0.0, 1.0};
  return unit(across(axis, t));
}

}  // namespace bitrock::runtime
