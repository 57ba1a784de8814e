#pragma once
/// Random numbers that are the same on every machine: a standard engine (its sequence is fixed by the C++ standard)
/// with our own distributions (the library's differ between vendors).

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>
#include <utility>

namespace bitrock::base {

using Random = std::mt19937_64;  ///< the standard's generator: the same numbers on every machine

/// Uniform in [0, 1) with 53 random bits.
inline double uniform(Random& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

/// Uniform in [low, high).
inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * uniform(random);
}

/// Standard normal by the polar method of Marsaglia: no trigonometry, one value a call (the second is dropped
/// so that the stream does not depend on earlier calls).
double normal(Random& random);

/// Uniform integer in [0, count); the bias is below count / 2^53.
inline std::uint64_t below(Random& random, std::uint64_t count) {
  return static_cast<std::uint64_t>(uniform(random) * static_cast<double>(count));
}

/// Fisher-Yates shuffle in place.
template <class T>
void shuffle(Random& random, std::span<T> values) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(random, i)]);
}

/// One well-mixed 64-bit word from a key: the finaliser of SplitMix64 [SteeleLeaFlood2014]. Lets a draw be
/// addressed by (seed, cutter, window, ...) instead of by its place in a stream, so that it cannot depend on order.
inline std::uint64_t mix(std::uint64_t key) {
  key += 0x9e3779b97f4a7c15ULL;
  key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9ULL;
  key = (key ^ (key >> 27)) * 0x94d049bb133111ebULL;
  return key ^ (key >> 31);
}

/// Uniform in [0, 1) addressed by a chain of keys.
template <class... Keys>
double keyed_uniform(std::uint64_t seed, Keys... keys) {
  std::uint64_t state = mix(seed);
  ((state = mix(state ^ static_cast<std::uint64_t>(keys))), ...);
  return static_cast<double>(state >> 11) * 0x1.0p-53;
}

}  // namespace bitrock::base
