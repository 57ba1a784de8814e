#include "runtime/drillstring/bit_rock.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/laws/progression_angle.hpp"

namespace bitrock::runtime {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;  // [rad] of cut over which the mean of a fluctuating source is taken

/// How much of the cut the cutters still have: 1 on the bottom, falling to 0 as the bit is lifted by the depth of cut.
double engagement(const BitRock& bit, double depth) {
  if (depth >= 0.0) return 1.0;
  return bit.engagement_depth > 0.0 ? std::max(0.0, 1.0 + depth / bit.engagement_depth) : 0.0;
}

double acting_force(const BitRock& bit, BitRockState& state, double force, double progressed) {
  if (bit.axial_source == AxialSource::none) return 0.0;
  if (bit.axial_source == AxialSource::full) return force;
  if (!state.source_known) state.source_mean = force;
  state.source_known = true;
  state.source_mean += (1.0 - std::exp(-progressed / turn)) * (force - state.source_mean);
  return force - state.source_mean;
}

}  // namespace

AdvanceLine advance_at(const BitRock& bit, double rotation) {
  switch (bit.advance_law) {
    case AdvanceLaw::root:
      return advance_line(bit.root_advance, rotation, bit.threshold_weight);
    case AdvanceLaw::regularized:
      return advance_line(bit.regularized_advance, rotation, bit.threshold_weight);
    case AdvanceLaw::imposed:
      if (!(rotation > 0.0)) break;
      return {.offset = bit.imposed_advance, .threshold = bit.threshold_weight};
    case AdvanceLaw::none:
      break;
  }
  return {};
}

double push_on_face(const BitRock& bit, BitRockState& state, double rotation, double position, double speed, double h) {
  const double before = state.rate_of_penetration;
  const double depth = position - (state.face + h * before);
  const RockPush push = rock_push(bit.contact, advance_at(bit, rotation), depth, speed);
  state.weight_on_bit = push.force;
  state.rate_of_penetration = push.speed;
  state.face += 0.5 * h * (before + push.speed);
  return depth;
}

void drive_source(const BitRock& bit, BitRockState& state, const BitRockSource& source, double turned, double depth) {
  // a bit that its cutters carry (their force is that of the instant before) goes on cutting without the rock spring
  const double pushed = state.weight_on_bit + std::max(0.0, state.source_force);
  const double progressed = progression(turned, pushed, bit.threshold_weight);
  state.progression += progressed;
  const BitLoad load = source({.angle = state.progression,
                               .rotation = mean(state.smooth_rotation),
                               .rate_of_penetration = mean(state.smooth_advance)});
  const double share = engagement(bit, depth);
  state.source_force = share * acting_force(bit, state, load.axial_force, progressed);
  state.source_torque = share * std::max(0.0, load.torque);
  const FractureSpring spring =
      fracture_spring(state.twist, turned, bit.fracture_stiffness, state.source_torque, bit.unloading);
  state.twist = spring.twist;
  state.fracture_torque = spring.torque;
}

}  // namespace bitrock::runtime
