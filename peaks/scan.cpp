// The passes, compiled once for AVX-512, AVX2 and plain code; the best is chosen when the program runs.
#include "peaks/scan.hpp"

#include <algorithm>

// clang-format off: the order matters
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)  // what lies between them is not worth its code
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "peaks/scan.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace bitrock::peaks::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;  // the answers of one vector fit into a byte
using Vector = hn::Vec<D>;
constexpr std::size_t lanes = hn::MaxLanes(D());

double HighestFinite(const double* samples, std::size_t count) {
  constexpr std::size_t chains = 4;  // that do not wait for each other
  constexpr double beyond = std::numeric_limits<double>::infinity();
  const Vector infinity = hn::Set(D(), beyond);
  Vector chain[chains];
  for (Vector& highest : chain) highest = hn::Zero(D());
  std::size_t i = 0;
  for (; i + chains * lanes <= count; i += chains * lanes) {
    for (std::size_t k = 0; k < chains; ++k) {
      const Vector value = hn::LoadU(D(), samples + i + k * lanes);
      chain[k] = hn::Max(chain[k], hn::IfThenElseZero(hn::Lt(value, infinity), value));  // 0 in place of a NaN
    }
  }
  double highest = hn::GetLane(hn::MaxOfLanes(D(), hn::Max(hn::Max(chain[0], chain[1]), hn::Max(chain[2], chain[3]))));
  for (; i < count; ++i) {
    if (samples[i] < beyond) highest = std::max(highest, samples[i]);
  }
  return highest;
}

/// The answers of `test` to 64 samples.
template <class Test>
HWY_INLINE std::uint64_t Word(const double* samples, const Test& test) {
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < 64; k += lanes) {
    std::uint8_t answers[8] = {};
    hn::StoreMaskBits(D(), test(samples + k), answers);
    word |= static_cast<std::uint64_t>(answers[0]) << k;
  }
  return word;
}

void Candidates(const double* samples, std::size_t words, double minimum_height, std::uint64_t* bits) {
  const Vector height = hn::Set(D(), minimum_height);
  const Vector infinity = hn::Set(D(), std::numeric_limits<double>::infinity());
  const auto test = [&](const double* sample) HWY_ATTR {
    const Vector value = hn::LoadU(D(), sample);
    const auto rises = hn::And(hn::Lt(hn::LoadU(D(), sample - 1), value), hn::Lt(height, value));
    return hn::Or(hn::And(rises, hn::Le(hn::LoadU(D(), sample + 1), value)), hn::Eq(value, infinity));
  };
  for (std::size_t w = 0; w < words; ++w) bits[w] = Word(samples + 64 * w, test);
}

void AtMost(const double* samples, std::size_t words, double height, std::uint64_t* bits) {
  const Vector limit = hn::Set(D(), height);
  const auto test = [&](const double* sample) HWY_ATTR { return hn::Le(hn::LoadU(D(), sample), limit); };
  for (std::size_t w = 0; w < words; ++w) bits[w] = Word(samples + 64 * w, test);
}

}  // namespace bitrock::peaks::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bitrock::peaks {

HWY_EXPORT(HighestFinite);
HWY_EXPORT(Candidates);
HWY_EXPORT(AtMost);

namespace {

/// A word of samples from `begin` on between their neighbours, with NaN where the signal has none.
using Padded = std::array<double, 1 + word_samples + 1>;

Padded padded(std::span<const double> signal, std::size_t begin) {
  Padded copy;
  copy.fill(std::numeric_limits<double>::quiet_NaN());
  if (begin > 0) copy[0] = signal[begin - 1];
  const std::span<const double> rest = signal.subspan(begin);
  std::copy_n(rest.begin(), std::min(rest.size(), word_samples + 1), copy.begin() + 1);
  return copy;
}

/// Words whose right neighbour is there come straight from the signal, the last one from a padded copy.
template <class Pass>
std::size_t word_by_word(std::span<const double> signal, std::size_t begin, BitBlock& block, const Pass& pass) {
  if (begin >= signal.size()) return 0;
  const std::size_t whole = std::min((signal.size() - begin - 1) / word_samples, block.size());
  pass(signal.data() + begin, whole, block.data());
  if (whole == block.size()) return whole;
  const Padded last = padded(signal, begin + whole * word_samples);
  pass(last.data() + 1, 1, block.data() + whole);
  return whole + 1;
}

}  // namespace

double highest_finite(std::span<const double> signal) {
  return HWY_DYNAMIC_DISPATCH(HighestFinite)(signal.data(), signal.size());
}

std::size_t find_candidates(std::span<const double> signal, std::size_t begin, double minimum_height, BitBlock& block) {
  return word_by_word(signal, begin, block, [&](const double* samples, std::size_t words, std::uint64_t* bits) {
    HWY_DYNAMIC_DISPATCH(Candidates)(samples, words, minimum_height, bits);
  });
}

std::size_t find_at_most(std::span<const double> signal, std::size_t begin, double height, BitBlock& block) {
  return word_by_word(signal, begin, block, [&](const double* samples, std::size_t words, std::uint64_t* bits) {
    HWY_DYNAMIC_DISPATCH(AtMost)(samples, words, height, bits);
  });
}

}  // namespace bitrock::peaks
#endif
