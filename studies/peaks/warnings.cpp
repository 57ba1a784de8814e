// What is odd about a force history although its peaks are counted.
#include <fmt/format.h>

#include "base/csv.hpp"
#include "studies/peaks/force_history.hpp"

namespace bitrock::studies {

std::string unit_of(const std::string& column) {
  for (const auto& [ending, unit] : {std::pair{"_N_per_m", " N/m"}, std::pair{"_N_m", " N m"}, std::pair{"_N", " N"}}) {
    if (column.ends_with(ending)) return unit;
  }
  return "";
}

std::vector<std::string> warnings(const ForceHistory& history, const ForceFindings& found) {
  std::vector<std::string> all;
  if (found.mean < 0.0) {
    all.push_back(
        fmt::format("the mean of {} is {:.4g}{}, below 0: the rock's resistance to the cutter and its push out of the "
                    "rock are positive here; is the sign of this column the other way round?",
                    history.column, found.mean, unit_of(history.column)));
  }
  if (history.time_column.empty() && !history.other_columns.empty()) {
    all.push_back(
        fmt::format("no column time_s: {}; the five numbers are the same (name the times with --time; there are: {})",
                    without_times, base::listed(history.other_columns)));
  }
  for (const auto& [what, count] : {std::pair{"not numbers", found.not_a_number}, {"infinite", found.infinite}}) {
    if (count == 0) continue;
    all.push_back(
        fmt::format("samples that are {}: {} (neither they nor their neighbours are counted as peaks)", what, count));
  }
  if (!found.even) {
    all.push_back(
        fmt::format("{} is not evenly spaced: zero-force shares are of samples, not of time", history.time_column));
  }
  return all;
}

}  // namespace bitrock::studies
