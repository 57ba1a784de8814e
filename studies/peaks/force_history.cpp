#include "studies/peaks/force_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/specimen/grading.hpp"

namespace bitrock::studies {

namespace {

/// What is asked for.
struct Wish {
  std::string file, column, time;
};

ForceHistory from_hdf5(const Wish& wish) {
  if (!wish.time.empty()) {
    throw base::InputError(fmt::format("--time {} (a run file has its own times; --time is for CSV)", wish.time));
  }
  const base::Hdf5Reader file(wish.file);
  ForceHistory history;
  history.column = wish.column.empty() ? "x_N_per_m" : wish.column;
  const std::string path = history.column.front() == '/' ? history.column : "/force/" + history.column;
  if (!file.has(path)) {
    throw base::InputError(fmt::format("{}: no {} (a run has x_N_per_m and y_N_per_m)", wish.file, history.column));
  }
  history.force = file.doubles(path);
  if (file.has("/force/time_s")) {
    history.time_column = "time_s";
    history.time = file.doubles("/force/time_s");
  }
  if (file.has_attribute("cut_length_m") && file.has_attribute("config_toml") && !history.force.empty()) {
    const dem2d::CutCase cut = dem2d::parse_resolved(file.text_attribute("config_toml"), wish.file);
    history.spacing = file.number_attribute("cut_length_m") / static_cast<double>(history.force.size());
    history.mean_diameter = dem2d::mean_diameter(cut.rock);
  }
  return history;
}

/// Times are in seconds. A column whose name ends in another unit of time is not taken for them.
void require_seconds(const std::string& column) {
  const std::string name =
      column.ends_with(')') || column.ends_with(']') ? column.substr(0, column.size() - 1) : column;
  for (const char* unit : {"ms", "us", "\xc2\xb5s", "\xce\xbcs", "ns", "min", "h", "msec", "minutes", "hours"}) {
    for (const char* before : {"_", " ", "(", "["}) {
      if (!name.ends_with(std::string(before) + unit)) continue;
      throw base::InputError(
          fmt::format("--time '{}' (a time must be in seconds; this one seems to be in {})", column, unit));
    }
  }
}

/// The force that is asked for, or the only one that there is.
std::string force_column(const base::CsvTable& table, const Wish& wish, const std::string& time) {
  if (!wish.column.empty()) return wish.column;
  std::vector<std::string> forces;
  for (const std::string& name : table.names) {
    if (name != time) forces.push_back(name);
  }
  if (forces.size() == 1) return forces.front();
  throw base::InputError(fmt::format("{}: which column? (choose with --column: {})", wish.file,
                                     forces.empty() ? "there is none beside the time" : base::listed(forces)));
}

ForceHistory from_csv(const Wish& wish) {
  const base::CsvTable table = base::read_csv(wish.file, true);  // a NaN is a sample that is missing
  const auto require = [&](const char* what, const std::string& name) {
    if (table.has(name)) return;
    throw base::InputError(
        fmt::format("{}: no {} {} (there are: {})", wish.file, what, name, base::listed(table.names)));
  };
  ForceHistory history;
  if (!wish.time.empty()) {
    require("time column", wish.time);
    require_seconds(wish.time);
    history.time_column = wish.time;
  } else if (table.has("time_s")) {
    history.time_column = "time_s";
  }
  history.column = force_column(table, wish, history.time_column);
  require("column", history.column);
  if (history.column == history.time_column) {
    throw base::InputError(fmt::format("--column and --time are both {} (must be two columns)", history.column));
  }
  history.force = table.column(history.column);
  if (!history.time_column.empty()) history.time = table.column(history.time_column);
  for (const std::string& name : table.names) {
    if (name != history.column && name != history.time_column) history.other_columns.push_back(name);
  }
  return history;
}

/// A time axis by which parts can be told: whole, finite, and never falling.
void require_good_time(const ForceHistory& history, const std::string& file) {
  const std::vector<double>& time = history.time;
  if (time.size() != history.force.size()) {
    throw base::InputError(
        fmt::format("{}: {} values in {} but {} times", file, history.force.size(), history.column, time.size()));
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!std::isfinite(time[i])) {
      throw base::InputError(
          fmt::format("{}: {} of sample {} is {} (must be a finite number)", file, history.time_column, i, time[i]));
    }
    if (i > 0 && time[i] < time[i - 1]) {
      throw base::InputError(fmt::format("{}: {} falls from {} to {} at sample {} (must rise)", file,
                                         history.time_column, time[i - 1], time[i], i));
    }
  }
  if (time.size() > 1 && !(time.back() > time.front())) {
    throw base::InputError(
        fmt::format("{}: {} is {} in all samples (must rise)", file, history.time_column, time.front()));
  }
}

/// No force and no time is that large; sums of a billion of them are still finite.
constexpr double largest_value = 1e100;

void refuse_huge(const std::vector<double>& values, const std::string& name, const std::string& file) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || std::abs(values[i]) <= largest_value) continue;
    throw base::InputError(
        fmt::format("{}: {} of sample {} is {} (must be at most {:g})", file, name, i, values[i], largest_value));
  }
}

void require_good(const ForceHistory& history, const Wish& wish) {
  const std::vector<double>& force = history.force;
  refuse_huge(force, history.column, wish.file);
  refuse_huge(history.time, history.time_column, wish.file);
  if (std::all_of(force.begin(), force.end(), [](double value) { return std::isnan(value); })) {
    throw base::InputError(fmt::format("{}: no number in {}", wish.file, history.column));
  }
  if (!history.time.empty()) require_good_time(history, wish.file);
}

/// Mean distance of samples [s]; NaN without times.
double mean_spacing(const std::vector<double>& time) {
  if (time.size() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (time.back() - time.front()) / static_cast<double>(time.size() - 1);
}

/// Whether shares of samples are shares of time: no sample is farther from its place than one spacing.
bool evenly_spaced(const std::vector<double>& time) {
  const double spacing = mean_spacing(time);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::abs(time[i] - time.front() - spacing * static_cast<double>(i)) > spacing) return false;
  }
  return true;
}

/// 0 where no sample is finite.
double mean_of_finite(const std::vector<double>& values) {
  double mean = 0.0, count = 0.0;
  for (const double value : values) {
    if (std::isfinite(value)) mean += (value - mean) / ++count;
  }
  return mean;
}

}  // namespace

ForceHistory read_force_history(const std::string& file, const std::string& column, const std::string& time) {
  const Wish wish{.file = file, .column = column, .time = time};
  const bool hdf5 = file.ends_with(".h5") || file.ends_with(".hdf5");
  ForceHistory history = hdf5 ? from_hdf5(wish) : from_csv(wish);
  require_good(history, wish);
  return history;
}

ForceFindings find_in(const ForceHistory& history, int parts, const peaks::Selection& selection) {
  const std::vector<double>& force = history.force;
  ForceFindings findings;
  findings.all = peaks::peak_statistics(force, selection);
  findings.zero = peaks::zero_force(force, peaks::minimum_height(force));
  findings.parts = peaks::statistics_by_part(
      force,
      history.time.size() > 1 ? peaks::part_borders(history.time, parts) : peaks::part_borders(force.size(), parts),
      selection);
  findings.not_a_number = force.size() - findings.zero.samples;
  findings.infinite =
      static_cast<std::size_t>(std::count(force.begin(), force.end(), std::numeric_limits<double>::infinity()));
  findings.mean_period = findings.zero.mean_period() * mean_spacing(history.time);
  findings.even = evenly_spaced(history.time);
  findings.mean = mean_of_finite(force);
  return findings;
}

peaks::Selection apply(const PeakWish& wish, ForceHistory& history, const std::string& file) {
  peaks::PeakDefinition definition;  // lengths in samples
  if (wish.converging) {
    if (history.spacing == 0.0) {
      throw base::InputError(fmt::format(
          "{}: neither the travel between samples nor the size of the grains is known (--definition converging is for "
          "run files; for other histories give --smoothing and --min-prominence)",
          file));
    }
    definition = peaks::converging(history.mean_diameter);
    definition.smoothing /= history.spacing;
  }
  if (wish.smoothing > 0.0) definition.smoothing = wish.smoothing;
  if (wish.min_prominence > 0.0) definition.min_prominence = wish.min_prominence;
  definition.min_distance = wish.min_distance;
  peaks::PeakSearch search = peaks::prepared(history.force, 1.0, definition);
  history.force = std::move(search.signal);
  return search.selection;
}

}  // namespace bitrock::studies
