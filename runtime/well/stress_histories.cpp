#include "runtime/well/stress_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "runtime/well/well_file.hpp"

namespace bitrock::runtime {

namespace {

std::vector<double> finite_array(const base::Hdf5Reader& file, const std::string& path, std::size_t count) {
  std::vector<double> values = file.doubles(path);
  const bool finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (values.size() == count && finite) return values;
  throw base::InputError(fmt::format("{}: {} has {} values{} (must have {} finite ones)", file.name(), path,
                                     values.size(), finite ? "" : ", not all finite", count));
}

}  // namespace

StressHistories read_stress_histories(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  file.require_format(well_format, well_format_version);
  StressHistories histories;
  histories.time = file.doubles("/series/time_s");
  const auto stuck = std::adjacent_find(histories.time.begin(), histories.time.end(),
                                        [](double before, double after) { return !(before < after); });
  if (histories.time.size() < 2 || stuck != histories.time.end())
    throw base::InputError(fmt::format("{}: /series/time_s (must have at least 2 values, rising)", file.name()));
  histories.settling = file.number_attribute("settling_s");
  std::istringstream names(file.text_attribute("stress_points"));
  for (std::string name; std::getline(names, name);) histories.points.push_back({.name = name});
  if (histories.points.empty()) return histories;
  const std::vector<double> depths = finite_array(file, "/stress/measured_depth_m", histories.points.size());
  for (std::size_t p = 0; p < histories.points.size(); ++p) {
    histories.points[p].measured_depth = depths[p];
    histories.points[p].stress = finite_array(file, fmt::format("/stress/point_{}_Pa", p + 1), histories.time.size());
  }
  return histories;
}

}  // namespace bitrock::runtime
