#include "report/gnuplot_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/gnuplot_text.hpp"

namespace bitrock::report {

namespace {

/// Distance of the labels of an axis: a round number that gives four to eight of them.
double label_step(const AxisRange& range) {
  const double least = (range.high - range.low) / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

/// 10 to the power of `exponent`, written out or as a power.
std::string power_of_ten(int exponent, bool written_out) {
  if (written_out || exponent == 0 || exponent == 1) return fmt::format("{:g}", std::pow(10.0, exponent));
  constexpr const char* digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

/// Labels of a logarithmic axis: whole decades, at most seven of them; powers where zeros would have to be counted.
std::string decades(char name, const AxisRange& range) {
  const int first = static_cast<int>(std::ceil(std::log10(range.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(range.high) + 1e-9));
  const int step = std::max(1, (last - first + 6) / 7);
  const bool written_out = first >= -3 && last <= 3;
  std::vector<std::string> labels;
  for (int exponent = first; exponent <= last; exponent += step)
    labels.push_back(fmt::format("'{}' 1e{}", power_of_ten(exponent, written_out), exponent));
  return labels.empty() ? fmt::format("set {}tics autofreq\n", name)
                        : fmt::format("set {}tics ({})\n", name, fmt::join(labels, ", "));
}

bool has_points(const Plot& plot) {
  return std::any_of(plot.series.begin(), plot.series.end(), [](const Series& series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) return true;
    }
    return false;
  });
}

}  // namespace

std::string axis(char name, const std::string& label, bool logarithmic, const std::optional<AxisRange>& range) {
  std::string text = fmt::format("set {}label {}\n", name, quoted(label));
  text += fmt::format("{} logscale {}\n", logarithmic ? "set" : "unset", name);
  text += range ? fmt::format("set {}range [{}:{}]\n", name, range->low, range->high)
                : fmt::format("set {}range [*:*]\n", name);
  if (!range) return text + fmt::format("set {}tics autofreq\n", name);
  return text + (logarithmic ? decades(name, *range) : fmt::format("set {}tics {:.4g}\n", name, label_step(*range)));
}

std::optional<AxisRange> range_of(const Plot& plot, const std::optional<AxisRange>& asked) {
  return !asked && !has_points(plot) ? AxisRange{1.0, 10.0} : asked;
}

std::string air(const Plot& plot) {
  constexpr double share = 0.04;
  const double x = plot.x_range ? 0.0 : share, y = plot.y_range ? 0.0 : share;
  return fmt::format("set offsets graph {0}, graph {0}, graph {1}, graph {1}\n", x, y);
}

}  // namespace bitrock::report
