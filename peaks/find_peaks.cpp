#include "peaks/find_peaks.hpp"

#include "peaks/scan.hpp"

namespace bitrock::peaks {

std::vector<std::size_t> find_peaks(std::span<const double> signal, double minimum_height) {
  std::vector<std::size_t> found;
  found.reserve(signal.size() / 8);  // growing would cost more than finding; what is not used is never touched
  for_each_peak(signal, minimum_height, [&found](std::size_t i) { found.push_back(i); });
  return found;
}

}  // namespace bitrock::peaks
