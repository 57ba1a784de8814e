// Restitution of the linear spring with a dashpot that never pulls.
//
// While the force pushes, m u'' + c u' + k u = 0 with c = 2 beta sqrt(m k), starting from u = 0, u' = v. The contact
// force ends when k u + c u' = -m u'' = 0, before the overlap does; from then on the force is cut off at zero and the
// speed stays. For beta < 1, with omega = sqrt(k/m), damped frequency omega sqrt(1 - beta^2) and beta = sin(gamma),
// u'' = 0 gives tan(omega sqrt(1 - beta^2) t) = -tan(2 gamma), first at pi - 2 gamma = 2 arccos(beta), and then
//
//     e = -u'/v = exp(-2 beta arccos(beta) / sqrt(1 - beta^2))
//     e = exp(-2)  at beta = 1      e = exp(-2 beta arcosh(beta) / sqrt(beta^2 - 1))  beyond
//
// (the condition on the force instead of the overlap as in [SchwagerPoeschel2007]). A dashpot that could pull would end
// at u = 0 and give exp(-pi beta / sqrt(1 - beta^2)): 0.163 instead of 0.298 at beta = 0.5.
#include <gtest/gtest.h>

#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

double closed_form(double beta) {
  if (beta < 1.0) return std::exp(-2.0 * beta * std::acos(beta) / std::sqrt(1.0 - beta * beta));
  if (beta == 1.0) return std::exp(-2.0);
  return std::exp(-2.0 * beta * std::acosh(beta) / std::sqrt(beta * beta - 1.0));
}

/// A disc falls on a wall: speed after over speed before.
double wall_restitution(double beta, double step_share) {
  dem2d::World world = small_worlds::disc_above_floor(0.0);
  world.boundaries[0].damping_ratio = beta;
  world.discs.velocity_y[0] = -1.0;
  dem2d::prepare(world);
  world.step = step_share / std::sqrt(2.0 * small_worlds::modulus / world.discs.mass[0]);
  while (world.time * std::sqrt(2.0 * small_worlds::modulus / world.discs.mass[0]) < 10.0) dem2d::advance(world);
  EXPECT_EQ(world.boundaries[0].force_y, 0.0) << "the contact must be over";
  return world.discs.velocity_y[0];
}

/// Two discs, one half as large, meet head on along a slanted line.
double pair_restitution(double beta, double step_share) {
  dem2d::World world = small_worlds::empty();
  world.materials.contact_damping_ratio = beta;
  dem2d::add_disc(world.discs, 0.0, 0.0, radius, small_worlds::density);
  dem2d::add_disc(world.discs, 0.6 * 1.5 * radius, 0.8 * 1.5 * radius, 0.5 * radius, small_worlds::density);
  world.discs.velocity_x = {0.6 * 0.3, -0.6 * 0.7};
  world.discs.velocity_y = {0.8 * 0.3, -0.8 * 0.7};
  dem2d::prepare(world);
  const double mass = world.discs.mass[0] / 5.0;         // m1 m2/(m1 + m2) with m2 = m1/4
  const double stiffness = small_worlds::modulus / 1.5;  // A E/L = 2 (R/2) E/(1.5 R)
  world.step = step_share / std::sqrt(stiffness / mass);
  while (world.time * std::sqrt(stiffness / mass) < 10.0) dem2d::advance(world);
  EXPECT_EQ(world.discs.force_x[0], 0.0) << "the contact must be over";
  EXPECT_NEAR(world.discs.spin[0], 0.0, 1e-9);
  return 0.6 * (world.discs.velocity_x[1] - world.discs.velocity_x[0]) +
         0.8 * (world.discs.velocity_y[1] - world.discs.velocity_y[0]);
}

/// The dashpot sees the velocity of half a step ago, so the error is of first order: it halves with the step, and
/// twice the finer result less the coarser one is right to second order, (omega dt)^2 = 1e-6.
template <class Collide>
void expect_restitution(const Collide& collide) {
  for (const double beta : {0.0, 0.05, 0.2, 0.5, 0.75, 1.0, 1.5}) {
    const double expected = closed_form(beta), coarse = collide(beta, 1e-3), fine = collide(beta, 5e-4);
    EXPECT_NEAR(2.0 * fine - coarse, expected, 2e-6) << beta;
    EXPECT_NEAR(fine, expected, 5e-4) << beta;
  }
}

TEST(Restitution, OfADiscOnAWallFollowsTheDashpotThatNeverPulls) {
  EXPECT_NEAR(closed_form(0.5), 0.29843, 1e-5);  // exp(-pi/3 / sqrt(3)/2 ...) = exp(-2 pi / (3 sqrt(3)))
  expect_restitution(wall_restitution);
}

TEST(Restitution, OfTwoDiscsFollowsTheDashpotThatNeverPulls) {
  expect_restitution(pair_restitution);
}

}  // namespace
