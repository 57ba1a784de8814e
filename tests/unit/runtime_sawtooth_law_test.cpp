// The law of the mode "sawtooth" against quadrature, and the draws of its pulses.
#include <numbers>

#include "base/random.hpp"
#include "tests/unit/sawtooth_fixtures.hpp"

using namespace sawtooth_test;

namespace {

double mean_length(const runtime::SawtoothLaw& law) {
  return over_rises(law, [&](double rise) { return rise + law.drop; });
}

TEST(SawtoothLaw, MeanAndDeviationFollowFromThePulses) {
  for (const double length : {0.08e-3, 0.4e-3, 2e-3}) {
    for (const double ratio : {0.15, 0.2, 0.3, 0.42}) {
      const runtime::ForceMoments wanted = moments_of(length, ratio);
      const runtime::SawtoothLaw law = law_of(wanted);
      const double area = 0.5 * mean_length(law);
      EXPECT_NEAR(x_density(law) * law.x_height * area, wanted.x_mean, 1e-6 * wanted.x_mean);
      EXPECT_NEAR(y_density(law) * law.y_height * area, wanted.y_mean, 1e-6 * wanted.y_mean);
      EXPECT_NEAR(std::sqrt(covariance(law, x_density(law), law.x_height, law.x_height, 0.0)), wanted.x_sd,
                  1e-5 * wanted.x_sd);
      EXPECT_NEAR(std::sqrt(covariance(law, y_density(law), law.y_height, law.y_height, 0.0)), wanted.y_sd,
                  1e-5 * wanted.y_sd);
      const double both = covariance(law, law.density * law.both_below, law.x_height, law.y_height, 0.0);
      EXPECT_NEAR(both / (wanted.x_sd * wanted.y_sd), wanted.xy_correlation, 1e-5);
    }
  }
}

TEST(SawtoothLaw, AutocorrelationHasBothLengths) {
  for (const double length : {0.07e-3, 0.4e-3, 2e-3}) {
    for (const double ratio : {0.15, 0.19, 0.25, 0.31, 0.38, 0.44}) {
      const runtime::SawtoothLaw law = law_of(moments_of(length, ratio));
      const double all = covariance(law, 1.0, 1.0, 1.0, 0.0);
      EXPECT_NEAR(covariance(law, 1.0, 1.0, 1.0, length / radius) / all, 1.0 / std::numbers::e, 6e-3) << ratio;
      EXPECT_NEAR(covariance(law, 1.0, 1.0, 1.0, ratio * length / radius) / all, 0.75, 6e-3) << ratio;
    }
  }
}

TEST(SawtoothLaw, WhatCannotBeHadIsCounted) {
  const auto tally_of = [](const runtime::ForceMoments& moments, double path_radius) {
    runtime::DrawTally tally;
    const runtime::SawtoothLaw law = runtime::sawtooth_law(moments, usual_settings(), path_radius, tally);
    EXPECT_TRUE(std::isfinite(law.density + law.x_height + law.y_height + law.rise + law.cell));
    const double longest =
        law.least_rise + law.drop + law.rise * runtime::unit_rise(law.power + law.part, runtime::most_climbed);
    EXPECT_GE(law.cell, longest);  // or a pulse would be lost
    return tally;
  };
  EXPECT_EQ(tally_of(usual_moments(), radius).drawn, 2);
  EXPECT_EQ(tally_of(usual_moments(), radius).capped, 0);
  EXPECT_EQ(tally_of(usual_moments(), radius).length_clamped, 0);
  for (const double ratio : {0.0, 0.1, 0.47, 1.0, 2.0})
    EXPECT_EQ(tally_of(moments_of(0.4e-3, ratio), radius).length_clamped, 1) << ratio;
  EXPECT_EQ(tally_of(moments_of(0.0, 0.3), radius).length_clamped, 1);
  EXPECT_EQ(tally_of(moments_of(0.5e-6, 0.3), radius).length_clamped, 1);
  EXPECT_EQ(tally_of(moments_of(-1.0, 0.3), radius).length_clamped, 1);
  runtime::ForceMoments moments = usual_moments();
  moments.xy_correlation = 0.99;  // more than the ratio of 1.29 and 1.4 allows
  EXPECT_EQ(tally_of(moments, radius).correlation_clamped, 1);
  moments.xy_correlation = -0.1;
  EXPECT_EQ(tally_of(moments, radius).correlation_clamped, 1);
  EXPECT_EQ(tally_of(usual_moments(), 1e-3).narrowed, 1);  // a window of 1 mm
  EXPECT_EQ(tally_of(usual_moments(), 1e-5).narrowed, 1);
  moments = usual_moments();
  moments.x_sd = 0.0;
  EXPECT_EQ(tally_of(moments, radius).capped, 1);
  EXPECT_EQ(
      tally_of({.x_mean = 1e308, .x_sd = 1e308, .correlation_length = 1e308, .short_correlation_length = 1e308}, radius)
          .drawn,
      1);
  EXPECT_EQ(tally_of({.x_mean = -1.0, .x_sd = 1.0}, radius).drawn, 0);
}

TEST(SawtoothLaw, TheMeanIsKeptWhereOtherThingsAreNot) {
  for (const double path_radius : {1e-3, 2e-3, radius}) {
    for (const double sd : {0.0, 1e5}) {
      runtime::ForceMoments moments = usual_moments();
      moments.x_sd = sd;
      const runtime::SawtoothLaw law = law_of(moments, path_radius);
      EXPECT_NEAR(x_density(law) * law.x_height * 0.5 * mean_length(law), moments.x_mean, 1e-6 * moments.x_mean);
    }
  }
}

// Heights do not depend on lengths, so a window too short for a pulse costs neither mean nor deviation.
TEST(SawtoothLaw, AShortWindowCostsLengthsAlone) {
  const runtime::ForceMoments wanted = usual_moments();
  const runtime::SawtoothLaw law = law_of(wanted, 1e-3);
  EXPECT_NEAR(std::sqrt(covariance(law, x_density(law), law.x_height, law.x_height, 0.0)), wanted.x_sd,
              1e-5 * wanted.x_sd);
}

// From sd / mean of 0.25 on, which rock under mud pressure comes near to, nothing is lost.
TEST(SawtoothLaw, ASteadyForceIsMet) {
  for (const auto& [ratio, steadiest] : {std::pair{0.38, 0.2}, {0.3, 0.25}, {0.2, 0.4}}) {
    runtime::ForceMoments moments = moments_of(0.4e-3, ratio);
    moments.x_sd = steadiest * moments.x_mean;
    moments.y_sd = steadiest * moments.y_mean;
    runtime::DrawTally tally;
    runtime::sawtooth_law(moments, usual_settings(), radius, tally);
    EXPECT_EQ(tally.capped, 0) << ratio;
  }
}

TEST(SawtoothCell, LogarithmIsThatOfTheLibrary) {
  base::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double u = i == 0 ? 0x1.0p-25 : std::max(base::uniform(random), 0x1.0p-25), high = 1e3 * u;
    const runtime::FourNumbers x{u, high, 1.0, 2.0};
    runtime::FourNumbers result;
    runtime::logarithm(x, result);
    EXPECT_NEAR(result[0], std::log(u), 1e-9);
    EXPECT_NEAR(result[1], std::log(high), 1e-9);
    EXPECT_EQ(result[2], 0.0);
  }
}

void expect_same(const runtime::FourNumbers& a, const runtime::FourNumbers& b) {
  for (std::size_t lane = 0; lane < 4; ++lane) ASSERT_EQ(a[lane], b[lane]);
}

TEST(SawtoothCell, TheSameBitsForAnyVectors) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  for (std::int64_t window = -50; window < 50; ++window) {
    runtime::CellDraw wide = runtime::cell_draw(law, runtime::window_word(3, 2, window), 0), narrow = wide;
    double before = 0.0;
    while (before < wide.end) {
      runtime::DrawnPulses a, b;
      draw_four(law, {0.7, 1.3}, runtime::has_wide_vectors(), wide, a);
      draw_four(law, {0.7, 1.3}, false, narrow, b);
      expect_same(a.begin, b.begin);
      expect_same(a.pulses.climb, b.pulses.climb);
      expect_same(a.pulses.climb_from, b.pulses.climb_from);
      expect_same(a.pulses.fall, b.pulses.fall);
      expect_same(a.pulses.fall_from, b.pulses.fall_from);
      expect_same(a.pulses.torque, b.pulses.torque);
      expect_same(a.pulses.force, b.pulses.force);
      for (std::size_t lane = 0; lane < 4; ++lane) {
        ASSERT_GE(a.begin[lane], before);
        before = a.begin[lane];
      }
    }
    ASSERT_EQ(wide.last, narrow.last);
  }
}

TEST(SawtoothCell, CountsArePoissonAndKindsHaveTheirShares) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  constexpr int windows = 3000;
  std::vector<double> counts;
  double pulses = 0.0, in_x = 0.0, in_y = 0.0, in_both = 0.0, heights = 0.0, squares = 0.0, rises = 0.0;
  for (int window = 0; window < windows; ++window) {
    double count = 0.0;
    for (std::int64_t cell = 0; cell < law.cells; ++cell) {
      runtime::CellDraw draw = runtime::cell_draw(law, runtime::window_word(9, 4, window), cell);
      runtime::DrawnPulses four;
      do {
        draw_four(law, {1.0, 1.0}, false, draw, four);
        for (std::size_t lane = 0; lane < 4 && four.begin[lane] < draw.end; ++lane) {
          const double a = four.pulses.torque[lane], b = four.pulses.force[lane];
          in_x += a > 0.0;
          in_y += b > 0.0;
          in_both += a > 0.0 && b > 0.0;
          const double g = a > 0.0 ? a / law.x_height : b / law.y_height;
          heights += g;
          squares += g * g;
          rises += 1.0 / four.pulses.climb[lane];
          ASSERT_NEAR(four.pulses.fall[lane], -1.0 / law.drop, 1e-12 / law.drop);
          ++count;
        }
      } while (draw.last < draw.end);
    }
    pulses += count;
    counts.push_back(count);
  }
  const double expected = law.density * usual_settings().window_angle;
  const Estimate mean = estimate(counts);
  EXPECT_NEAR(mean.value, expected, 4.0 * std::sqrt(expected / windows));
  const double dispersion = mean.error * mean.error * windows / mean.value;
  EXPECT_NEAR(dispersion, 1.0, 4.0 * std::sqrt(2.0 / windows));
  const auto expect_share = [&](double seen, double share) {
    EXPECT_NEAR(seen / pulses, share, 4.0 * std::sqrt(share * (1.0 - share) / pulses) + 1.3e-4);
  };
  expect_share(in_x, law.x_below);
  expect_share(in_both, law.both_below);
  expect_share(in_y, 1.0 - law.x_below + law.both_below);
  EXPECT_NEAR(heights / pulses, 1.0, 4.0 / std::sqrt(pulses));
  EXPECT_NEAR(squares / pulses, 2.0, 4.0 * std::sqrt(20.0 / pulses));
  const double rise = over_rises(law, [](double h) { return h; });
  const double spread = std::sqrt(over_rises(law, [](double h) { return h * h; }) - rise * rise);
  EXPECT_NEAR(rises / pulses, rise, 4.0 * spread / std::sqrt(pulses));
}

}  // namespace
