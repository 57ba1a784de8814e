// A string against the wall of its hole: rest, sliding, turning.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double horizontal = 90.0 * degree;

/// Free at both ends, on the low side of a horizontal hole of 8.5 in, at rest.
WellString lying(const PipeSection& pipe, int segments, double friction) {
  return {.sections = {section(pipe, 10.0 * segments, segments)},
          .hole = straight_hole(horizontal, 20.0 * segments, 0.2159, friction)};
}

WellStringState at_rest(const WellString& string, double h) {
  const double room = string.hole[0].radius - string.sections[0].contact_radius;
  WellStringState state = unloaded(string, {2.0, 0.0, room}, rotation_to(string.hole[0].arc.tangent));
  for (std::size_t i = 0; i + 1 < state.count; ++i) renew_piece(string, state.columns, i);
  relax(string, state, h);
  return state;
}

double total(const WellStringState& state, Column column) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < state.count; ++i) sum += state.columns.at(column, i);
  return sum;
}

/// A collar along a straight hole, against its wall at `room` [m] off the middle, that spins and goes round [rad/s].
WellStringState rolling_collar(const WellString& string, double room, double spin, double rolling) {
  WellStringState state = unloaded(string, {room, 0.0, 5.0}, rotation_to({0.0, 0.0, 1.0}));
  for (std::size_t i = 0; i < state.count; ++i) {
    if (i + 1 < state.count) renew_piece(string, state.columns, i);
    const double inertia = 1.0 / (state.columns.at(inverse_inertia, i) + state.columns.at(inverse_inertia_along, i));
    set_vector(state.columns, momentum, i, (inertia * spin) * vector_at(state.columns, direction, i));
    set_vector(state.columns, velocity, i, {0.0, rolling * room, 0.0});
    renew_derived(state.columns, state.columns.place_of(i));
  }
  return state;
}

TEST(WellContact, TheWallCarriesTheWeight) {
  const WellString string = lying(drill_pipe(), 12, 0.25);
  WellStringState state = at_rest(string, 5e-4);
  advance(string, state, {}, nothing, 5e-4);
  EXPECT_NEAR(total(state, wall_force), 120.0 * string.sections[0].weight, 1e-4 * 120.0 * string.sections[0].weight);
}

TEST(WellContact, ASliderStopsWhereCoulombSaysAndStays) {
  // 1 m/s, mu .25: at rest after v / (mu g) = .4077 s and v^2 / (2 mu g) = .2039 m; then exactly still
  const double h = 5e-4;
  WellString string = lying(drill_pipe(), 12, 0.25);
  string.sections[0].drag_across = 100.0;  // so that the free ends do not swing for long
  WellStringState state = at_rest(string, h);
  for (std::size_t i = 0; i < state.count; ++i) set_vector(state.columns, velocity, i, {1.0, 0.0, 0.0});
  const double start = vector_at(state.columns, position, 6).x;
  double stopped = 0.0;
  while (state.time < 0.8) {
    advance(string, state, {}, nothing, h);
    if (stopped == 0.0 && vector_at(state.columns, velocity, 6).x < 1e-3) stopped = state.time;
  }
  EXPECT_NEAR(stopped, .4077, 0.01);
  EXPECT_NEAR(vector_at(state.columns, position, 6).x - start, .2039, 1e-3);
  // then no joint slips, to rounding of the loads
  while (state.time < 8.0) advance(string, state, {}, nothing, h);
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    EXPECT_LT(std::abs(state.columns.at(slip_along, i)), 3e-8) << i;
    EXPECT_LT(std::abs(state.columns.at(slip_around, i)), 3e-8) << i;
  }
}

/// A pipe that a torque turns at 60 rpm in a horizontal hole: the torque of the wall at the beginning of rest, and
/// where it lies.
struct Climb {
  double psi, torque;  ///< [rad] from the low side, [N m/m]
};

Climb climb(const PipeSection& pipe) {
  const double h = 5e-4, mu = 0.25;
  WellString string = lying(pipe, 12, mu);
  string.sections[0].drag_across = 50.0;  // so that it settles soon
  WellStringState state = at_rest(string, h);
  const double weight = string.sections[0].weight, radius = string.sections[0].contact_radius;
  const double torque = 120.0 * weight * radius * mu / std::sqrt(1.0 + mu * mu);
  string.tip_moment = {torque, 0.0, 0.0};
  for (std::size_t i = 0; i < state.count; ++i) {
    const double inertia = 1.0 / (state.columns.at(inverse_inertia, i) + state.columns.at(inverse_inertia_along, i));
    set_vector(state.columns, momentum, i, (inertia * 60.0 * rpm) * vector_at(state.columns, direction, i));
    renew_derived(state.columns, state.columns.place_of(i));
  }
  while (state.time < 20.0) advance(string, state, {}, nothing, h);
  Vector3 across_hole;
  for (std::size_t i = 0; i + 1 < state.count; ++i) across_hole += vector_at(state.columns, wall_normal, i);
  EXPECT_GT(spin_of(state.columns, 6), 1.0 * rpm);
  return {.psi = std::abs(std::atan2(across_hole.y, across_hole.z)),
          .torque = -radius * total(state, friction_around) / 120.0};
}

/// The same slider where friction depends on speed, from v0 to rest: time and way, by integration of the closed form
/// dv/dt = -g mu(v). With d = mu_s - mu_k and a^2 = 1 + d / mu_k,
///   t = (v0 - d / (mu_k a) v_s atan(v0 / (a v_s))) / (g mu_k),
///   s = (v0^2 / 2 - d v_s^2 / (2 mu_k) ln(1 + (v0 / (a v_s))^2)) / (g mu_k).
TEST(WellContact, ASliderSlowsDownByFrictionThatDependsOnSpeed) {
  const double h = 5e-4, mu_k = 0.2, mu_s = 0.4, vs = 0.2, v0 = 1.0;
  const double d = mu_s - mu_k, a = std::sqrt(1.0 + d / mu_k);
  const double time = (v0 - d / (mu_k * a) * vs * std::atan(v0 / (a * vs))) / (gravity * mu_k);
  const double way =
      (0.5 * v0 * v0 - 0.5 * d * vs * vs / mu_k * std::log1p(std::pow(v0 / (a * vs), 2))) / (gravity * mu_k);
  WellString string = lying(drill_pipe(), 12, mu_k);
  for (HolePiece& piece : string.hole) {
    piece.more_at_rest = d;
    piece.slip_speed = vs;
  }
  string.sections[0].drag_across = 100.0;
  WellStringState state = at_rest(string, h);
  for (std::size_t i = 0; i < state.count; ++i) set_vector(state.columns, velocity, i, {v0, 0.0, 0.0});
  const double start = vector_at(state.columns, position, 6).x;
  double stopped = 0.0;
  while (state.time < 1.0) {
    advance(string, state, {}, nothing, h);
    if (stopped == 0.0 && vector_at(state.columns, velocity, 6).x < 1e-3) stopped = state.time;
  }
  EXPECT_NEAR(time, 0.4163, 1e-4) << "without the rise .5097 s";
  EXPECT_NEAR(stopped, time, 0.01);
  EXPECT_NEAR(vector_at(state.columns, position, 6).x - start, way, 1e-3);
}

TEST(WellContact, AtRestItHoldsMoreThanWhenItSlips) {
  // a push that grows: nothing moves until mu_s w L; then mu_k w L is too little to hold it
  const double h = 5e-4, mu_k = 0.2, mu_s = 0.4;
  WellString string = lying(drill_pipe(), 12, mu_k);
  for (HolePiece& piece : string.hole) {
    piece.more_at_rest = mu_s - mu_k;
    piece.slip_speed = 0.01;
  }
  string.sections[0].drag_across = 100.0;
  WellStringState state = at_rest(string, h);
  const double limit = mu_s * 120.0 * string.sections[0].weight;
  double broke = 0.0;
  while (state.time < 10.0 && broke == 0.0) {
    string.tip_force = {0.12 * limit * state.time, 0.0, 0.0};
    advance(string, state, {}, nothing, h);
    if (vector_at(state.columns, velocity, 11).x > 1e-2) broke = string.tip_force.x;  // the other end has come along
  }
  EXPECT_NEAR(broke, limit, 0.02 * limit);
  const double mass = 120.0 * string.sections[0].beam.mass, from = state.time;
  string.tip_force = {limit, 0.0, 0.0};
  const double before = vector_at(state.columns, velocity, 6).x;
  while (state.time < from + 0.5) advance(string, state, {}, nothing, h);
  const double slides = (limit - mu_k * 120.0 * string.sections[0].weight) / mass;
  EXPECT_NEAR(vector_at(state.columns, velocity, 6).x - before, 0.5 * slides, 0.05 * slides);
}

TEST(WellContact, TheWallBearsWhatWhirlsRoundIt) {
  // collars in bars of 2 m roll backwards along the wall, stiff enough not to bend where they end: all joints together
  // bear the sum of m r w^2, each bar's mass on the orbit of its middle. One joint of the middle bears its own bar less
  // what the friction along the hole at its neighbours lifts, F_x R being a couple: R (F_x above - F_x below) / 2 L.
  // What rolls does not slip, so this friction stays as the first moments left it, up to mu N.
  const double h = 4e-5, spin = 60.0 * rpm;
  const int bars = 20;
  StringSection collar = section(drill_collar(), 2.0 * bars, bars);
  collar.weight = 0.0;
  WellString string{.sections = {collar}, .hole = straight_hole(0.0, 100.0, 0.2159, 0.3)};
  string.damping.bending = 2e-4;
  const double room = string.hole[0].radius - collar.contact_radius, rolling = -spin * collar.contact_radius / room;
  WellStringState state = rolling_collar(string, room, spin, rolling);
  double all = 0.0, needed = 0.0, samples = 0.0;
  std::array<double, bars> bears{}, centripetal{}, along{};
  while (state.time < 1.0) {
    advance(string, state, {}, nothing, h);
    if (state.time < 0.5) continue;
    all += total(state, wall_force);
    for (std::size_t i = 0; i < state.count; ++i) {
      const Vector3 at = vector_at(state.columns, position, i), v = vector_at(state.columns, velocity, i);
      const double r = std::hypot(at.x, at.y), w = (at.x * v.y - at.y * v.x) / (r * r);
      needed += 2.0 * collar.beam.mass * r * w * w;
      centripetal[i] += 2.0 * collar.beam.mass * r * w * w;
      if (i + 1 == state.count) continue;
      bears[i] += state.columns.at(wall_force, i);
      along[i] += state.columns.at(friction_along, i);
    }
    samples += 1.0;
  }
  const double bar = needed / samples / bars, pure = 2.0 * collar.beam.mass * room * rolling * rolling;
  EXPECT_NEAR(pure / 2.0 * 10.0, 14.5e3, 0.1e3) << "10 m at 60 rpm";
  EXPECT_NEAR(bar, pure, 0.03 * pure) << "it loses some speed when it is first pressed against the wall";
  EXPECT_NEAR(all / samples, bars * bar, 2e-3 * bars * bar);
  double most_lifted = 0.0;
  for (std::size_t i = 5; i < 14; ++i) {
    const double lifted = collar.contact_radius * (along[i + 1] - along[i - 1]) / 4.0 / samples;
    EXPECT_NEAR(bears[i] / samples, centripetal[i] / samples - lifted, 1e-3 * bar) << i;
    most_lifted = std::max(most_lifted, lifted);
  }
  EXPECT_NEAR(most_lifted, 0.01 * bar, 0.002 * bar) << "so much would be missed without the couple";
}

TEST(WellContact, APipeThatTurnsClimbsTheWall) {
  // it rests at psi = atan mu = 14.036 degrees from the low side, N = w cos psi, torque w r mu / sqrt(1 + mu^2)
  const Climb pipe = climb(drill_pipe()), collar = climb(drill_collar());
  EXPECT_NEAR(pipe.psi / degree, 14.036, 0.1);
  EXPECT_NEAR(pipe.torque, 4.036, 0.02);
  EXPECT_NEAR(collar.psi / degree, 14.036, 0.1);
  EXPECT_NEAR(collar.torque, 26.83, 0.13);
}

TEST(WellContact, FrictionTurnsWithTheSlip) {
  // 60 rpm and 5 mm/s: the share of friction along the hole is .005 / .399 of mu N for drill pipe
  const double around = 60.0 * rpm * 0.0635;
  EXPECT_NEAR(0.005 / std::hypot(0.005, around), 0.005 / .399, 1e-5);
  const double h = 5e-4;
  const WellString string = lying(drill_pipe(), 12, 0.25);
  WellStringState state = at_rest(string, h);
  for (std::size_t i = 0; i < state.count; ++i) {
    const double inertia = 1.0 / (state.columns.at(inverse_inertia, i) + state.columns.at(inverse_inertia_along, i));
    set_vector(state.columns, momentum, i, (inertia * 60.0 * rpm) * vector_at(state.columns, direction, i));
    set_vector(state.columns, velocity, i, {0.005, 0.0, 0.0});
    renew_derived(state.columns, state.columns.place_of(i));
  }
  advance(string, state, {}, nothing, h);
  const double normal = total(state, wall_force);
  EXPECT_NEAR(-total(state, friction_along) / (0.25 * normal), 0.005 / .399, 2e-4);
  EXPECT_NEAR(-total(state, friction_around) / (0.25 * normal), 1.0, 1e-3);
}

TEST(WellContact, ACollarRollsBackwardsAlongTheWall) {
  // pure backward whirl: the centre goes round with -W R / r, R the radius of the collar, r that of its orbit,
  // some 3.25 times W for 6 1/2 in in 8 1/2 in; it needs a force of the wall of m r w^2, 14.5 kN for 10 m at 60 rpm
  const double h = 2e-4, spin = 60.0 * rpm;
  StringSection collar = section(drill_collar(), 60.0, 6);
  collar.weight = 0.0;
  const WellString string{.sections = {collar}, .hole = straight_hole(0.0, 100.0, 0.2159, 0.3)};
  const double room = string.hole[0].radius - collar.contact_radius, rolling = -spin * collar.contact_radius / room;
  EXPECT_NEAR(rolling / spin, -3.25, 1e-12);
  WellStringState state = rolling_collar(string, room, spin, rolling);
  while (state.time < 1.0) advance(string, state, {}, nothing, h);
  const double from = state.columns.at(turns, 3);
  double round = 0.0, orbit = 0.0, samples = 0.0;
  Vector3 last = vector_at(state.columns, position, 3);
  while (state.time < 3.0) {
    advance(string, state, {}, nothing, h);
    const Vector3 now = vector_at(state.columns, position, 3);
    round += std::atan2(last.x * now.y - last.y * now.x, last.x * now.x + last.y * now.y);
    last = now;
    orbit += std::hypot(now.x, now.y);
    samples += 1.0;
  }
  const double turned = state.columns.at(turns, 3) - from, radius = orbit / samples;
  EXPECT_NEAR(round / turned * radius / collar.contact_radius, -1.0, 3e-3);
}

TEST(WellContact, AWeightlessStringOverABendHoldsBackByTheCapstanLaw) {
  // T1 / T2 = exp(mu pi / 2) over 90 degrees, 1.481 for mu .25, plus what the discrete joints change: mu * 3.33 degrees
  const double mu = 0.25, h = 2e-4;
  const std::vector<HolePiece> hole =
      hole_pieces(well_path({{0, 0, 0}, {30, 0, 0}, {300, horizontal, 0}, {400, horizontal, 0}}), {{400, 0.2159, mu}});
  StringSection pipe = section(drill_pipe(), 330.0, 66);
  pipe.weight = 0.0;
  WellString string{.sections = {pipe}, .hole = hole, .upper_end = UpperEnd::table};
  WellStringState state = hung_in_hole(string);
  // pulled out: first loaded without friction, then the hoist goes up slowly against a dead load
  string.tip_force = {1e5, 0.0, 0.0};
  relax(string, state, h);
  double sum = 0.0;
  int samples = 0;
  while (state.time < 8.0) {
    state.top.reference -= 0.02 * std::min(1.0, state.time / 2.0) * h;
    advance(string, state, {}, nothing, h);
    if (state.time > 4.0) {
      sum += state.top.hook_load;
      ++samples;
    }
  }
  EXPECT_NEAR(sum / samples / 1e5, std::exp(mu * horizontal), 0.01 * std::exp(mu * horizontal));
}

}  // namespace
