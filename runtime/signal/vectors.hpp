#pragma once
/// Vectors of four numbers, by whatever vectors the machine has: the same operations in the same order, so the same
/// bits. What is in here goes into the two functions a machine chooses between, once compiled for each.

#include <cstdint>
#include <limits>

// Inlined into code for two kinds of machine. The wider one has no fused multiply-add, which would change bits. Not on
// Windows, where compilers have been known to place wide vectors on a stack that is not aligned for them.
#if defined(__x86_64__) && !defined(_WIN32)
#define BITROCK_WIDE __attribute__((target("avx2")))
#endif
/// Of a function that goes into both.
#define BITROCK_INTO_BOTH inline __attribute__((always_inline))

namespace bitrock::runtime {

typedef double FourNumbers __attribute__((vector_size(4 * sizeof(double)), aligned(16)));

typedef std::int64_t FourWords __attribute__((vector_size(4 * sizeof(std::int64_t)), aligned(16)));

typedef std::uint64_t UnsignedWords __attribute__((vector_size(4 * sizeof(std::uint64_t)), aligned(16)));

/// **What** Logarithm of four numbers.
/// **Equation** x = 2^k m with sqrt(1/2) <= m < sqrt(2); ln x = k ln 2 + 2 (t + t^3 / 3 + t^5 / 5 + ... + t^9 / 9),
/// t = (m - 1) / (m + 1).
/// **Symbols** x [1].
/// **Source** the series of the inverse hyperbolic tangent, as commonly done.
/// **Differences and validity** x above 0, finite and normal; within 1e-9 of ln x. The
/// library's logarithm is not used because its bits differ between machines.
BITROCK_INTO_BOTH void logarithm(const FourNumbers& x, FourNumbers& result) {
  constexpr double ln2 = 0.693147180559945309417, root_of_half = 0.70710678118654752440;
  constexpr std::int64_t fraction = 0xfffffffffffffLL, half = 0x3feLL << 52, whole = 0x433LL << 52;
  // the exponent becomes a double as the last bits of one of 2^52 and more
  const FourWords exponent = ((FourWords)x >> 52) | whole;
  FourNumbers k = (FourNumbers)exponent - (0x1.0p52 + 1022.0);
  FourNumbers m = (FourNumbers)(((FourWords)x & fraction) | half);  // in [1/2, 1)
  const FourWords low = m < root_of_half;
  m += (FourNumbers)((FourWords)m & low);
  k -= (FourNumbers)((FourWords)(FourNumbers{1.0, 1.0, 1.0, 1.0}) & low);
  const FourNumbers t = (m - 1.0) / (m + 1.0), s = t * t;
  const FourNumbers series = 1.0 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9))));
  result = k * ln2 + 2.0 * t * series;
}

}  // namespace bitrock::runtime
