#pragma once
/// Passes over all samples at the speed of memory, and the loop over peaks on top of them; find_peaks.hpp says what a
/// peak is. A pass answers one bit a sample, 64 samples a word, so that what follows looks only at the few samples that
/// matter and no branch has to be guessed for the others. Bit k of word w belongs to sample begin + 64 w + k.
/// Nothing but comparisons is done, so all vector units give the same bits. For the files of this module.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace bitrock::peaks {

inline constexpr std::size_t word_samples = 64;  ///< samples in a word [1]
/// The words of one call: 2048 samples, so that they are still in the first cache when the peaks among them are read.
using BitBlock = std::array<std::uint64_t, 32>;
inline constexpr std::size_t block_samples =
    word_samples * std::tuple_size_v<BitBlock>;  ///< samples that are looked at together

/// The highest finite sample; 0 when none is positive.
double highest_finite(std::span<const double> signal);

/// Samples from `begin` on, not the first of the signal, that may be peaks: higher than their left neighbour and than
/// `minimum_height`, and not lower than their right neighbour; also those that are +infinity. A comparison with a NaN
/// is false, and beyond the last sample there is one. Fills at most one block; returns the number of words with
/// samples.
std::size_t find_candidates(std::span<const double> signal, std::size_t begin, double minimum_height, BitBlock& block);

/// Samples from `begin` on that are at most `height`; a NaN is not. Otherwise as above.
std::size_t find_at_most(std::span<const double> signal, std::size_t begin, double height, BitBlock& block);

/// Whether the signal falls after the run of equal samples that begins at i. Candidates begin their runs, so all calls
/// of a pass together look at each sample once.
inline bool falls_after(std::span<const double> signal, std::size_t i) {
  std::size_t end = i + 1;
  while (end < signal.size() && signal[end] == signal[i]) ++end;
  return end < signal.size() && signal[end] < signal[i];
}

/// Calls `take(i)` for each peak in order of occurrence.
template <class Take>
void for_each_peak(std::span<const double> signal, double minimum_height, const Take& take) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!signal.empty() && signal[0] == infinity) take(std::size_t{0});
  BitBlock block;
  for (std::size_t begin = 1; begin < signal.size(); begin += block_samples) {
    const std::size_t words = find_candidates(signal, begin, minimum_height, block);
    for (std::size_t w = 0; w < words; ++w) {
      for (std::uint64_t bits = block[w]; bits != 0; bits &= bits - 1) {  // clears the lowest bit
        const std::size_t i = begin + word_samples * w + static_cast<std::size_t>(std::countr_zero(bits));
        if (signal[i] == infinity || falls_after(signal, i)) take(i);
      }
    }
  }
}

}  // namespace bitrock::peaks
