// What holds for any run of a string in a well: lengths, forces and energy in balance, the same bits however it is run.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/errors.hpp"
#include "runtime/signal/step5.hpp"
#include "runtime/well/saved_state.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double h = 5e-4;

/// 1000 m of drill pipe and 200 m of collars that hang in a vertical hole.
WellString hanging() {
  return {.sections = {section(drill_pipe(), 1000.0, 100), section(drill_collar(), 200.0, 20)},
          .hole = straight_hole(0.0, 3000.0, 0.2159, 0.25),
          .upper_end = UpperEnd::table,
          .guided = true};
}

double weight_of(const WellStringState& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.count; ++i) sum += state.columns.at(weight, i);
  return sum;
}

TEST(WellInvariants, AVerticalStringBeginsInBalance) {
  // stretch of 1000 m pipe and 200 m collars by their own weight, by hand: .59398 m
  WellStringState state = hung_in_hole(hanging());
  EXPECT_NEAR(state.bit.depth - 1200.0, .59398, 6e-6);
  const double start = lower_end_of(state.columns, 0).z;
  while (state.time < 2.0) advance(hanging(), state, {}, nothing, h);
  EXPECT_NEAR(lower_end_of(state.columns, 0).z, start, 1e-10);
  EXPECT_NEAR(state.top.hook_load, weight_of(state), 1e-9 * weight_of(state));
}

TEST(WellInvariants, FeedMakesTheStringLonger) {
  // 35 m in 36 s: as one growing segment, and splitting off a segment three times
  for (const Growth growth : {Growth::grow, Growth::split}) {
    WellString string = hanging();
    string.growth = growth;
    string.longest_grown = 40.0;
    WellStringState state = hung_in_hole(string);
    const double initial = stored_energy(string, state, h).total(), before = state.bit.depth;
    double jump = 0.0, last = state.top.hook_load, fed = 0.0, hook = 0.0, samples = 0.0;
    while (state.time < 38.0 + 5.0 * 1.464) {  // five periods of the first axial mode at rest
      const double up = step5(state.time, 0.0, 0.0, 2.0, 1.0), down = step5(state.time, 35.0, 1.0, 37.0, 0.0);
      const double speed = up * down;
      fed += speed * h;
      advance(string, state, {.feed_speed = speed}, nothing, h);
      if (state.time > 0.1) jump = std::max(jump, std::abs(state.top.hook_load - last));
      last = state.top.hook_load;
      if (state.time < 38.0) continue;
      hook += last;
      samples += 1.0;
    }
    EXPECT_NEAR(state.top.fed, fed, 1e-9);
    EXPECT_EQ(state.count, growth == Growth::grow ? 120u : 123u);
    double length_now = 0.0;
    for (std::size_t i = 0; i < state.count; ++i) length_now += 2.0 * state.columns.at(half_length, i);
    EXPECT_NEAR(length_now, 1200.0 + fed, 1e-9);
    EXPECT_NEAR(hook / samples, weight_of(state), 3e-3 * weight_of(state));
    // the bit is deeper by the feed and by the stretch of more weight
    EXPECT_NEAR(state.bit.depth - before, fed, 0.2);  // it still rings by 0.1 m
    EXPECT_LT(jump, 1e-3 * weight_of(state));
    // of the work of 500 kN over 35 m
    EXPECT_LT(std::abs(energy_residual(string, state, initial, h)), 2e-5 * weight_of(state) * fed);
  }
}

/// A bit on rock that a sine shakes, in the well of the article.
struct Drilling {
  WellString string;
  BitRockSource source =
      sinusoidal_excitation({.mean = 8e3, .deviation = 2e3}, {.mean = 900.0, .deviation = 200.0}, 5.0);
};

Drilling drilling() {
  Drilling it{.string = {.sections = {section(drill_pipe(), 1290.0, 129), section(drill_collar(), 200.0, 20)},
                         .hole = quarter_hole(0.25),
                         .upper_end = UpperEnd::table,
                         .longest_grown = 20.0,
                         .guided = true,
                         .on_rock = true}};
  it.string.bit.advance_law = AdvanceLaw::imposed;
  it.string.bit.imposed_advance = 4e-3;
  it.string.bit.friction.law = FrictionLaw::smooth;
  it.string.bit.friction_radius = 0.08;
  it.string.bit_mass = 65.0;
  it.string.bit_inertia = 0.3;
  return it;
}

RigControls controls_of(double time) {
  return {.feed_speed = 4e-3 + 0.05 * (step5(time, 0.0, 0.0, 2.0, 1.0) - step5(time, 8.0, 0.0, 10.0, 1.0)),
          .drive_speed = 60.0 * rpm * step5(time, 0.0, 0.0, 4.0, 1.0)};
}

TEST(WellInvariants, ASlackLineHoldsNothing) {
  // 60 m of collars are set down on rock, and fed 50 mm on: the rock bears all their weight and the hook nothing.
  // Pulled up again, it is the other way round
  WellString string{.sections = {section(drill_collar(), 60.0, 6)},
                    .hole = straight_hole(0.0, 300.0, 0.2159, 0.0),
                    .upper_end = UpperEnd::table,
                    .guided = true,
                    .on_rock = true};
  string.longest_grown = 20.0;
  string.bit.advance_law = AdvanceLaw::none;
  string.damping.axial = 5e-3;  // so that it settles soon
  WellStringState state = hung_in_hole(string);
  state.bit.face = state.bit.depth + 0.01;
  const double short_step = 1e-4, initial = stored_energy(string, state, short_step).total();
  const auto go_on = [&](double to, double speed) {
    double least = 1e9;
    while (state.time < to) {
      advance(string, state, {.feed_speed = speed}, nothing, short_step);
      least = std::min(least, state.top.hook_load);
    }
    return least;
  };
  const double weight = weight_of(state);
  EXPECT_EQ(go_on(3.0, 0.02), 0.0);
  EXPECT_EQ(go_on(8.0, 0.0), 0.0);
  EXPECT_EQ(state.top.hook_load, 0.0);
  EXPECT_NEAR(state.bit.weight_on_bit, weight, 1e-3 * weight);
  EXPECT_LT(std::abs(energy_residual(string, state, initial, short_step)), 1e-2 * weight * 0.06);
  go_on(12.0, -0.02);
  go_on(17.0, 0.0);
  EXPECT_EQ(state.bit.weight_on_bit, 0.0);
  EXPECT_NEAR(state.top.hook_load, weight, 2e-3 * weight);
}

TEST(WellInvariants, ADriveThatGivesWayKeepsTheLedger) {
  Drilling it = drilling();
  it.string.control = soft_torque(2900.0, 296.4, 2.0);
  WellStringState state = hung_in_hole(it.string);
  relax(it.string, state, h);
  state.bit.face = state.bit.depth + 0.05;
  const double initial = stored_energy(it.string, state, h).total();
  double turned = 0.0;
  while (state.time < 40.0) {
    const RigControls now = controls_of(state.time);
    advance(it.string, state, now, it.source, h);
    turned += h * now.drive_speed;
  }
  EXPECT_NEAR(state.top.set_angle, turned, 1e-9 * turned);
  EXPECT_NE(state.top.drive_speed, state.top.set_speed) << "it gives way";
  EXPECT_NEAR(state.top.drive_angle, turned, 5.0) << "and comes back";
  EXPECT_LT(std::abs(energy_residual(it.string, state, initial, h)), 1e-3 * friction_work_of(state));
}

TEST(WellInvariants, ForcesAndEnergyWhileDrillingAreInBalance) {
  const Drilling it = drilling();
  WellStringState state = hung_in_hole(it.string);
  relax(it.string, state, h);
  state.bit.face = state.bit.depth + 0.05;
  const double initial = stored_energy(it.string, state, h).total();
  double rock = 0.0, hook = 0.0, torque = 0.0, drive = 0.0, samples = 0.0;
  while (state.time < 60.0) {
    advance(it.string, state, controls_of(state.time), it.source, h);
    if (state.time < 40.0) continue;
    rock += state.bit.weight_on_bit + state.bit.source_force;
    hook += state.top.hook_load;
    torque += state.bit.friction_torque + state.bit.fracture_torque;
    for (std::size_t i = 0; i + 1 < state.count; ++i)
      torque -= state.columns.at(contact_radius, i) * state.columns.at(friction_around, i);
    drive += state.top.drive_torque;
    samples += 1.0;
  }
  EXPECT_GT(rock / samples, 2e4);
  EXPECT_GT(state.bit.progression, 200.0);
  EXPECT_NEAR(state.bit.rate_of_penetration, 4e-3, 1e-12);
  EXPECT_NEAR(drive / torque, 1.0, 0.02);
  EXPECT_LT(std::abs(energy_residual(it.string, state, initial, h)), 1e-3 * friction_work_of(state));
  require_sound(it.string, state);
}

/// Bytes of the state after a run.
std::vector<std::byte> bytes_of(const WellStringState& state) {
  std::vector<std::byte> bytes(state_size(state));
  save(state, bytes);
  return bytes;
}

void drill(const Drilling& it, WellStringState& state, double to) {
  while (state.time < to - 0.5 * h) advance(it.string, state, controls_of(state.time), it.source, h);
}

TEST(WellInvariants, TheSameBitsForAnyVectorsAndAfterSaving) {
  Drilling it = drilling();
  WellStringState first = hung_in_hole(it.string);
  WellStringState plain = first, saved = first;
  drill(it, first, 3.0);
  it.string.plain_vectors = true;
  drill(it, plain, 3.0);
  EXPECT_EQ(bytes_of(first), bytes_of(plain));
  it.string.plain_vectors = false;
  drill(it, saved, 1.3);
  const std::vector<std::byte> bytes = bytes_of(saved);
  WellStringState other = hung_in_hole(it.string);
  restore(other, bytes);
  drill(it, other, 3.0);
  EXPECT_EQ(bytes_of(other), bytes_of(first));
  EXPECT_THROW(restore(other, std::span(bytes).first(100)), base::InputError);
  std::vector<std::byte> damaged = bytes;
  damaged[0] ^= std::byte{1};
  EXPECT_THROW(restore(other, damaged), base::InputError);
}

TEST(WellInvariants, HalfTheStepGivesTheSameString) {
  // mean hook load and torque over ten seconds of turning in the article's well
  WellString string{.sections = {section(drill_pipe(), 1290.0, 129), section(drill_collar(), 200.0, 20)},
                    .hole = quarter_hole(0.25),
                    .upper_end = UpperEnd::table,
                    .guided = true};
  double hook[2], torque[2];
  for (const int part : {0, 1}) {
    const double step = part == 0 ? h : 0.5 * h;
    WellStringState state = hung_in_hole(string);
    relax(string, state, step);
    double samples = 0.0;
    hook[part] = torque[part] = 0.0;
    while (state.time < 16.0) {
      advance(string, state, {.drive_speed = 60.0 * rpm * step5(state.time, 0.0, 0.0, 4.0, 1.0)}, nothing, step);
      if (state.time < 6.0) continue;
      hook[part] += state.top.hook_load;
      torque[part] += state.top.drive_torque;
      samples += 1.0;
    }
    hook[part] /= samples;
    torque[part] /= samples;
  }
  EXPECT_NEAR(hook[0] / hook[1], 1.0, 2e-3);
  EXPECT_NEAR(torque[0] / torque[1], 1.0, 2e-3);
}

TEST(WellInvariants, TheLongestStepIsStableAndMuchLongerOnesAreNot) {
  const WellString string{.sections = {section(drill_pipe(), 1290.0, 129), section(drill_collar(), 200.0, 20)},
                          .hole = quarter_hole(0.25),
                          .upper_end = UpperEnd::table,
                          .guided = true};
  const double limit = longest_stable_step(string);
  EXPECT_GT(limit, 1.2e-3);
  EXPECT_LT(limit, 1.9e-3);  // axial alone: 2 / (1009 rad/s), less its damping
  WellStringState good = hung_in_hole(string), bad = good;
  for (int k = 0; k < 20000; ++k) advance(string, good, {.drive_speed = 6.0}, nothing, 0.95 * limit);
  require_sound(string, good);
  EXPECT_LT(stored_energy(string, good, limit).kinetic, 1e5);
  EXPECT_THROW(
      {
        for (int k = 0; k < 20000; ++k) advance(string, bad, {.drive_speed = 6.0}, nothing, 1.7 * limit);
        require_sound(string, bad);
      },
      base::SimulationError);
}

/// Whether drill pipe on the low side of a horizontal hole, pushed from its end, leaves its straight line within 20 s.
bool buckles(double push, int segments) {
  StringSection pipe = section(drill_pipe(), 120.0, segments);
  pipe.drag_across = 5.0;
  // a free end would buckle by itself at half the load: it is heavy and stiff here
  StringSection end = section(drill_pipe(), 20.0, segments / 6);
  end.weight *= 20.0;
  end.beam.mass *= 20.0;
  end.beam.bending *= 1e4;
  WellString string{.sections = {pipe, end},
                    .hole = straight_hole(90.0 * degree, 200.0, 0.2159, 0.0),
                    .upper_end = UpperEnd::clamped};
  const double room = string.hole[0].radius - pipe.contact_radius;
  WellStringState state = unloaded(string, {1.0, 0.0, room}, rotation_to({1.0, 0.0, 0.0}));
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    renew_piece(string, state.columns, i);
    Vector3 x = vector_at(state.columns, position, i);
    x.y = 1e-6 * std::sin(0.2653 * x.x) + 1e-6 * std::sin(0.31 * x.x);
    set_vector(state.columns, position, i, x);
  }
  const double step = 0.6 * longest_stable_step(string);
  while (state.time < 20.0) {
    string.tip_force = {-push * step5(state.time, 0.0, 0.0, 4.0, 1.0), 0.0, 0.0};
    advance(string, state, {}, nothing, step);
  }
  double most = 0.0;  // away from the ends
  for (std::size_t i = state.count / 4; i < 3 * state.count / 4; ++i)
    most = std::max(most, std::abs(vector_at(state.columns, position, i).y));
  return most > 1e-4;
}

TEST(WellInvariants, PipeInAHorizontalHoleBucklesAtItsLoad) {
  // 2 sqrt(E I w / r) = 167.4 kN in air [DawsonPaslay1984]: joints 2.5 m apart are near enough, below 2 (E I r /
  // w)^(1/4) = 7.5 m
  EXPECT_FALSE(buckles(160e3, 48));
  EXPECT_TRUE(buckles(176e3, 48));
}

TEST(WellInvariants, RefusesWhatIsNoString) {
  const auto refused = [](const auto& change) {
    WellString string = hanging();
    change(string);
    EXPECT_THROW(hung_in_hole(string), base::InputError);
  };
  refused([](WellString& s) { s.sections.clear(); });
  refused([](WellString& s) { s.sections[0].segments = 0; });
  refused([](WellString& s) { s.sections[0].length = std::nan(""); });
  refused([](WellString& s) { s.sections[1].beam.bending = 0.0; });
  refused([](WellString& s) { s.sections[1].contact_radius = 0.2; });
  refused([](WellString& s) { s.sections[1].drag_along = -1.0; });
  refused([](WellString& s) { s.hole.clear(); });
  refused([](WellString& s) { s.wall.stiffness = 0.0; });
  refused([](WellString& s) { s.longest_grown = -1.0; });
  refused([](WellString& s) {
    s.upper_end = UpperEnd::clamped;
    s.longest_grown = 1.0;
  });
  // a bar of 10 m in a bend of radius 4 m
  refused([](WellString& s) {
    s.hole = hole_pieces(well_path({{0, 0, 0}, {1000, 0, 0}, {1006, 1.5, 0}}), {{2000, 0.2159, 0.2}});
  });
}

}  // namespace
