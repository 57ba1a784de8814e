// A string in two dimensions that hangs from a block by the spring of its drill line: statics, steady drilling, a
// drill-off, the response of the autodriller, modes, the stable step, and where the energy goes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/errors.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "tests/verification/drillstring_fixtures.hpp"

using namespace bitrock;

namespace {

using drillstring_test::pipe, drillstring_test::rpm, drillstring_test::short_string;
using runtime::DrillState, runtime::DrillString, runtime::HoistRule;
using std::numbers::pi;

const runtime::BitRockSource nothing = runtime::no_excitation();
constexpr double h = 2e-4, line = 8e6;  // [s], [N/m]

/// The 150 m string below a block; nothing but weight, jets and rock act along it.
DrillString hung(HoistRule rule, double weight_on_bit) {
  DrillString string = short_string(0.0, 60.0 * rpm);
  string.hoist = {.rule = rule, .stiffness = line, .weight_on_bit = weight_on_bit};
  string.bit.threshold_weight = 0.0;
  string.bit.friction.law = runtime::FrictionLaw::none;
  string.bit.root_advance = {.c1 = 1.35e-8, .c2 = 0.0};
  return string;
}

/// The same with a rock that goes away with one speed, and an autodriller that answers in `time`.
DrillString automatic(double weight_on_bit, double time, double rop) {
  DrillString string = hung(HoistRule::autodriller, weight_on_bit);
  string.bit.advance_law = runtime::AdvanceLaw::imposed;
  string.bit.imposed_advance = rop;
  string.hoist.autodriller = runtime::autodriller_for(runtime::stiffness_below_block(string), time, 1.0);
  return string;
}

void run_to(const DrillString& string, DrillState& state, double time, const runtime::BitRockSource& source = nothing) {
  while (state.time < time - 0.5 * h) advance(string, state, source, h);
}

double stretch_of(const DrillState& state) {
  return state.axial.position.front() - state.hoist.block;
}

TEST(Hoist, AtRestTheHookBearsWhatTheBitDoesNotAndTheLineIsAsLongAsItsLoad) {
  for (const double weight_on_bit : {0.0, 5e3, 14e3}) {
    DrillString string = hung(HoistRule::feed, weight_on_bit);
    string.drive.rotation = 0.0;
    string.bit.hydraulic_force = 700.0;
    const double weight = string.weights[0] + string.weights[1];
    for (const double off_bottom : {0.0, 0.02}) {
      DrillState state = beginning(string, nothing, false, off_bottom);
      run_to(string, state, 2.0);
      const double borne = off_bottom > 0.0 ? 0.0 : weight_on_bit, expected = weight - 700.0 - borne;
      EXPECT_NEAR(state.weight_on_bit, borne, 1e-8 * weight);
      EXPECT_NEAR(hook_load(string, state), expected, 1e-9 * weight);
      EXPECT_NEAR(stretch_of(state), expected / line, 1e-9 * weight / line);
      EXPECT_EQ(state.hoist.block, beginning(string, nothing, false, off_bottom).hoist.block);
    }
  }
}

// What the bit bears, the hook loses: the weight of the rock's law at the speed of the feed.
TEST(Hoist, AtASteadyFeedTheRockGoesAwayAsFast) {
  DrillString string = hung(HoistRule::feed, 10e3);
  string.bit.root_advance.c2 = -1e-4;
  string.bit.threshold_weight = 1e3;
  string.hoist.feed = 2.0 / 3600.0;
  const double slope = 1.35e-8 * std::sqrt(60.0 * rpm), expected = (string.hoist.feed + 1e-4) / slope;
  EXPECT_NEAR(runtime::weight_for_advance(string.bit, 60.0 * rpm, string.hoist.feed), expected, 1e-9 * expected);
  ASSERT_GT(std::abs(expected - 10e3), 5e3) << "it does not begin there";
  DrillState state = beginning(string, nothing, true, 0.0);
  run_to(string, state, 150.0);  // the rock takes 7 s to a factor e
  EXPECT_NEAR(state.rate_of_penetration / string.hoist.feed, 1.0, 1e-6);
  EXPECT_NEAR(state.weight_on_bit / expected, 1.0, 1e-6);
  const double weight = string.weights[0] + string.weights[1];
  EXPECT_NEAR(hook_load(string, state), weight - expected, 1e-6 * weight);
}

// With the brake on, the string grows longer as the rock goes away: W' = -k V, V = s W, so W falls with exp(-k s t).
TEST(Hoist, ADrillOffTestGivesTheLawOfTheRock) {
  const DrillString string = hung(HoistRule::feed, 14e3);
  const double slope = 1.35e-8 * std::sqrt(60.0 * rpm), rate = runtime::stiffness_below_block(string) * slope;
  EXPECT_NEAR(1.0 / runtime::stiffness_below_block(string),
              1.0 / line + 1.0 / string.axial.stiffness[1] + 1.0 / string.bit.contact.stiffness, 1e-20);
  DrillState state = beginning(string, nothing, true, 0.0);
  run_to(string, state, 2.0);  // the waves of the sudden brake are gone
  const double first = state.weight_on_bit;
  for (const double time : {5.0, 10.0, 20.0}) {
    run_to(string, state, time);
    // masses and the rock's damper, k_r / c_r = 7.7e3 1/s, change the rate in the fifth figure
    EXPECT_NEAR(state.weight_on_bit / (first * std::exp(-rate * (time - 2.0))), 1.0, 2e-4) << time;
  }
  EXPECT_LT(state.weight_on_bit, 0.1 * first);
}

/// The weight that is missing over k V t, `times` answers of the autodriller after it began on bottom with the weight
/// that is asked for and an integral of 0.
double missing_after(double times, double time, double rop) {
  const double wanted = 14e3;
  const DrillString string = automatic(wanted, time, rop);
  DrillState state = beginning(string, nothing, true, 0.0);
  state.hoist.drift = 0.0;
  run_to(string, state, times * time);
  return (wanted - state.weight_on_bit) / (runtime::stiffness_below_block(string) * rop * time);
}

// e'' + 2 e' / t + e / t^2 = 0 with e = 0 and e' = k V at first is e = k V s exp(-s / t). The rig's gauge is late by 1
// s, which is a share of 1 / t: what is left of the difference halves when t doubles.
TEST(Hoist, TheAutodrillerAnswersAsItsEquationSays) {
  for (const double times : {0.5, 1.0, 2.0, 3.0}) {
    const double exact = times * std::exp(-times), rop = 2e-5;
    const double quick = missing_after(times, 40.0, rop), slow = missing_after(times, 80.0, rop);
    EXPECT_NEAR(slow, exact, 0.03) << times;
    EXPECT_NEAR(2.0 * slow - quick, exact, 1.5e-3) << times;
  }
  // the same for a rock that is ten times as fast
  EXPECT_NEAR(missing_after(1.0, 40.0, 2e-4) / missing_after(1.0, 40.0, 2e-5), 1.0, 1e-3);
}

// With the gauge in the loop, for the answer of 5 s that cases have: the loop alone, without masses.
TEST(Hoist, TheGaugeOfTheRigIsPartOfTheLoop) {
  const double wanted = 14e3, rop = 5.0 / 3600.0, time = 5.0;
  const DrillString string = automatic(wanted, time, rop);
  const double k = runtime::stiffness_below_block(string);
  DrillState state = beginning(string, nothing, true, 0.0);
  state.hoist.drift = 0.0;
  double missing = 0.0, gauge = 0.0, drift = 0.0, largest = 0.0, worst = 0.0;
  const double fine = 0.1 * h;
  for (int i = 0; i < 200000; ++i) {
    advance(string, state, nothing, h);
    for (int j = 0; j < 10; ++j) {
      const double since = i * h + j * fine;
      gauge += fine / std::min(1.0, std::max(since, fine)) * (missing - gauge);
      drift += fine * gauge / (k * time * time);
      missing += fine * k * (rop - 2.0 * gauge / (k * time) - drift);
    }
    largest = std::max(largest, missing);
    worst = std::max(worst, std::abs(wanted - state.weight_on_bit - missing));
  }
  EXPECT_GT(largest, 0.3 * k * rop * time);
  EXPECT_LT(worst, 2e-2 * largest);  // the waves of the first second, 135 kN s/m times the speed
  EXPECT_NEAR(wanted - state.weight_on_bit, missing, 1e-3 * largest);
}

TEST(Hoist, TheAutodrillerHoldsTheWeightWhateverTheRock) {
  for (const double rop : {0.0, 2e-4, 5e-3}) {
    const DrillString string = automatic(14e3, 5.0, rop);
    DrillState state = beginning(string, nothing, true, 0.0);
    EXPECT_EQ(state.hoist.drift, rop);
    state.hoist.drift = 0.0;
    run_to(string, state, 200.0);
    EXPECT_NEAR(state.weight_on_bit / 14e3, 1.0, 1e-6) << rop;
    EXPECT_NEAR(state.hoist.speed, rop, 1e-9 + 1e-6 * rop);
  }
  DrillString string = automatic(14e3, 5.0, 0.0);
  string.bit.advance_law = runtime::AdvanceLaw::root;
  for (const double off_bottom : {0.0, 0.05}) {
    DrillState state = beginning(string, nothing, true, off_bottom);
    double highest = 0.0;
    while (state.time < 240.0) {  // the rock yields, and makes the slower part slower: 11 s
      advance(string, state, nothing, h);
      highest = std::max(highest, state.weight_on_bit);
    }
    EXPECT_NEAR(state.weight_on_bit / 14e3, 1.0, 1e-6) << off_bottom;
    // lowered to bottom with K_p W* it would come to 1 + exp(-2) without the gauge that is late and the rock that
    // yields
    EXPECT_LT(highest, off_bottom > 0.0 ? 1.35 * 14e3 : 1.001 * 14e3);
  }
}

TEST(Hoist, TheAutodrillerHoldsTheMeanUnderASource) {
  DrillString string = automatic(14e3, 5.0, 0.0);
  string.bit.advance_law = runtime::AdvanceLaw::root;
  const runtime::BitRockSource source = runtime::sinusoidal_excitation({3e3, 1e3}, {0.0, 0.0}, 3.0);
  DrillState state = beginning(string, source, true, 0.0);
  run_to(string, state, 60.0, source);
  double sum = 0.0, count = 0.0;
  while (state.time < 120.0) {
    advance(string, state, source, h);
    sum += state.weight_on_bit + state.source_force;
    count += 1.0;
  }
  EXPECT_NEAR(sum / count / 14e3, 1.0, 1e-3) << "what the hook has lost is all that the rock does";
}

TEST(Hoist, ALineGoesSlackAndNeverPushes) {
  DrillString string = hung(HoistRule::feed, 10e3);
  string.bit.advance_law = runtime::AdvanceLaw::none;
  string.hoist.damping = 2e4;
  const double weight = string.weights[0] + string.weights[1];
  DrillState state = beginning(string, nothing, true, 0.0);
  const double initial = stored_energy(string, state);
  const auto fed = [&](double to, double speed) {
    double least = 1e9;
    while (state.time < to) {
      advance(string, state, nothing, h, speed);
      least = std::min(least, state.hoist.pull);
    }
    return least;
  };
  EXPECT_EQ(fed(2.0, 0.01), 0.0);
  EXPECT_EQ(fed(12.0, 0.0), 0.0);
  EXPECT_EQ(state.hoist.pull, 0.0);
  EXPECT_LT(stretch_of(state), -0.01) << "the block is below";
  EXPECT_NEAR(state.weight_on_bit, weight, 1e-6 * weight);
  EXPECT_LT(std::abs(energy_residual(string, state, initial)), 1e-4 * weight * 0.02);
  fed(15.0, -0.01);
  fed(28.0, 0.0);
  EXPECT_EQ(state.weight_on_bit, 0.0);
  EXPECT_NEAR(state.hoist.pull, weight, 1e-3 * weight);
}

TEST(Hoist, TheLineIsASpringOfTheModes) {
  // N masses below N equal springs, the uppermost of which is the line
  for (const int lumps : {1, 2, 5}) {
    DrillString string = hung(HoistRule::feed, 0.0);
    string.axial = runtime::axial_chain({pipe()}, lumps, runtime::Lumping::end, 0.0);
    string.hoist.stiffness = lumps == 1 ? line : string.axial.stiffness[1];
    const std::vector<double> found = runtime::drill_modes(string).axial_off_bottom;
    for (int k = 1; k <= lumps; ++k) {
      const double exact = runtime::equal_lumps_frequency(string.hoist.stiffness, string.axial.inertia[0], lumps, k);
      EXPECT_NEAR(found[static_cast<std::size_t>(k - 1)] / exact, 1.0, 1e-10) << lumps << " " << k;
    }
  }
  EXPECT_EQ(runtime::drill_modes(short_string(25e3, 0.0)).axial_off_bottom[0], 0.0) << "a hook load is no spring";
}

/// Relative error of the first frequency of 150 m of pipe on the line, in so many lumps: E A q tan(q L) = k of the
/// continuous pipe on a spring, free below.
double error_of(int lumps) {
  runtime::DrillCase drill;
  drill.pipes = {pipe()};
  drill.axial_lumps = lumps;
  drill.hoist.rule = HoistRule::feed;
  drill.hoist.stiffness = line;
  const double stiffness = 200e9 * runtime::area(pipe());
  double low = 0.0, high = 0.5 * pi / 150.0;
  for (int i = 0; i < 100; ++i) {
    const double q = 0.5 * (low + high);
    (stiffness * q * std::tan(q * 150.0) < line ? low : high) = q;
  }
  const double exact = low * std::sqrt(200e9 / 7850.0) / (2.0 * pi);
  return runtime::drill_modes(assemble(drill)).axial_off_bottom[0] / exact - 1.0;
}

TEST(Hoist, LumpsOnALineComeToTheContinuousPipeOnASpring) {
  EXPECT_LT(std::abs(error_of(40)), 1e-4);
  EXPECT_NEAR(error_of(10) / error_of(20), 4.0, 0.1);
}

TEST(Hoist, TheStableStepCountsTheLine) {
  DrillString string = hung(HoistRule::feed, 0.0);
  const double without = runtime::longest_stable_step(short_string(0.0, 60.0 * rpm));
  EXPECT_NEAR(runtime::longest_stable_step(string) / without, 1.0, 0.05) << "a soft line is not the fastest";
  string.hoist.stiffness = 1e11;
  const double fastest = std::sqrt((1e11 + string.axial.stiffness[1]) / string.axial.inertia[0]);
  EXPECT_NEAR(runtime::longest_stable_step(string), 2.0 / fastest, 2e-3 * 2.0 / fastest);
  runtime::DrillCase drill;
  drill.run.step = 2e-4;
  EXPECT_NO_THROW(runtime::require_stable(drill, string));
  drill.run.step = 4e-4;
  EXPECT_THROW(runtime::require_stable(drill, string), base::InputError);
}

double residual_share(DrillString string, double step) {
  const runtime::BitRockSource source = runtime::sinusoidal_excitation({3e3, 1e3}, {0.0, 0.0}, 5.0);
  string.bit.friction.law = runtime::FrictionLaw::smooth;
  DrillState state = beginning(string, source, true, 0.0);
  state.hoist.drift = 0.0;
  const double initial = stored_energy(string, state);
  for (int i = 0; i < std::lround(4.0 / step); ++i) advance(string, state, source, step);
  EXPECT_LT(state.work.hook, -20.0) << "the hoist takes work from a string that sinks";
  EXPECT_GT(state.work.weight, 30.0);
  return std::abs(runtime::energy_residual(string, state, initial)) / state.work.drive;
}

TEST(Hoist, ItsWorkIsInTheLedgerAndTheRestOfSecondOrder) {
  DrillString drilled = automatic(10e3, 1.0, 0.0);
  drilled.bit.advance_law = runtime::AdvanceLaw::root;
  DrillString given = hung(HoistRule::feed, 10e3);
  given.hoist.feed = 2e-3;
  for (DrillString& string : std::array{drilled, given}) {
    string.hoist.damping = 1e4;
    const double coarse = residual_share(string, 2e-4), fine = residual_share(string, 1e-4);
    EXPECT_LT(fine, 1e-5);
    EXPECT_GT(coarse / fine, 3.0);
  }
}

}  // namespace
