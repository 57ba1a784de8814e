#include "report/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/errors.hpp"

namespace bitrock::report {

namespace {

[[noreturn]] void refuse(const Plot& plot, const std::string& why) {
  throw base::InputError(fmt::format("plot '{}': {}", plot.title, why));
}

void check_length(const Plot& plot, const Series& series, const char* what, std::size_t length) {
  if (length == series.x.size()) return;
  refuse(plot, fmt::format("series '{}': {} has {} values (x has {}; both must be of one length)", series.name, what,
                           length, series.x.size()));
}

void check_series(const Plot& plot, const Series& series) {
  check_length(plot, series, "y", series.y.size());
  if (!series.error_x.empty()) check_length(plot, series, "error_x", series.error_x.size());
  if (!series.error_y.empty()) check_length(plot, series, "error_y", series.error_y.size());
  if (!series.labels.empty()) check_length(plot, series, "labels", series.labels.size());
  if (series.style == Style::band || !series.upper.empty()) {
    check_length(plot, series, "upper", series.upper.size());
  }
  if (series.style != Style::band && !series.upper.empty()) {
    refuse(plot, fmt::format("series '{}': an upper edge is given (only a band has one)", series.name));
  }
}

void check_limits(const Plot& plot, const char* what, double low, double high, bool logarithmic) {
  if (!(std::isfinite(low) && std::isfinite(high) && low < high)) {
    refuse(plot, fmt::format("{} from {} to {} (must be finite and go upwards)", what, low, high));
  }
  if (logarithmic && low <= 0.0) {
    refuse(plot, fmt::format("{} from {} to {} (must be above 0 on a logarithmic axis)", what, low, high));
  }
}

void share(std::span<Plot> plots, std::vector<double> Series::*values, std::optional<AxisRange> Plot::*range) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Plot& plot : plots) {
    for (const Series& series : plot.series) {
      for (const double value : series.*values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  if (low > high) return;
  constexpr double part = 0.05, least = 1e-9;  // of the spread; where all is one value, of that value
  const double air = high > low ? part * (high - low) : std::max(least, part * std::abs(high));
  for (Plot& plot : plots) plot.*range = AxisRange{low - air, high + air};
}

}  // namespace

void check(const Plot& plot) {
  for (const Series& series : plot.series) check_series(plot, series);
  for (const HorizontalBand& band : plot.bands) {
    check_limits(plot, "band", band.low, band.high, plot.log_y);
  }
  if (plot.x_range) check_limits(plot, "x axis", plot.x_range->low, plot.x_range->high, plot.log_x);
  if (plot.y_range) check_limits(plot, "y axis", plot.y_range->low, plot.y_range->high, plot.log_y);
  if (!(plot.height_px > 0.0)) refuse(plot, fmt::format("height_px = {} (must be above 0)", plot.height_px));
}

void share_x_axis(std::span<Plot> plots) {
  share(plots, &Series::x, &Plot::x_range);
}

void share_y_axis(std::span<Plot> plots) {
  share(plots, &Series::y, &Plot::y_range);
}

std::string colour_code(Colour colour, std::size_t index) {
  // The hues of [OkabeIto2008] without its yellow, which is lost on white paper; grey and black come from the page.
  constexpr std::array<const char*, 8> codes{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#56b4e9", "#e69f00", "#6b7280", "#1d2733"};
  constexpr std::size_t hues = 6;
  if (colour == Colour::automatic) return codes[index % hues];
  return codes[static_cast<std::size_t>(colour) - 1];
}

}  // namespace bitrock::report
