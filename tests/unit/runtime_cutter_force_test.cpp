// The force of one cutter over the angle: where peaks lie, what area they have, how smooth it is, and that nothing but
// the angle and the seed decides it.
#include "runtime/signal/cutter_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

using runtime::Combine;
using runtime_test::usual_pair;
using runtime_test::usual_settings;
using runtime_test::whole_pair;

constexpr double radius = 0.1;  // [m]

runtime::PeakWindow drawn(const runtime::SignalSettings& settings, int cutter, std::int64_t k,
                          const runtime::CutterStatistics& statistics = usual_pair()) {
  runtime::PeakWindow window;
  draw_window(window, statistics, radius, settings, {.seed = settings.seed, .cutter = cutter, .window = k});
  return window;
}

/// The pulses of one window alone, with room before and after it: angle 0 is one window before it begins.
runtime::PulseTrain alone(const runtime::PeakWindow& window, double window_angle) {
  runtime::PulseTrain train;
  put_pulses(window, window_angle, 3.0 * window_angle, train);
  restart(train);
  return train;
}

/// Force at any angle, entering windows as needed.
runtime::ForcePerMetre force(runtime::CutterForce& cutter, double angle,
                             const runtime::CutterStatistics& statistics = usual_pair()) {
  const double k = std::floor(angle / cutter.settings.window_angle);
  enter_window(cutter, static_cast<std::int64_t>(k), statistics);
  return force_at(cutter.train, cutter.settings.combine, angle - k * cutter.settings.window_angle);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sa += a[i], sb += b[i], saa += a[i] * a[i], sbb += b[i] * b[i], sab += a[i] * b[i];
  }
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

TEST(PeakWindow, AnglesAreUniformInTheWindow) {
  runtime::SignalSettings settings = usual_settings();
  settings.window_angle = 0.8;
  std::vector<double> angles;
  for (int k = -200; k < 200; ++k) {
    for (const runtime::Peak& peak : drawn(settings, 1, k).peaks) angles.push_back(peak.angle / settings.window_angle);
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_GE(angles.front(), 0.0);
  EXPECT_LT(angles.back(), 1.0);
  // Kolmogorov-Smirnov: sqrt(n) times the largest gap exceeds 1.95 once in a thousand
  const auto n = static_cast<double>(angles.size());
  double gap = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto below = static_cast<double>(i);
    gap = std::max({gap, (below + 1.0) / n - angles[i], angles[i] - below / n});
  }
  EXPECT_GT(n, 5000.0);
  EXPECT_LT(std::sqrt(n) * gap, 1.95);
}

TEST(PeakWindow, CuttersWindowsAndSeedsDrawIndependently) {
  runtime::SignalSettings settings = usual_settings(), other_seed = usual_settings();
  other_seed.seed = 8;
  std::vector<double> base, next_cutter, next_window, next_seed;
  const int windows = 4000;
  for (int k = 0; k < windows; ++k) {
    base.push_back(drawn(settings, 1, k).peaks[0].angle);
    next_cutter.push_back(drawn(settings, 2, k).peaks[0].angle);
    next_window.push_back(drawn(settings, 1, k + 1).peaks[0].angle);
    next_seed.push_back(drawn(other_seed, 1, k).peaks[0].angle);
  }
  const double allowed = 4.0 / std::sqrt(windows);  // standard error of a correlation of 0 is 1 / sqrt(n)
  EXPECT_NEAR(correlation(base, next_cutter), 0.0, allowed);
  EXPECT_NEAR(correlation(base, next_window), 0.0, allowed);
  EXPECT_NEAR(correlation(base, next_seed), 0.0, allowed);
}

TEST(PeakWindow, BothComponentsPeakTogether) {
  const runtime::PeakWindow window = drawn(usual_settings(), 1, 0);
  ASSERT_NE(window.x.counts.total(), window.y.counts.total());
  EXPECT_EQ(window.peaks.size(), static_cast<std::size_t>(std::max(window.x.counts.total(), window.y.counts.total())));
  EXPECT_EQ(window.peaks[0].x, usual_pair().x.amax);
  EXPECT_EQ(window.peaks[0].y, usual_pair().y.amax);
}

TEST(PeakWindow, AreaIsTheSumOfHeightTimesHalfWidth) {
  for (const double factor : {0.5, 1.0, 2.0}) {
    runtime::SignalSettings settings = usual_settings();
    settings.pulse_width_factor = factor;
    for (int k = 0; k < 20; ++k) {
      const runtime::PeakWindow window = drawn(settings, 1, k, whole_pair());
      double heights_x = 0.0, heights_y = 0.0;
      for (const runtime::Peak& peak : window.peaks) heights_x += peak.x, heights_y += peak.y;
      runtime::PulseTrain train = alone(window, settings.window_angle);
      const std::vector<double> points = runtime_test::break_points(train, 0.0, 3.0 * settings.window_angle);
      const double area_x =
          runtime_test::integral(points, [&](double angle) { return force_at(train, Combine::sum, angle).x; });
      const double area_y =
          runtime_test::integral(points, [&](double angle) { return force_at(train, Combine::sum, angle).y; });
      ASSERT_FALSE(window.x.fit.mean_missed || window.y.fit.mean_missed);
      EXPECT_NEAR(area_x, window.x.half_width * heights_x, 1e-12 * area_x);
      EXPECT_NEAR(area_y, window.y.half_width * heights_y, 1e-12 * area_y);
      EXPECT_NEAR(area_x, 0.5 * factor * whole_pair().x.amean * settings.window_angle, 1e-12 * area_x);
      EXPECT_NEAR(area_y, 0.5 * factor * whole_pair().y.amean * settings.window_angle, 1e-12 * area_y);
    }
  }
}

TEST(PeakWindow, IsolatedPulseHasTheExactAreaOfItsSquare) {
  const peaks::PeakRates one{.amax = 5.0, .amean = 5.0, .np1 = 10.0};  // 10 / m on 0.1 m: one peak
  const runtime::PeakWindow window = drawn(usual_settings(), 1, 0, {.x = one, .y = one});
  runtime::PulseTrain train = alone(window, 1.0);
  const double square = runtime_test::integral(runtime_test::break_points(train, 0.0, 3.0), [&](double angle) {
    const double f = force_at(train, Combine::sum, angle).x;
    return f * f;
  });
  EXPECT_NEAR(square, 2.0 * 0.5 * 25.0 * 181.0 / 462.0, 1e-13);  // 2 h A^2 181/462
}

TEST(CutterForce, NeverNegativeAndBelowTheLargestWhereThePulsesDoNotAdd) {
  runtime::SignalSettings settings = usual_settings();
  settings.pulse_width_factor = 2.0;
  runtime::CutterForce sum = runtime_test::cutter_force(settings, 1, radius);
  settings.combine = Combine::max;
  runtime::CutterForce max = runtime_test::cutter_force(settings, 1, radius);
  double largest_sum = 0.0;
  for (int i = 0; i < 40000; ++i) {
    const runtime::ForcePerMetre a = force(sum, 1e-3 * i), b = force(max, 1e-3 * i);
    ASSERT_GE(std::min({a.x, a.y, b.x, b.y}), 0.0);
    ASSERT_LE(b.x, usual_pair().x.amax * (1.0 + 4e-16));
    ASSERT_LE(b.y, usual_pair().y.amax * (1.0 + 4e-16));
    ASSERT_LE(b.x, a.x);
    largest_sum = std::max(largest_sum, a.x);
  }
  EXPECT_GT(largest_sum, usual_pair().x.amax);  // the price of keeping the area
}

/// Slope and curvature from the left and from the right of `edge`, as differences over steps e. They may differ by what
/// a function with continuous curvature and the second and third derivatives of the pulses there can show. On the unit
/// interval those of S are at most 5.78 and 60.
void expect_smooth(runtime::CutterForce& cutter, double edge, const runtime::CutterStatistics& before,
                   const runtime::CutterStatistics& after) {
  const double e = 1e-5;
  const auto left = [&](double distance) { return force(cutter, edge - distance, before).x; };
  const double l[3] = {left(2.5 * e), left(1.5 * e), left(0.5 * e)};
  const double r[3] = {force(cutter, edge + 0.5 * e, after).x, force(cutter, edge + 1.5 * e, after).x,
                       force(cutter, edge + 2.5 * e, after).x};
  double second = 0.0, third = 0.0;
  for (const runtime::Pulse& pulse : cutter.train.pulses) {
    if (pulse.begin > 3.0 * e || pulse.end < -3.0 * e) continue;
    second += 5.78 * pulse.x * std::pow(pulse.inverse_half_width_x, 2);
    third += 60.0 * pulse.x * std::pow(pulse.inverse_half_width_x, 3);
  }
  const double rounding = 1e-14 * usual_pair().x.amax;
  ASSERT_NEAR(r[0] - l[2], l[2] - l[1], second * e * e + rounding);
  ASSERT_NEAR(r[0] - 2.0 * l[2] + l[1], l[2] - 2.0 * l[1] + l[0], third * e * e * e + rounding);
  ASSERT_NEAR(r[2] - 2.0 * r[1] + r[0], l[2] - 2.0 * l[1] + l[0], 3.0 * third * e * e * e + rounding);
}

TEST(CutterForce, TwiceDifferentiableOverWindowEdges) {
  runtime::CutterForce cutter = runtime_test::cutter_force(usual_settings(), 1, radius);
  for (int k = 1; k < 200; ++k) expect_smooth(cutter, k, usual_pair(), usual_pair());
}

TEST(CutterForce, SmoothWhileConditionsChange) {
  runtime::CutterForce cutter = runtime_test::cutter_force(usual_settings(), 1, radius);
  runtime::CutterStatistics now = usual_pair();
  for (int k = 1; k < 100; ++k) {
    runtime::CutterStatistics next = usual_pair();
    next.x.amax *= k % 3 == 0 ? 0.2 : 1.0;
    next.x.amean *= k % 3 == 0 ? 0.1 : 1.0;
    next.x.np4 *= k % 5 == 0 ? 4.0 : 1.0;
    expect_smooth(cutter, k, now, next);
    now = next;
  }
}

TEST(CutterForce, StatisticsAreLatchedOneWindowAhead) {
  runtime::CutterForce cutter = runtime_test::cutter_force(usual_settings(), 1, radius);
  runtime::CutterForce steady = runtime_test::cutter_force(usual_settings(), 1, radius);
  const runtime::CutterStatistics nothing;
  EXPECT_EQ(force(cutter, 0.5).x, force(steady, 0.5).x);
  // window 1 was drawn with window 0; window 2 comes into reach now, with nothing in it
  EXPECT_EQ(force(cutter, 1.4, nothing).x, force(steady, 1.4).x);
  EXPECT_EQ(force(cutter, 3.5, nothing).x, 0.0);
}

TEST(CutterForce, DependsOnTheAngleAloneToTheLastBit) {
  runtime::CutterForce fine = runtime_test::cutter_force(usual_settings(), 3, radius);
  runtime::CutterForce coarse = runtime_test::cutter_force(usual_settings(), 3, radius);
  runtime::CutterForce backward = runtime_test::cutter_force(usual_settings(), 3, radius);
  std::vector<double> by_fine_steps;
  for (int i = 0; i < 40000; ++i) {
    const double here = force(fine, 1e-3 * i - 20.0).x;
    if (i % 37 == 0) by_fine_steps.push_back(here);
  }
  const int count = static_cast<int>(by_fine_steps.size());
  for (int n = 0; n < count; ++n) {
    ASSERT_EQ(force(coarse, 1e-3 * (37 * n) - 20.0).x, by_fine_steps[static_cast<std::size_t>(n)]);
  }
  for (int n = count - 1; n >= 0; --n) {
    ASSERT_EQ(force(backward, 1e-3 * (37 * n) - 20.0).x, by_fine_steps[static_cast<std::size_t>(n)]);
  }
}

TEST(CutterForce, AStepTakenBackOverAnEdgeFindsTheForceItLeft) {
  runtime::CutterForce cutter = runtime_test::cutter_force(usual_settings(), 1, radius);
  for (int k = 0; k < 5; ++k) force(cutter, k + 0.5);
  const double left = force(cutter, 4.99).x;
  force(cutter, 5.01, {});  // another prediction at the far side
  EXPECT_EQ(force(cutter, 4.99, {}).x, left);
}

TEST(CutterForce, MeanForceDoesNotDependOnTheWindow) {
  const double turns = 24.0;
  for (const double window_angle : {0.75, 1.5, 3.0}) {
    runtime::SignalSettings settings = usual_settings();
    settings.window_angle = window_angle;
    runtime::CutterForce cutter = runtime_test::cutter_force(settings, 1, radius);
    double area = 0.0, leak = 0.0;
    for (int k = 0; k < static_cast<int>(turns / window_angle); ++k) {
      force(cutter, (k + 0.5) * window_angle, whole_pair());
      area += runtime_test::integral(runtime_test::break_points(cutter.train, 0.0, window_angle),
                                     [&](double x) { return force_at(cutter.train, Combine::sum, x).x; });
      for (const runtime::PeakWindow& window : cutter.windows) leak = std::max(leak, window.x.half_width);
    }
    EXPECT_EQ(cutter.memory.tally.mean_missed, 0);
    // each window has exactly its share; only pulses over the two outer ends, at most a few of amax h, are not whole
    const double expected = 0.5 * whole_pair().x.amean * turns;
    EXPECT_NEAR(area, expected, 2.0 * 2.0 * whole_pair().x.amax * leak);
  }
}

/// Mean over blocks of two windows of 1 rad, and its standard error.
struct Estimate {
  double mean = 0.0;
  double error = 0.0;
};

Estimate estimate(const std::vector<double>& blocks) {
  double sum = 0.0, squares = 0.0;
  for (const double block : blocks) sum += block, squares += block * block;
  const auto n = static_cast<double>(blocks.size());
  return {.mean = sum / n, .error = std::sqrt((squares / n - sum * sum / (n * n)) / n)};
}

TEST(CutterForce, DoublingTheWindowDoublesThePeaksAndKeepsMeanSquareAndCorrelation) {
  const double step = 4e-3, lag = 0.25 / (radius * 320.0);  // a quarter of a pulse
  const int blocks = 600, samples = 500;
  struct Moments {
    std::vector<double> square, product;  // of the force, and with the force `lag` further on, in amax^2
    int peaks = 0;
  };
  const auto moments = [&](double window_angle) {
    runtime::SignalSettings settings = usual_settings();
    settings.window_angle = window_angle;
    runtime::CutterForce here = runtime_test::cutter_force(settings, 1, radius);
    runtime::CutterForce there = runtime_test::cutter_force(settings, 1, radius);
    Moments result{.peaks = drawn(settings, 1, 0, whole_pair()).x.counts.total()};
    const auto at = [&](runtime::CutterForce& cutter, double angle) {
      const double k = std::floor(angle / window_angle);
      if (cutter.memory.entered != static_cast<std::int64_t>(k)) {
        enter_window(cutter, static_cast<std::int64_t>(k), whole_pair());
      }
      return force_at(cutter.train, Combine::sum, angle - k * window_angle).x / whole_pair().x.amax;
    };
    for (int block = 0; block < blocks; ++block) {
      double square = 0.0, product = 0.0;
      for (int i = 0; i < samples; ++i) {
        const double angle = 2.0 * block + step * i, force = at(here, angle);
        square += force * force, product += force * at(there, angle + lag);
      }
      result.square.push_back(square / samples), result.product.push_back(product / samples);
    }
    return result;
  };
  const Moments half = moments(1.0), whole = moments(2.0);
  EXPECT_EQ(half.peaks, 32);
  EXPECT_EQ(whole.peaks, 64);
  for (const auto member : {&Moments::square, &Moments::product}) {
    const Estimate a = estimate(half.*member), b = estimate(whole.*member);
    EXPECT_LT(std::max(a.error, b.error), 0.01 * a.mean);  // the samples can tell one per cent
    EXPECT_NEAR(a.mean, b.mean, 4.0 * std::hypot(a.error, b.error));
  }
}

TEST(PeakWindow, PulsesAreAsWideInShortWindowsAsInLongOnes) {
  for (const double window_angle : {0.05, 0.3, 2.0}) {
    runtime::SignalSettings settings = usual_settings();
    settings.window_angle = window_angle;
    for (int k = 0; k < 20; ++k) {
      const runtime::PeakWindow window = drawn(settings, 1, k);
      if (window.x.counts.total() == 0) continue;
      EXPECT_FALSE(window.x.narrowed);
      EXPECT_NEAR(2.0 * window.x.half_width * radius, 1.0 / (33.0 + 101.0 + 160.0), 1e-15);  // f = 1
    }
  }
}

TEST(PeakWindow, MeanForceHoldsOverWindowsThatAreOftenEmpty) {
  // 40 peaks a metre on 15 mm: 0.6 peaks a window, four windows of ten empty
  const peaks::PeakRates sparse{.amax = 2e5, .amean = 0.6e5, .np1 = 4.0, .np23 = 12.0, .np4 = 24.0};
  runtime::SignalSettings settings = usual_settings();
  settings.window_angle = 0.15;
  const int windows = 20000;
  double sum = 0.0, squares = 0.0;
  for (int k = 0; k < windows; ++k) {
    const runtime::PeakWindow window = drawn(settings, 1, k, {.x = sparse, .y = sparse});
    double heights = 0.0;
    for (const runtime::Peak& peak : window.peaks) heights += peak.x;
    const double mean_force = window.x.half_width * heights / settings.window_angle;  // area as tested above
    sum += mean_force, squares += mean_force * mean_force;
  }
  const double mean = sum / windows, variance = squares / windows - mean * mean;
  EXPECT_NEAR(mean, 0.5 * sparse.amean, 4.0 * std::sqrt(variance / windows));
}

TEST(PeakWindow, APulseReachesNoFurtherThanTheNextWindow) {
  const peaks::PeakRates rare{.amax = 2.0, .amean = 1.0, .np23 = 2.0};  // 0.2 peaks expected
  runtime::SignalSettings settings = usual_settings();
  int narrowed = 0;
  for (int k = 0; k < 100; ++k) {
    const runtime::PeakWindow window = drawn(settings, 1, k, {.x = rare});
    if (window.x.counts.total() == 0) continue;
    EXPECT_EQ(window.x.half_width, settings.window_angle);
    narrowed += window.x.narrowed ? 1 : 0;
  }
  EXPECT_NEAR(narrowed, 20, 16);  // four standard deviations of 100 draws
}

TEST(CutterForce, TallyCountsWhatCouldNotBeGranted) {
  runtime::CutterForce cutter = runtime_test::cutter_force(usual_settings(), 1, radius);
  const peaks::PeakRates alone{.amax = 2.0, .amean = 1.0, .np1 = 10.0};  // one peak, of the top band
  const peaks::PeakRates crowd{.amax = 2.0, .amean = 1.0, .np1 = 1e5, .np23 = 1e5, .np4 = 1e5};
  enter_window(cutter, 0, {.x = alone, .y = crowd});
  EXPECT_EQ(cutter.memory.tally.drawn, 6);
  EXPECT_EQ(cutter.memory.tally.mean_missed, 3);
  EXPECT_EQ(cutter.memory.tally.capped, 3);
  EXPECT_EQ(cutter.memory.tally.band_left, 0);
  EXPECT_EQ(cutter.memory.tally.narrowed, 0);
}

}  // namespace
