#include "report/spectrum_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bitrock::report {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// Of a plot without data.
constexpr AxisRange nothing{0.1, 10.0};

AxisRange density_range(std::span<const SpectrumLine> lines, double decades) {
  double low = infinite, high = 0.0;
  for (const SpectrumLine& line : lines) {
    for (std::size_t j = 1; j < line.spectrum.density.size(); ++j) {
      const double value = line.spectrum.density[j];
      if (value > 0.0) low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (high == 0.0) return nothing;
  constexpr double air = 0.05;  // decades over the highest value, at least
  const double top = std::ceil(std::log10(high) + air), bottom = std::floor(std::log10(low));
  return {std::pow(10.0, std::max(bottom, top - decades)), std::pow(10.0, top)};
}

AxisRange frequency_range(std::span<const SpectrumLine> lines) {
  double low = infinite, high = 0.0;
  for (const SpectrumLine& line : lines) {
    if (line.spectrum.frequency.size() < 2) continue;
    low = std::min(low, line.spectrum.frequency[1]);
    high = std::max(high, line.spectrum.frequency.back());
  }
  return low < high ? AxisRange{low, high} : nothing;
}

bool same_marks(const SpectrumLine& a, const SpectrumLine& b) {
  constexpr double share = 1e-6;  // far below what a plot can show
  return std::equal(a.marks.begin(), a.marks.end(), b.marks.begin(), b.marks.end(),
                    [](double x, double y) { return std::abs(x - y) <= share * std::max(x, y); });
}

/// Lines from the bottom to the top of the plot, with gaps between them.
Series upright(const SpectrumLine& line, const std::string& name, Colour colour, const Plot& plot) {
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  Series marks{.name = name, .x = {}, .y = {}, .style = Style::dashed, .colour = colour};
  for (const double frequency : line.marks) {
    if (frequency <= plot.x_range->low || frequency >= plot.x_range->high) continue;
    marks.x.insert(marks.x.end(), {frequency, frequency, gap});
    marks.y.insert(marks.y.end(), {plot.y_range->low, plot.y_range->high, gap});
  }
  return marks;
}

Series density(const SpectrumLine& line) {
  Series series{.name = line.name, .x = {}, .y = {}, .colour = line.colour};
  for (std::size_t j = 1; j < line.spectrum.density.size(); ++j) {
    if (line.spectrum.density[j] <= 0.0) continue;
    series.x.push_back(line.spectrum.frequency[j]);
    series.y.push_back(line.spectrum.density[j]);
  }
  return series;
}

}  // namespace

Plot spectrum_plot(std::string title, std::string density_label, const std::string& marks_name,
                   std::span<const SpectrumLine> lines, double decades) {
  Plot plot{.title = std::move(title),
            .x_label = "frequency [Hz]",
            .y_label = std::move(density_label),
            .log_x = true,
            .log_y = true,
            .x_range = frequency_range(lines),
            .y_range = density_range(lines, decades)};
  const bool common = std::all_of(lines.begin(), lines.end(),
                                  [&](const SpectrumLine& line) { return same_marks(line, lines.front()); });
  for (const SpectrumLine& line : common ? lines.first(std::min<std::size_t>(1, lines.size())) : lines) {
    Series marks = common ? upright(line, marks_name, Colour::grey, plot)
                          : upright(line, marks_name + ", " + line.name, line.colour, plot);
    if (!marks.x.empty()) plot.series.push_back(std::move(marks));
  }
  for (const SpectrumLine& line : lines) plot.series.push_back(density(line));
  return plot;
}

}  // namespace bitrock::report
