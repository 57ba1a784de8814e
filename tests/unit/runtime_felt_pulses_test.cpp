// The force of the mode "sawtooth": long records of it against the closed forms of its law, and that the angle alone
// decides.
#include "base/random.hpp"
#include "tests/unit/sawtooth_fixtures.hpp"

using namespace sawtooth_test;

namespace {

TEST(FeltPulses, LongRecordHasTheMomentsOfTheProcess) {
  for (const double ratio : {0.2, 0.33}) {
    const runtime::ForceMoments wanted = moments_of(0.4e-3, ratio);
    Cutters cutter(wanted);
    const runtime::SawtoothLaw law = law_of(wanted);
    const double length = wanted.correlation_length / radius;
    constexpr std::size_t samples = 2'000'000;
    const Record r = record(cutter, length / 5.0, samples);
    const double mx = wanted.x_mean, my = wanted.y_mean;
    expect_met(over_pieces(samples, [&](std::size_t i) { return r.x[i]; }), mx, 0.01 * mx);
    expect_met(over_pieces(samples, [&](std::size_t i) { return r.y[i]; }), my, 0.01 * my);
    for (const std::size_t lag : {0u, 1u, 3u, 5u, 10u, 20u}) {
      const double at = r.step * static_cast<double>(lag);
      const Estimate x = over_pieces(samples - 20, [&](std::size_t i) { return (r.x[i] - mx) * (r.x[i + lag] - mx); });
      expect_met(x, covariance(law, x_density(law), law.x_height, law.x_height, at), 0.015 * wanted.x_sd * wanted.x_sd);
      const Estimate y = over_pieces(samples - 20, [&](std::size_t i) { return (r.y[i] - my) * (r.y[i + lag] - my); });
      expect_met(y, covariance(law, y_density(law), law.y_height, law.y_height, at), 0.015 * wanted.y_sd * wanted.y_sd);
    }
    expect_met(over_pieces(samples, [&](std::size_t i) { return (r.x[i] - mx) * (r.y[i] - my); }),
               wanted.xy_correlation * wanted.x_sd * wanted.y_sd, 0.015 * wanted.x_sd * wanted.y_sd);
  }
}

// Nothing is felt where no pulse reaches: their number at a place is Poisson, with lambda (E[h] + delta) in the mean.
TEST(FeltPulses, WithoutForceAsOftenAsNoPulseReaches) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  Cutters cutter(usual_moments());
  constexpr std::size_t samples = 1'000'000;
  const Record r = record(cutter, 0.4e-3 / radius, samples);
  const double felt = over_rises(law, [&](double rise) { return rise + law.drop; });
  // a pulse of less than 2^-25 counts as none: the first 1e-4 of its climb
  expect_met(over_pieces(samples, [&](std::size_t i) { return r.x[i] == 0.0 ? 1.0 : 0.0; }),
             std::exp(-x_density(law) * felt), 0.005);
  EXPECT_GE(*std::min_element(r.x.begin(), r.x.end()), 0.0);
}

TEST(FeltPulses, TheAngleAloneDecidesWhicheverWay) {
  for (const double path_radius : {radius, 2e-3}) {  // many cells a window, and one
    Cutters forward(usual_moments(), {1, 2, 3}, runtime::has_wide_vectors(), usual_settings(), path_radius);
    Cutters jumping(usual_moments(), {1, 2, 3}, false, usual_settings(), path_radius);
    std::vector<double> angles;
    for (int i = 0; i < 40000; ++i) angles.push_back(-3.0 + 2e-4 * i);
    std::vector<runtime::ForcePerMetre> seen;
    for (const double angle : angles) seen.push_back(forward.at(angle));
    const auto expect_same = [&](std::size_t i) {
      const runtime::ForcePerMetre force = jumping.at(angles[i]);
      ASSERT_EQ(force.x, seen[i].x);
      ASSERT_EQ(force.y, seen[i].y);
    };
    base::Random random(5);
    for (int i = 0; i < 20000; ++i) expect_same(static_cast<std::size_t>(base::below(random, angles.size())));
    for (std::size_t i = angles.size(); i-- > 0;) expect_same(i);
    for (const std::size_t stride : {7u, 61u, 1009u}) {
      for (std::size_t i = 0; i < angles.size(); i += stride) expect_same(i);
    }
    // as a solver that tries a step and takes part of it back
    for (std::size_t i = 0; i + 20 < angles.size(); i += 3) {
      expect_same(i);
      expect_same(i + static_cast<std::size_t>(base::below(random, 20)));
    }
  }
}

TEST(FeltPulses, ABitIsTheSumOfItsCutters) {
  Cutters bit(usual_moments(), {4, 9});
  Cutters first(usual_moments(), {4}), second(usual_moments(), {9});
  for (int i = 0; i < 20000; ++i) {
    const double angle = 3e-4 * i;
    const runtime::ForcePerMetre all = bit.at(angle), a = first.at(angle), b = second.at(angle);
    ASSERT_EQ(all.x, a.x + b.x);  // multiples of 2^-24 add up without rounding
    ASSERT_EQ(all.y, a.y + b.y);
  }
}

TEST(FeltPulses, CuttersWindowsAndSeedsDrawIndependently) {
  runtime::SignalSettings other = usual_settings();
  other.seed += 1;
  Cutters first(usual_moments()), second(usual_moments(), {2}),
      third(usual_moments(), {1}, runtime::has_wide_vectors(), other);
  constexpr std::size_t samples = 300'000;
  const double step = 0.8e-3 / radius, mean = usual_moments().x_mean, sd = usual_moments().x_sd;
  const Record a = record(first, step, samples), b = record(second, step, samples), c = record(third, step, samples);
  for (const Record* r : {&b, &c}) {
    const Estimate seen =
        over_pieces(samples, [&](std::size_t i) { return (a.x[i] - mean) * (r->x[i] - mean) / (sd * sd); });
    EXPECT_NEAR(seen.value, 0.0, 4.0 * seen.error);
  }
}

// A polynomial of degree five between its points: the second difference over h goes to 0 with h at each of them, and a
// jump in slope or curvature would not.
TEST(FeltPulses, TwiceDifferentiable) {
  Cutters cutter(usual_moments());
  const double window = cutter.window_angle;
  const auto jump_of_curvature = [&](double at, double h) {
    const auto curvature = [&](double t) {
      return (cutter.at(t - h).x - 2.0 * cutter.at(t).x + cutter.at(t + h).x) / (h * h);
    };
    return std::abs(curvature(at + h) - curvature(at - h));
  };
  const runtime::SawtoothLaw& law = cutter.list[0].laws[0];
  // third derivative of the steepest pulse, 60 a g / length^3, of the shortest climb
  const double shortest = law.least_rise, steepest = 60.0 * law.x_height * 12.0 / std::pow(shortest, 3);
  const double h = 1e-2 * shortest, rounding = 8.0 * 6e-8 * 10.0 / (h * h);
  for (int k = 1; k < 20; ++k) {
    EXPECT_LE(jump_of_curvature(k * window, h), 4.0 * steepest * h + rounding);
    cutter.at(k * window + 0.3);
    const runtime::DrawnPulses& four = cutter.list[0].four[cutter.list[0].now];
    const double rise = 1.0 / four.pulses.climb[0], begin = four.begin[0];
    for (const double point : {begin, begin + rise, begin + rise + law.drop})
      EXPECT_LE(jump_of_curvature(k * window + point, h), 4.0 * steepest * h + rounding);
  }
}

// Fewer free places than pulses: the blocks stay few, however long it goes on.
TEST(FeltPulses, WhatIsOverIsReplaced) {
  Cutters cutter(usual_moments(), {1, 2, 3, 4});
  std::size_t most = 0;
  for (int i = 0; i < 200000; ++i) {
    cutter.at(1e-4 * i);
    most = std::max(most, cutter.felt.count);
  }
  const runtime::SawtoothLaw law = law_of(usual_moments());
  const double felt = 4.0 * law.density * over_rises(law, [&](double rise) { return rise + law.drop; });
  EXPECT_LT(4.0 * static_cast<double>(most), felt + 8.0 * std::sqrt(felt) + 2.0 * runtime::added_together + 8.0);
}

}  // namespace
