// Ten steps against numbers computed apart from this code, the two places of epsilon, and minima of named functions.
#include "surrogate/train/adam.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace bitrock;

namespace {

TEST(SurrogateAdam, TenStepsAgreeWithTheRecurrenceInDecimalArithmetic) {
  // f = p0^2 + 10 p1^2 from (1, -0.5), alpha = 0.1, beta1 = 0.9, beta2 = 0.999, epsilon = 1e-7. For t = 1..10:
  //   g = (2 p0, 20 p1),  m = 0.9 m + 0.1 g,  v = 0.999 v + 0.001 g^2,
  //   p = p - 0.1 sqrt(1 - 0.999^t) / (1 - 0.9^t) m / (sqrt(v) + 1e-7),
  // evaluated with 50 decimal digits.
  constexpr std::array<std::array<double, 2>, 10> expected{{{0.90000015811363301, -0.40000003162276660},
                                                            {0.80041250194377462, -0.30118747499214730},
                                                            {0.70158664312671618, -0.20487132439333361},
                                                            {0.60393951564897814, -0.11291548441002511},
                                                            {0.50796418952859778, -0.02781454662907090},
                                                            {0.41423705219953175, 0.04743142486772898},
                                                            {0.32342135722933318, 0.10978877440964740},
                                                            {0.23626442172608782, 0.15694593593531288},
                                                            {0.15358528926148520, 0.18795141016735863},
                                                            {0.07624990191235925, 0.20332279622244770}}};
  const surrogate::AdamOptions options{.learning_rate = 0.1};
  surrogate::AdamState state;
  std::array<double, 2> p{1.0, -0.5};
  for (std::size_t t = 0; t < expected.size(); ++t) {
    const std::array<double, 2> gradient{2.0 * p[0], 20.0 * p[1]};
    surrogate::adam_step(options, state, gradient, p);
    EXPECT_NEAR(p[0], expected[t][0], 1e-14) << "step " << t + 1;
    EXPECT_NEAR(p[1], expected[t][1], 1e-14) << "step " << t + 1;
  }
}

TEST(SurrogateAdam, EpsilonStandsOutsideTheBiasCorrection) {
  // First step for g = 1e-6: m = 1e-7, sqrt(v) = sqrt(0.001) 1e-6, step = alpha sqrt(0.001) / 0.1, so
  // p = -alpha g / (g + epsilon / sqrt(0.001)). Algorithm 1 of the paper would give -alpha g / (g + epsilon).
  const surrogate::AdamOptions options{.learning_rate = 1.0};
  surrogate::AdamState state;
  std::array<double, 1> p{0.0};
  const std::array<double, 1> gradient{1e-6};
  surrogate::adam_step(options, state, gradient, p);
  EXPECT_NEAR(p[0], -1.0 / (1.0 + 0.1 / std::sqrt(0.001)), 1e-12);
  EXPECT_GT(std::abs(p[0] + 1.0 / 1.1), 0.6);
}

TEST(SurrogateAdam, AZeroGradientMovesNothing) {
  surrogate::AdamState state;
  std::array<double, 2> p{3.0, -4.0};
  const std::array<double, 2> gradient{0.0, 0.0};
  surrogate::adam_step({}, state, gradient, p);
  EXPECT_EQ(p, (std::array<double, 2>{3.0, -4.0}));
}

TEST(SurrogateAdam, FindsTheMinimumOfRosenbrock) {
  // f = (1 - x)^2 + 100 (y - x^2)^2 [Rosenbrock1960], minimum 0 at (1, 1), usual start (-1.2, 1).
  const surrogate::AdamOptions options{.learning_rate = 0.01};
  surrogate::AdamState state;
  std::array<double, 2> p{-1.2, 1.0};
  for (int step = 0; step < 40000; ++step) {
    const double x = p[0], y = p[1];
    const std::array<double, 2> gradient{-2.0 * (1.0 - x) - 400.0 * x * (y - x * x), 200.0 * (y - x * x)};
    surrogate::adam_step(options, state, gradient, p);
  }
  EXPECT_NEAR(p[0], 1.0, 1e-6);
  EXPECT_NEAR(p[1], 1.0, 1e-6);
}

}  // namespace
