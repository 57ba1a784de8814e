// The well of the article's section 4.2 at rest, tripped in, pulled out and turned, against columns that know no bars:
// the weight over the true vertical depth, the soft string, and a stiff string of beams 0.25 m long that was computed
// apart from this program. 200 m of collars below drill pipe, in air, bit off bottom.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/signal/step5.hpp"
#include "runtime/well/stress.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double h = 5e-4, horizontal = 90.0 * degree;

WellString string_to(double depth, double friction) {
  return {.sections = {section(drill_pipe(), depth - 200.0, static_cast<int>(std::lround((depth - 200.0) / 10.0))),
                       section(drill_collar(), 200.0, 20)},
          .hole = quarter_hole(friction),
          .upper_end = UpperEnd::table,
          .guided = true};
}

WellStringState at_rest(const WellString& string) {
  WellStringState state = hung_in_hole(string);
  relax(string, state, h);
  advance(string, state, {}, nothing, h);
  return state;
}

/// True vertical depth of the bit where the article's well has it.
double vertical_depth(double depth) {
  const double radius = 270.0 / (90.0 * degree);
  if (depth <= 1205.0) return depth;
  return 1205.0 + radius * std::sin(std::min(depth - 1205.0, 270.0) / radius);
}

const double pipe_weight = gravity * beam_of(drill_pipe()).mass, collar_weight = gravity * beam_of(drill_collar()).mass;

/// The weight over the vertical depth of the string from the table to the bit [N]: what a frictionless hook carries.
double weight_over_depth(double bit) {
  const double change = bit - 200.0;
  return pipe_weight * vertical_depth(change) + collar_weight * (vertical_depth(bit) - vertical_depth(change));
}

/// **What** Tension at the table of a string that does not bend, pulled (direction 1) or lowered (-1).
/// **Equation** dT/ds = w cos I + direction mu |w sin I - T / R|, from the bit up; 5 mm pieces, mid-point rule.
double soft_hook(double bit, double mu, double direction) {
  const double radius = 270.0 / horizontal, piece = 5e-3;
  double tension = 0.0;
  for (double depth = bit; depth > 0.0; depth -= piece) {
    const double middle = depth - 0.5 * piece;
    const double inclination = std::min(std::max(0.0, (middle - 1205.0) / radius), horizontal);
    const double w = middle > bit - 200.0 ? collar_weight : pipe_weight;
    const double curvature = middle > 1205.0 && middle < 1475.0 ? 1.0 / radius : 0.0;
    const auto slope = [&](double t) {
      return w * std::cos(inclination) + direction * mu * std::abs(w * std::sin(inclination) - t * curvature);
    };
    tension += piece * slope(tension + 0.5 * piece * slope(tension));
  }
  return tension;
}

TEST(WellDepths, TheFrictionlessHookCarriesTheWeightOverTheVerticalDepth) {
  // kN at 1200 ... 1500 m; the bit hangs lower by the stretch, 1.18 kN a metre
  const struct {
    double bit, hook;
  } rows[] = {{1200, 530.06}, {1250, 542.47}, {1300, 549.88}, {1350, 547.13},
              {1400, 529.92}, {1450, 495.72}, {1500, 448.84}};
  for (const auto& row : rows) {
    EXPECT_NEAR(weight_over_depth(row.bit) / 1e3, row.hook, 6e-3);
    const WellString string = string_to(row.bit, 0.0);
    const WellStringState state = at_rest(string);
    // by virtual work on a string that is as heavy as before, but stretched down by so much; and a string that bends
    // where it enters the build, and straightens where it leaves, takes E I / 2R^2
    const double stretch = state.bit.depth - row.bit;
    const double collar_bends = row.bit > 1205.0 && row.bit < 1405.0 ? 1.0 : 0.0,
                 pipe_bends = row.bit > 1405.0 ? 1.0 : 0.0;
    const double collar_straightens = row.bit > 1475.0 ? 1.0 : 0.0;
    const double expected = weight_over_depth(state.bit.depth) - pipe_weight * stretch - 119.1 * collar_bends -
                            20.1 * pipe_bends + 119.1 * collar_straightens;
    // 1e-4 but at 1500 m, where the energy of a joint that passes the end of the build comes in steps of 10 m
    EXPECT_NEAR(state.top.hook_load, expected, (row.bit < 1500.0 ? 1e-4 : 4e-4) * expected)
        << row.bit << " bit at " << state.bit.depth;
    EXPECT_LT(state.bit.depth - row.bit, 0.8);
    EXPECT_GT(state.bit.depth - row.bit, -0.2);
  }
}

TEST(WellDepths, WallForcesAndMomentsAtRest) {
  // beams of 0.25 m: sum of the wall 245.5 kN, largest moment 45.02 kN m where pipe and collars meet; bars of 10 m
  // 245.4 and 43.45. Inside the arcs E I / R: 6.911 and 40.95 kN m
  const WellString string = string_to(1500.0, 0.0);
  const WellStringState state = at_rest(string);
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    sum += state.columns.at(wall_force, i);
    const Vector3 m = joint_now(state.columns, i).section_moment;
    largest = std::max(largest, std::hypot(m.y, m.z));
  }
  EXPECT_NEAR((sum + state.bit.side_force) / 1e3, 245.4, 0.6);
  EXPECT_NEAR(largest / 1e3, 43.45, 0.3);
  const auto moment = [&](std::size_t i) {
    const Vector3 m = joint_now(state.columns, i).section_moment;
    return std::hypot(m.y, m.z);
  };
  EXPECT_NEAR(moment(24) / 1e3, 6.911, 0.007);
  EXPECT_NEAR(moment(10) / 1e3, 40.95, 0.04);
  // wall forces below the kick-off, the same chain computed apart from this program, kN
  const double pushed[] = {.63, 7.24, 7.32, 6.95, 6.65, 6.35, 6.06, 5.78, 5.53, 4.37, 0.0, 0.0, 2.29, 4.73, 5.61, 6.68};
  for (std::size_t k = 0; k < std::size(pushed); ++k)
    EXPECT_NEAR(state.columns.at(wall_force, 29 - k) / 1e3, pushed[k], 0.02) << k;
}

TEST(WellDepths, WhereTheStringHangsFreeOfTheWall) {
  // where pipe and collars meet, and at the end of the build: a stiff column lies free from 1290 to 1302, 1303 to 1319
  // and 1468 to 1475 m. Of the joints below the kick-off those at some 1300 and 1310 m do, and no other
  const WellString string = string_to(1500.0, 0.0);
  const WellStringState state = at_rest(string);
  std::vector<double> free;
  for (std::size_t i = state.count - 1; i-- > 0;) {
    const Vector3 middle = 0.5 * (lower_end_of(state.columns, i + 1) + upper_end_of(state.columns, i));
    const WellFoot foot = foot_on(string.hole[static_cast<std::size_t>(state.columns.at(piece, i))].arc, middle);
    if (foot.measured_depth < 1206.0 || state.columns.at(wall_force, i) > 0.0) continue;
    free.push_back(foot.measured_depth);
    EXPECT_LT(length(foot.offset), state.columns.at(clearance, i));
  }
  ASSERT_EQ(free.size(), 2u);
  for (const double depth : free) EXPECT_TRUE((depth > 1290.0 && depth < 1302.0) || (depth > 1303.0 && depth < 1319.0));
}

TEST(WellDepths, EightFibresShareTheTension) {
  // bending pulls one side as much as it pushes the other, wherever the string is bent
  const WellString string = string_to(1500.0, 0.0);
  const WellStringState state = at_rest(string);
  for (const double above_bit : {20.0, 120.0, 235.0, 900.0}) {
    double sum = 0.0, axial = 0.0;
    for (int k = 0; k < 8; ++k) {
      const Stress stress = stress_at(string, state,
                                      {.name = {},
                                       .above_bit = above_bit,
                                       .angle = 45.0 * degree * k,
                                       .outer_diameter = 0.127,
                                       .inner_diameter = 0.10861},
                                      0.0);
      sum += stress.normal;
      axial = stress.axial;
    }
    EXPECT_NEAR(sum, 8.0 * axial, 1.0) << above_bit;
  }
}

/// Means of a run after it has come to a steady speed.
struct Steady {
  double hook = 0.0, bit = 0.0, wall_torque = 0.0, drive_torque = 0.0;
};

Steady run(const WellString& string, const RigControls& full, double from, double to) {
  WellStringState state = hung_in_hole(string);
  relax(string, state, h);
  const double initial = stored_energy(string, state, h).total();
  Steady mean;
  double samples = 0.0;
  while (state.time < to) {
    const double part = step5(state.time, 0.0, 0.0, 4.0, 1.0);
    advance(string, state, {.feed_speed = part * full.feed_speed, .drive_speed = part * full.drive_speed}, nothing, h);
    if (state.time < from) continue;
    samples += 1.0;
    mean.hook += state.top.hook_load;
    mean.bit += state.bit.depth;
    mean.drive_torque += state.top.drive_torque;
    mean.wall_torque += state.bit.gauge_torque;
    for (std::size_t i = 0; i + 1 < state.count; ++i)
      mean.wall_torque -= state.columns.at(contact_radius, i) * state.columns.at(friction_around, i);
  }
  for (double Steady::*value : {&Steady::hook, &Steady::bit, &Steady::drive_torque, &Steady::wall_torque})
    mean.*value /= samples;
  // the ledger, in which new pipe and hoist, friction and dampers all take part
  EXPECT_LT(std::abs(energy_residual(string, state, initial, h)), 1e-3 * friction_work_of(state));
  return mean;
}

TEST(WellDepths, HookLoadsOfATrip) {
  // soft string at 1300, 1400, 1500 m: run in 541.62, 498.92, 385.07 kN, pulled out 558.48, 562.18, 511.66 kN
  const struct {
    double bit, in, out;
  } rows[] = {{1300, 541.62, 558.48}, {1400, 498.92, 562.18}, {1500, 385.07, 511.66}};
  for (const auto& row : rows) {
    EXPECT_NEAR(soft_hook(row.bit, 0.25, -1.0) / 1e3, row.in, 0.02);
    EXPECT_NEAR(soft_hook(row.bit, 0.25, 1.0) / 1e3, row.out, 0.02);
    WellString string = string_to(row.bit, 0.25);
    string.longest_grown = 10.0;
    string.gauge_radius = 0.0825;
    // two periods of the first axial mode, 1.7 s, at a steady speed
    const Steady in = run(string, {.feed_speed = 0.1}, 12.0, 22.0), out = run(string, {.feed_speed = -0.1}, 12.0, 22.0);
    EXPECT_NEAR(in.hook / soft_hook(in.bit, 0.25, -1.0), 1.0, 5e-3) << row.bit;
    EXPECT_NEAR(out.hook / soft_hook(out.bit, 0.25, 1.0), 1.0, 5e-3) << row.bit;
    if (row.bit < 1500.0) continue;
    // the stiff column at 1500 m, 386.1 and 511.2 kN, moved to where the bit is by the soft string
    const double stiff_in = 386.1e3 + soft_hook(in.bit, 0.25, -1.0) - soft_hook(1500.0, 0.25, -1.0);
    const double stiff_out = 511.2e3 + soft_hook(out.bit, 0.25, 1.0) - soft_hook(1500.0, 0.25, 1.0);
    EXPECT_NEAR(in.hook / stiff_in, 1.0, 2e-3);
    EXPECT_NEAR(out.hook / stiff_out, 1.0, 2e-3);
  }
}

TEST(WellDepths, TorqueOffBottom) {
  // 60 rpm, mu .25, bit at 1500 m: stiff column 4658 N m, soft string whose pipe climbs the wall 4751 N m
  WellString string = string_to(1500.0, 0.25);
  string.gauge_radius = 0.0825;
  const Steady mean = run(string, {.drive_speed = 60.0 * rpm}, 16.0, 30.5);  // five periods of the first torsional mode
  EXPECT_NEAR(mean.wall_torque, 4658.0, 0.01 * 4658.0);
  EXPECT_NEAR(mean.drive_torque, mean.wall_torque, 0.02 * mean.wall_torque);
  // turning takes the drag out of the hook load
  EXPECT_NEAR(mean.hook, weight_over_depth(mean.bit), 2e-3 * mean.hook);
}

TEST(WellDepths, BendingDampersBrakeAStringThatTurns) {
  // 2 U_b beta_b Omega, here without friction; U_b is what the bending springs hold
  WellString string = string_to(1500.0, 0.0);
  string.damping.bending = 1e-4;
  WellStringState state = hung_in_hole(string);
  relax(string, state, h);
  double bent = 0.0;
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    const Vector3 m = joint_now(state.columns, i).section_moment;
    bent += 0.5 * (m.y * m.y + m.z * m.z) / state.columns.at(bending_stiffness, i);
  }
  // 22 755 J if pipe and collars had the curvature of the hole everywhere; they do not where they change and at the
  // ends
  EXPECT_NEAR(bent, 22755.0, 0.04 * 22755.0);
  for (std::size_t i = 0; i < state.count; ++i) {
    const double inertia = 1.0 / (state.columns.at(inverse_inertia, i) + state.columns.at(inverse_inertia_along, i));
    set_vector(state.columns, momentum, i, (inertia * 60.0 * rpm) * vector_at(state.columns, direction, i));
    renew_derived(state.columns, state.columns.place_of(i));
  }
  double torque = 0.0, samples = 0.0;
  while (state.time < 20.3) {  // the last five periods of the first torsional mode
    advance(string, state, {.drive_speed = 60.0 * rpm}, nothing, h);
    if (state.time < 5.8) continue;
    torque += state.top.drive_torque;
    samples += 1.0;
  }
  EXPECT_NEAR(torque / samples, 2.0 * bent * 1e-4 * 60.0 * rpm, 0.02 * 28.6);
}

TEST(WellDepths, TurnedWellsAndMirroredOnesGiveTheSame) {
  // the path turned about the vertical, and mirrored with the drive reversed
  const auto hook_and_torque = [](double azimuth, double drive) {
    WellString string = string_to(1500.0, 0.25);
    string.sections[0].segments = 65;
    string.hole = quarter_hole(0.25, azimuth);
    WellStringState state = hung_in_hole(string);
    const double step = 4e-4;
    while (state.time < 2.0)
      advance(string, state, {.drive_speed = drive * step5(state.time, 0.0, 0.0, 2.0, 1.0)}, nothing, step);
    return std::pair{state.top.hook_load, state.top.drive_torque};
  };
  const auto north = hook_and_torque(0.0, 6.0), other = hook_and_torque(1.1, 6.0),
             mirrored = hook_and_torque(0.0, -6.0);
  EXPECT_NEAR(other.first / north.first, 1.0, 1e-9);
  EXPECT_NEAR(other.second / north.second, 1.0, 1e-9);
  EXPECT_NEAR(mirrored.first / north.first, 1.0, 1e-9);
  EXPECT_NEAR(mirrored.second / north.second, -1.0, 1e-9);
}

TEST(WellDepths, WithoutTurningAPlaneWellStaysPlane) {
  WellString string = string_to(1500.0, 0.25);
  string.longest_grown = 10.0;
  WellStringState state = hung_in_hole(string);
  while (state.time < 4.0) advance(string, state, {.feed_speed = 0.5}, nothing, h);
  for (std::size_t i = 0; i < state.count; ++i) {
    EXPECT_EQ(vector_at(state.columns, position, i).y, 0.0) << i;
    EXPECT_EQ(vector_at(state.columns, velocity, i).y, 0.0) << i;
  }
}

}  // namespace
