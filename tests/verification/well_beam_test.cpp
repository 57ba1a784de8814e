// A chain of rigid segments as a beam, against closed forms. Where the chain itself has a closed form, that is the
// expected number; where only the beam has one, the chain must go to it as its segments become shorter.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double pi = std::numbers::pi;

/// Clamped at the origin, along north, at rest and without load.
WellStringState clamped(WellString& string) {
  string.upper_end = UpperEnd::clamped;
  return unloaded(string, {}, no_rotation);
}

TEST(WellBeam, CantileverUnderASmallForce) {
  // P L^3 / 3EI (1 + 1/(2N^2)), by summing the chain; stretch and shear are made stiff
  for (const int n : {1, 2, 4, 8, 16}) {
    WellString string{.sections = {bare(1e8, n)}};
    WellStringState state = clamped(string);
    string.tip_force = {0.0, 1e-4, 0.0};
    EXPECT_LT(come_to_rest(string, state, 60, 1e-12), 1e-6);
    // the shear that is left: 3 EI / (kGA L^2) = 3e-8
    EXPECT_NEAR(lower_end_of(state.columns, 0).y / (1e-4 / 3.0), 1.0 + 0.5 / (n * n), 2e-7) << n;
  }
}

TEST(WellBeam, AMomentRollsItUp) {
  // M = 2 pi EI / L closes the chain to a polygon of height L / (N sin(pi / N)) on its corners
  for (const int n : {10, 20}) {
    WellString string{.sections = {bare(1e6, n)}};
    WellStringState state = clamped(string);
    for (int part = 1; part <= 20; ++part) {
      string.tip_moment = {0.0, 0.0, 2.0 * pi * part / 20.0};
      come_to_rest(string, state, 40, 1e-9);
    }
    EXPECT_LT(come_to_rest(string, state, 40, 1e-9), 1e-8);
    EXPECT_LT(length(lower_end_of(state.columns, 0)), 1e-9);
    double height = 0.0;
    for (std::size_t i = 0; i < state.count; ++i) height = std::max(height, lower_end_of(state.columns, i).y);
    EXPECT_NEAR(height, n == 10 ? .32361 : .31962, 5e-6);
    EXPECT_NEAR(height, 1.0 / (n * std::sin(pi / n)), 1e-9);
  }
}

TEST(WellBeam, ElasticaUnderATipForce) {
  // (L - u, w) / L and theta for a = P L^2 / EI; of the continuous elastica [BisshoppDrucker1945], and of the chain in
  // N segments from the energy minimum of a planar chain, both computed apart from this program
  const struct {
    double a;
    int n;
    double u, w, theta, tolerance;
  } cases[] = {{2, 5, .16368, .50206, .77942, 6e-6},
               {2, 10, .16139, .49561, .78116, 6e-6},
               {2, 20, .16083, .49400, .78160, 6e-6},
               {10, 10, .55695, .81510, 1.42847, 6e-6},
               {10, 20, .55547, .81173, 1.42983, 6e-6}};
  for (const auto& c : cases) {
    WellString string{.sections = {bare(1e8, c.n)}};
    WellStringState state = clamped(string);
    for (int part = 1; part <= 10; ++part) {
      string.tip_force = {0.0, 0.1 * part * c.a, 0.0};
      come_to_rest(string, state, 60, 1e-7);
    }
    const Vector3 tip = lower_end_of(state.columns, 0), d = vector_at(state.columns, direction, 0);
    EXPECT_NEAR(1.0 - tip.x, c.u, c.tolerance) << c.a << " " << c.n;
    EXPECT_NEAR(tip.y, c.w, c.tolerance) << c.a << " " << c.n;
    EXPECT_NEAR(std::atan2(d.y, d.x), c.theta, c.tolerance) << c.a << " " << c.n;
  }
}

/// One eighth of a circle of radius 100 in its unloaded form, of n chords, with a force of 600 across its plane at the
/// tip; beam 1 x 1, E 1e7, nu 0.
Vector3 tip_of_bend(int n) {
  const double angle = pi / 4.0 / n, chord = 200.0 * std::sin(0.5 * angle);
  StringSection pipe{.beam = {.axial = 1e7,
                              .shear = 1e7 / 2.0 * 5.0 / 6.0,
                              .torsion = 8.3333e5,
                              .bending = 8.3333e5,
                              .mass = 1.0,
                              .polar_inertia = 1.0,
                              .transverse_inertia = 1.0},
                     .length = n * chord,
                     .segments = n,
                     .bend = {0.0, 0.0, angle / chord}};
  WellString string{.sections = {pipe}, .upper_end = UpperEnd::clamped};
  WellStringState state = unloaded(string, {}, no_rotation);
  for (int part = 1; part <= 6; ++part) {
    string.tip_force = {0.0, 0.0, 100.0 * part};
    come_to_rest(string, state, 60, 1e-6);
  }
  return lower_end_of(state.columns, 0);
}

TEST(WellBeam, FortyFiveDegreeBend) {
  // tip from (70.711, 29.289, 0) to what the differential equation of the rod gives, integrated apart from this program
  const Vector3 exact{47.150, 15.685, 53.475};
  const Vector3 eight = tip_of_bend(8), sixteen = tip_of_bend(16);
  EXPECT_NEAR(length(eight - exact) / length(sixteen - exact), 4.0, 0.1);  // second order
  const Vector3 limit = (1.0 / 3.0) * (4.0 * sixteen - eight);
  EXPECT_NEAR(limit.x, exact.x, 2e-3);
  EXPECT_NEAR(limit.y, exact.y, 2e-3);
  EXPECT_NEAR(limit.z, exact.z, 2e-3);
  // published displacements of other programs: -23.5, 53.4 and -13.4 [BatheBolourchi1979]
  EXPECT_NEAR(limit.x - 70.711, -23.5, 0.15);
  EXPECT_NEAR(limit.z, 53.4, 0.15);
  EXPECT_NEAR(limit.y - 29.289, -13.5, 0.15);
}

TEST(WellBeam, AJointIsTheGradientOfItsEnergy) {
  // one joint at a large angle and a large gap, moved a little: the energy changes by the work of its loads
  JointSide<double> a, b;
  a.frame = normalised(Rotation{0.9, 0.2, -0.3, 0.1});
  b.frame = normalised(a.frame * rotation_by_twice(Vector3{0.35, 0.3, -0.2}));
  a.end = {0.1, 0.2, 0.3};
  a.arm = {1.0, -0.5, 0.7};
  b.end = {0.3, 0.1, 0.6};
  b.arm = {-0.4, 0.3, -1.1};
  const JointSprings<double> k{.axial = 3.0, .shear = 2.0, .torsion = 1.3, .bending = 0.7, .bend = {0.02, -0.1, 0.05}};
  const JointLoad<double> load = joint_load(a, b, k);
  EXPECT_GT(length(load.force), 0.5);
  const auto energy_after = [&](const Vector3& move_a, const Vector3& turn_a, const Vector3& move_b,
                                const Vector3& turn_b) {
    JointSide<double> c = a, d = b;
    const Axes<double> by_a = axes_of(rotation_by_twice(0.5 * turn_a)), by_b = axes_of(rotation_by_twice(0.5 * turn_b));
    c.frame = rotation_by_twice(0.5 * turn_a) * a.frame;
    d.frame = rotation_by_twice(0.5 * turn_b) * b.frame;
    c.end = a.end + move_a + to_world(by_a, a.arm) - a.arm;
    d.end = b.end + move_b + to_world(by_b, b.arm) - b.arm;
    return joint_load(c, d, k).energy;
  };
  const double step = 1e-5;
  const Vector3 units[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, zero{};
  for (const Vector3& e : units) {
    const auto slope = [&](int which) {
      Vector3 moves[4];
      const auto at = [&](double s) {
        for (Vector3& m : moves) m = zero;
        moves[which] = s * e;
        return energy_after(moves[0], moves[1], moves[2], moves[3]);
      };
      return (at(step) - at(-step)) / (2.0 * step);
    };
    EXPECT_NEAR(-slope(0), dot(load.force, e), 1e-9);
    EXPECT_NEAR(-slope(1), dot(load.torque_above, e), 1e-9);
    EXPECT_NEAR(-slope(2), -dot(load.force, e), 1e-9);
    EXPECT_NEAR(-slope(3), dot(load.torque_below, e), 1e-9);
  }
}

TEST(WellBeam, TheMeasureOfAngleIsRightUpToHalfATurn) {
  // torque 1 N m/rad times the angle, about each axis; and four joints side by side get the same bits
  JointSide<double> a, b;
  a.frame = no_rotation;
  const JointSprings<double> k{.torsion = 1.0, .bending = 1.0};
  for (const double angle : {1e-9, 1e-4, 0.0582, 0.5, 1.0, 2.0, 3.0, 3.14}) {
    for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 0.6, -0.8}, unit(Vector3{1, 2, 3})}) {
      b.frame = Rotation{std::cos(0.5 * angle), std::sin(0.5 * angle) * axis.x, std::sin(0.5 * angle) * axis.y,
                         std::sin(0.5 * angle) * axis.z};
      const JointLoad<double> load = joint_load(a, b, k);
      EXPECT_NEAR(dot(load.section_moment, axis), angle, 2e-15 * (1.0 + 1.0 / (3.1416 - angle)));
      EXPECT_NEAR(length(load.torque_above - angle * axis), 0.0, 1e-14 * (1.0 + 1.0 / (3.1416 - angle)));
    }
  }
}

}  // namespace
