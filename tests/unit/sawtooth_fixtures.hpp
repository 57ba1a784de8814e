#pragma once
/// What the tests of the mode "sawtooth" share: moments, one cutter whose force is asked for by its angle, the exact
/// covariance of its law by quadrature, and long records with the errors of their means. Whatever is compared with a
/// record may be off by four standard errors of that record, which are found from a hundred pieces of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "runtime/core/core.hpp"
#include "runtime/signal/felt_pulses.hpp"
#include "runtime/signal/rise_lengths.hpp"
#include "runtime/signal/step5.hpp"
#include "tests/unit/runtime_fixtures.hpp"

namespace sawtooth_test {

using namespace bitrock;

inline constexpr double radius = 0.05;  // [m]

inline runtime::ForceMoments usual_moments() {
  return {.x_mean = 1e5,
          .x_sd = 1.4e5,
          .y_mean = 0.7e5,
          .y_sd = 0.9e5,
          .correlation_length = 0.4e-3,
          .short_correlation_length = 0.13e-3,
          .xy_correlation = 0.8};
}

inline runtime::ForceMoments moments_of(double length, double ratio) {
  runtime::ForceMoments moments = usual_moments();
  moments.correlation_length = length;
  moments.short_correlation_length = ratio * length;
  return moments;
}

inline runtime::SignalSettings usual_settings() {
  runtime::SignalSettings settings = runtime_test::usual_settings();
  settings.mode = runtime::SignalMode::sawtooth;
  return settings;
}

inline runtime::SawtoothLaw law_of(const runtime::ForceMoments& moments, double path_radius = radius) {
  runtime::DrawTally tally;
  return runtime::sawtooth_law(moments, usual_settings(), path_radius, tally);
}

/// Some cutters with the same moments in all windows, as one bit; x weighs into the torque, y into the force.
struct Cutters {
  std::vector<runtime::SawtoothCutter> list;
  std::vector<runtime::PulseBlock> blocks;
  runtime::FeltPulses felt;
  double window_angle;

  explicit Cutters(const runtime::ForceMoments& moments, const std::vector<int>& numbers = {1},
                   bool wide = runtime::has_wide_vectors(), const runtime::SignalSettings& settings = usual_settings(),
                   double path_radius = radius)
      : list(numbers.size()), blocks(runtime::most_felt_blocks(numbers.size())), window_angle(settings.window_angle) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      list[i].seed = settings.seed;
      list[i].number = numbers[i];
      list[i].wide = wide;
      list[i].weights = {.torque = 1.0, .force = 1.0};
      runtime::DrawTally tally;
      list[i].laws.fill(runtime::sawtooth_law(moments, settings, path_radius, tally));
    }
  }
  /// [N/m]
  runtime::ForcePerMetre at(double angle) {
    const auto now = static_cast<std::int64_t>(std::floor(angle / window_angle));
    const double from_begin = angle - static_cast<double>(now) * window_angle;
    if (now != felt.window || !(from_begin >= felt.from && from_begin < felt.until))
      follow(felt, blocks.data(), list, window_angle, now, from_begin);
    felt.last = from_begin;
    runtime::ForcePerMetre force;
    runtime::add_up(blocks.data(), felt.count, from_begin, force.x, force.y);
    return force;
  }
};

/// Mean over w of f(rise of w), w from exp(-w), cut off at 6.
inline double over_rises(const runtime::SawtoothLaw& law, const std::function<double(double)>& f) {
  std::vector<double> points;
  for (int i = 0; i <= 64; ++i) points.push_back(runtime::most_climbed * i * i / (64.0 * 64.0));
  const double share = 1.0 - std::exp(-runtime::most_climbed);
  return runtime_test::integral(points, [&](double w) {
    return std::exp(-w) / share *
           f(law.least_rise + law.rise * std::pow(w, law.power) * (1.0 - law.part + law.part * w));
  });
}

/// The pulse of height 1.
inline double pulse(double s, double rise, double drop) {
  if (s <= 0.0 || s >= rise + drop) return 0.0;
  return runtime::smooth_unit_step(s < rise ? s / rise : 1.0 - (s - rise) / drop);
}

/// lambda a b E[g^2] times the mean integral of f(s) f(s + lag), by quadrature.
inline double covariance(const runtime::SawtoothLaw& law, double density, double a, double b, double lag) {
  return 2.0 * density * a * b * over_rises(law, [&](double rise) {
           const double length = rise + law.drop;
           if (lag >= length) return 0.0;
           std::vector<double> points{0.0, length - lag};
           for (const double bend : {rise, rise - lag}) {
             if (bend > 0.0 && bend < length - lag) points.push_back(bend);
           }
           std::sort(points.begin(), points.end());
           return runtime_test::integral(
               points, [&](double s) { return pulse(s, rise, law.drop) * pulse(s + lag, rise, law.drop); });
         });
}

inline double x_density(const runtime::SawtoothLaw& law) {
  return law.density * law.x_below;
}
inline double y_density(const runtime::SawtoothLaw& law) {
  return law.density * (1.0 - law.x_below + law.both_below);
}

/// Mean over pieces of a record, and its standard error.
struct Estimate {
  double value = 0.0, error = 0.0;
};
inline Estimate estimate(const std::vector<double>& pieces) {
  Estimate result;
  const auto n = static_cast<double>(pieces.size());
  for (const double piece : pieces) result.value += piece / n;
  for (const double piece : pieces) result.error += (piece - result.value) * (piece - result.value) / (n * (n - 1.0));
  result.error = std::sqrt(result.error);
  return result;
}
inline void expect_met(const Estimate& seen, double exact, double largest_error) {
  EXPECT_NEAR(seen.value, exact, 4.0 * seen.error);
  EXPECT_LT(seen.error, largest_error);  // or the record says too little
}

struct Record {
  double step = 0.0;  ///< [rad]
  std::vector<double> x, y;
};
inline Record record(Cutters& cutters, double step, std::size_t samples) {
  Record made{.step = step, .x = {}, .y = {}};
  for (std::size_t i = 0; i < samples; ++i) {
    const runtime::ForcePerMetre force = cutters.at(step * static_cast<double>(i));
    made.x.push_back(force.x);
    made.y.push_back(force.y);
  }
  return made;
}

/// Mean of a function of the sample number over each of a hundred pieces.
inline Estimate over_pieces(std::size_t samples, const std::function<double(std::size_t)>& f) {
  constexpr std::size_t pieces = 100;
  std::vector<double> means;
  for (std::size_t p = 0; p < pieces; ++p) {
    double sum = 0.0;
    for (std::size_t i = p * samples / pieces; i < (p + 1) * samples / pieces; ++i) sum += f(i);
    means.push_back(sum / (static_cast<double>(samples) / pieces));
  }
  return estimate(means);
}

}  // namespace sawtooth_test
