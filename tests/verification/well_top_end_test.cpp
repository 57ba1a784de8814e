// Hoist and drive at the table that are moved by a force and a torque: a block under the pull of its line, a drive
// under the torque of its motor. Momentum, energy, the linear chain they are part of, and the step at which they are
// stable.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/signal/step5.hpp"
#include "runtime/well/well_modes.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double h = 5e-4;

/// 300 m of drill pipe and 100 m of collars in a smooth vertical hole.
WellString hanging() {
  WellString string{.sections = {section(drill_pipe(), 300.0, 30), section(drill_collar(), 100.0, 10)},
                    .hole = straight_hole(0.0, 3000.0, 0.2159, 0.0),
                    .upper_end = UpperEnd::table,
                    .guided = true};
  string.longest_grown = 40.0;
  return string;
}

double sum_of(const WellStringState& state, Column along_z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.count; ++i) sum += vector_at(state.columns, along_z, i).z;
  return sum;
}

double weight_of(const WellStringState& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.count; ++i) sum += state.columns.at(weight, i);
  return sum;
}

double momentum_of(const WellStringState& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.count; ++i)
    sum += vector_at(state.columns, velocity, i).z /
           (state.columns.at(inverse_mass, i) + state.columns.at(inverse_mass_along, i));
  return sum;
}

// Nothing else turns them: J w of the drive and the angular momentum of the string are what the motor has given.
TEST(WellTopEnd, ATorqueTurnsDriveAndStringTogether) {
  for (const DriveControl& control : {DriveControl{}, soft_torque(2900.0, 296.4, 1.0)}) {
    WellString string = hanging();
    string.control = control;
    string.drive_inertia = 1500.0;
    if (control.inertia > 0.0) string.drive_inertia = control.inertia;
    WellStringState state = hung_in_hole(string);
    const double initial = stored_energy(string, state, h).total();
    double given = 0.0;
    while (state.time < 20.0) {
      const double torque = state.time < 10.0 ? 4e3 : 1e3;
      advance(string, state, {.gives_torque = true, .torque = torque}, nothing, h);
      given += h * torque;
    }
    EXPECT_NEAR(string.drive_inertia * state.top.drive_speed + sum_of(state, momentum), given, 1e-9 * given);
    EXPECT_GT(state.top.drive_speed, 10.0);
    const double residual = energy_residual(string, state, initial, h);
    EXPECT_LT(std::abs(residual), 1e-4 * state.work.drive);
    // speed control goes on from where the drive is: it does not wind back what the torque has turned
    const double angle = state.top.drive_angle, speed = state.top.drive_speed;
    EXPECT_EQ(state.top.set_angle, angle);
    advance(string, state, {.drive_speed = speed}, nothing, h);
    EXPECT_NEAR(state.top.drive_angle, angle + h * speed, 1e-4 * speed);
  }
}

TEST(WellTopEnd, ABlockInBalanceStaysWhereverItIs) {
  const WellString string = hanging();
  WellStringState state = hung_in_hole(string);
  advance(string, state, {}, nothing, h);
  const auto pulled = [&](double pull, double time) {
    const double end = state.time + time;
    while (state.time < end) advance(string, state, {.is_pulled = true, .pull = pull}, nothing, h);
  };
  pulled(state.top.hook_load, 5.0);
  EXPECT_NEAR(state.top.fed, 0.0, 1e-8);
  EXPECT_NEAR(state.top.block_speed, 0.0, 1e-8);
  // lowered by 6 m, and some 20 mm more by a pull that is a little less for a while: heavier by the new pipe, and in
  // balance with what the hook bore when the block was left to the pull
  while (state.time < 40.0) {
    const double up = step5(state.time, 6.0, 0.0, 10.0, 1.0), down = step5(state.time, 18.0, 1.0, 22.0, 0.0);
    advance(string, state, {.feed_speed = 0.5 * up * down}, nothing, h);
  }
  ASSERT_NEAR(state.top.fed, 6.0, 1e-3);
  const double weight = weight_of(state), fed = state.top.fed;
  EXPECT_NEAR(state.top.hook_load, weight, 1e-3 * weight);
  pulled(weight - 200.0, 2.0);
  EXPECT_GT(state.top.block_speed, 5e-3);
  pulled(weight + 200.0, 2.0);
  EXPECT_NEAR(state.top.block_speed, 0.0, 3e-3);
  pulled(weight, 5.0);
  EXPECT_NEAR(state.top.block_speed, 0.0, 3e-3);
  EXPECT_EQ(state.top.pulled_from, fed);
  EXPECT_GT(state.top.fed - fed, 0.005);
  EXPECT_LT(state.top.fed - fed, 0.05);
}

// Block and string together fall with what the line does not bear, (m + M) a = H_0 - P, whatever the string does.
TEST(WellTopEnd, AWeakerPullLetsBlockAndStringFallTogether) {
  const WellString string = hanging();
  WellStringState state = hung_in_hole(string);
  advance(string, state, {}, nothing, h);
  const double balance = state.top.hook_load, initial = stored_energy(string, state, h).total();
  const double begin = state.time, before = momentum_of(state);
  while (state.time - begin < 2.0 - 0.5 * h)
    advance(string, state, {.is_pulled = true, .pull = balance - 1e3}, nothing, h);
  const double gained = string.block_mass * state.top.block_speed + momentum_of(state) - before;
  // new pipe enters with the speed v it joins: m' v^2 over the time, 2e-5 of this
  EXPECT_NEAR(gained, 1e3 * 2.0, 1e-4 * 1e3 * 2.0);
  EXPECT_GT(state.top.fed, 0.02);
  EXPECT_LT(std::abs(energy_residual(string, state, initial, h)), 2e-5 * balance * state.top.fed);
}

// Small motion is that of the chain of segments with the block as one more mass on the hoist's spring.
TEST(WellTopEnd, TheBlockIsAMassOnTheChain) {
  WellString string = without_damping({.sections = {section(drill_pipe(), 90.0, 3)}, .upper_end = UpperEnd::table});
  string.longest_grown = 1.0;
  string.block_mass = 3000.0;  // 1.2 times the pipe, so that both move
  const double step = 2.5e-5;  // its phase is late by (w h)^2 / 24, 1e-3 of the fastest mode in 0.5 s
  WellStringState state = hung_in_hole([&] {
    WellString in_hole = string;
    in_hole.hole = straight_hole(0.0, 300.0, 0.2159, 0.0);
    return in_hole;
  }());
  advance(string, state, {}, nothing, step);
  const double balance = state.top.hook_load;
  Chain chain = chains_of(string, 0.0).axial;
  chain.inertia.insert(chain.inertia.begin(), string.block_mass);
  chain.stiffness.insert(chain.stiffness.begin(), 0.0);
  const auto n = static_cast<Eigen::Index>(chain.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    mass(i, i) = chain.inertia[static_cast<std::size_t>(i)];
    if (i == 0) continue;
    const double k = chain.stiffness[static_cast<std::size_t>(i)];
    stiffness(i, i) += k;
    stiffness(i - 1, i - 1) += k;
    stiffness(i, i - 1) -= k;
    stiffness(i - 1, i) -= k;
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness, mass);
  const Eigen::MatrixXd& shape = modes.eigenvectors();
  Eigen::VectorXd kick = Eigen::VectorXd::Zero(n);
  kick(0) = 1e-4;  // [m/s] of the block
  const Eigen::VectorXd amplitude = shape.transpose() * (mass * kick);
  state.top.block_speed = kick(0);
  const double begin = state.time;
  double largest = 0.0, worst = 0.0;
  while (state.time - begin < 0.5) {
    advance(string, state, {.is_pulled = true, .pull = balance}, nothing, step);
    const double time = state.time - 0.5 * step - begin;  // of the forces, since the kick, which was half a step before
    Eigen::VectorXd place = Eigen::VectorXd::Zero(n);
    for (Eigen::Index k = 1; k < n; ++k) {
      const double w = std::sqrt(modes.eigenvalues()(k));
      place += amplitude(k) * std::sin(w * time) / w * shape.col(k);
    }
    const double more = chain.stiffness[1] * (place(1) - place(0));
    largest = std::max(largest, std::abs(more));
    worst = std::max(worst, std::abs(state.top.hook_load - balance - more));
  }
  EXPECT_GT(largest, 20.0);
  EXPECT_LT(worst, 1e-3 * largest);
}

TEST(WellTopEnd, TheLeastMassAndInertiaAreStableAndATenthIsNot) {
  for (const double share : {1.0, 0.1}) {
    WellString string = hanging();
    string.block_mass = share * least_block_mass(string, h);
    string.drive_inertia = share * least_drive_inertia(string, h);
    WellStringState state = hung_in_hole(string);
    advance(string, state, {}, nothing, h);
    const double balance = state.top.hook_load;
    state.top.block_speed = 1e-6;
    state.top.drive_speed = 1e-6;
    double largest = 0.0;
    for (int i = 0; i < 4000 && largest < 1.0; ++i) {
      advance(string, state, {.gives_torque = true, .is_pulled = true, .pull = balance}, nothing, h);
      largest = std::max({largest, std::abs(state.top.block_speed), std::abs(state.top.drive_speed)});
    }
    EXPECT_EQ(largest < 2e-6, share == 1.0) << share << ": " << largest;
  }
}

TEST(WellTopEnd, ImposedSpeedsAreUntouched) {
  const RigControls speeds{.feed_speed = 0.01, .drive_speed = 1.0};
  const WellString string = hanging();
  WellString heavy = string;
  heavy.block_mass *= 3.0;
  heavy.drive_inertia *= 3.0;
  WellStringState one = hung_in_hole(string), other = one;
  for (int i = 0; i < 500; ++i) {
    advance(string, one, speeds, nothing, h);
    advance(heavy, other, speeds, nothing, h);
  }
  EXPECT_EQ(one.top.hook_load, other.top.hook_load);
  EXPECT_EQ(one.top.block_speed, 0.01);
  EXPECT_EQ(one.columns.memory, other.columns.memory);
}

}  // namespace
