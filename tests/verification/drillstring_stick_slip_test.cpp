// Drill strings that stick and slip under dry friction, against an exact orbit and a published program.
//
// One disc J on a spring K behind a drive of speed W, held by T_s and braked by T_d while it slides. With
// w = sqrt(K/J) and lambda = (T_s - T_d) / (W sqrt(K J)) the disc moves against the drive as an undamped oscillator
// while it slides, so that
//
//     slip lasts (2/w)(pi - atan lambda), stick 2 lambda / w; the fastest speed is W (1 + sqrt(1 + lambda^2)), and the
//     torque of the spring swings between T_s and 2 T_d - T_s.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/verification/drillstring_fixtures.hpp"

using namespace bitrock;

namespace {

using drillstring_test::four_discs, drillstring_test::one_disc;
using std::numbers::pi;

/// Times at which the lowest disc begins to slide.
struct Orbit {
  std::vector<double> releases, stops;
  double fastest = 0.0, torque_when_caught = 0.0, least_torque = 1e300, most_torque = -1e300;
};

Orbit orbit_of(const runtime::DrillString& string, double duration, double h) {
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, false, 0.0);
  Orbit orbit;
  for (long long i = 0; i < std::llround(duration / h); ++i) {
    const int before = state.sliding.back();
    runtime::advance(string, state, nothing, h);
    if (before == 0 && state.sliding.back() != 0) orbit.releases.push_back(state.time);
    orbit.fastest = std::max(orbit.fastest, state.torsional.velocity.back());
    const double torque =
        runtime::drive_reaction(string.torsional, state.torsional, drive_at(string.drive, state.time));
    if (before != 0 && state.sliding.back() == 0) {
      orbit.stops.push_back(state.time);
      orbit.torque_when_caught = torque;
    }
    if (orbit.releases.empty()) continue;
    orbit.least_torque = std::min(orbit.least_torque, torque);
    orbit.most_torque = std::max(orbit.most_torque, torque);
  }
  return orbit;
}

TEST(StickSlip, OneDiscFollowsTheExactOrbit) {
  const double stiffness = 473.0, inertia = 374.0, rotation = 10.0, at_rest = 8000.0, sliding = 5000.0;
  const double w = std::sqrt(stiffness / inertia);
  const double lambda = (at_rest - sliding) / (rotation * std::sqrt(stiffness * inertia));
  const double slip = 2.0 / w * (pi - std::atan(lambda)), stick = 2.0 * lambda / w;
  EXPECT_NEAR(slip, 4.4852, 5e-5);  // the formulas, evaluated by hand
  EXPECT_NEAR(stick, 1.2685, 5e-5);

  // Three cycles. Release and stop are each noticed up to a step late: 2e-5 s in 1.27 s.
  const Orbit orbit = orbit_of(one_disc(inertia, stiffness, rotation, at_rest, sliding), 19.5, 2e-5);
  ASSERT_GE(orbit.releases.size(), 3u);
  ASSERT_GE(orbit.stops.size(), 3u);
  EXPECT_NEAR(orbit.releases[0], at_rest / (stiffness * rotation), 1e-4);  // the spring winds up first
  for (int k = 0; k < 2; ++k) {
    const auto cycle = static_cast<std::size_t>(k);
    EXPECT_NEAR((orbit.stops[cycle] - orbit.releases[cycle]) / slip, 1.0, 1e-4);
    EXPECT_NEAR((orbit.releases[cycle + 1] - orbit.stops[cycle]) / stick, 1.0, 1e-4);
    EXPECT_NEAR((orbit.releases[cycle + 1] - orbit.releases[cycle]) / (slip + stick), 1.0, 1e-4);
  }
  EXPECT_NEAR(orbit.fastest / (rotation * (1.0 + std::sqrt(1.0 + lambda * lambda))), 1.0, 1e-4);
  const double swing = rotation * std::sqrt(stiffness * inertia) * std::sqrt(1.0 + lambda * lambda);
  EXPECT_NEAR(orbit.torque_when_caught / (2.0 * sliding - at_rest), 1.0, 1e-4);
  EXPECT_NEAR(orbit.least_torque, sliding - swing, 1e-4 * swing);
  EXPECT_NEAR(orbit.most_torque, sliding + swing, 1e-4 * swing);
}

TEST(StickSlip, AHeldDiscStandsStillToTheLastBit) {
  const runtime::DrillString string = one_disc(374.0, 473.0, 10.0, 8000.0, 5000.0);
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, false, 0.0);
  for (int i = 0; i < 1600; ++i) {  // to 1.6 s: the spring lets go at 1.69 s
    runtime::advance(string, state, nothing, 1e-3);
    ASSERT_EQ(state.torsional.velocity[0], 0.0);
    ASSERT_EQ(state.torsional.position[0], 0.0);
  }
  EXPECT_NEAR(state.friction_torque, 473.0 * 10.0 * 1.6, 1e-6);  // friction is what the spring asks of it
}

/// Bit speed over whole cycles of the attractor, cut where the bit lets go.
struct Cycle {
  double period = 0.0, fastest = 0.0, mean = 0.0, stuck = 0.0, slowest_table = 1e300, fastest_table = 0.0;
};

Cycle cycle_of(const runtime::DrillString& string, double transient, double duration, double h) {
  const runtime::BitRockSource nothing = runtime::no_excitation();
  runtime::DrillState state = runtime::beginning(string, nothing, false, 0.0);
  Cycle cycle;
  double first = -1.0, last = -1.0, turned_at_first = 0.0, turned_at_last = 0.0, stuck = 0.0, stuck_at_last = 0.0;
  int cycles = -1;
  for (long long i = 0; i < std::llround((transient + duration) / h); ++i) {
    const int before = state.sliding.back();
    runtime::advance(string, state, nothing, h);
    if (state.time < transient) continue;
    if (before == 0 && state.sliding.back() != 0) {
      if (first < 0.0) {
        first = state.time;
        turned_at_first = state.torsional.position.back();
        stuck = 0.0;
      }
      last = state.time;
      turned_at_last = state.torsional.position.back();
      stuck_at_last = stuck;
      ++cycles;
    }
    if (state.sliding.back() == 0) stuck += h;
    cycle.fastest = std::max(cycle.fastest, state.torsional.velocity.back());
    cycle.slowest_table = std::min(cycle.slowest_table, state.torsional.velocity.front());
    cycle.fastest_table = std::max(cycle.fastest_table, state.torsional.velocity.front());
  }
  if (cycles < 1) return cycle;
  cycle.period = (last - first) / cycles;
  cycle.mean = (turned_at_last - turned_at_first) / (last - first);
  cycle.stuck = stuck_at_last / (last - first);
  return cycle;
}

// The figure of [ChengWuChen2018] shows a period of some 8.3 s, the bit between 0 and 6.7 rad/s, the table between 0.25
// and 4.4. The closer numbers are an independent integration of the same equations by a variable-step solver:
// period 8.30 to 8.32 s, fastest 6.69, mean 2.275, table 0.25 to 4.39, stuck for 0.435 of the time.
TEST(StickSlip, FourDiscsAgreeWithThePublishedCase) {
  const Cycle cycle = cycle_of(four_discs(10e3, 97347.0), 100.0, 100.0, 1e-3);
  EXPECT_NEAR(cycle.period, 8.3, 0.083);
  EXPECT_NEAR(cycle.fastest, 6.69, 0.0669);
  EXPECT_NEAR(cycle.stuck, 0.435, 0.01);
  EXPECT_NEAR(cycle.mean, 2.275, 0.023);
  EXPECT_NEAR(cycle.slowest_table, 0.25, 0.02);
  EXPECT_NEAR(cycle.fastest_table, 4.39, 0.044);
  // and the step does not decide: a tenth of it changes nothing that matters
  const Cycle finer = cycle_of(four_discs(10e3, 97347.0), 100.0, 100.0, 1e-4);
  EXPECT_NEAR(cycle.period / finer.period, 1.0, 1e-3);
  EXPECT_NEAR(cycle.fastest / finer.fastest, 1.0, 1e-3);
}

// Where the string turns steadily, the torque of the drive is what bit and dampers take: T = (c_r + c_b) w + W R mu(w).
TEST(StickSlip, FourDiscsTurnSteadilyUnderLittleWeightOrMuchTorque) {
  const struct {
    double torque, weight, speed;  // the speeds by the independent integration
  } cases[] = {{10e3, 60e3, 11.23}, {12e3, 97347.0, 9.32}, {16e3, 97347.0, 17.74}};
  for (const auto& c : cases) {
    const runtime::DrillString string = four_discs(c.torque, c.weight);
    const runtime::BitRockSource nothing = runtime::no_excitation();
    runtime::DrillState state = runtime::beginning(string, nothing, false, 0.0);
    for (int i = 0; i < 300000; ++i) runtime::advance(string, state, nothing, 1e-3);
    const double speed = state.torsional.velocity.back();
    EXPECT_NEAR(speed, c.speed, 0.006);  // half a unit of their last digit
    const double needed =
        475.0 * speed + c.weight * 0.155575 * friction_coefficient(string.bit.friction.stribeck, speed);
    EXPECT_NEAR(needed / c.torque, 1.0, 1e-6);
  }
}

}  // namespace
