// Two discs against the same scheme stepped by hand: opening, shear, bending, spin and friction all at once, for discs
// of different size on a slanted line. The hand works with complex numbers (x + i y), so that a force with the
// components N along n and T along t = i n is (N + i T) n.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;
using Complex = std::complex<double>;

struct HandDisc {
  Complex position, velocity;
  double angle, spin, radius, mass, inertia;
};

HandDisc by_hand(const dem2d::Discs& d, std::size_t i) {
  return {.position = {d.x[i], d.y[i]},
          .velocity = {d.velocity_x[i], d.velocity_y[i]},
          .angle = d.angle[i],
          .spin = d.spin[i],
          .radius = d.radius[i],
          .mass = d.mass[i],
          .inertia = d.inertia[i]};
}

/// Line of centres and relative motion of disc 2 against disc 1.
struct HandPair {
  Complex normal;
  double distance, lever1, lever2, opening_speed, shear_speed;
};

HandPair look(const HandDisc& one, const HandDisc& two) {
  const Complex line = two.position - one.position;
  HandPair pair;
  pair.distance = std::abs(line);
  pair.normal = line / pair.distance;
  const double gap = pair.distance - one.radius - two.radius;
  pair.lever1 = one.radius + 0.5 * gap;
  pair.lever2 = two.radius + 0.5 * gap;
  // the velocity of a material point at r from the centre is v + i w r; the contact point is at n lever1, -n lever2
  const Complex at1 = one.velocity + Complex(0.0, one.spin * pair.lever1) * pair.normal;
  const Complex at2 = two.velocity - Complex(0.0, two.spin * pair.lever2) * pair.normal;
  const Complex relative = (at2 - at1) * std::conj(pair.normal);
  pair.opening_speed = relative.real();
  pair.shear_speed = relative.imag();
  return pair;
}

/// F - alpha |F| sign(v), component by component.
double damped(double force, double velocity, double alpha) {
  return velocity == 0.0 ? force : force - alpha * std::fabs(force) * (velocity > 0.0 ? 1.0 : -1.0);
}

void move(HandDisc& disc, Complex force, double moment, double alpha, double dt) {
  disc.velocity +=
      Complex(damped(force.real(), disc.velocity.real(), alpha), damped(force.imag(), disc.velocity.imag(), alpha)) /
      disc.mass * dt;
  disc.spin += damped(moment, disc.spin, alpha) / disc.inertia * dt;
  disc.position += disc.velocity * dt;
  disc.angle += disc.spin * dt;
}

/// Positions near round-off of 1e-3 m, added up over hundreds of steps; speeds to 1e-11 of what they reach.
void expect_same(const HandDisc& hand, const dem2d::Discs& d, std::size_t i, double speed, int step) {
  ASSERT_NEAR(d.x[i], hand.position.real(), 1e-15) << step;
  ASSERT_NEAR(d.y[i], hand.position.imag(), 1e-15) << step;
  ASSERT_NEAR(d.angle[i], hand.angle, 1e-11) << step;
  ASSERT_NEAR(d.velocity_x[i], hand.velocity.real(), 1e-10 * speed) << step;
  ASSERT_NEAR(d.velocity_y[i], hand.velocity.imag(), 1e-10 * speed) << step;
  ASSERT_NEAR(d.spin[i], hand.spin, 1e-10 * speed / radius) << step;
}

/// Discs of radius R and 0.6 R whose surfaces are `gap` apart along 40 degrees.
dem2d::World slanted_pair(double gap) {
  dem2d::World world = small_worlds::empty();
  const Complex second = std::polar(1.6 * radius + gap, 0.7);
  dem2d::add_disc(world.discs, 0.0, 0.0, radius, small_worlds::density);
  dem2d::add_disc(world.discs, second.real(), second.imag(), 0.6 * radius, small_worlds::density);
  return world;
}

class PairRecurrence : public verification::JointPaths {};

TEST_P(PairRecurrence, BondedPairStretchesShearsBendsAndTurns) {
  for (const double alpha : {0.0, 0.2}) {
    dem2d::World world = on_path(slanted_pair(2e-5));  // joined across a gap
    dem2d::JointProperties properties = small_worlds::properties();
    properties.radius_multiplier = 0.8;
    properties.stiffness_ratio = 1.7;
    dem2d::add_joint(world, 0, 1, properties);
    world.materials.local_damping = alpha;
    world.discs.velocity_x = {1.0, -2.0};
    world.discs.velocity_y = {0.5, 3.0};
    world.discs.spin = {2000.0, -500.0};
    dem2d::prepare(world);
    world.step = 0.3 * dem2d::critical_step(world);

    const double half = 0.8 * 0.6 * radius, kn = small_worlds::modulus / (1.6 * radius), ks = kn / 1.7;
    const double installed = look(by_hand(world.discs, 0), by_hand(world.discs, 1)).distance;
    HandDisc one = by_hand(world.discs, 0), two = by_hand(world.discs, 1);
    double slip = 0.0, most_bent = 0.0;
    for (int step = 0; step < 400; ++step) {
      const HandPair pair = look(one, two);
      slip += pair.shear_speed * world.step;
      const double pull = kn * 2.0 * half * (pair.distance - installed), shear = ks * 2.0 * half * slip;
      const double bending = kn * std::pow(2.0 * half, 3) / 12.0 * (two.angle - one.angle);
      const Complex force = Complex(pull, shear) * pair.normal;  // on disc 1
      move(one, force, pair.lever1 * shear + bending, alpha, world.step);
      move(two, -force, pair.lever2 * shear - bending, alpha, world.step);
      dem2d::advance(world);
      expect_same(one, world.discs, 0, 3.0, step);
      expect_same(two, world.discs, 1, 3.0, step);
      most_bent = std::fmax(most_bent, std::fabs(two.angle - one.angle));
    }
    EXPECT_GT(most_bent, 1e-4) << "it must have bent";
  }
}

TEST(LoosePairRecurrence, SticksSlipsAndParts) {
  // an oblique collision with spin: friction 0.5, with and without dashpots; the contact ends on its own
  for (const double beta : {0.0, 0.2}) {
    dem2d::World world = slanted_pair(1e-6);
    world.materials.contact_damping_ratio = beta;
    world.materials.contact_shear_damping_ratio = 0.5 * beta;
    world.discs.velocity_x = {1.0, -2.0};
    world.discs.velocity_y = {0.5, -1.0};
    world.discs.spin = {2000.0, 500.0};
    dem2d::prepare(world);
    world.step = 1e-8;
    HandDisc one = by_hand(world.discs, 0), two = by_hand(world.discs, 1);
    const double kn = 2.0 * 0.6 * radius * small_worlds::modulus / (1.6 * radius), ks = kn / 2.0;
    const double reduced = one.mass * two.mass / (one.mass + two.mass);
    const double dashpot = 2.0 * beta * std::sqrt(reduced * kn);
    const double shear_dashpot = 2.0 * 0.5 * beta * std::sqrt(reduced * ks);
    double spring = 0.0;
    int sticking = 0, slipping = 0, step = 0;
    bool parted = false;
    for (; step < 2000 && !parted; ++step) {
      const HandPair pair = look(one, two);
      const double overlap = 1.6 * radius - pair.distance;
      double push = 0.0, shear = 0.0;
      if (overlap > 0.0) {
        push = std::max(0.0, kn * overlap - dashpot * pair.opening_speed);
        const double trial = spring + ks * pair.shear_speed * world.step;
        spring = std::clamp(trial, -0.5 * push, 0.5 * push);
        const bool sticks = spring == trial;
        shear = sticks ? std::clamp(spring + shear_dashpot * pair.shear_speed, -0.5 * push, 0.5 * push) : spring;
        ++(sticks ? sticking : slipping);
      }
      parted = overlap <= 0.0 && sticking + slipping > 0;
      const Complex force = Complex(-push, shear) * pair.normal;
      move(one, force, pair.lever1 * shear, 0.0, world.step);
      move(two, -force, pair.lever2 * shear, 0.0, world.step);
      dem2d::advance(world);
      expect_same(one, world.discs, 0, 3.0, step);
      expect_same(two, world.discs, 1, 3.0, step);
    }
    EXPECT_TRUE(parted);
    EXPECT_GT(sticking, 10);
    EXPECT_GT(slipping, 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, PairRecurrence, testing::Bool(), verification::path_name);

}  // namespace
