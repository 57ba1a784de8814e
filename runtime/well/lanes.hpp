#pragma once
/// Four segments or joints side by side, and the operations that a number and four numbers share by name. It exists so
/// that each law of the string is written once, and gives the same bits to one joint and to four.

#include <cmath>
#include <cstring>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "runtime/signal/vectors.hpp"

// Everything here is inlined: no vector is handed over at a call.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace bitrock::runtime {

inline constexpr std::size_t lane_count = 4;  ///< side by side

/// Rounded as IEEE 754 says.
BITROCK_INTO_BOTH double square_root(double x) {
  return std::sqrt(x);
}

/// Of each.
BITROCK_INTO_BOTH FourNumbers square_root(const FourNumbers& x) {
#if defined(__SSE2__)
  __m128d pairs[2];
  std::memcpy(pairs, &x, sizeof x);
  pairs[0] = _mm_sqrt_pd(pairs[0]);
  pairs[1] = _mm_sqrt_pd(pairs[1]);
  FourNumbers root;
  std::memcpy(&root, pairs, sizeof root);
  return root;
#else
  return FourNumbers{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
#endif
}

/// -1 below 0, else 1.
BITROCK_INTO_BOTH double sign_of(double x) {
  return x < 0.0 ? -1.0 : 1.0;
}
/// Of each.
BITROCK_INTO_BOTH FourNumbers sign_of(const FourNumbers& x) {
  constexpr FourNumbers minus{-1.0, -1.0, -1.0, -1.0}, plus{1.0, 1.0, 1.0, 1.0};
  return x < 0.0 ? minus : plus;
}

/// x where it is above 0, else 0; 0 also for what is not a number.
BITROCK_INTO_BOTH double above_zero(double x) {
  return x > 0.0 ? x : 0.0;
}
/// Of each.
BITROCK_INTO_BOTH FourNumbers above_zero(const FourNumbers& x) {
  constexpr FourNumbers zero{};
  return x > zero ? x : zero;
}

/// `yes` where x is above 0, else `no`.
BITROCK_INTO_BOTH double choose(double x, double yes, double no) {
  return x > 0.0 ? yes : no;
}
/// For each.
BITROCK_INTO_BOTH FourNumbers choose(const FourNumbers& x, const FourNumbers& yes, const FourNumbers& no) {
  constexpr FourNumbers zero{};
  return x > zero ? yes : no;
}

/// Whether any of them is below 0.
BITROCK_INTO_BOTH bool any_below_zero(double x) {
  return x < 0.0;
}
/// Whether any of the four is.
BITROCK_INTO_BOTH bool any_below_zero(const FourNumbers& x) {
  const FourWords below = x < 0.0;
  return ((below[0] | below[1]) | (below[2] | below[3])) != 0;
}

/// Whether any of them is above 0.
BITROCK_INTO_BOTH bool any_above_zero(double x) {
  return x > 0.0;
}
/// Whether any of the four is.
BITROCK_INTO_BOTH bool any_above_zero(const FourNumbers& x) {
  const FourWords above = x > 0.0;
  return ((above[0] | above[1]) | (above[2] | above[3])) != 0;
}

/// The larger one; b where one is not a number.
BITROCK_INTO_BOTH double larger(double a, double b) {
  return a > b ? a : b;
}
/// Of each pair.
BITROCK_INTO_BOTH FourNumbers larger(const FourNumbers& a, const FourNumbers& b) {
  return a > b ? a : b;
}

/// One number from memory.
BITROCK_INTO_BOTH void load(const double* from, double& to) {
  to = *from;
}
/// Four that lie in a row.
BITROCK_INTO_BOTH void load(const double* from, FourNumbers& to) {
  std::memcpy(&to, from, sizeof to);
}
/// One number to memory.
BITROCK_INTO_BOTH void store(double value, double* to) {
  *to = value;
}
/// Four in a row.
BITROCK_INTO_BOTH void store(const FourNumbers& value, double* to) {
  std::memcpy(to, &value, sizeof value);
}

}  // namespace bitrock::runtime
