#include "runtime/signal/sawtooth_law.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::runtime {

namespace {

constexpr double square_of_step = 181.0 / 462.0;  ///< I2
constexpr double countless = 1e100;               ///< keeps products of absurd moments finite
constexpr double apart = 1.0 + 1e-9;              ///< so that rounding does not let a pulse reach beyond a cell

double wanted(double moment) {
  return std::clamp(moment, 0.0, countless);
}

/// G_1, G_2, G_3 for heights up to c.
struct HeightMoments {
  double first, second, third;
};

HeightMoments height_moments(double c) {
  const double beyond = std::exp(-c);
  return {1.0 - beyond, 2.0 * (1.0 - beyond * (1.0 + c)), 6.0 * (1.0 - beyond * (1.0 + c + 0.5 * c * c))};
}

/// lambda and a of one component, in the units of m1: events per length, height.
struct Component {
  double density = 0.0, height = 0.0;
};

Component component(double mean, double sd, double m1, double m2, double cell, DrawTally& tally) {
  if (!(mean > 0.0)) return {};
  ++tally.drawn;
  const double most = most_expected / cell;
  const double coefficient = sd * m1 / mean;
  double density = m2 / (coefficient * coefficient);
  if (!(density <= most)) {
    ++tally.capped;
    density = most;
  }
  const double height = mean / (density * m1);
  // so rare that no event will ever come, and no double holds how high it were
  return density > 0.0 && std::isfinite(height) ? Component{density, height} : Component{};
}

}  // namespace

SawtoothLaw sawtooth_law(const ForceMoments& moments, const SignalSettings& settings, double path_radius,
                         DrawTally& tally) {
  const double window = settings.window_angle;
  const double x_mean = wanted(moments.x_mean), y_mean = wanted(moments.y_mean);
  SawtoothLaw law{.highest = highest_unit, .cell = window};
  if (!(x_mean > 0.0 || y_mean > 0.0)) return law;

  law.drop = drop_angle(settings, path_radius);
  const double length = std::min(wanted(moments.correlation_length) / path_radius, countless);
  law.rise = (length - length_of_drop * law.drop) / length_of_rise;
  if (const double shortest = shortest_rise * law.drop; law.rise < shortest) {
    tally.length_clamped += law.rise * apart < shortest ? 1 : 0;
    law.rise = shortest;
  }
  // a pulse ends at most one window behind its beginning
  const double room = window / apart - law.drop;
  if (law.rise * law.highest > room) {
    ++tally.narrowed;
    law.rise = std::min(law.rise, room);
    law.highest = room / law.rise;
  }

  const HeightMoments g = height_moments(law.highest);
  const double m1 = 0.5 * (law.rise * g.second + law.drop * g.first);
  const double m2 = square_of_step * (law.rise * g.third + law.drop * g.second);
  // the shortest cells that hold a pulse; longer ones below when events are few
  const double reach = law.rise * law.highest + law.drop;
  const double most_cells = std::max(1.0, std::floor(window / (apart * reach)));
  const Component x = component(x_mean, wanted(moments.x_sd), m1, m2, window / most_cells, tally);
  const Component y = component(y_mean, wanted(moments.y_sd), m1, m2, window / most_cells, tally);
  law.x_height = x.height;
  law.y_height = y.height;

  double both = std::clamp(moments.xy_correlation, -1.0, 1.0) * std::sqrt(x.density) * std::sqrt(y.density);
  const double most_both = std::min(x.density, y.density);
  if (most_both > 0.0 && (both < 0.0 || both > most_both * apart)) ++tally.correlation_clamped;
  both = std::clamp(both, 0.0, most_both);
  law.density = x.density + y.density - both;
  if (!(law.density > 0.0)) return law;
  law.both_below = both / law.density;
  law.x_below = x.density / law.density;

  const double enough_cells = std::max(1.0, std::floor(law.density * window / usual_expected));
  law.cells = static_cast<std::int64_t>(std::min(most_cells, enough_cells));
  law.cell = window / static_cast<double>(law.cells);
  return law;
}

}  // namespace bitrock::runtime
