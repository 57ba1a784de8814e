#include "views/drill/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "base/thin.hpp"

namespace bitrock::views {

namespace {

// A line over the whole time has its envelope drawn: some thousand stretches, one for each column of pixels.
constexpr std::size_t points_of_a_line = 5000;

}  // namespace

report::Colour colour_of_run(std::size_t run) {
  constexpr std::array<report::Colour, most_shown_runs> colours{report::Colour::blue,  report::Colour::vermillion,
                                                                report::Colour::green, report::Colour::purple,
                                                                report::Colour::sky,   report::Colour::orange};
  return colours[run % colours.size()];
}

std::vector<double> in_unit(const std::vector<double>& values, double unit, std::size_t first) {
  std::vector<double> shown;
  shown.reserve(values.size() - first);
  for (std::size_t i = first; i < values.size(); ++i) shown.push_back(values[i] / unit);
  return shown;
}

report::Series line_over_time(const std::vector<double>& time, const std::vector<double>& values, double unit,
                              std::size_t first) {
  const std::vector<double> y = in_unit(values, unit, first);
  report::Series line{.name = {}, .x = {}, .y = {}};
  for (const std::size_t i : base::envelope(y, points_of_a_line)) {
    line.x.push_back(time[first + i]);
    line.y.push_back(y[i]);
  }
  return line;
}

std::size_t first_later_than(const std::vector<double>& time, double instant) {
  return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end() - 1, instant) - time.begin());
}

std::size_t first_of_last(const std::vector<double>& time, double span) {
  const auto at = std::lower_bound(time.begin(), time.end() - 2, time.back() - span);
  return static_cast<std::size_t>(at - time.begin());
}

std::vector<std::string> labels_of(const std::vector<std::string>& names) {
  std::vector<std::string> stems, labels;
  for (const std::string& name : names) stems.push_back(std::filesystem::path(name).stem().string());
  for (std::size_t k = 0; k < names.size(); ++k)
    labels.push_back(std::count(stems.begin(), stems.end(), stems[k]) == 1 ? stems[k] : names[k]);
  return labels;
}

base::Spectrum spectrum_of(const std::vector<double>& values, double unit, std::size_t first, double sample,
                           double segment_s) {
  const double rate = 1.0 / sample;
  const std::size_t segment = base::quick_length(static_cast<std::size_t>(segment_s * rate * (1.0 + 1e-9)));
  return base::welch(in_unit(values, unit, first), rate, std::max(segment, base::least_segment));
}

std::string welch_words(const base::Spectrum& spectrum) {
  return fmt::format(
      "Power spectral densities by Welch's method: {} segments of {:.3g} s, Hann window, half overlap, mean removed; "
      "a value of a noise scatters by {:.0f} %. Their area is the variance.",
      spectrum.segments, 1.0 / spectrum.frequency[1], 100.0 * spectrum.relative_deviation);
}

}  // namespace bitrock::views
