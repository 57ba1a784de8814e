#include "runtime/drillstring/drill_string.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/laws/karnopp.hpp"
#include "runtime/signal/step5.hpp"

namespace bitrock::runtime {

namespace {

/// Velocities half-way, positions at the end, velocities as predicted for the end.
void drift(ChainMotion& motion, std::vector<double>& predicted, double h) {
  for (std::size_t i = 0; i < motion.position.size(); ++i) {
    motion.velocity[i] += 0.5 * h * motion.acceleration[i];
    motion.position[i] += h * motion.velocity[i];
    predicted[i] = motion.velocity[i] + 0.5 * h * motion.acceleration[i];
  }
}

/// Weight on bit and rate of penetration; returns how deep the bit stands below the face.
double push_on_rock(const DrillString& string, DrillState& state, double h) {
  const double rotation = state.torsional_room.predicted.back();
  if (string.axial.size() > 0)
    return push_on_face(string.bit, state, rotation, state.axial.position.back(), state.axial_room.predicted.back(), h);
  state.weight_on_bit = string.bit.imposed_weight;
  state.rate_of_penetration = rate_of_penetration(advance_at(string.bit, rotation), state.weight_on_bit);
  return 0.0;
}

void accelerate_axial(const DrillString& string, DrillState& state) {
  std::vector<double>& force = state.axial_room.force;
  set_chain_forces(string.axial, state.axial.position, state.axial_room.predicted, {}, force);
  for (std::size_t i = 0; i < force.size(); ++i) force[i] += string.weights[i];
  if (is_fed(string.hoist))
    state.hoist.pull =
        line_pull(string.hoist, state.hoist, state.axial.position.front(), state.axial_room.predicted.front()).pull;
  force.front() -= hook_load(string, state);
  force.back() -= state.weight_on_bit + state.source_force + string.bit.hydraulic_force;
  for (std::size_t i = 0; i < force.size(); ++i) state.axial.acceleration[i] = force[i] / string.axial.inertia[i];
}

/// Dry friction that acts on a lump: most it holds at rest, and while sliding.
struct DryLimits {
  double at_rest = 0.0, sliding = 0.0;
};

void add_dry(const Friction& friction, double moment, double speed, DryLimits& limits) {
  limits.at_rest += moment * friction.stribeck.resting;
  limits.sliding += moment * friction_coefficient(friction.stribeck, speed);
}

/// Friction of one place on its lump: smooth friction goes into the torque at once, dry friction into the limits.
/// Returns the smooth torque against forward turning.
double smooth_or_dry(const Friction& friction, double moment, double speed, double& torque, DryLimits& limits) {
  if (friction.law == FrictionLaw::stribeck) add_dry(friction, moment, speed, limits);
  if (friction.law != FrictionLaw::smooth) return 0.0;
  const double resisting = moment * friction_coefficient(friction.smooth, speed);
  torque -= resisting;
  return resisting;
}

/// Returns the power of friction at the wall [W].
double accelerate_torsional(const DrillString& string, DrillState& state, double half_step) {
  const std::vector<double>& speed = state.torsional_room.predicted;
  std::vector<double>& torque = state.torsional_room.force;
  set_chain_forces(string.torsional, state.torsional.position, speed, drive_at(string.drive, state.time), torque);
  if (!string.drive.imposes_speed) torque.front() += drive_torque_at(string.drive, state.time);
  torque.back() -= state.fracture_torque;

  double wall_power = 0.0;
  const std::size_t last = torque.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    DryLimits limits;
    double wall = 0.0, bit = 0.0;
    if (!string.wall_moment.empty())
      wall = smooth_or_dry(string.wall_friction, string.wall_moment[i], speed[i], torque[i], limits);
    const double wall_share = limits.sliding;
    const double bit_moment = i == last ? state.weight_on_bit * string.bit.friction_radius : 0.0;
    if (i == last) bit = smooth_or_dry(string.bit.friction, bit_moment, speed[i], torque[i], limits);

    double& v = state.torsional.velocity[i];
    if (limits.at_rest > 0.0) {
      const DryFriction dry = karnopp(state.sliding[i], v, half_step / string.torsional.inertia[i], torque[i],
                                      limits.at_rest, limits.sliding);
      const double of_wall = limits.sliding > 0.0 ? wall_share / limits.sliding : 0.0;
      wall -= of_wall * dry.torque;
      bit -= (1.0 - of_wall) * dry.torque;
      torque[i] += dry.torque;
      state.sliding[i] = dry.direction;
      if (dry.direction == 0) {
        torque[i] = 0.0;
        v = 0.0;
      }
    } else {
      state.sliding[i] = v > 0.0 ? 1 : v < 0.0 ? -1 : 0;
    }
    state.torsional.acceleration[i] = torque[i] / string.torsional.inertia[i];
    v += half_step * state.torsional.acceleration[i];
    wall_power += wall * v;
    if (i == last) state.friction_torque = bit;
  }
  return wall_power;
}

/// Of the line with the velocities of this instant; nothing where the hook load is imposed.
LinePull line_now(const DrillString& string, const DrillState& state) {
  if (!is_fed(string.hoist)) return {};
  return line_pull(string.hoist, state.hoist, state.axial.position.front(), state.axial.velocity.front());
}

EnergyFlows power_now(const DrillString& string, const DrillState& state, double wall_power) {
  const Drive drive = drive_at(string.drive, state.time);
  const double rotation = state.torsional.velocity.back();
  EnergyFlows power;
  power.drive = string.drive.imposes_speed
                    ? drive_reaction(string.torsional, state.torsional, drive) * drive.velocity
                    : drive_torque_at(string.drive, state.time) * state.torsional.velocity.front();
  power.dampers = damper_power(string.torsional, state.torsional, drive);
  power.wall_friction = wall_power;
  power.bit_friction = state.friction_torque * rotation;
  power.fracture = state.fracture_torque * rotation;
  if (string.axial.size() == 0) return power;
  const double sinking = state.axial.velocity.back();
  power.weight = std::inner_product(string.weights.begin(), string.weights.end(), state.axial.velocity.begin(), 0.0);
  power.hook = -string.drive.hook_load * state.axial.velocity.front();
  if (is_fed(string.hoist)) power.hook = -state.hoist.pull * state.hoist.speed;
  power.hydraulic = -string.bit.hydraulic_force * sinking;
  power.dampers += damper_power(string.axial, state.axial, {}) + line_now(string, state).damped;
  power.rock_push = state.weight_on_bit * sinking;
  power.source = state.source_force * sinking;
  power.drilling = state.weight_on_bit * state.rate_of_penetration;
  return power;
}

constexpr double EnergyFlows::*all_flows[] = {
    &EnergyFlows::drive,     &EnergyFlows::weight,        &EnergyFlows::hook,         &EnergyFlows::hydraulic,
    &EnergyFlows::dampers,   &EnergyFlows::wall_friction, &EnergyFlows::bit_friction, &EnergyFlows::fracture,
    &EnergyFlows::rock_push, &EnergyFlows::source,        &EnergyFlows::drilling};

/// Everything that follows from positions and predicted velocities of one instant. `h` 0: the beginning, where
/// velocities are known already.
void settle(const DrillString& string, DrillState& state, const BitRockSource& source, double turned, double h) {
  const double depth = push_on_rock(string, state, h);
  drive_source(string.bit, state, source, turned, depth);
  if (string.axial.size() > 0) {
    accelerate_axial(string, state);
    for (std::size_t i = 0; i < string.axial.size(); ++i)
      state.axial.velocity[i] += 0.5 * h * state.axial.acceleration[i];
  }
  const double wall_power = accelerate_torsional(string, state, 0.5 * h);
  accept(state.smooth_rotation, state.time, state.torsional.velocity.back());
  accept(state.smooth_advance, state.time, state.rate_of_penetration);

  const EnergyFlows power = power_now(string, state, wall_power);
  for (double EnergyFlows::*flow : all_flows) state.work.*flow += 0.5 * h * (power.*flow + state.power.*flow);
  state.power = power;
}

void begin_chain(const Chain& chain, ChainMotion& motion, ChainRoom& room) {
  motion.position.assign(chain.size(), 0.0);
  motion.velocity.assign(chain.size(), 0.0);
  motion.acceleration.assign(chain.size(), 0.0);
  room.predicted.assign(chain.size(), 0.0);
  room.force.assign(chain.size(), 0.0);
}

/// Positions in balance on a face at 0, with the rock's spring carrying `weight` [N] and jets pushing.
void place_on_bottom(const DrillString& string, double weight, std::vector<double>& position) {
  double pull = -weight - string.bit.hydraulic_force;  // of the spring above the lump, upwards
  position.back() = weight / string.bit.contact.stiffness;
  for (std::size_t i = position.size() - 1; i > 0; --i) {
    pull += string.weights[i];
    position[i - 1] = position[i] - pull / string.axial.stiffness[i];
  }
}

/// A string in balance under a block that is fed, sinking as the rock goes away.
void hang_on_line(const DrillString& string, double weight, bool on_bottom, DrillState& state) {
  HoistState& hoist = state.hoist;
  place_on_bottom(string, weight, state.axial.position);
  const double advance = state.rate_of_penetration;
  const bool automatic = string.hoist.rule == HoistRule::autodriller;
  hoist.speed = automatic ? std::min(advance, string.hoist.autodriller.fastest) : string.hoist.feed;
  state.axial.velocity.assign(string.axial.size(), on_bottom ? advance : hoist.speed);
  state.axial_room.predicted = state.axial.velocity;
  hoist.pull = hoist.gauge = hanging_load(string) - weight;
  hoist.block = state.axial.position.front() - hoist.pull / string.hoist.stiffness;
  hoist.on_bottom = on_bottom;
  if (automatic && on_bottom) hoist.drift = hoist.speed;
}

}  // namespace

bool is_lump(const TopDrive& drive) {
  return !drive.imposes_speed || drive.control.inertia > 0.0;
}

TopRotation top_rotation(const DrillString& string, const DrillState& state) {
  const Drive set = drive_at(string.drive, state.time);
  if (!string.drive.imposes_speed) return {state.torsional.velocity.front(), drive_torque_at(string.drive, state.time)};
  if (!is_lump(string.drive)) return {set.velocity, drive_reaction(string.torsional, state.torsional, set)};
  const auto& [position, velocity, acceleration] = state.torsional;
  return {velocity[0], string.torsional.stiffness[1] * (position[0] - position[1]) +
                           string.torsional.damping[1] * (velocity[0] - velocity[1])};
}

Drive drive_at(const TopDrive& drive, double time) {
  if (!drive.imposes_speed) return {};
  const double t = time - drive.since, more = drive.rotation - drive.rotation_then;
  if (drive.ramp <= 0.0) return {drive.angle_then + drive.rotation * t, drive.rotation};
  const double s = t / drive.ramp;
  if (s >= 1.0)
    return {drive.angle_then + (drive.rotation * (t - 0.5 * drive.ramp) + drive.rotation_then * 0.5 * drive.ramp),
            drive.rotation};
  return {drive.angle_then + (more * drive.ramp * s * s * s * s * (2.5 + s * (s - 3.0)) + drive.rotation_then * t),
          drive.rotation_then + more * smooth_unit_step(s)};
}

double drive_torque_at(const TopDrive& drive, double time) {
  if (drive.ramp <= 0.0) return drive.torque;
  return step5(time, drive.since, drive.torque_then, drive.since + drive.ramp, drive.torque);
}

TopDrive redirected(const TopDrive& drive, double time, double rotation, double torque) {
  const Drive now = drive_at(drive, time);
  TopDrive next = drive;
  next.rotation = rotation;
  next.torque = torque;
  next.since = time;
  next.angle_then = now.position;
  next.rotation_then = now.velocity;
  next.torque_then = drive_torque_at(drive, time);
  return next;
}

double bit_position(const DrillString& string, const DrillState& state) {
  return string.axial.size() > 0 ? state.axial.position.back() : state.face;
}

bool is_finite(const DrillState& state) {
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  return finite(state.axial.velocity) && finite(state.torsional.velocity) && std::isfinite(state.weight_on_bit) &&
         std::isfinite(torque_on_bit(state)) && std::isfinite(state.face);
}

double static_weight_on_bit(const DrillString& string) {
  if (string.axial.size() == 0) return string.bit.imposed_weight;
  if (is_fed(string.hoist)) return std::min(string.hoist.weight_on_bit, hanging_load(string));
  const double weight = std::accumulate(string.weights.begin(), string.weights.end(), 0.0);
  return std::max(0.0, weight - string.drive.hook_load - string.bit.hydraulic_force);
}

double hanging_load(const DrillString& string) {
  const double weight = std::accumulate(string.weights.begin(), string.weights.end(), 0.0);
  return std::max(0.0, weight - string.bit.hydraulic_force);
}

double hook_load(const DrillString& string, const DrillState& state) {
  return is_fed(string.hoist) ? state.hoist.pull : string.drive.hook_load;
}

Chain held_axial_chain(const DrillString& string) {
  Chain chain = string.axial;
  if (!is_fed(string.hoist) || chain.size() == 0) return chain;
  chain.stiffness.front() = string.hoist.stiffness;
  chain.damping.front() = string.hoist.damping;
  return chain;
}

double planned_block_speed(const DrillString& string, DrillState& state, double h) {
  if (!is_fed(string.hoist)) return 0.0;
  return next_block_speed(string.hoist, state.hoist, hanging_load(string), state.time, h);
}

DrillState beginning(const DrillString& string, const BitRockSource& source, bool turning, double off_bottom) {
  DrillState state;
  begin_chain(string.axial, state.axial, state.axial_room);
  begin_chain(string.torsional, state.torsional, state.torsional_room);
  state.smooth_rotation.window = state.smooth_advance.window = string.bit.averaging_time;

  const double rotation = turning ? string.drive.rotation : 0.0;
  state.torsional.velocity.assign(string.torsional.size(), rotation);
  state.torsional_room.predicted = state.torsional.velocity;
  state.sliding.assign(string.torsional.size(), rotation > 0.0 ? 1 : 0);
  accept(state.smooth_rotation, 0.0, rotation);

  const double weight = static_weight_on_bit(string);
  if (string.axial.size() > 0 && off_bottom > 0.0) state.face = off_bottom;
  if (string.axial.size() > 0 && off_bottom == 0.0 && weight > 0.0)
    place_on_bottom(string, weight, state.axial.position);
  if (off_bottom == 0.0) state.rate_of_penetration = rate_of_penetration(advance_at(string.bit, rotation), weight);
  accept(state.smooth_advance, 0.0, state.rate_of_penetration);
  if (is_fed(string.hoist)) hang_on_line(string, off_bottom > 0.0 ? 0.0 : weight, off_bottom == 0.0, state);
  settle(string, state, source, 0.0, 0.0);
  return state;
}

void advance(const DrillString& string, DrillState& state, const BitRockSource& source, double h) {
  advance(string, state, source, h, planned_block_speed(string, state, h));
}

void advance(const DrillString& string, DrillState& state, const BitRockSource& source, double h, double block_speed) {
  state.time += h;
  state.hoist.block += 0.5 * h * (state.hoist.speed + block_speed);
  state.hoist.speed = block_speed;
  drift(state.axial, state.axial_room.predicted, h);
  drift(state.torsional, state.torsional_room.predicted, h);
  settle(string, state, source, h * state.torsional.velocity.back(), h);
}

double stored_energy(const DrillString& string, const DrillState& state) {
  return kinetic_energy(string.axial, state.axial) + kinetic_energy(string.torsional, state.torsional) +
         spring_energy(string.axial, state.axial, {}) + line_now(string, state).energy +
         spring_energy(string.torsional, state.torsional, drive_at(string.drive, state.time));
}

double energy_residual(const DrillString& string, const DrillState& state, double initial) {
  const EnergyFlows& w = state.work;
  const double in = w.drive + w.weight + w.hook + w.hydraulic;
  const double out = w.dampers + w.wall_friction + w.bit_friction + w.fracture + w.rock_push + w.source;
  return in - out - (stored_energy(string, state) - initial);
}

}  // namespace bitrock::runtime
