// Balances of the whole drill string on rock, and how fast its errors vanish with the step.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/unit/runtime_fixtures.hpp"
#include "tests/verification/drillstring_fixtures.hpp"

using namespace bitrock;

namespace {

using drillstring_test::pipe, drillstring_test::rpm, drillstring_test::short_string;

double weight_of(const runtime::DrillString& string) {
  double sum = 0.0;
  for (const double weight : string.weights) sum += weight;
  return sum;
}

// 150 m of the pipe weigh 39.31 kN; a hook load of 25, 15 and 35.5 kN leaves 14.31, 24.31 and 3.81 kN on the bit.
TEST(DrillStringBalance, StaticWeightOnBitIsWeightLessHookLoadAndJets) {
  const struct {
    double hook, weight_on_bit;  // [kN]
  } cases[] = {{25.0, 14.31}, {15.0, 24.31}, {35.5, 3.81}};
  for (const auto& c : cases) {
    runtime::DrillString string = short_string(c.hook * 1e3, 60.0 * rpm);
    EXPECT_NEAR(runtime::static_weight_on_bit(string), c.weight_on_bit * 1e3, 5.0);
    string.bit.hydraulic_force = 500.0;
    EXPECT_NEAR(runtime::static_weight_on_bit(string), c.weight_on_bit * 1e3 - 500.0, 5.0);
  }
}

TEST(DrillStringBalance, ABitAtRestOnRockStaysAtRest) {
  const runtime::DrillString string = short_string(25e3, 0.0);
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, false, 0.0);
  for (int i = 0; i < 10000; ++i) runtime::advance(string, state, nothing, 1e-4);
  EXPECT_NEAR(state.weight_on_bit / runtime::static_weight_on_bit(string), 1.0, 1e-9);
  EXPECT_NEAR(state.axial.velocity[1], 0.0, 1e-12);
  EXPECT_EQ(state.face, 0.0);
}

// Off bottom nothing but weight and hook load acts: the centre of mass falls with (W - H) / M, whatever the string
// does.
TEST(DrillStringBalance, OffBottomTheCentreOfMassFallsFreely) {
  for (const double hook : {25e3, 35.5e3}) {
    const runtime::DrillString string = short_string(hook, 60.0 * rpm);
    const runtime::BitRockSource source = runtime::sinusoidal_excitation({2e3, 1e3}, {100.0, 50.0}, 3.0);
    runtime::DrillState state = runtime::beginning(string, source, true, 1.0);
    const double mass = string.axial.inertia[0] + string.axial.inertia[1];
    const double acceleration = (weight_of(string) - hook) / mass;
    for (int i = 0; i < 3000; ++i) {
      runtime::advance(string, state, source, 1e-4);
      const double momentum =
          string.axial.inertia[0] * state.axial.velocity[0] + string.axial.inertia[1] * state.axial.velocity[1];
      ASSERT_NEAR(momentum / mass, acceleration * state.time, 1e-11 * acceleration);  // 3000 roundings
    }
    EXPECT_EQ(state.weight_on_bit, 0.0);
    EXPECT_EQ(state.source_force, 0.0);  // the cutters are not in the rock
    EXPECT_EQ(state.progression, 0.0);
    const double x =
        (string.axial.inertia[0] * state.axial.position[0] + string.axial.inertia[1] * state.axial.position[1]) / mass;
    EXPECT_NEAR(x, 0.5 * acceleration * 0.09, 1e-11);
  }
}

// Over a long time the rock carries what the hook does not: spring and source together, W - H - F_hyd.
TEST(DrillStringBalance, TheRockCarriesInTheMeanWhatTheHookDoesNot) {
  runtime::DrillString string = short_string(25e3, 60.0 * rpm);
  string.bit.hydraulic_force = 700.0;
  // begins at its highest, so that a running mean must find its way to 3 kN
  const runtime::BitRockSource source = [](const runtime::BitMotion& motion) {
    const double wave = std::cos(5.0 * motion.angle);
    return runtime::BitLoad{.axial_force = 3e3 + 2e3 * wave, .torque = 80.0 + 20.0 * wave};
  };
  for (const runtime::AxialSource kind :
       {runtime::AxialSource::full, runtime::AxialSource::fluctuation, runtime::AxialSource::none}) {
    string.bit.axial_source = kind;
    runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
    double spring = 0.0, of_source = 0.0;
    constexpr int settling = 50000, steps = 200000;
    for (int i = 0; i < settling + steps; ++i) {
      runtime::advance(string, state, source, 1e-4);
      if (i < settling) continue;
      spring += state.weight_on_bit / steps;
      of_source += state.source_force / steps;
    }
    const double expected = weight_of(string) - 25e3 - 700.0;
    EXPECT_NEAR((spring + of_source) / expected, 1.0, 0.005);
    const double of_mean = kind == runtime::AxialSource::full ? 3e3 : 0.0;
    EXPECT_NEAR(of_source, of_mean, 0.005 * expected);  // so the spring reads low by the mean of a full source
  }
}

// Cutters that push harder than the weight lift the bit a little off the rock spring, and go on cutting: the angle must
// not stand still, or the same force would carry the bit for ever.
TEST(DrillStringBalance, ABitCarriedByItsCuttersGoesOnCutting) {
  const runtime::DrillString string = short_string(25e3, 60.0 * rpm);
  const runtime::BitRockSource source = [](const runtime::BitMotion&) { return runtime::BitLoad{.axial_force = 20e3}; };
  runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
  for (int i = 0; i < 100000; ++i) runtime::advance(string, state, source, 1e-4);
  // in balance where the share of the cut still taken is 14.3 / 20 of the engagement depth
  const double share = runtime::static_weight_on_bit(string) / 20e3;
  EXPECT_EQ(state.weight_on_bit, 0.0);
  EXPECT_NEAR(state.source_force / 20e3, share, 1e-3);
  EXPECT_NEAR(state.axial.position.back() - state.face, (share - 1.0) * string.bit.engagement_depth, 1e-6);
  EXPECT_NEAR(state.progression / (20.0 * std::numbers::pi), 1.0, 0.05);
}

/// A string under everything at once: pipe and rock damping, friction at bit and wall, source, jets, breaking rock.
runtime::DrillString busy_string() {
  runtime::DrillString string = short_string(25e3, 60.0 * rpm);
  string.wall_friction.law = runtime::FrictionLaw::smooth;
  string.wall_moment = {30.0, 20.0};
  string.bit.hydraulic_force = 700.0;
  string.torsional.wall_damping = {0.5, 0.2};
  return string;
}

double residual_share(const runtime::DrillString& string, const runtime::BitRockSource& source, double h) {
  runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
  const double initial = runtime::stored_energy(string, state);
  for (int i = 0; i < std::lround(4.0 / h); ++i) runtime::advance(string, state, source, h);
  EXPECT_GT(state.work.drive, 100.0);
  EXPECT_GT(state.work.bit_friction, 100.0);
  return std::abs(runtime::energy_residual(string, state, initial)) / state.work.drive;
}

// Work of drive, weight, hook and jets is what dampers, frictions and rock take, and what is stored. The solver's own
// error is of second order in the step while nothing switches.
TEST(DrillStringBalance, PowerInIsPowerOutAndStored) {
  const runtime::BitRockSource source = runtime::sinusoidal_excitation({3e3, 1e3}, {0.0, 0.0}, 5.0);
  const double coarse = residual_share(busy_string(), source, 2e-4), fine = residual_share(busy_string(), source, 1e-4);
  EXPECT_LT(fine, 1e-5);
  EXPECT_GT(coarse / fine, 3.0);
}

TEST(DrillStringBalance, PowerIsBalancedWhileRockBreaksAndTheBitSticks) {
  runtime::DrillString string = busy_string();
  const runtime::BitRockSource source = runtime::sinusoidal_excitation({3e3, 1e3}, {150.0, 100.0}, 5.0);
  for (const runtime::Unloading unloading : {runtime::Unloading::free, runtime::Unloading::elastic}) {
    string.bit.unloading = unloading;
    EXPECT_LT(residual_share(string, source, 1e-4), 1e-3);
  }
  string.bit.friction.law = runtime::FrictionLaw::stribeck;
  string.bit.friction.stribeck = {.resting = 0.5, .sliding = 0.3, .decay = 0.9};
  EXPECT_LT(residual_share(string, source, 1e-4), 1e-3);
}

/// Bit speed, sinking speed and weight on bit after 0.5 s.
std::array<double, 3> after_half_a_second(double h) {
  const runtime::DrillString string = busy_string();
  const runtime::BitRockSource source = runtime::sinusoidal_excitation({3e3, 1e3}, {0.0, 0.0}, 5.0);
  runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
  for (int i = 0; i < std::lround(0.5 / h); ++i) runtime::advance(string, state, source, h);
  return {state.torsional.velocity.back(), state.axial.velocity.back(), state.weight_on_bit};
}

// Second order: halving the step quarters the error. Three steps tell it without an exact solution.
TEST(DrillStringConvergence, IsOfSecondOrderWhereNothingSwitches) {
  const auto coarse = after_half_a_second(2e-4), middle = after_half_a_second(1e-4), fine = after_half_a_second(5e-5);
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    EXPECT_NEAR((coarse[k] - middle[k]) / (middle[k] - fine[k]), 4.0, 0.4) << k;
  }
}

/// Torque and force of a bit on an all but infinite flywheel at 60 rpm, every 10 ms.
std::vector<double> history(double h, double stiffness, double runtime::DrillState::*what) {
  runtime::Bit bit;
  bit.name = "two cutters";
  bit.signal = runtime_test::usual_settings();
  bit.cutters = {{.number = 1, .radius = 0.06, .width = 0.02}, {.number = 2, .radius = 0.1, .width = 0.01}};
  runtime::BitForce load(bit, runtime_test::constant_model(runtime_test::usual_pair()));
  runtime::DrillString string;
  string.torsional = {{1e12}, {1e-6}, {0.0}, {0.0}};
  string.drive = {.rotation = 60.0 * rpm};
  string.bit.imposed_weight = 30e3;
  string.bit.fracture_stiffness = stiffness;
  const runtime::BitRockSource source = runtime::bit_excitation(load);
  runtime::DrillState state = runtime::beginning(string, source, true, 0.0);
  std::vector<double> values;
  for (int sample = 0; sample < 300; ++sample) {
    for (int i = 0; i < std::lround(1e-2 / h); ++i) runtime::advance(string, state, source, h);
    values.push_back(state.*what);
  }
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(DrillStringConvergence, TheForceOfBreakingRockDoesNotDependOnTheStep) {
  using runtime::DrillState;
  // the source is a function of the angle; after 3 s of steps the angles differ by roundings
  const std::vector<double> force = history(1e-3, 2e4, &DrillState::source_force);
  EXPECT_GT(*std::max_element(force.begin(), force.end()), 1e3);
  EXPECT_LT(largest_difference(force, history(1e-4, 2e4, &DrillState::source_force)), 1e-6);
  // so is the torque where the rock is stiff: what it bears
  const std::vector<double> stiff = history(1e-3, 1e9, &DrillState::fracture_torque);
  EXPECT_GT(*std::max_element(stiff.begin(), stiff.end()), 100.0);
  EXPECT_LT(largest_difference(stiff, history(1e-4, 1e9, &DrillState::fracture_torque)), 1e-6);
  // where it is compliant, the least torque between two steps is missed by a second-order amount
  const std::vector<double> fine = history(1e-5, 2e4, &DrillState::fracture_torque);
  const double coarse_error = largest_difference(history(1e-3, 2e4, &DrillState::fracture_torque), fine);
  const double middle_error = largest_difference(history(1e-4, 2e4, &DrillState::fracture_torque), fine);
  EXPECT_LT(middle_error, 0.5);
  EXPECT_GT(coarse_error / middle_error, 20.0);
}

// A solver that rejects a step copies the state, tries, and takes the copy back: the way there leaves no trace.
TEST(DrillStringConvergence, ARejectedStepLeavesNoTrace) {
  runtime::DrillString string = busy_string();
  const runtime::BitRockSource source = runtime::noise_excitation({3e3, 1e3}, {150.0, 100.0}, 0.01, 3);
  runtime::DrillState straight = runtime::beginning(string, source, true, 0.0), tried = straight;
  for (int i = 0; i < 5000; ++i) {
    runtime::advance(string, straight, source, 1e-4);
    const runtime::DrillState kept = tried;
    runtime::advance(string, tried, source, 3e-4);
    tried = kept;
    runtime::advance(string, tried, source, 1e-4);
  }
  EXPECT_EQ(straight.torsional.velocity, tried.torsional.velocity);
  EXPECT_EQ(straight.weight_on_bit, tried.weight_on_bit);
  EXPECT_EQ(straight.progression, tried.progression);
  EXPECT_EQ(mean(straight.smooth_advance), mean(tried.smooth_advance));
}

// The drive's ramp is the integral of its own speed: half of ramp times speed is lost on the way.
TEST(DrillStringBalance, ARampLosesHalfItsTime) {
  const runtime::TopDrive drive{.rotation = 6.0, .ramp = 2.0};
  EXPECT_EQ(drive_at(drive, 0.0).position, 0.0);
  EXPECT_EQ(drive_at(drive, 0.0).velocity, 0.0);
  EXPECT_NEAR(drive_at(drive, 1.0).velocity, 3.0, 1e-15);
  EXPECT_NEAR(drive_at(drive, 1.0).position, 6.0 * 2.0 * (0.0625 * 2.5 - 3.0 / 32.0 + 1.0 / 64.0), 1e-14);
  EXPECT_NEAR(drive_at(drive, 2.0).position, 6.0, 1e-14);
  EXPECT_NEAR(drive_at(drive, 5.0).position, 24.0, 1e-14);
  for (double t = 0.05; t < 2.5; t += 0.1) {
    const double slope = (drive_at(drive, t + 1e-5).position - drive_at(drive, t - 1e-5).position) / 2e-5;
    EXPECT_NEAR(slope, drive_at(drive, t).velocity, 1e-8);
  }
}

}  // namespace
