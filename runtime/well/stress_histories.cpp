#include "runtime/well/stress_histories.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "runtime/drillstring/series_file.hpp"
#include "runtime/well/well_file.hpp"

namespace bitrock::runtime {

StressHistories read_stress_histories(const std::filesystem::path& path) {
  return read_stress_histories(base::Hdf5Reader(path));
}

StressHistories read_stress_histories(const base::Hdf5Reader& file) {
  file.require_format(well_format, well_format_version);
  StressHistories histories;
  histories.time = file.doubles("/series/time_s");
  require_rising(file, histories.time);
  histories.settling = file.number_attribute("settling_s");
  std::istringstream names(file.text_attribute("stress_points"));
  for (std::string name; std::getline(names, name);) histories.points.push_back({.name = name});
  const auto settled = std::upper_bound(histories.time.begin(), histories.time.end(), histories.settling);
  histories.joints = read_joints(file, static_cast<std::size_t>(histories.time.end() - settled));
  if (histories.points.empty()) return histories;
  const std::vector<double> depths = finite_array(file, "/stress/measured_depth_m", histories.points.size());
  for (std::size_t p = 0; p < histories.points.size(); ++p) {
    histories.points[p].measured_depth = depths[p];
    histories.points[p].stress = finite_array(file, fmt::format("/stress/point_{}_Pa", p + 1), histories.time.size());
  }
  return histories;
}

}  // namespace bitrock::runtime
