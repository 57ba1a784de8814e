#include "runtime/drillstring/series_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace bitrock::runtime {

std::vector<double> finite_array(const base::Hdf5Reader& file, const std::string& path, std::size_t count) {
  std::vector<double> values = file.doubles(path);
  if (values.size() != count)
    throw base::InputError(fmt::format("{}: {} has {} values (must have {})", file.name(), path, values.size(), count));
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (bad != values.end())
    throw base::InputError(
        fmt::format("{}: {}[{}] = {} (must be finite)", file.name(), path, bad - values.begin(), *bad));
  return values;
}

void require_rising(const base::Hdf5Reader& file, const std::vector<double>& time) {
  if (time.size() < 2)
    throw base::InputError(fmt::format("{}: {} samples (a run has at least 2)", file.name(), time.size()));
  const auto stuck = std::adjacent_find(time.begin(), time.end(), [](double a, double b) { return !(a < b); });
  if (stuck != time.end())
    throw base::InputError(
        fmt::format("{}: /series/time_s goes from {} to {} s (must go up)", file.name(), *stuck, *std::next(stuck)));
}

}  // namespace bitrock::runtime
