// Free oscillation of a bonded pair of equal discs, alone in space: frequencies of its three modes, and its decay under
// local damping.
//
// With Kn = kn 2R, Ks = ks 2R, Kb = kn (2R)^3/12 and I = m R^2/2 the pair oscillates
//
//     along its axis           omega^2 = 2 Kn/m
//     in shear                 omega^2 = 2 Ks (1/m + R^2/I) = 6 Ks/m      (discs move apart along t and turn alike)
//     in bending               omega^2 = 2 Kb/I                           (discs turn against each other)
//
// and the leap-frog scheme keeps each mode exactly with sin(omega_d dt/2) = omega dt/2.
//
// Local damping alpha makes the force (1 - alpha) F on the way to the middle and (1 + alpha) F on the way out. Energy
// on a way in and out: (1 - alpha) A^2 = (1 + alpha) A'^2. So each half cycle keeps the share sqrt((1 - alpha)/(1 +
// alpha)) of the amplitude and lasts pi/(2 omega) (1/sqrt(1 - alpha) + 1/sqrt(1 + alpha)).
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

constexpr double axial = small_worlds::modulus;                   // Kn = kn 2R = E* [Pa]
constexpr double shear = axial / 2.0;                             // Ks [Pa]
constexpr double bending = axial * 4.0 * radius * radius / 12.0;  // Kb [N]
constexpr double step_share = 0.3;                                // omega dt

class PairOscillation : public verification::JointPaths {
 protected:
  dem2d::World pair(double omega, double share) const {
    dem2d::World world = on_path(small_worlds::empty());
    dem2d::add_disc(world.discs, -radius, 0.0, radius, small_worlds::density);
    dem2d::add_disc(world.discs, radius, 0.0, radius, small_worlds::density);
    dem2d::add_joint(world, 0, 1, small_worlds::properties());
    dem2d::prepare(world);
    world.step = share / omega;
    return world;
  }
  const double mass = small_worlds::density * pi * radius * radius;
  const double inertia = 0.5 * mass * radius * radius;
  const double phase = 2.0 * std::asin(0.5 * step_share);  // omega_d dt
};

TEST_P(PairOscillation, AlongItsAxisHasTheDiscreteFrequency) {
  dem2d::World world = pair(std::sqrt(2.0 * axial / mass), step_share);
  const double largest = 1e-5, first = largest * std::sin(phase);  // opening = largest sin(n phase)
  world.discs.velocity_x = {-0.5 * first / world.step, 0.5 * first / world.step};
  for (int step = 1; step <= 1000; ++step) {
    dem2d::advance(world);
    const double opening = world.discs.x[1] - world.discs.x[0] - 2.0 * radius;
    ASSERT_NEAR(opening, largest * std::sin(step * phase), 1e-10 * largest) << step;  // 1000 roundings of 1e-19 m
  }
}

TEST_P(PairOscillation, InShearHasTheDiscreteFrequency) {
  dem2d::World world = pair(std::sqrt(6.0 * shear / mass), step_share);
  // slip s = 2 y - 2 R spin angle, shared as the mode has it: m y = -I angle / R, so y = s/6 and R angle = -s/3
  const double largest = 1e-10, first = largest * std::sin(phase);
  const double vy = first / 6.0 / world.step, spin = -first / 3.0 / radius / world.step;
  world.discs.velocity_y = {-vy, vy};
  world.discs.spin = {spin, spin};
  // the joint takes its slip from the motion of the step that led here: this is the first step's
  world.discs.y = {-first / 6.0, first / 6.0};
  world.discs.angle = {-first / 3.0 / radius, -first / 3.0 / radius};
  for (int step = 2; step <= 1000; ++step) {
    dem2d::advance(world);
    // the axis turns by y/R = 1e-8: what that changes is of its square
    ASSERT_NEAR(world.discs.y[1], largest / 6.0 * std::sin(step * phase), 1e-10 * largest) << step;
    ASSERT_NEAR(world.discs.angle[0] * radius, -largest / 3.0 * std::sin(step * phase), 1e-10 * largest) << step;
  }
}

TEST_P(PairOscillation, InBendingHasTheDiscreteFrequency) {
  dem2d::World world = pair(std::sqrt(2.0 * bending / inertia), step_share);
  const double largest = 1e-3, first = largest * std::sin(phase);
  world.discs.spin = {-0.5 * first / world.step, 0.5 * first / world.step};
  for (int step = 1; step <= 1000; ++step) {
    dem2d::advance(world);
    ASSERT_NEAR(world.discs.angle[1] - world.discs.angle[0], largest * std::sin(step * phase), 1e-10 * largest) << step;
  }
}

TEST_P(PairOscillation, LosesItsShareToLocalDampingInEachHalfCycle) {
  // The sign of the velocity is known half a step late: the error is of first order, a few omega dt a half cycle.
  const double omega = std::sqrt(2.0 * axial / mass), share = 5e-4;
  for (const double alpha : {0.1, 0.3, 0.7}) {
    dem2d::World world = pair(omega, share);
    world.materials.local_damping = alpha;
    double amplitude = 1e-5, start = 0.0;
    world.discs.x[0] -= 0.5 * amplitude;
    world.discs.x[1] += 0.5 * amplitude;
    const double ratio = std::sqrt((1.0 - alpha) / (1.0 + alpha));
    const double half_cycle = 0.5 * pi / omega * (1.0 / std::sqrt(1.0 - alpha) + 1.0 / std::sqrt(1.0 + alpha));
    for (int turn = 1; turn <= 4; ++turn) {
      const double towards = turn % 2 == 1 ? -1.0 : 1.0;
      do {
        dem2d::advance(world);
      } while ((world.discs.velocity_x[1] - world.discs.velocity_x[0]) * towards > 0.0);
      const double reached = std::fabs(world.discs.x[1] - world.discs.x[0] - 2.0 * radius);
      EXPECT_NEAR(reached / amplitude, ratio, 5.0 * share) << alpha << " " << turn;
      EXPECT_NEAR((world.time - start) / half_cycle, 1.0, 5.0 * share) << alpha << " " << turn;
      amplitude = reached;
      start = world.time;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, PairOscillation, testing::Bool(), verification::path_name);

}  // namespace
