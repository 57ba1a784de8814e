#include "peaks/find_peaks.hpp"

#include <cmath>

namespace peaks {

std::vector<std::size_t> find_peaks(std::span<const double> signal, double minimum_height) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const auto seen = [&signal](std::size_t i) { return signal[i] == infinity ? not_a_number : signal[i]; };

  std::vector<std::size_t> found;
  std::size_t i = 0;
  while (i < signal.size()) {
    if (signal[i] == infinity) {
      found.push_back(i++);
      continue;
    }
    // Comparisons with NaN are false, so a NaN on either side rules a peak out.
    if (i == 0 || !(seen(i - 1) < signal[i])) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;  // one past the run of equal samples
    while (end < signal.size() && signal[end] == signal[i]) ++end;
    if (end < signal.size() && seen(end) < signal[i] && signal[i] > minimum_height) found.push_back(i);
    i = end;
  }
  return found;
}

}  // namespace peaks
