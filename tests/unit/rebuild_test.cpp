// What makes a rebuilt force like the DEM's: rainflow, octaves over travel, and their comparison.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "peaks/rainflow.hpp"
#include "studies/rebuild/likeness.hpp"

using namespace bitrock;

namespace {

using Values = std::vector<double>;

struct Cycle {
  double range, mean, cycles;
  bool operator==(const Cycle&) const = default;
};

std::vector<Cycle> cycles_of(const Values& signal) {
  std::vector<Cycle> all;
  peaks::Rainflow rainflow([&all](double range, double mean, double cycles) { all.push_back({range, mean, cycles}); });
  for (const double value : signal) rainflow.add(value);
  rainflow.finish();
  return all;
}

TEST(Rainflow, OfTheExampleOfTheStandard) {
  // the worked example of ASTM E1049: ranges 3, 4, 6, 8, 9 with 0.5, 1.5, 0.5, 1, 0.5 cycles
  const std::vector<Cycle> expected{{3, -0.5, 0.5}, {4, -1, 0.5}, {4, 1, 1},  {8, 1, 0.5},
                                    {9, 0.5, 0.5},  {8, 0, 0.5},  {6, 1, 0.5}};
  EXPECT_EQ(cycles_of({-2, 1, -3, 5, -1, 3, -4, 4, -2}), expected);
}

TEST(Rainflow, PointsOnTheWayAndRestsCountForNothing) {
  const Values turning{-2, 1, -3, 5, -1, 3, -4, 4, -2};
  Values fine;
  for (std::size_t i = 0; i + 1 < turning.size(); ++i) {
    for (int k = 0; k < 7; ++k) fine.push_back(turning[i] + (turning[i + 1] - turning[i]) * k / 7.0);
    fine.push_back(fine.back());
  }
  fine.push_back(turning.back());
  EXPECT_EQ(cycles_of(fine), cycles_of(turning));
  EXPECT_TRUE(cycles_of({3, 3, 3}).empty());
  EXPECT_TRUE(cycles_of({}).empty());
  EXPECT_EQ(cycles_of({0, 2}), (std::vector<Cycle>{{2, 1, 0.5}}));
}

TEST(Rainflow, TheDamageEquivalentRangeOfASineIsItsOwn) {
  Values sine;
  const int waves = 400, samples_each = 64;
  for (int i = 0; i < waves * samples_each; ++i)
    sine.push_back(5.0 + 3.0 * std::sin(2.0 * std::numbers::pi * i / samples_each));
  // 400 cycles of the range 6 over 2 m: (200 6^4)^(1/4); the two ends are half cycles, an 800th of the sum
  EXPECT_NEAR(peaks::damage_equivalent_range(sine, 2.0, 4.0), 6.0 * std::pow(200.0, 0.25), 22.6 / 4.0 / 800.0);
}

TEST(Octaves, AWaveStandsInItsBandWithItsVariance) {
  const double spacing = 20e-6;
  for (const auto& [waves_per_mm, band] : {std::pair{0.15, 0u}, {0.3, 1u}, {1.0, 3u}, {5.0, 5u}, {8.0, 6u}}) {
    Values wave;
    for (int i = 0; i < 5000; ++i)  // 100 mm
      wave.push_back(7.0 + 3.0 * std::sin(2.0 * std::numbers::pi * waves_per_mm * 1e3 * spacing * i));
    const auto levels = studies::octave_levels(wave, spacing);
    for (std::size_t k = 0; k < levels.size(); ++k) EXPECT_NEAR(levels[k], k == band ? 4.5 : 0.0, 1e-9) << waves_per_mm;
  }
}

TEST(Octaves, OfWhiteNoiseAddUpToTheShareOfTheBands) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Values noise(200000);
  for (double& value : noise) value = normal(random);
  const auto levels = studies::octave_levels(noise, 20e-6);  // up to 25 per mm
  double sum = 0.0;
  for (const double level : levels) sum += level;
  EXPECT_NEAR(sum, (9.0 - 0.1) / 25.0, 0.01);
  EXPECT_NEAR(levels[5], 3.2 / 25.0, 0.005);
  EXPECT_EQ(studies::octave_levels(Values{}, 1.0)[0], 0.0);
  EXPECT_EQ(studies::octave_levels(Values{5.0}, 1.0)[0], 0.0);
}

Values rough_force(int seed) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::exponential_distribution<double> step(1.0);
  Values force(5000);
  double value = 0.0;
  for (double& sample : force) sample = value = 0.97 * value + 0.1 * step(random);
  return force;
}

TEST(Likeness, AForceIsLikeItselfAndTwiceItIsTwiceAsLarge) {
  const Values x = rough_force(1), y = rough_force(2);
  Values twice = x;
  for (double& value : twice) value *= 2.0;
  const peaks::PeakDefinition definition = peaks::converging(0.5e-3);
  const studies::Portrait dem = studies::portrait({x, y, 20e-6}, definition);
  const studies::Likeness same = studies::compare(dem, dem);
  EXPECT_EQ(same.x.mean_ratio, 1.0);
  EXPECT_EQ(same.y.damage_range_ratio, 1.0);
  EXPECT_EQ(same.x.octave_difference[3], 0.0);
  const studies::Likeness other = studies::compare(dem, studies::portrait({twice, y, 20e-6}, definition));
  EXPECT_NEAR(other.x.mean_ratio, 2.0, 1e-12);
  EXPECT_NEAR(other.x.sd_ratio, 2.0, 1e-12);
  EXPECT_NEAR(other.x.damage_range_ratio, 2.0, 1e-12);
  EXPECT_NEAR(other.x.correlation_length_ratio, 1.0, 1e-9);
  EXPECT_EQ(other.x.low_share, other.x.low_share_dem);
  for (const double difference : other.x.octave_difference) EXPECT_NEAR(difference, 20.0 * std::log10(2.0), 1e-9);
  EXPECT_NEAR(other.xy_correlation, other.xy_correlation_dem, 1e-12);
}

TEST(Likeness, MeansOfPortraitsAreThoseOfTheirNumbers) {
  const Values a = rough_force(1), b = rough_force(2);
  const peaks::PeakDefinition definition = peaks::converging(0.5e-3);
  const studies::Portrait one = studies::portrait({a, b, 20e-6}, definition),
                          two = studies::portrait({b, a, 20e-6}, definition);
  const studies::Portrait mean = studies::mean_of(std::vector{one, two});
  EXPECT_DOUBLE_EQ(mean.x.moments.mean, 0.5 * (one.x.moments.mean + two.x.moments.mean));
  EXPECT_DOUBLE_EQ(mean.x.damage_range,
                   std::pow(0.5 * (std::pow(one.x.damage_range, 4.0) + std::pow(two.x.damage_range, 4.0)), 0.25));
  EXPECT_EQ(mean.x.peaks.count(), one.x.peaks.count() + two.x.peaks.count());
  EXPECT_DOUBLE_EQ(mean.x.octaves[2], 0.5 * (one.x.octaves[2] + two.x.octaves[2]));
  EXPECT_DOUBLE_EQ(mean.x.moments.short_correlation_length,
                   0.5 * (one.x.moments.short_correlation_length + two.x.moments.short_correlation_length));
  EXPECT_DOUBLE_EQ(mean.xy_correlation, one.xy_correlation);
}

}  // namespace
