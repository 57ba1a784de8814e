// The energy ledger: it closes, each entry is the number it should be, and looking changes nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dem2d/cut/run_cut.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"
#include "tests/verification/ledger.hpp"

using namespace bitrock;

namespace {

using small_worlds::modulus;
using small_worlds::radius;
using verification::run;

void start(dem2d::World& world, double step_over_critical) {
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.step = step_over_critical * dem2d::critical_step(world);
}

/// The same for a disc that does not touch its floor yet: a step in units of sqrt(m / kn).
void start_on_floor(dem2d::World& world, double step_times_frequency) {
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.step = step_times_frequency * std::sqrt(world.discs.mass[0] / (2.0 * modulus));
}

double strain(const dem2d::Energies& e) {
  return e.strain_joints + e.strain_contacts + e.strain_boundaries;
}

class EnergyOfAPair : public verification::JointPaths {};
INSTANTIATE_TEST_SUITE_P(Both, EnergyOfAPair, testing::Bool(), verification::path_name);

TEST_P(EnergyOfAPair, OscillationKeepsItsEnergyToRounding) {
  // The leap-frog scheme keeps m v- v+ / 2 + k x^2 / 2 of a linear spring exactly; velocities before and after alone
  // would swing by (omega dt)^2 / 4, here 20 %.
  dem2d::World world = on_path(small_worlds::chain(2));
  world.discs.velocity_x = {-0.5, 0.5};
  start(world, 1.0);
  const dem2d::Energies first = run(world, 1);
  const double energy = first.kinetic + strain(first);
  EXPECT_NEAR(energy, world.discs.mass[0] * 0.25, 1e-12 * energy);
  for (int look = 0; look < 200; ++look) {
    const dem2d::Energies now = run(world, 1);
    ASSERT_NEAR(now.kinetic + strain(now), energy, 1e-11 * energy) << look;
  }
  EXPECT_GT(run(world, 3).strain_joints, 0.01 * energy);
}

TEST_P(EnergyOfAPair, APairThatBreaksClosesItsLedger) {
  // Flying apart, turning against each other and shearing, with damping: elements break one after the other in both
  // modes, the rest rubs, opens and closes. All that was there is the kinetic energy of the start.
  dem2d::World world = on_path(small_worlds::chain(2, 2e6));
  for (double& cohesion : world.joints.cohesion) cohesion = 2e6;
  world.materials.local_damping = 0.1;
  world.discs.velocity_x = {-2.0, -2.2};
  world.discs.velocity_y = {0.0, 3.0};
  world.discs.spin = {-4000.0, 2000.0};
  start(world, 0.1);
  const dem2d::Energies first = run(world, 1);
  double largest = 0.0;
  dem2d::Energies last;
  for (int look = 0; look < 400; ++look) {
    last = run(world, 5);
    largest = std::max(largest, std::fabs(dem2d::energy_residual(first, last)));
  }
  EXPECT_EQ(world.cracks.size(), 4u) << "every element must have broken";
  EXPECT_GT(last.breaking, 0.005 * first.kinetic);
  EXPECT_GT(last.friction, 0.005 * first.kinetic);
  EXPECT_LT(largest, 1e-4 * first.kinetic);
  EXPECT_LT(std::fabs(last.switching), 5e-4 * first.kinetic);
}

TEST_P(EnergyOfAPair, WorkOfAStrikingBoundaryIsFoundAgain) {
  // A boundary runs into the second disc of a resting pair, off its middle, so that the joint is bent, sheared and
  // broken. The only input is the work of the boundary, which has friction and dashpots.
  dem2d::World world = on_path(small_worlds::chain(2, 1e6));
  for (double& cohesion : world.joints.cohesion) cohesion = 1.5e6;
  world.materials.local_damping = 0.1;
  world.boundaries.push_back({.shape = dem2d::rectangle(2.2 * radius, 1.01 * radius, 4.0 * radius, 3.0 * radius),
                              .velocity_y = -5.0,
                              .modulus = modulus,
                              .stiffness_ratio = 2.0,
                              .friction = 0.4,
                              .damping_ratio = 0.3,
                              .shear_damping_ratio = 0.2});
  start(world, 0.1);
  const dem2d::Energies first = run(world, 1);
  const dem2d::Energies last = run(world, 4000);
  EXPECT_EQ(world.cracks.size(), 4u);
  EXPECT_GT(last.boundary_work, 0.0);
  EXPECT_GT(last.dashpots, 0.01 * last.boundary_work);
  EXPECT_LT(std::fabs(dem2d::energy_residual_fraction(first, last)), 1e-4);
  EXPECT_LT(std::fabs(last.switching), 1e-3 * last.boundary_work);
}

TEST_P(EnergyOfAPair, ABreakReleasesWhatTheStrengthSays) {
  // Pulled apart slowly along its axis, every element of the joint holds sigma_c^2 / (2 kn) per area when it breaks.
  const double strength = 1e6, kn = modulus / (2.0 * radius);
  dem2d::World world = on_path(small_worlds::chain(2, strength));
  for (const std::size_t disc : {0u, 1u}) {
    dem2d::set_mass(world.discs, disc, 1e6, world.discs.inertia[disc]);
  }  // heavy discs are moved, not stopped, by the joint: a steady pull
  world.discs.velocity_x = {-0.5e-3, 0.5e-3};
  world.ledger.measured = true;
  dem2d::prepare(world);
  world.step = strength / kn / 1e-3 / 2000.5;  // breaks within step 2001
  const dem2d::Energies last = run(world, 2010);
  EXPECT_EQ(world.cracks.size(), 4u);
  const double expected = strength * strength / (2.0 * kn) * 2.0 * radius;
  EXPECT_NEAR(last.breaking, expected, 2.0 / 2000.0 * expected);  // the strength is passed somewhere within a step
  EXPECT_EQ(last.strain_joints, 0.0);
}

TEST(Energy, FrictionIsForceTimesSlip) {
  // One disc, pressed on a floor by a constant overlap and kept from turning, slides a known way.
  dem2d::World world = small_worlds::disc_above_floor(-1e-6);
  start(world, 0.1);
  const double normal = 2.0 * modulus * 1e-6, limit = 0.5 * normal, ks = modulus, speed = 2.0;
  const int steps = 500;
  dem2d::Energies last;
  for (int step = 0; step <= steps; ++step) {
    world.discs.y[0] = radius - 1e-6;
    world.discs.velocity_x[0] = speed;
    world.discs.velocity_y[0] = 0.0;
    world.discs.spin[0] = 0.0;
    dem2d::find_forces(world);
    if (step == steps) last = dem2d::read_energies(world);
    dem2d::move(world);
  }
  const double way = speed * world.step * (steps + 1);  // the spring of the first instant counts from its step, too
  // sliding begins within a step, whose mean force is then up to half that of one step's spring short of the limit:
  // at most limit times 1/8 of a step's way
  EXPECT_NEAR(last.friction, limit * (way - limit / ks), limit * speed * world.step / 8.0);
  EXPECT_NEAR(last.strain_boundaries, normal * 1e-6 / 2.0 + limit * limit / (2.0 * ks), 1e-9 * normal * 1e-6);
}

TEST(Energy, DashpotsAndSwitchingTakeWhatACollisionLoses) {
  for (const double shear_speed : {0.0, 0.4}) {
    dem2d::World world = small_worlds::disc_above_floor(1e-7);
    world.boundaries[0].damping_ratio = 0.3;
    world.boundaries[0].shear_damping_ratio = 0.2;
    world.discs.velocity_y[0] = -1.0;
    world.discs.velocity_x[0] = shear_speed;
    start_on_floor(world, 0.2);
    const dem2d::Energies first = run(world, 1), last = run(world, 200);
    ASSERT_GT(world.discs.velocity_y[0], 0.1);
    const double lost = first.kinetic - last.kinetic;
    // with shear, the lever of its force changes with the overlap within a step: of second order, 2e-6 here
    EXPECT_NEAR(last.dashpots + last.switching + last.friction, lost, (shear_speed > 0.0 ? 1e-5 : 1e-9) * lost);
    EXPECT_GT(last.dashpots, 0.9 * lost - last.friction);
    EXPECT_GT(last.switching, 0.0) << "it closes faster than it opens";
    EXPECT_LT(last.switching, 0.01 * lost);
  }
}

TEST(Energy, LocalDampingTakesItsShareOfForceTimesWay) {
  // A disc is thrown on a floor without dashpots and friction and comes back; damping takes alpha |F| over every bit of
  // way, in and out. In: (1 + alpha) U = E, so the spring holds U = E / (1 + alpha). Out: the disc keeps (1 - alpha) U.
  const double alpha = 0.25;
  dem2d::World world = small_worlds::disc_above_floor(0.0);
  world.boundaries[0].friction = 0.0;
  world.materials.local_damping = alpha;
  world.discs.velocity_y[0] = -1.0;
  start_on_floor(world, 0.02);
  const double kinetic = 0.5 * world.discs.mass[0];
  const dem2d::Energies last = run(world, 400);
  ASSERT_GT(world.discs.velocity_y[0], 0.0);
  const double held = kinetic / (1.0 + alpha);
  EXPECT_NEAR(last.local_damping, 2.0 * alpha * held, 1e-3 * kinetic);
  EXPECT_NEAR(last.kinetic, (1.0 - alpha) * held, 1e-3 * kinetic);
  EXPECT_NEAR(last.kinetic + last.local_damping + last.switching, kinetic, 1e-12 * kinetic);
}

TEST(Energy, ALostDiscTakesItsEnergyAlong) {
  dem2d::World world = small_worlds::chain(3);
  world.domain = {-1.0, -1.0, 1.0, 5.0 * radius};
  world.discs.velocity_y = {0.0, 0.0, 0.0};
  dem2d::add_disc(world.discs, 0.0, 4.5 * radius, radius, 2500.0);
  world.discs.velocity_y[3] = 10.0;
  world.discs.spin[3] = 500.0;
  start(world, 1.0);
  const dem2d::Energies first = run(world, 1);
  const dem2d::Energies last = run(world, 2000);
  ASSERT_EQ(world.removed_discs, 1);
  const double mass = world.discs.mass[0];
  const double own = 0.5 * mass * 100.0 + 0.5 * (0.5 * mass * radius * radius) * 500.0 * 500.0;
  EXPECT_NEAR(last.removed, own, 1e-12 * own);
  EXPECT_NEAR(dem2d::energy_residual(first, last), 0.0, 1e-12 * own);
}

TEST(Energy, ADiscThatLeavesAJointTakesItsEnergyAlong) {
  // A vibrating pair is carried over the edge, and one of it is lost while the joint is strained. The book of that
  // instant is right to second order: the residual falls by more than 2.5 when the step is halved (mean over where in
  // its vibration the pair is lost).
  double mean[2] = {0.0, 0.0};
  for (const int halved : {0, 1}) {
    for (int phase = 0; phase < 16; ++phase) {
      dem2d::World world = small_worlds::chain(2);
      world.domain = {-1.0, -1.0, (2.05 + 0.01 * phase) * radius, 1.0};
      world.discs.velocity_x = {19.0, 21.0};
      start(world, halved != 0 ? 0.05 : 0.1);
      const dem2d::Energies first = run(world, 1);
      while (world.removed_discs == 0) run(world, 1);
      const dem2d::Energies last = run(world, 1);
      ASSERT_EQ(world.removed_discs, 1);
      const double vibration = world.discs.mass[0];  // 2 m v^2 / 2 with v = 1 m/s [J/m]
      mean[halved] += std::fabs(dem2d::energy_residual(first, last)) / vibration / 16.0;
    }
  }
  EXPECT_LT(mean[0], 0.01);
  EXPECT_LT(mean[1], mean[0] / 2.5);
}

TEST(Energy, AJointThatEndsBooksItsLastHalfStepAlsoWhenAnotherDiscIsLost) {
  // Two joined pairs: the first loses a disc; the second is broken, pressed and has slid past its end, at the same
  // instant. As kn 2R = E = kn of the contact that takes over, both hold the same energy, and what is left is half a
  // step's work of the joint's last force, E u on each disc, which part with 3 m/s.
  dem2d::World world = small_worlds::empty();
  for (const double x : {0.0, 2.0, 8.0, 10.0}) dem2d::add_disc(world.discs, x * radius, 0.0, radius, 2500.0);
  dem2d::add_joint(world, 0, 1, small_worlds::properties());
  dem2d::add_joint(world, 2, 3, small_worlds::properties());
  start(world, 1.0);
  world.step = 1e-8;
  const double overlap = 2e-6;
  world.discs.x[1] -= 3.0 * overlap;  // another force in the first pair
  world.discs.x[3] -= overlap;
  world.discs.velocity_x = {0.0, 0.0, -1.0, 2.0};
  world.joints.bonded[1] = 0;
  std::fill_n(&world.joints.state[4], 4, dem2d::ElementState::broken_in_tension);
  dem2d::find_forces(world);
  world.joints.shear_displacement[1] = 2.1 * radius;
  world.discs.y[0] = world.domain.y_high + 1.0;
  world.lists.valid = false;
  dem2d::refresh_neighbours(world);
  ASSERT_EQ(world.joints.count(), 0);
  const double half_step = 0.5 * world.step * modulus * overlap * 3.0;
  EXPECT_NEAR(world.ledger.accounts.injected, -half_step, 1e-6 * half_step);
}

/// What the scheme swallows when a spring closes, averaged over where in the step it closes.
template <class MakeWorld>
double mean_switching(const MakeWorld& make, double speed, double dt, int steps) {
  double sum = 0.0;
  const int phases = 64;
  for (int phase = 0; phase < phases; ++phase) {
    dem2d::World world = make((1.0 + (phase + 0.5) / phases) * speed * dt);
    world.ledger.measured = true;
    dem2d::prepare(world);
    world.step = dt;
    sum += run(world, steps).switching / phases;
  }
  return sum;
}

TEST(Energy, AClosingSpringSwallowsATwelfthOfKTimesItsStepSquared) {
  // k (v dt)^2 / 12, for a disc on a wall and for the unbonded face of a flat joint; both steps, so its order is seen
  const double speed = 1.0;
  const auto on_wall = [&](double gap) {
    dem2d::World world = small_worlds::disc_above_floor(gap);
    world.discs.velocity_y[0] = -speed;
    return world;
  };
  const auto slit = [&](double gap) {
    dem2d::World world = small_worlds::empty();
    for (const double x : {0.0, 2.0 * radius}) dem2d::add_disc(world.discs, x, 0.0, radius, 2500.0);
    dem2d::JointProperties properties = small_worlds::properties();
    properties.type = dem2d::JointType::gapped;
    properties.initial_gap = gap;
    dem2d::add_joint(world, 0, 1, properties);
    world.discs.velocity_x = {0.5 * speed, -0.5 * speed};
    return world;
  };
  for (const double dt : {2e-9, 1e-9}) {
    const double wall = 2.0 * modulus * speed * speed * dt * dt / 12.0, face = 0.5 * wall;  // kn = 2 E, kn 2R = E
    // a spring slows the disc by k u dt / m within the few steps looked at: a thousandth at most
    EXPECT_NEAR(mean_switching(on_wall, speed, dt, 5), wall, 3e-3 * wall);
    EXPECT_NEAR(mean_switching(slit, speed, dt, 5), face, 3e-3 * face);
  }
}

TEST(Energy, TheResidualIsWhatIsGivenAndNotFound) {
  using dem2d::Energies;
  EXPECT_EQ(dem2d::energy_residual({}, {.boundary_work = 8.0}), 8.0);
  for (double Energies::*found :
       {&Energies::kinetic, &Energies::strain_joints, &Energies::strain_contacts, &Energies::strain_boundaries,
        &Energies::friction, &Energies::dashpots, &Energies::local_damping, &Energies::breaking, &Energies::switching,
        &Energies::removed}) {
    Energies start, now{.boundary_work = 8.0};
    start.*found = 1.0;
    now.*found = 3.0;
    EXPECT_EQ(dem2d::energy_residual(start, now), 6.0);
    EXPECT_EQ(dem2d::energy_residual_fraction(start, now), 0.75);
  }
  Energies fed{.boundary_work = 8.0};
  fed.injected = 1.0;
  EXPECT_EQ(dem2d::energy_residual({}, fed), 9.0);
  EXPECT_EQ(dem2d::energy_residual_fraction({}, {}), 0.0);
}

void expect_a_closed_ledger_of_a_cut(double softening) {
  dem2d::CutCase cut = dem2d::read_cut_case(std::string(BITROCK_SOURCE_DIR) + "/campaigns/cuts/example.toml");
  cut.rock.tension_softening = softening;
  cut.cutter_speed = 2.0;
  cut.cut_length = 20e-3;
  cut.bed_length = 36e-3;
  cut.bed_height = 14e-3;
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 2, 1);
  const dem2d::CutRun measured = dem2d::run_cut(cut, bed);
  const dem2d::Energies& e = measured.energies.back();
  EXPECT_LT(std::fabs(measured.energy_residual_fraction), 1e-3);
  EXPECT_LT(std::fabs(e.switching), 5e-3 * e.boundary_work) << "the step is short enough for the contacts";
  EXPECT_GT(e.friction, 0.1 * e.boundary_work);
  EXPECT_GT(e.breaking, 0.02 * e.boundary_work);
  // the same force history, and the same ledger, however one looks at it
  const dem2d::CutRun blind = dem2d::run_cut(cut, bed, {.measure_energy = false}),
                      threads = dem2d::run_cut(cut, bed, {.threads = 2});
  EXPECT_EQ(blind.force_x, measured.force_x);
  EXPECT_EQ(blind.force_y, measured.force_y);
  EXPECT_TRUE(blind.energies.empty());
  EXPECT_EQ(threads.energies.back().friction, e.friction);
  EXPECT_EQ(threads.energies.back().local_damping, e.local_damping);
  EXPECT_EQ(threads.energies.back().breaking, e.breaking);
  EXPECT_EQ(threads.energy_residual_fraction, measured.energy_residual_fraction);
}

TEST(Energy, ACutOfTwentyMillimetresClosesItsLedgerToATenthOfAPercent) {
  expect_a_closed_ledger_of_a_cut(0.0);
}

TEST(Energy, SoDoesOneInRockThatSoftens) {
  expect_a_closed_ledger_of_a_cut(3.0);
}

}  // namespace
