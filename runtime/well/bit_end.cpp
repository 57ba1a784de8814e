#include "runtime/well/bit_end.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::runtime {

namespace {

constexpr WallSpring guide;  // as stiff as the wall

/// Piece of the hole that the bit is in. That of the joint above it is a good place to begin.
const HolePiece& piece_of_bit(const WellString& string, const Columns& columns) {
  return string.hole[piece_at(string.hole, lower_end_of(columns, 0), static_cast<std::size_t>(columns.at(piece, 0)))];
}

/// Friction of the gauge of a guided bit, implicit as at the joints; one body takes all of it.
void rub_gauge(const WellString& string, WellStringState& state, double h) {
  Columns& columns = state.columns;
  BitState& bit = state.bit;
  const Vector3 d = vector_at(columns, direction, 0), t = bit.tangent, c = cross(t, bit.side);
  const Vector3 surface = string.gauge_radius * bit.side, arm = columns.at(half_length, 0) * d + surface;
  const auto slip_now = [&] { return lower_velocity_of(columns, 0) + cross(vector_at(columns, rate, 0), surface); };
  const Vector3 before = bit.velocity + cross(bit.rate, surface), slip = slip_now();
  const double half = columns.at(half_length, 0), tumble = columns.at(inverse_inertia, 0);
  const double mass = columns.at(inverse_mass, 0), r = string.gauge_radius;
  const SlipImpulse<double> p =
      slip_impulse(dot(slip, t), dot(slip, c), mass + columns.at(inverse_mass_along, 0),
                   mass + half * half * tumble + r * r * (tumble + columns.at(inverse_inertia_along, 0)),
                   h * bit.friction * bit.side_force);
  const Vector3 impulse = p.along * t + p.around * c;
  set_vector(
      columns, velocity, 0,
      vector_at(columns, velocity, 0) + mass * impulse + (columns.at(inverse_mass_along, 0) * dot(impulse, d)) * d);
  set_vector(columns, momentum, 0, vector_at(columns, momentum, 0) + cross(arm, impulse));
  renew_derived(columns, columns.place_of(0));
  bit.gauge_drag = p.along / h;
  bit.gauge_torque = -r * p.around / h;
  state.work.bit -= 0.5 * dot(impulse, before + slip_now());
}

}  // namespace

void load_bit(const WellString& string, WellStringState& state, const BitRockSource& source, double h) {
  Columns& columns = state.columns;
  BitState& bit = state.bit;
  const Vector3 d = vector_at(columns, direction, 0), arm = columns.at(half_length, 0) * d;
  bit.velocity = lower_velocity_of(columns, 0);
  bit.rate = vector_at(columns, rate, 0);
  Vector3 force = string.tip_force, torque = string.tip_moment;
  if (!string.hole.empty()) {
    const HolePiece& hole = piece_of_bit(string, columns);
    const WellFoot foot = foot_on(hole.arc, lower_end_of(columns, 0));
    bit.depth = foot.measured_depth;
    bit.tangent = foot.tangent;
    if (string.guided) {
      const Vector3 damping = guide.damping * across(bit.velocity, foot.tangent);
      const Vector3 side = guide.stiffness * foot.offset + damping;
      force -= side;
      bit.side_force = length(side);
      bit.side = (1.0 / (bit.side_force + 1e-200)) * side;
      // of the gauge, which slips in the plane of the wall
      const Vector3 slip = bit.velocity + cross(bit.rate, string.gauge_radius * bit.side);
      const double along = dot(slip, bit.tangent), around = dot(slip, cross(bit.tangent, bit.side));
      bit.friction =
          friction_at(hole.friction, hole.more_at_rest, 1.0 / hole.slip_speed, along * along + around * around);
      state.work.dampers += h * dot(damping, bit.velocity);
    }
  }
  if (string.on_rock) {
    const double rotation = dot(bit.rate, d);
    const double depth = push_on_face(string.bit, bit, rotation, bit.depth, dot(bit.velocity, bit.tangent), h);
    drive_source(string.bit, bit, source, h * rotation, depth);
    accept(bit.smooth_rotation, state.time, rotation);
    accept(bit.smooth_advance, state.time, bit.rate_of_penetration);
    bit.friction_torque = string.bit.friction.law == FrictionLaw::smooth
                              ? bit.weight_on_bit * string.bit.friction_radius *
                                    friction_coefficient(string.bit.friction.smooth, rotation)
                              : 0.0;
    force -= (bit.weight_on_bit + bit.source_force + string.bit.hydraulic_force) * bit.tangent;
    torque -= (bit.friction_torque + bit.fracture_torque) * d;
  }
  const std::size_t below = columns.half - 1;  // where a joint below the bit would have its load
  put(columns, force_above, below, force);
  put(columns, torque_above, below, torque + cross(arm, force));
}

void finish_bit(const WellString& string, WellStringState& state, double h) {
  Columns& columns = state.columns;
  BitState& bit = state.bit;
  const Vector3 d = vector_at(columns, direction, 0);
  if (string.on_rock && string.bit.friction.law == FrictionLaw::stribeck) {
    const double yield = columns.at(inverse_inertia, 0) + columns.at(inverse_inertia_along, 0);
    const double spin = spin_of(columns, 0), arm = bit.weight_on_bit * string.bit.friction_radius;
    const double stop = spin / (h * yield);
    const double most = arm * friction_coefficient(string.bit.friction.stribeck, std::abs(spin));
    bit.friction_torque =
        std::abs(stop) <= arm * string.bit.friction.stribeck.resting ? stop : std::copysign(most, spin);
    set_vector(columns, momentum, 0, vector_at(columns, momentum, 0) - (h * bit.friction_torque) * d);
    renew_derived(columns, columns.place_of(0));
  }
  if (string.guided && string.gauge_radius > 0.0) rub_gauge(string, state, h);
  const Vector3 velocity = 0.5 * (bit.velocity + lower_velocity_of(columns, 0));
  const Vector3 rate_now = 0.5 * (bit.rate + vector_at(columns, rate, 0));
  state.work.tip += h * (dot(string.tip_force, velocity) + dot(string.tip_moment, rate_now));
  if (string.on_rock)
    state.work.bit +=
        h * ((bit.weight_on_bit + bit.source_force + string.bit.hydraulic_force) * dot(velocity, bit.tangent) +
             (bit.friction_torque + bit.fracture_torque) * dot(rate_now, d));
}

double bit_energy(const WellString& string, const WellStringState& state) {
  if (!string.guided) return 0.0;
  const WellFoot foot = offset_from(piece_of_bit(string, state.columns).arc, lower_end_of(state.columns, 0));
  return 0.5 * guide.stiffness * dot(foot.offset, foot.offset);
}

}  // namespace bitrock::runtime
