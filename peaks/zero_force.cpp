#include "peaks/zero_force.hpp"

#include <bit>
#include <limits>

#include "peaks/scan.hpp"

namespace bitrock::peaks {

namespace {

std::size_t ones(const BitBlock& block, std::size_t words) {
  std::size_t count = 0;
  for (std::size_t w = 0; w < words; ++w) count += static_cast<std::size_t>(std::popcount(block[w]));
  return count;
}

}  // namespace

ZeroForce zero_force(std::span<const double> signal, double least_height) {
  ZeroForce zero;
  BitBlock block;
  std::uint64_t before = 0;  // whether the sample before the word is quiet
  for (std::size_t begin = 0; begin < signal.size(); begin += block_samples) {
    std::size_t words = find_at_most(signal, begin, std::numeric_limits<double>::infinity(), block);
    zero.samples += ones(block, words);
    words = find_at_most(signal, begin, 0.0, block);
    zero.not_positive += ones(block, words);
    words = find_at_most(signal, begin, least_height, block);
    zero.quiet += ones(block, words);
    for (std::size_t w = 0; w < words; ++w) {
      const std::uint64_t quiet = block[w], first_of_run = quiet & ~(quiet << 1 | before);
      zero.periods += static_cast<std::size_t>(std::popcount(first_of_run));
      before = quiet >> 63;
    }
  }
  return zero;
}

}  // namespace bitrock::peaks
