// Error and bias of a network, with the scatter of the data taken out: by hand, and over lots drawn with a known error.
#include "surrogate/train/network_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "surrogate/train/noise_floor.hpp"

using namespace bitrock;

namespace {

using surrogate::JudgedCase;
using surrogate::network_error;
using surrogate::NetworkError;

/// As many cases as asked for, of values from 1 up, by a network whose (p - truth) / p has this deviation, and cuts of
/// this scatter [1].
std::vector<JudgedCase> drawn(base::Random& random, int count, double error, double scatter) {
  std::vector<JudgedCase> cases;
  for (int i = 1; i <= count; ++i) {
    const double truth = i, prediction = truth / (1.0 - error * base::normal(random));
    cases.push_back({.prediction = prediction,
                     .dem_mean = truth * (1.0 + scatter * base::normal(random)),
                     .standard_error = truth * scatter});
  }
  return cases;
}

TEST(NetworkErrors, TwoCasesByHand) {
  const std::vector<JudgedCase> cases{{10.0, 8.0, 1.0}, {20.0, 25.0, 2.0}};
  const NetworkError error = *network_error(cases, 30.0);
  const double squares = (0.04 + 0.0625) / 2, q = 0.01;
  EXPECT_NEAR(error.rms, std::sqrt(squares - q), 1e-15);
  EXPECT_NEAR(error.rms_high, std::sqrt(squares / surrogate::f_quantile(0.025, 2.0, 30.0) - q), 1e-12);
  EXPECT_NEAR(error.bias, (0.2 - 0.25) / 2, 1e-15);
  EXPECT_NEAR(error.bias_chance, 1.959963984540054 * std::sqrt(0.01 / 2), 1e-15);
}

/// Of many networks of the same error [1]: how often the upper end is not below it, and the root of the mean of e^2.
struct Covered {
  double share, error;
};

Covered covered(double error, double scatter) {
  constexpr int lots = 4000, cases = 12;
  base::Random random(7);
  int inside = 0;
  double squares = 0.0;
  for (int lot = 0; lot < lots; ++lot) {
    const NetworkError found = *network_error(drawn(random, cases, error, scatter), 1e6);
    inside += error <= found.rms_high ? 1 : 0;
    squares += found.rms * found.rms;
  }
  return {.share = inside / static_cast<double>(lots), .error = std::sqrt(squares / lots)};
}

TEST(NetworkErrors, TheUpperEndIsAboveTheTruthAsOftenAsItSays) {
  const Covered large = covered(0.1, 0.05), small = covered(0.02, 0.1);
  EXPECT_NEAR(large.share, 0.975, 0.01);  // 4 standard errors of a binomial share
  EXPECT_NEAR(large.error, 0.1, 0.003);
  EXPECT_EQ(small.share, 1.0) << "an error below what 12 cases can show";
}

TEST(NetworkErrors, ByChanceCloserThanTheScatterIsNoProofOfNoError) {
  const std::vector<JudgedCase> none{{10.0, 10.0, 1.0}, {20.0, 20.0, 2.0}};
  const NetworkError error = *network_error(none, 30.0);
  EXPECT_EQ(error.rms, 0.0);
  EXPECT_NEAR(error.rms_high, std::sqrt(0.01 / surrogate::f_quantile(0.025, 2.0, 30.0) - 0.01), 1e-12);
}

TEST(NetworkErrors, AFaultlessNetworkHasNoBiasHoweverMuchTheDataScatter) {
  constexpr int lots = 4000, cases = 12;
  constexpr double scatter = 0.3;
  base::Random random(11);
  int inside = 0;
  double sum = 0.0;
  for (int lot = 0; lot < lots; ++lot) {
    const NetworkError found = *network_error(drawn(random, cases, 0.0, scatter), 1e6);
    inside += std::abs(found.bias) <= found.bias_chance ? 1 : 0;
    sum += found.bias;
  }
  EXPECT_NEAR(inside / static_cast<double>(lots), 0.95, 4.0 * std::sqrt(0.95 * 0.05 / lots));
  EXPECT_NEAR(sum / lots, 0.0, 4.0 * scatter / std::sqrt(1.0 * lots * cases));
}

TEST(NetworkErrors, AreAbsentWhereTheyCannotBeSaid) {
  EXPECT_FALSE(network_error({}, 10.0));
  EXPECT_FALSE(network_error(std::vector<JudgedCase>{{1.0, 2.0, 0.1}}, 10.0));
  EXPECT_FALSE(network_error(std::vector<JudgedCase>{{1.0, 2.0, 0.0}, {1.0, 2.0, 0.0}}, 10.0)) << "no scatter known";
  EXPECT_FALSE(network_error(std::vector<JudgedCase>{{1.0, 2.0, 0.1}, {1.0, 2.0, 0.1}}, 0.0));
  EXPECT_FALSE(network_error(std::vector<JudgedCase>{{1.0, 2.0, 0.1}, {0.0, 2.0, 0.1}}, 10.0)) << "nothing to share";
}

}  // namespace
