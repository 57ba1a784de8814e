// Force and torque of a whole bit, from networks that answer what the test wants: superposition, clamping, magnitude,
// and the history at constant speed.
#include "runtime/bit/bit_force.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "runtime/bit/constant_speed.hpp"
#include "runtime/core/conditions.hpp"
#include "runtime/signal/cutter_force.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

using runtime_test::constant_model;
using runtime_test::usual_pair;

constexpr double pi = std::numbers::pi;
constexpr double rpm = 2.0 * pi / 60.0;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

runtime::Bit shipped_bit() {
  return runtime::read_bit(std::filesystem::path(BITROCK_SOURCE_DIR) / "campaigns/bits/pdc15.toml");
}

runtime::Bit bit_of(std::vector<runtime::Cutter> cutters) {
  runtime::Bit bit{.name = "test", .diameter = 0.2, .cutters = std::move(cutters)};
  bit.signal.window_angle = pi / 3.0;
  bit.signal.seed = 5;
  return bit;
}

runtime::Cutter cutter(int number, double radius = 0.08, double width = 0.01) {
  return {.number = number, .radius = radius, .width = width, .back_rake = 20.0 * pi / 180.0};
}

/// 60 rpm and 2 mm a turn.
runtime::BitMotion moving(double angle) {
  return {.angle = angle, .rotation = 60.0 * rpm, .rate_of_penetration = 2e-3};
}

TEST(CutConditions, DepthTimesTurnsIsRateOfPenetration) {
  for (const double rotation : {0.5, 6.28, 20.0}) {
    for (const double rop : {1e-4, 2e-3, 1e-2}) {
      const surrogate::CutConditions c = runtime::cut_conditions(0.07, 0.3, rotation, rop);
      EXPECT_DOUBLE_EQ(c.depth_of_cut * rotation / (2.0 * pi), rop);
      EXPECT_DOUBLE_EQ(c.cutter_speed, rotation * 0.07);
      EXPECT_EQ(c.back_rake, 0.3);
    }
  }
}

TEST(BitForce, IsTheSumOfItsCuttersWithTheirArms) {
  const std::vector<runtime::Cutter> cutters{cutter(1, 0.03, 0.02), cutter(2, 0.06, 0.01), cutter(3, 0.09, 0.005)};
  runtime::BitForce whole(bit_of(cutters), constant_model(usual_pair()));
  std::vector<runtime::CutterForce> parts;
  for (const runtime::Cutter& c : cutters) {
    parts.push_back(runtime_test::cutter_force(bit_of(cutters).signal, c.number, c.radius));
  }
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.01 * i, window_angle = pi / 3.0, k = std::floor(angle / window_angle);
    double force = 0.0, torque = 0.0;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      enter_window(parts[n], static_cast<std::int64_t>(k), usual_pair());
      const runtime::ForcePerMetre f = force_at(parts[n].train, runtime::Combine::sum, angle - k * window_angle);
      force += f.y * cutters[n].width;
      torque += f.x * cutters[n].width * cutters[n].radius;
    }
    const runtime::BitLoad load = whole.at(moving(angle));
    ASSERT_NEAR(load.axial_force, force, 1e-15 * 10.0 * (1.0 + force));
    ASSERT_NEAR(load.torque, torque, 1e-15 * 10.0 * (1.0 + torque));
  }
}

TEST(BitForce, OrderOfCuttersDoesNotMatter) {
  runtime::BitForce forward(bit_of({cutter(1, 0.03), cutter(2, 0.06), cutter(3, 0.09)}), constant_model(usual_pair()));
  runtime::BitForce backward(bit_of({cutter(3, 0.09), cutter(2, 0.06), cutter(1, 0.03)}), constant_model(usual_pair()));
  for (int i = 0; i < 2000; ++i) {
    const runtime::BitLoad a = forward.at(moving(0.01 * i)), b = backward.at(moving(0.01 * i));
    ASSERT_NEAR(a.axial_force, b.axial_force, 1e-14 * a.axial_force);
    ASSERT_NEAR(a.torque, b.torque, 1e-14 * a.torque);
  }
}

TEST(BitForce, IdenticalCuttersAddUpOrAverageOut) {
  const int count = 9;
  std::vector<runtime::Cutter> same, different;
  for (int n = 0; n < count; ++n) same.push_back(cutter(1)), different.push_back(cutter(n + 1));
  runtime::BitForce one(bit_of({cutter(1)}), constant_model(usual_pair()));
  runtime::BitForce equal_seeds(bit_of(same), constant_model(usual_pair()));
  runtime::BitForce own_seeds(bit_of(different), constant_model(usual_pair()));

  // one sample every second window: pulses reach one window at most, so the samples are independent
  const int samples = 6000;
  double sum_one = 0, sum_own = 0, square_one = 0, square_own = 0, fourth_one = 0;
  const double mean_one = 0.5 * usual_pair().y.amean * 0.01;  // amean / 2 on 10 mm
  for (int i = 0; i < samples; ++i) {
    const double angle = (2.0 * i + 0.5) * pi / 3.0;
    const double f1 = one.at(moving(angle)).axial_force, fn = own_seeds.at(moving(angle)).axial_force;
    ASSERT_NEAR(equal_seeds.at(moving(angle)).axial_force, count * f1, 1e-14 * count * f1);
    sum_one += f1, sum_own += fn;
    const double d1 = f1 - mean_one, dn = fn - count * mean_one;
    square_one += d1 * d1, square_own += dn * dn, fourth_one += d1 * d1 * d1 * d1;
  }
  const double variance_one = square_one / samples, variance_own = square_own / samples;
  const double kurtosis = fourth_one / samples / (variance_one * variance_one);
  EXPECT_NEAR(sum_one / samples, mean_one, 4.0 * std::sqrt(variance_one / samples));
  EXPECT_NEAR(sum_own / samples, count * mean_one, 4.0 * std::sqrt(variance_own / samples));
  // relative standard error of a variance: sqrt((kurtosis - 1) / n); the sum is nearer to normal than one cutter
  EXPECT_NEAR(variance_own / (count * variance_one), 1.0, 4.0 * std::sqrt(2.0 * (kurtosis - 1.0) / samples));
}

TEST(BitForce, DepthOfCutReachesTheNetwork) {
  const runtime::CutterStatistics at_1_mm = usual_pair();
  runtime::BitForce proportional(shipped_bit(), runtime_test::depth_proportional_model(at_1_mm));
  runtime::BitForce constant(shipped_bit(), constant_model(at_1_mm));
  for (int i = 0; i < 500; ++i) {
    const runtime::BitLoad a = proportional.at(moving(0.02 * i)), b = constant.at(moving(0.02 * i));
    ASSERT_NEAR(a.axial_force, 2.0 * b.axial_force, 1e-12 * b.axial_force);  // 2 mm a turn
    ASSERT_NEAR(a.torque, 2.0 * b.torque, 1e-12 * b.torque);
  }
}

TEST(BitForce, ClampingIsCountedPerReason) {
  // trained on 0.05-1 m/s, 0.2-4 mm, 10-30 degrees
  runtime::Cutter inner = cutter(1, 0.005), steep = cutter(2, 0.05), flat = cutter(3, 0.05), outer = cutter(4, 0.2);
  steep.back_rake = 40.0 * pi / 180.0;
  flat.back_rake = 0.0;
  runtime::BitForce force(bit_of({inner, steep, flat, outer}), constant_model(usual_pair()));
  force.at(moving(0.5));
  EXPECT_EQ(force.clamps().asked, 4);
  EXPECT_EQ(force.clamps().speed_below, 1);
  EXPECT_EQ(force.clamps().speed_above, 1);
  EXPECT_EQ(force.clamps().rake_above, 1);
  EXPECT_EQ(force.clamps().rake_below, 1);
  EXPECT_EQ(force.clamps().depth_below + force.clamps().depth_above, 0);
  force.at({.angle = 2.0, .rotation = 60.0 * rpm, .rate_of_penetration = 1e-4});
  EXPECT_EQ(force.clamps().depth_below, 4);
  force.at({.angle = 3.0, .rotation = 60.0 * rpm, .rate_of_penetration = 1e-2});
  EXPECT_EQ(force.clamps().depth_above, 4);
  EXPECT_EQ(force.clamps().asked, 12);
  EXPECT_EQ(force.clamps().clamped(), 3 * 4 + 8);
  force.at(moving(3.1));  // the same window: nothing is asked
  force.at(moving(1.5));  // a window that is still kept
  EXPECT_EQ(force.clamps().asked, 12);
}

TEST(BitForce, ClampedConditionsGiveTheForceAtTheEdge) {
  const surrogate::Model model = runtime_test::depth_proportional_model(usual_pair());
  runtime::BitForce beyond(shipped_bit(), model), edge(shipped_bit(), model);
  for (int i = 0; i < 200; ++i) {
    const runtime::BitMotion far{.angle = 0.1 * i, .rotation = 60.0 * rpm, .rate_of_penetration = 9e-3};
    const runtime::BitMotion at_edge{.angle = 0.1 * i, .rotation = 60.0 * rpm, .rate_of_penetration = 4e-3};
    ASSERT_NEAR(beyond.at(far).torque, edge.at(at_edge).torque, 1e-12 * edge.at(at_edge).torque);
  }
}

TEST(BitForce, StandingBitAndNoPenetrationStayFinite) {
  runtime::BitForce force(shipped_bit(), constant_model(usual_pair()));
  for (const double rotation : {0.0, -3.0, 1e-300}) {
    const runtime::BitLoad load = force.at({.angle = 1.0, .rotation = rotation, .rate_of_penetration = 1e-3});
    EXPECT_TRUE(std::isfinite(load.axial_force) && std::isfinite(load.torque));
  }
  runtime::BitForce idle(shipped_bit(), constant_model(usual_pair()));
  for (int i = 0; i < 100; ++i) {
    const runtime::BitLoad load = idle.at({.angle = 0.1 * i, .rotation = 0.0, .rate_of_penetration = -1e-3});
    EXPECT_EQ(load.axial_force, 0.0);
    EXPECT_EQ(load.torque, 0.0);
  }
  EXPECT_EQ(idle.clamps().asked, 0);
}

TEST(BitForce, NotANumberIsAnErrorWhereverItComesFrom) {
  runtime::BitForce force(shipped_bit(), constant_model(usual_pair()));
  EXPECT_THROW(force.at({.angle = not_a_number, .rotation = 1.0, .rate_of_penetration = 1e-3}), base::SimulationError);
  EXPECT_THROW(force.at({.angle = 1e30, .rotation = 1.0, .rate_of_penetration = 1e-3}), base::SimulationError);
  EXPECT_THROW(force.at({.rotation = not_a_number, .rate_of_penetration = 1e-3}), base::SimulationError);
  EXPECT_THROW(force.at({.rotation = 1.0, .rate_of_penetration = not_a_number}), base::SimulationError);
}

TEST(BitForce, AModelThatOverflowsIsNamedWithCutterAndOutput) {
  surrogate::Model broken = constant_model(usual_pair());
  broken.outputs[7].network.parameters = {0.0, 1e300, 0.0, 0.0};
  broken.outputs[7].variable.scale = 1e300;
  runtime::BitForce force(bit_of({cutter(4), cutter(5)}), broken);
  try {
    force.at(moving(0.0));
    FAIL();
  } catch (const base::SimulationError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 58), "cutter 4: predicted y_np1_per_m is not a finite number at ")
        << error.what();
  }
  EXPECT_EQ(force.clamps().asked, 0);
  EXPECT_EQ(force.draws().drawn, 0);
}

TEST(BitForce, RefusesABitThatCannotBeUsed) {
  const surrogate::Model model = constant_model(usual_pair());
  EXPECT_THROW(runtime::BitForce(bit_of({}), model), base::InputError);
  EXPECT_THROW(runtime::BitForce(bit_of({cutter(1, 0.0)}), model), base::InputError);
  EXPECT_THROW(runtime::BitForce(bit_of({cutter(1, 0.05, -1.0)}), model), base::InputError);
  runtime::Bit wide = bit_of({cutter(1)});
  wide.signal.pulse_width_factor = 2.5;
  EXPECT_THROW(runtime::BitForce(wide, model), base::InputError);
  wide.signal = {.window_angle = not_a_number};
  EXPECT_THROW(runtime::BitForce(wide, model), base::InputError);
  surrogate::Model broken = model;
  broken.outputs[7].network.parameters[3] = not_a_number;
  EXPECT_THROW(runtime::BitForce(bit_of({cutter(1)}), broken), base::InputError);
}

TEST(ConstantSpeed, IsWhatTheBitFeelsAtEverySampleToTheLastBit) {
  const surrogate::Model model = constant_model(usual_pair());
  for (const runtime::Combine combine : {runtime::Combine::sum, runtime::Combine::max}) {
    runtime::Bit bit = shipped_bit();
    bit.signal.combine = combine;
    const runtime::Signal signal = runtime::constant_speed_signal(
        bit, model, {.rotation = 60.0 * rpm, .rate_of_penetration = 2e-3, .duration = 3.0, .rate = 997.0});
    ASSERT_EQ(signal.time_s.size(), 2991u);
    runtime::BitForce force(bit, model);
    for (std::size_t i = signal.time_s.size(); i-- > 0;) {  // backwards, one by one
      ASSERT_EQ(signal.time_s[i], static_cast<double>(i) / 997.0);
      ASSERT_EQ(signal.angle_rad[i], 60.0 * rpm * signal.time_s[i]);
      const runtime::BitLoad load = force.at(moving(signal.angle_rad[i]));
      ASSERT_EQ(signal.axial_force_N[i], load.axial_force);
      ASSERT_EQ(signal.torque_N_m[i], load.torque);
    }
  }
}

TEST(ConstantSpeed, DependsOnTheAngleNotOnTheTime) {
  // at one depth of cut the model is the same, so twice the speed is the same signal in half the time
  const surrogate::Model model = constant_model(usual_pair());
  const runtime::Signal slow = runtime::constant_speed_signal(
      shipped_bit(), model, {.rotation = 4.0, .rate_of_penetration = 1e-3, .duration = 4.0, .rate = 256.0});
  const runtime::Signal fast = runtime::constant_speed_signal(
      shipped_bit(), model, {.rotation = 8.0, .rate_of_penetration = 2e-3, .duration = 2.0, .rate = 512.0});
  EXPECT_EQ(slow.angle_rad, fast.angle_rad);
  EXPECT_EQ(slow.torque_N_m, fast.torque_N_m);
}

TEST(ConstantSpeed, FullFaceWithoutFrictionHasTheTorqueOfItsSpecificEnergy) {
  // A force eps w d at the middle of every ring gives axial eps d a and torque eps d sum w r = eps d a^2 / 2 exactly.
  const double eps = 70.5e6, depth = 2e-3, turns = 20.0;
  runtime::Bit bit = shipped_bit();
  bit.signal.window_angle = 2.0 * pi;
  const double amean = 2.0 * eps * depth;  // mean force is amean / 2
  const peaks::PeakRates s{.amax = 2.0 * amean, .amean = amean, .np1 = 30.0, .np23 = 200.0, .np4 = 30.0};
  const runtime::Signal signal = runtime::constant_speed_signal(
      bit, constant_model({.x = s, .y = s}),
      {.rotation = 2.0 * pi, .rate_of_penetration = depth, .duration = turns, .rate = 2000.0});
  EXPECT_EQ(signal.summary.draws.mean_missed, 0);
  EXPECT_DOUBLE_EQ(signal.summary.depth_of_cut_m, depth);

  const double a = 0.5 * bit.diameter;
  // pulses cut by the two ends: at most two each, of amax h, beside the mean over the turns; fewest peaks at the centre
  const double ends = 2.0 * 2.0 * 2.0 / (260.0 * 2.0 * pi * bit.cutters[0].radius * turns);
  EXPECT_NEAR(signal.summary.mean_force_N / (eps * depth * a), 1.0, ends + 1e-4);  // rounded widths
  EXPECT_NEAR(signal.summary.mean_torque_N_m / (eps * depth * a * a / 2.0), 1.0, ends + 1e-4);
}

TEST(ConstantSpeed, NoPenetrationNoForce) {
  const runtime::Signal signal = runtime::constant_speed_signal(shipped_bit(), constant_model(usual_pair()),
                                                                {.rotation = 6.0, .duration = 2.0, .rate = 100.0});
  EXPECT_EQ(signal.summary.max_force_N, 0.0);
  EXPECT_EQ(signal.summary.max_torque_N_m, 0.0);
  EXPECT_EQ(signal.summary.clamps.asked, 0);
}

TEST(ConstantSpeed, SamplesEndBeforeTheDuration) {
  const auto samples = [](double duration, double rate) {
    return runtime::constant_speed_signal(bit_of({cutter(1)}), constant_model(usual_pair()),
                                          {.rotation = 6.0, .duration = duration, .rate = rate})
        .time_s.size();
  };
  EXPECT_EQ(samples(0.1, 30.0), 3u);  // 0.1 * 30 is above 3 in binary
  EXPECT_EQ(samples(0.11, 30.0), 4u);
  EXPECT_EQ(samples(1e-9, 1.0), 1u);
}

TEST(ConstantSpeed, RefusesWhatItCannotDo) {
  const auto message = [](const runtime::ConstantSpeed& run) -> std::string {
    try {
      runtime::constant_speed_signal(bit_of({cutter(1)}), constant_model(usual_pair()), run);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  const runtime::ConstantSpeed good{.rotation = 6.0, .rate_of_penetration = 1e-3, .duration = 1.0, .rate = 10.0};
  const auto with = [&](double runtime::ConstantSpeed::*member, double value) {
    runtime::ConstantSpeed run = good;
    run.*member = value;
    return message(run);
  };
  EXPECT_EQ(message(good), "accepted");
  EXPECT_EQ(with(&runtime::ConstantSpeed::rotation, 0.0), "rotation = 0 rpm (must be at least 0.01 and at most 10000)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::rotation, not_a_number),
            "rotation = nan rpm (must be at least 0.01 and at most 10000)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::rate_of_penetration, -1.0 / 3600.0),
            "rate of penetration = -1 m/h (must be at least 0 and at most 2000)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::rate_of_penetration, not_a_number),
            "rate of penetration = nan m/h (must be at least 0 and at most 2000)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::duration, -1.0), "duration = -1 s (must be finite and above 0)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::rate, std::numeric_limits<double>::infinity()),
            "rate = inf Hz (must be finite and above 0)");
  EXPECT_EQ(with(&runtime::ConstantSpeed::duration, 1e9),
            "duration 1e+09 s at 10 Hz = 1e+10 samples (must be at most 20000000); shorten the duration or lower the "
            "rate");
}

TEST(ConstantSpeed, ReportsProgressAndStopsWhenAsked) {
  const runtime::ConstantSpeed run{.rotation = 6.0, .rate_of_penetration = 1e-3, .duration = 10.0, .rate = 2e4};
  double last = -1.0;
  runtime::constant_speed_signal(bit_of({cutter(1)}), constant_model(usual_pair()), run,
                                 [&](double done, double total) {
                                   EXPECT_GT(done, last);
                                   EXPECT_EQ(total, 2e5);
                                   last = done;
                                 });
  EXPECT_EQ(last, 2e5);
  base::stop_requested() = true;
  EXPECT_THROW(runtime::constant_speed_signal(bit_of({cutter(1)}), constant_model(usual_pair()), run),
               base::Interrupted);
  base::stop_requested() = false;
}

}  // namespace
