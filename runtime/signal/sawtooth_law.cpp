#include "runtime/signal/sawtooth_law.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/signal/rise_lengths.hpp"

namespace bitrock::runtime {

namespace {

constexpr double square_of_step = 181.0 / 462.0;  ///< I2
constexpr double countless = 1e100;               ///< keeps products of absurd moments finite
constexpr double apart = 1.0 + 1e-9;              ///< so that rounding does not let a pulse reach beyond a cell

double wanted(double moment) {
  return std::clamp(moment, 0.0, countless);
}

/// lambda and a of one component: pulses per length, height.
struct Component {
  double density = 0.0, height = 0.0;
};

Component component(double mean, double sd, double mean_length, double cell, DrawTally& tally) {
  if (!(mean > 0.0)) return {};
  ++tally.drawn;
  const double most = most_expected / cell;
  double height = sd * (sd / mean) / (4.0 * square_of_step);
  double density = 2.0 * mean / (height * mean_length);
  if (!(density <= most)) {
    ++tally.capped;
    density = most;
    height = 2.0 * mean / (density * mean_length);
  }
  // so rare that no pulse will ever come, and no double holds how high it were
  return density > 0.0 && std::isfinite(height) ? Component{density, height} : Component{};
}

/// The lengths of the pulses, as angles, none longer than a window.
RiseLengths lengths(const ForceMoments& moments, double window, double path_radius, DrawTally& tally) {
  const double usual = std::min(wanted(moments.correlation_length), countless);
  const double brief = std::min(wanted(moments.short_correlation_length), countless);
  const double least = shortest_length;
  RiseLengths found = rise_lengths(std::max(usual, least) / path_radius, std::max(brief, least) / path_radius);
  if (found.clamped || usual < least || brief < least) ++tally.length_clamped;
  const double room = window / apart;
  if (found.longest + found.drop > room) {
    ++tally.narrowed;
    found = shortened(found, room / (found.longest + found.drop));
  }
  return found;
}

}  // namespace

SawtoothLaw sawtooth_law(const ForceMoments& moments, const SignalSettings& settings, double path_radius,
                         DrawTally& tally) {
  const double window = settings.window_angle;
  const double x_mean = wanted(moments.x_mean), y_mean = wanted(moments.y_mean);
  SawtoothLaw law{.cell = window};
  if (!(x_mean > 0.0 || y_mean > 0.0)) return law;

  const RiseLengths rises = lengths(moments, window, path_radius, tally);
  law.power = whole_power(rises.exponent);
  law.part = rises.exponent - law.power;
  law.rise = rises.scale;
  law.least_rise = rises.least;
  law.drop = rises.drop;
  law.inverse_drop = 1.0 / rises.drop;

  // the shortest cells that hold a pulse; longer ones below when pulses are few
  const double mean_length = rises.mean + rises.drop, longest = rises.longest + rises.drop;
  const double most_cells = std::max(1.0, std::floor(window / (apart * longest)));
  const Component x = component(x_mean, wanted(moments.x_sd), mean_length, window / most_cells, tally);
  const Component y = component(y_mean, wanted(moments.y_sd), mean_length, window / most_cells, tally);
  law.x_height = x.height;
  law.y_height = y.height;

  double both = std::clamp(moments.xy_correlation, -1.0, 1.0) * std::sqrt(x.density) * std::sqrt(y.density);
  const double most_both = std::min(x.density, y.density);
  if (most_both > 0.0 && (both < 0.0 || both > most_both * apart)) ++tally.correlation_clamped;
  both = std::clamp(both, 0.0, most_both);
  law.density = x.density + y.density - both;
  if (!(law.density > 0.0)) return law;
  law.mean_gap = 1.0 / law.density;
  law.both_below = both / law.density;
  law.x_below = x.density / law.density;

  const double enough_cells = std::max(1.0, std::floor(law.density * window / usual_expected));
  law.cells = static_cast<std::int64_t>(std::min(most_cells, enough_cells));
  law.cell = window / static_cast<double>(law.cells);
  return law;
}

}  // namespace bitrock::runtime
