// Waves along a bar of bonded discs. A row of n equal discs with Kn = kn 2R = E* between neighbours and a = 2R has the
// standing waves [Brillouin1946] (free ends, p = 1 .. n - 1)
//
//     u_i = A cos(k a (i + 1/2)) cos(omega_d t)     k = p pi/(n a)     omega = 2 sqrt(Kn/m) sin(k a/2)
//
// The leap-frog scheme with step dt keeps them exactly, only faster: sin(omega_d dt/2) = omega dt/2. Long waves run at
// sqrt(E/rho) of the bar, with E = E* and the density of discs in squares, rho pi/4.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;
using std::numbers::pi;

constexpr double amplitude = 1e-5;  // [m]; along the row the opening of a joint is linear in the motion, however large

class BondedBar : public verification::JointPaths {
 protected:
  /// A row in its mode p at the turning point: speeds half a step earlier are half the first step's change, backwards.
  dem2d::World standing_wave(int discs, int p, double step_share) const {
    dem2d::World world = on_path(small_worlds::chain(discs));
    dem2d::prepare(world);
    const double natural = std::sqrt(small_worlds::modulus / world.discs.mass[0]);  // sqrt(Kn/m) [rad/s]
    world.step = step_share / natural;
    const double omega = 2.0 * natural * std::sin(0.5 * p * pi / discs);
    for (int i = 0; i < discs; ++i) {
      const double displacement = amplitude * std::cos(p * pi * (i + 0.5) / discs);
      world.discs.x[static_cast<std::size_t>(i)] += displacement;
      world.discs.velocity_x[static_cast<std::size_t>(i)] = 0.5 * omega * omega * displacement * world.step;
    }
    return world;
  }
};

TEST_P(BondedBar, StandingWavesKeepTheirShapeAndTheirDiscreteFrequency) {
  const int discs = 16;
  for (const int p : {1, 2, 5, 8, 13, 15}) {
    dem2d::World world = standing_wave(discs, p, 0.7);
    const double phase = 2.0 * std::asin(0.7 * std::sin(0.5 * p * pi / discs));  // omega_d dt
    for (int step = 1; step <= 2000; ++step) {
      dem2d::advance(world);
      for (int i = 0; i < discs; i += 5) {
        const double expected = amplitude * std::cos(p * pi * (i + 0.5) / discs) * std::cos(phase * step);
        // each step rounds positions of 1e-2 m to 1e-18 m, 1e-13 of the amplitude; 2000 steps add up at random
        ASSERT_NEAR(world.discs.x[static_cast<std::size_t>(i)] - 2.0 * radius * i, expected, 1e-10 * amplitude)
            << p << " " << step << " " << i;
      }
    }
    for (const double y : world.discs.y) EXPECT_NEAR(y, 0.0, 1e-10 * amplitude);
  }
}

TEST_P(BondedBar, TheSpeedOfLongWavesConvergesToThatOfTheBar) {
  // phase speed omega_d / k of the lowest mode, omega_d from three samples: cos(omega_d dt) = (u' + u'')/(2 u). Its
  // error is (1 - step_share^2) (k a)^2/24, of second order in the number of discs
  const double bar_speed = std::sqrt(small_worlds::modulus / (small_worlds::density * pi / 4.0)), step_share = 0.5;
  double previous = 0.0;
  for (const int discs : {8, 16, 32}) {
    dem2d::World world = standing_wave(discs, 1, step_share);
    const double before = world.discs.x[0];
    dem2d::advance(world);
    const double now = world.discs.x[0];
    dem2d::advance(world);
    const double after = world.discs.x[0];
    const double frequency = std::acos(0.5 * (before + after) / now) / world.step;
    const double wave_number = pi / (discs * 2.0 * radius);
    const double error = 1.0 - frequency / wave_number / bar_speed;
    const double expected = (1.0 - step_share * step_share) * std::pow(pi / discs, 2) / 24.0;
    EXPECT_NEAR(error, expected, 0.02 * expected) << discs;
    if (previous != 0.0) {
      EXPECT_NEAR(previous / error, 4.0, 0.05) << discs;
    }
    previous = error;
  }
}

/// Time at which the top of a pulse that leaves the left end of a bar reaches the right end, over length by speed.
double pulse_travel(dem2d::World world, double width_share) {
  dem2d::prepare(world);
  const double speed = std::sqrt(small_worlds::modulus / (small_worlds::density * pi / 4.0));
  const double length =
      2.0 * radius * world.discs.count();  // the free ends mirror waves half a disc beyond the centres
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    const double from_end = world.discs.x[i] + radius;
    world.discs.velocity_x[i] = std::exp(-std::pow(from_end / (width_share * length), 2));
  }
  world.step = 0.5 * 2.0 * radius / speed;
  double before = 0.0, top = 0.0, arrival = 0.0;
  while (world.time < 1.3 * length / speed) {
    dem2d::advance(world);
    const double now = world.discs.velocity_x.back();
    const double bend = before - 2.0 * top + now;
    if (top > before && top > now && top > 0.5) {  // the highest point of the parabola through three samples
      arrival = world.time - 1.5 * world.step + 0.5 * world.step * (before - now) / bend;
    }
    before = top;
    top = now;
  }
  return arrival / (length / speed);
}

TEST_P(BondedBar, APulseRunsAtTheSpeedOfTheBar) {
  // its shorter waves lag by (k a)^2/24 and more: the delay is of second order in the number of discs
  const double coarse = pulse_travel(on_path(small_worlds::chain(64)), 0.2) - 1.0;
  const double fine = pulse_travel(on_path(small_worlds::chain(128)), 0.2) - 1.0;
  EXPECT_GT(fine, 0.0);
  EXPECT_LT(fine, 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Paths, BondedBar, testing::Bool(), verification::path_name);

}  // namespace
