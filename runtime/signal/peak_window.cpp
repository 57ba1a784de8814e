#include "runtime/signal/peak_window.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace bitrock::runtime {

namespace {

ComponentDraw draw_component(PeakWindow& window, const peaks::PeakRates& statistics, double width,
                             double Peak::*component, double path_radius, const SignalSettings& settings,
                             const WindowKey& key) {
  ComponentDraw drawn;
  drawn.counts = count_peaks(statistics, path_radius * settings.window_angle, key);
  const auto count = static_cast<std::size_t>(drawn.counts.total());
  const double factor = width < 0.0 ? settings.pulse_width_factor : width;
  if (count == 0) return drawn;
  if (factor == 0.0) return {};  // a component without force

  const double half_width = factor * settings.window_angle / (2.0 * drawn.counts.expected());
  drawn.narrowed = half_width > settings.window_angle;
  drawn.half_width = std::min(half_width, settings.window_angle);
  std::array<double, largest_peak_count> heights;  // [N/m]
  drawn.fit = draw_amplitudes(statistics, drawn.counts, settings.amplitude_fit, key, std::span(heights.data(), count));
  while (window.peaks.size() < count) window.peaks.push_back({});  // never more than `largest_peak_count`
  for (std::size_t i = 0; i < count; ++i) window.peaks[i].*component = heights[i];
  return drawn;
}

}  // namespace

void draw_window(PeakWindow& window, const CutterStatistics& statistics, double path_radius,
                 const SignalSettings& settings, const WindowKey& key) {
  window.peaks.clear();
  window.x = draw_component(window, statistics.x, statistics.x_width, &Peak::x, path_radius, settings, key);
  window.y = draw_component(window, statistics.y, statistics.y_width, &Peak::y, path_radius, settings, key);
  for (std::size_t i = 0; i < window.peaks.size(); ++i) {
    window.peaks[i].angle = settings.window_angle * draw(key, static_cast<int>(i), DrawStream::angle);
  }
}

void put_pulses(const PeakWindow& window, double shift, double window_angle, PulseTrain& train) {
  const auto inverse = [](double half_width) { return half_width > 0.0 ? 1.0 / half_width : 0.0; };
  const double reach = std::max(window.x.half_width, window.y.half_width);
  for (const Peak& peak : window.peaks) {
    const double centre = peak.angle + shift;
    if (centre + reach <= 0.0 || centre - reach >= window_angle) continue;
    train.pulses.push_back({.begin = centre - reach,
                            .end = centre + reach,
                            .centre = centre,
                            .x = peak.x,
                            .y = peak.y,
                            .inverse_half_width_x = inverse(window.x.half_width),
                            .inverse_half_width_y = inverse(window.y.half_width)});
  }
}

}  // namespace bitrock::runtime
