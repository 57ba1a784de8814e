// The laws at the bit against numbers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "runtime/laws/bit_inertia.hpp"
#include "runtime/laws/fracture_spring.hpp"
#include "runtime/laws/friction.hpp"
#include "runtime/laws/hydraulic_force.hpp"
#include "runtime/laws/karnopp.hpp"
#include "runtime/laws/moving_average.hpp"
#include "runtime/laws/progression_angle.hpp"
#include "runtime/laws/rate_of_penetration.hpp"
#include "runtime/laws/rock_contact.hpp"
#include "tests/allocations.hpp"

using namespace bitrock;

namespace {

constexpr double rpm = 2.0 * std::numbers::pi / 60.0;  // [rad/s]

TEST(Friction, SmoothLawHasTheValuesOfTheFormula) {
  const runtime::SmoothFriction law;
  // evaluated apart from this program, to the digits given
  const struct {
    double rpm, mu, slope;
  } cases[] = {{0, 0.0, .1806},        {5, .07846, .1004},      {10, .10741, .02139},
               {20, .10612, -.009875}, {30, .09634, -.007962},  {60, .08240, -.002217},
               {90, .07825, -.000706}, {120, .07703, -.000146}, {180, .07766, .000265}};
  for (const auto& c : cases) {
    EXPECT_NEAR(friction_coefficient(law, c.rpm * rpm), c.mu, 6e-6) << c.rpm;
    EXPECT_NEAR(friction_slope(law, c.rpm * rpm), c.slope, 6e-4 * std::abs(c.slope) + 6e-7) << c.rpm;
    EXPECT_EQ(friction_coefficient(law, -c.rpm * rpm), -friction_coefficient(law, c.rpm * rpm));
  }
  // by hand at x = 1: tanh 1 + 2/2 + 0.01
  EXPECT_NEAR(friction_coefficient(law, 1.0), 0.06 * (std::tanh(1.0) + 1.01), 1e-17);
  EXPECT_NEAR(friction_coefficient(law, 1.412), .11072, 5e-6);  // the highest
  EXPECT_NEAR(friction_coefficient(law, 14.03), .07693, 5e-6);  // the lowest beyond it
  EXPECT_NEAR(friction_slope(law, 1.412), 0.0, 1e-4);
  EXPECT_NEAR(friction_slope(law, 14.03), 0.0, 1e-6);
}

TEST(Friction, SlopesAreThoseOfTheLaws) {
  for (const double gamma : {0.5, 1.0, 1.7}) {
    const runtime::SmoothFriction law{.mu0 = 0.1, .alpha = 3.0, .beta = 0.7, .gamma = gamma, .nu = 0.02};
    const runtime::StribeckFriction stribeck;
    for (const double x : {0.3, 1.0, 4.0, 11.0}) {
      const double h = 1e-5;
      EXPECT_NEAR((friction_coefficient(law, x + h) - friction_coefficient(law, x - h)) / (2 * h),
                  friction_slope(law, x), 1e-10);
      EXPECT_NEAR((friction_coefficient(stribeck, x + h) - friction_coefficient(stribeck, x - h)) / (2 * h),
                  friction_slope(stribeck, x), 1e-10);
    }
  }
}

// The published torque WOB 0.0239 (tanh 1.91 x + 8.5 x / (1 + 5.47 x^2)) is the smooth law in z = 1.91 x
// [LoboTorsional].
TEST(Friction, SmoothLawHoldsThePublishedOneAsASpecialCase) {
  const runtime::SmoothFriction law{
      .mu0 = 0.0239, .alpha = 8.5 / 1.91, .beta = 5.47 / (1.91 * 1.91), .gamma = 1.0, .nu = 0.0};
  for (const double x : {0.1, 0.5, 2.0, 12.0}) {
    EXPECT_NEAR(friction_coefficient(law, 1.91 * x), 0.0239 * (std::tanh(1.91 * x) + 8.5 * x / (1.0 + 5.47 * x * x)),
                1e-16);
  }
}

TEST(Friction, StribeckFallsFromRestingToSliding) {
  const runtime::StribeckFriction law;
  EXPECT_EQ(friction_coefficient(law, 0.0), 0.8);
  EXPECT_NEAR(friction_coefficient(law, 1.0), 0.5 + 0.3 * std::exp(-0.9), 1e-16);
  EXPECT_EQ(friction_coefficient(law, -2.0), friction_coefficient(law, 2.0));
  EXPECT_NEAR(friction_coefficient(law, 50.0), 0.5, 1e-15);
}

TEST(Karnopp, HoldsUpToTheLimitAndThenLetsGoAlongTheTorque) {
  using runtime::karnopp;
  for (const double torque : {0.0, 3.0, -3.0, 8.0, -8.0}) {
    const runtime::DryFriction held = karnopp(0, 0.0, 0.1, torque, 8.0, 5.0);
    EXPECT_EQ(held.direction, 0);
    EXPECT_EQ(held.torque, -torque);
  }
  for (const int sign : {1, -1}) {
    const runtime::DryFriction released = karnopp(0, 0.0, 0.1, sign * 8.0001, 8.0, 5.0);
    EXPECT_EQ(released.direction, sign);
    EXPECT_EQ(released.torque, -sign * 5.0);
    // slides on while it is fast enough: 2 + 0.1 (1 - 5) > 0
    EXPECT_EQ(karnopp(sign, sign * 2.0, 0.1, sign * 1.0, 8.0, 5.0).direction, sign);
    EXPECT_EQ(karnopp(sign, sign * 2.0, 0.1, sign * 1.0, 8.0, 5.0).torque, -sign * 5.0);
    // comes to rest within the step: 0.3 + 0.1 (1 - 5) < 0, and 1 is below the limit
    EXPECT_EQ(karnopp(sign, sign * 0.3, 0.1, sign * 1.0, 8.0, 5.0).direction, 0);
    EXPECT_EQ(karnopp(sign, sign * 0.3, 0.1, sign * 1.0, 8.0, 5.0).torque, -sign * 1.0);
    // thrown back through rest by more than the limit
    EXPECT_EQ(karnopp(sign, sign * 0.3, 0.1, -sign * 9.0, 8.0, 5.0).direction, -sign);
  }
}

TEST(RateOfPenetration, RootLawHasTheValuesOfTheFormula) {
  const runtime::RootAdvance law;
  const auto metres_per_hour = [&](double weight, double speed) {
    return 3600.0 * rate_of_penetration(advance_line(law, speed * rpm, 0.0), weight);
  };
  EXPECT_NEAR(metres_per_hour(100e3, 120), 16.5, 0.05);
  EXPECT_NEAR(metres_per_hour(14.3e3, 60), 1.06, 0.005);
  EXPECT_NEAR(metres_per_hour(24.3e3, 30), 1.41, 0.005);
  // nothing below 1.9e-4 / (1.35e-8 sqrt(x))
  EXPECT_EQ(metres_per_hour(5.60e3, 60), 0.0);
  EXPECT_GT(metres_per_hour(5.62e3, 60), 0.0);
  EXPECT_EQ(metres_per_hour(7.93e3, 30), 0.0);
  EXPECT_GT(metres_per_hour(7.95e3, 30), 0.0);
}

TEST(RateOfPenetration, RegularizedLawHasTheValuesOfTheFormula) {
  const runtime::RegularizedAdvance law;
  const auto metres_per_hour = [&](double weight, double speed) {
    return 3600.0 * rate_of_penetration(advance_line(law, speed * rpm, 0.0), weight);
  };
  EXPECT_NEAR(metres_per_hour(244.2e3, 120), 42.7, 0.05);
  EXPECT_NEAR(metres_per_hour(205e3, 85), 32.4, 0.05);
  EXPECT_NEAR(metres_per_hour(100e3, 60), 10.3, 0.05);
}

TEST(RateOfPenetration, IsNeverNegativeAndNeedsWeightAndRotation) {
  for (const double speed : {-3.0, 0.0}) {
    EXPECT_EQ(rate_of_penetration(advance_line(runtime::RootAdvance{}, speed, 0.0), 1e6), 0.0);
    EXPECT_EQ(rate_of_penetration(advance_line(runtime::RegularizedAdvance{}, speed, 0.0), 1e6), 0.0);
  }
  const runtime::AdvanceLine line{.slope = 1e-8, .offset = 1e-4, .threshold = 2e3};
  EXPECT_EQ(rate_of_penetration(line, 2e3), 0.0);
  EXPECT_NEAR(rate_of_penetration(line, 3e3), 1.3e-4, 1e-19);
  EXPECT_EQ(rate_of_penetration(line, std::nan("")), 0.0);
}

TEST(HydraulicForce, IsPressureTimesAreaWithASign) {
  EXPECT_NEAR(runtime::hydraulic_force(5e6, 3e-4, runtime::JetForce::up), 1500.0, 1e-9);
  EXPECT_NEAR(runtime::hydraulic_force(5e6, 3e-4, runtime::JetForce::down), -1500.0, 1e-9);
}

TEST(BitInertia, IsThatOfACylinder) {
  EXPECT_NEAR(runtime::bit_inertia(65.0, 0.10795), 0.3787, 5e-5);
}

TEST(ProgressionAngle, GrowsOnlyForwardUnderWeight) {
  EXPECT_EQ(runtime::progression(0.1, 3e3, 2e3), 0.1);
  EXPECT_EQ(runtime::progression(0.1, 2e3, 2e3), 0.0);
  EXPECT_EQ(runtime::progression(-0.1, 3e3, 2e3), 0.0);
  EXPECT_EQ(runtime::progression(0.1, 0.0, 0.0), 0.0);  // off bottom
  EXPECT_EQ(runtime::progression(std::nan(""), 3e3, 2e3), 0.0);
}

TEST(FractureSpring, LoadsUpToWhatTheRockBears) {
  using runtime::fracture_spring, runtime::Unloading;
  const auto loading = fracture_spring(0.001, 0.002, 1e4, 100.0, Unloading::free);
  EXPECT_NEAR(loading.torque, 30.0, 1e-12);
  EXPECT_NEAR(loading.twist, 0.003, 1e-18);
  const auto broken = fracture_spring(0.009, 0.005, 1e4, 100.0, Unloading::free);
  EXPECT_EQ(broken.torque, 100.0);
  EXPECT_EQ(broken.twist, 0.01);  // the excess of 0.004 rad is broken rock
  // a limit that falls takes the torque with it, and none or a negative one leaves nothing
  EXPECT_EQ(fracture_spring(0.01, 0.0, 1e4, 40.0, Unloading::free).torque, 40.0);
  EXPECT_EQ(fracture_spring(0.01, 0.001, 1e4, 0.0, Unloading::free).torque, 0.0);
  EXPECT_EQ(fracture_spring(0.01, 0.001, 1e4, -5.0, Unloading::elastic).twist, 0.0);
}

TEST(FractureSpring, BackwardsItIsGoneOrGivesBackWhatItHolds) {
  using runtime::fracture_spring, runtime::Unloading;
  EXPECT_EQ(fracture_spring(0.01, -1e-9, 1e4, 100.0, Unloading::free).torque, 0.0);
  EXPECT_EQ(fracture_spring(0.01, -1e-9, 1e4, 100.0, Unloading::free).twist, 0.0);
  EXPECT_NEAR(fracture_spring(0.01, -0.004, 1e4, 100.0, Unloading::elastic).torque, 60.0, 1e-12);
  EXPECT_EQ(fracture_spring(0.01, -0.04, 1e4, 100.0, Unloading::elastic).torque, 0.0);  // never pulls
}

// Forward through a rock of constant strength and back, in many or few steps: the same torque at the end.
TEST(FractureSpring, DoesNotDependOnTheStep) {
  for (const int steps : {1, 7, 1000}) {
    runtime::FractureSpring spring;
    for (int i = 0; i < steps; ++i)
      spring = runtime::fracture_spring(spring.twist, 0.05 / steps, 1e4, 200.0, runtime::Unloading::elastic);
    EXPECT_EQ(spring.torque, 200.0);
    for (int i = 0; i < steps; ++i)
      spring = runtime::fracture_spring(spring.twist, -0.005 / steps, 1e4, 200.0, runtime::Unloading::elastic);
    EXPECT_NEAR(spring.torque, 150.0, 1e-9);
  }
}

TEST(RockContact, PushesAndNeverPulls) {
  const runtime::RockContact rock{.stiffness = 1e9, .damping = 1e5};
  const runtime::AdvanceLine still;
  EXPECT_EQ(rock_push(rock, still, -1e-3, 5.0).force, 0.0);  // off bottom, however fast it comes
  EXPECT_EQ(rock_push(rock, still, 0.0, 5.0).force, 0.0);
  EXPECT_EQ(rock_push(rock, still, 1e-5, -1.0).force, 0.0);  // leaving faster than the spring pushes: 1e4 - 1e5 < 0
  EXPECT_NEAR(rock_push(rock, still, 1e-5, 0.02).force, 1.2e4, 1e-9);
  EXPECT_EQ(rock_push(rock, still, 1e-5, 0.02).speed, 0.0);
}

// Force and speed of the face satisfy both laws at once, for every weight, law and threshold.
TEST(RockContact, ForceAndFaceBelongTogether) {
  const runtime::RockContact rock{.stiffness = 1e9, .damping = 1e5};
  const runtime::AdvanceLine lines[] = {{.slope = 3e-8, .offset = -2e-4},
                                        {.slope = 3e-8, .offset = -2e-4, .threshold = 9e3},
                                        {.slope = 3e-8, .offset = 1e-4},
                                        {.slope = 0.0, .offset = 1e-3},
                                        {.slope = 0.0, .offset = -1e-3}};
  for (const runtime::AdvanceLine& line : lines) {
    for (double depth = 1e-7; depth < 1e-4; depth *= 1.3) {
      for (const double speed : {-0.01, 0.0, 0.03}) {
        const runtime::RockPush push = rock_push(rock, line, depth, speed);
        const double expected = std::max(0.0, rock.stiffness * depth + rock.damping * (speed - push.speed));
        EXPECT_NEAR(push.force, expected, 1e-9 * expected + 1e-12);
        if (push.force == line.threshold) {  // where the law jumps, the face takes any speed up to that above the jump
          EXPECT_LE(push.speed, rate_of_penetration(line, push.force * (1.0 + 1e-9) + 1e-9) + 1e-12);
        } else {
          EXPECT_NEAR(push.speed, rate_of_penetration(line, push.force), 1e-15);
        }
      }
    }
  }
}

TEST(RockContact, StaysAtAThresholdWhereTheLawJumps) {
  // at 2 kN the face would at once run at 1.6e-4 m/s and take 16 N with it: between, the weight stands at 2 kN
  const runtime::RockContact rock{.stiffness = 1e9, .damping = 1e5};
  const runtime::AdvanceLine line{.slope = 3e-8, .offset = 1e-4, .threshold = 2e3};
  const runtime::RockPush push = rock_push(rock, line, 2.008e-6, 0.0);
  EXPECT_EQ(push.force, 2e3);
  EXPECT_NEAR(push.speed, 8e-5, 1e-15);
}

TEST(MissingAngle, MakesTheAngleOfASmoothRotationRightToSecondOrder) {
  // 60 rpm +- 80 % at 2 Hz; held speeds lag by 2.5 mrad at 1 ms, straight lines by the last step's 0.03
  const auto speed = [](double t) { return 2.0 * std::numbers::pi * (1.0 + 0.8 * std::sin(12.6 * t)); };
  const auto angle = [](double t) { return 2.0 * std::numbers::pi * (t + 0.8 * (1.0 - std::cos(12.6 * t)) / 12.6); };
  double worst[2] = {};
  for (int n = 0; n < 2; ++n) {
    const double h = n == 0 ? 1e-3 : 0.5e-3;
    double reached = 0.0, before = speed(0.0);
    for (int i = 0; i * h < 1.0; ++i) {
      reached += i > 0 ? runtime::missing_angle(before, speed(i * h), h) : 0.0;
      before = speed(i * h);
      reached += h * before;
      worst[n] = std::max(worst[n], std::fabs(reached - angle((i + 1) * h)));
    }
  }
  EXPECT_LT(worst[0], 4e-5);
  EXPECT_NEAR(worst[0] / worst[1], 4.0, 0.2);
}

TEST(MissingAngle, IsNoneWhereTheSpeedJumps) {
  EXPECT_EQ(runtime::missing_angle(5.0, 5.0, 0.1), 0.0);
  EXPECT_EQ(runtime::missing_angle(0.0, 5.0, 0.1), 0.0);
  EXPECT_EQ(runtime::missing_angle(5.0, 0.0, 0.1), 0.0);
  EXPECT_EQ(runtime::missing_angle(0.0, 0.0, 0.1), 0.0);
  EXPECT_EQ(runtime::missing_angle(2.0, 6.5, 0.1), 0.0);
  EXPECT_EQ(runtime::missing_angle(6.0, 2.0, 0.1), -0.2);
  EXPECT_EQ(runtime::missing_angle(2.0, 6.0, 0.0), 0.0);
  // what is taken back is never more than the next step of that length adds
  for (const double after : {2.0, 2.1, 3.0, 5.9}) EXPECT_GE(runtime::missing_angle(6.0, after, 0.1) + 0.1 * after, 0.0);
}

TEST(MovingAverage, AConstantComesOutAtOnce) {
  runtime::MovingAverage average;
  EXPECT_EQ(mean(average), 0.0);
  double time = 3.0;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_TRUE(accept(average, time, 6.3));
    ASSERT_EQ(mean(average), 6.3);
    time += i % 3 == 0 ? 1e-4 : 7e-4;
  }
}

// To the last bit, however often and from wherever the signal came: a rate of penetration of 0 must end as 0.
TEST(MovingAverage, AWindowAfterAJumpTheMeanIsTheNewValue) {
  for (const double step : {3e-6, 1e-4, 1e-3, 7e-3, 0.05, 0.3, 100.0}) {
    runtime::MovingAverage average;
    double time = 0.0, value = 0.1;
    accept(average, time, value);
    for (const double next : {0.0, 4.1e-3, 0.0, -7.7, 1e-300, 0.0, 12.566370614359172, 3e-3}) {
      // some steps of changing values, then the next one until it alone is in the window
      for (int i = 0; i < 50; ++i) accept(average, time += step, value * (1.0 + 0.01 * i));
      value = next;
      accept(average, time += step, value);
      const double jumped = time;
      double between = mean(average);
      while (time - jumped < 0.1) {
        between = mean(average);
        accept(average, time += step, value);
      }
      for (int i = 0; i < 20; ++i) {
        accept(average, time += step, value);
        ASSERT_EQ(mean(average), value) << step;
      }
      ASSERT_TRUE(std::isfinite(between));
    }
  }
}

// A ramp comes out 50 ms late, exactly, whatever the steps: steps longer than a piece are kept one by one.
TEST(MovingAverage, ARampIsHalfAWindowLate) {
  runtime::MovingAverage average;
  double time = 0.0;
  for (int i = 0; i < 3000; ++i) {
    accept(average, time, 5.0 * time);
    if (time > 0.1) {
      ASSERT_NEAR(mean(average), 5.0 * (time - 0.05), 1e-11);
    } else {
      ASSERT_NEAR(mean(average), 2.5 * time, 1e-12);  // of what is known
    }
    time += i % 5 == 0 ? 3.1e-3 : 4.3e-4;
  }
}

// A sine of frequency f comes out with the gain sin(pi f T) / (pi f T), 50 ms late: 0.738 at 4.17 Hz, nothing at 10 Hz.
TEST(MovingAverage, HasTheGainOfAWindow) {
  const struct { double frequency, gain; } cases[] = {{4.17, .738}, {5.3, .598}, {10.0, 0.0}};
  for (const auto& c : cases) {
    for (const double step : {2e-5, 1e-4, 1e-3}) {
      runtime::MovingAverage average;
      const double omega = 2.0 * std::numbers::pi * c.frequency, half = 0.5 * omega * 0.1;
      const double gain = std::sin(half) / half;
      EXPECT_NEAR(gain, c.gain, 5e-4);
      for (int i = 0; i * step < 0.5; ++i) {
        accept(average, i * step, std::sin(omega * i * step));
        // straight lines between samples and shared pieces: (omega h)^2 / 12, h the longer of step and 0.4 ms
        const double h = std::max(step, 4e-4);
        if (i * step > 0.1) {
          ASSERT_NEAR(mean(average), gain * std::sin(omega * (i * step - 0.05)), omega * omega * h * h / 12.0 + 1e-12);
        }
      }
    }
  }
}

// The mean of a step signal, sampled unevenly, against the integral by hand.
TEST(MovingAverage, WeighsByTimeAndNotByCount) {
  runtime::MovingAverage average;
  accept(average, 0.0, 1.0);
  accept(average, 0.08, 1.0);
  for (int i = 0; i < 20; ++i) accept(average, 0.081 + 0.001 * i, 3.0);
  // 0 to 0.08: 1; 0.08 to 0.081: from 1 to 3; to 0.1: 3
  EXPECT_NEAR(mean(average), (0.08 * 1.0 + 0.001 * 2.0 + 0.019 * 3.0) / 0.1, 1e-12);
}

// However uneven the steps, the window of a ramp begins in the right piece: its mean is the value half a window ago.
TEST(MovingAverage, FindsTheBeginningOfTheWindowAmongUnevenSteps) {
  std::uint64_t draw = 1;
  for (const double longest : {5e-4, 5e-3, 0.04, 0.09}) {
    runtime::MovingAverage average;
    double time = 0.0;
    for (int i = 0; i < 2000; ++i) {
      draw = base::mix(draw);
      const double share = static_cast<double>(draw >> 11) * 0x1p-53;
      time += longest * share * share * share + 1e-6;  // most steps are short, some long
      accept(average, time, 3.0 * time);
      if (time > 0.2) {
        ASSERT_NEAR(mean(average), 3.0 * (time - 0.05), 1e-10) << longest << " " << i;
      }
    }
  }
}

TEST(MovingAverage, RefusesTimeThatStandsOrGoesBackAndWhatIsNoNumber) {
  runtime::MovingAverage average;
  EXPECT_TRUE(accept(average, 1.0, 2.0));
  EXPECT_TRUE(accept(average, 1.01, 4.0));
  const double before = mean(average);
  EXPECT_FALSE(accept(average, 1.01, 100.0));
  EXPECT_FALSE(accept(average, 0.5, 100.0));
  EXPECT_FALSE(accept(average, std::nan(""), 100.0));
  EXPECT_FALSE(accept(average, 1.02, std::nan("")));
  EXPECT_FALSE(accept(average, 1.02, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(mean(average), before);
}

TEST(MovingAverage, ACopyIsAWholeState) {
  runtime::MovingAverage average;
  for (int i = 0; i < 500; ++i) accept(average, 1e-3 * i, std::sin(0.3 * i));
  const runtime::MovingAverage kept = average;
  for (int i = 500; i < 600; ++i) accept(average, 1e-3 * i, 7.0);
  runtime::MovingAverage again = kept;
  EXPECT_NE(mean(again), mean(average));
  for (int i = 500; i < 600; ++i) accept(again, 1e-3 * i, 7.0);
  EXPECT_EQ(mean(again), mean(average));
}

}  // namespace
