#include "surrogate/train/unit_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bitrock::surrogate {

namespace {

/// Smallest and largest number of a column.
struct Span {
  double low = 0.0, high = 0.0;

  /// "0.3" or "0.3 to 1.2".
  std::string text() const {
    return low == high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
  }
};

/// Over the rows for which `value` gives a number above 0; both 0 when there is none.
template <class Value>
Span span_of(const TrainingData& data, const Value& value) {
  Span span;
  for (const TrainingRow& row : data.rows) {
    const double v = value(row);
    if (!(v > 0.0)) continue;
    span.low = span.low == 0.0 ? v : std::min(span.low, v);
    span.high = std::max(span.high, v);
  }
  return span;
}

/// What cuts of rock have, far beyond what a rig or a model of one does.
constexpr double fastest = 5.0;                           // [m/s] gauge of a 12 1/4 in bit at 300 rpm
constexpr double shallowest = 0.01, deepest = 100.0;      // [mm]
constexpr double longest = 10.0;                          // [m]
constexpr double least_energy = 1e6, most_energy = 1e10;  // [J/m3] chalk; above the strength of any mineral

/// Mean height of the peaks along the cut over the depth: the specific energy, as far as a slip of units is concerned.
std::string energy_slip(const TrainingData& data) {
  constexpr std::size_t depth = 1, mean_height = 1;
  const Span energy =
      span_of(data, [](const TrainingRow& row) { return row.outputs[mean_height] / (row.inputs[depth] * 1e-3); });
  if (energy.high == 0.0) return "";
  const Span shown{energy.low * 1e-6, energy.high * 1e-6};
  if (energy.high < least_energy) {
    return fmt::format(
        "{}: x_amean_N_per_m over depth_of_cut_mm is {} MPa in all rows (rocks need 1 MPa or more): are the forces in "
        "N (divide them by the width of the cutter in metres), in kN or in kN/m?",
        data.file, shown.text());
  }
  if (energy.low > most_energy) {
    return fmt::format(
        "{}: x_amean_N_per_m over depth_of_cut_mm is {} MPa in all rows (no rock bears 10000 MPa): are the forces "
        "divided by the width of the cutter in metres, and are the depths in mm?",
        data.file, shown.text());
  }
  return "";
}

/// The same counts in all rows are none that were counted.
std::string counts_slip(const TrainingData& data) {
  constexpr std::size_t fewest = 3;  // rows: two cuts may agree
  const TrainingRow& first = data.rows.front();
  if (data.rows.size() < fewest) return "";
  std::string seen;
  for (std::size_t i = 0; i < first.outputs.size(); ++i) {
    if (!is_count(i)) continue;
    const double count = first.outputs[i] * first.cut_length;
    for (const TrainingRow& row : data.rows) {
      if (std::abs(row.outputs[i] * row.cut_length - count) > 1e-6 * std::max(1.0, count)) return "";
    }
    seen += fmt::format("{}{:.6g}", seen.empty() ? "" : ", ", count);
  }
  return fmt::format(
      "{}: the peak counts of all rows are the same ({}): were they counted? (the force on a bit is rebuilt from them; "
      "`bitrock peaks` counts them in the record of a cut)",
      data.file, seen);
}

}  // namespace

std::vector<std::string> unit_slips(const TrainingData& data) {
  std::vector<std::string> all;
  const auto doubt = [&](std::size_t input, const Span& seen, const std::string& why) {
    all.push_back(fmt::format("{}: {} is {} in all rows ({})", data.file, input_names[input].name, seen.text(), why));
  };
  const Span speed = span_of(data, [](const TrainingRow& row) { return row.inputs[0]; });
  const Span depth = span_of(data, [](const TrainingRow& row) { return row.inputs[1]; });
  const Span rake = span_of(data, [](const TrainingRow& row) { return std::abs(row.inputs[2]); });
  const Span length = span_of(data, [](const TrainingRow& row) { return row.cut_length; });
  if (speed.low > fastest) {
    doubt(0, speed, "cutters on a bit move at 5 m/s or less: are these m/min (divide by 60) or mm/s (divide by 1000)?");
  }
  if (depth.high < shallowest) doubt(1, depth, "cuts are 0.01 mm or deeper: are these metres (multiply by 1000)?");
  if (depth.low > deepest) doubt(1, depth, "cuts are 100 mm deep at most: are these um (divide by 1000)?");
  if (rake.high > 0.0 && rake.high < 1.0) {
    doubt(2, rake, "cutters lean back by 5 to 40 degrees: are these radians (multiply by 57.3)?");
  }
  if (length.low > longest) {
    all.push_back(fmt::format("{}: cut_length_m is {} in all rows (cuts are 10 m long at most: are these mm?)",
                              data.file, length.text()));
  }
  const bool depths_are_right = depth.high >= shallowest && depth.low <= deepest;
  for (const std::string& slip : {depths_are_right ? energy_slip(data) : std::string(), counts_slip(data)}) {
    if (!slip.empty()) all.push_back(slip);
  }
  return all;
}

}  // namespace bitrock::surrogate
