#pragma once
/// Drill strings that the tests share.

#include <numbers>
#include <vector>

#include "runtime/drillstring/drill_string.hpp"

using namespace bitrock;

namespace drillstring_test {

inline constexpr double rpm = 2.0 * std::numbers::pi / 60.0;  // [rad/s]

/// 150 m of plain 5 in 19.5 lb/ft drill pipe: 127 mm by 4.276 in.
inline runtime::PipeSection pipe() {
  return {.length = 150.0, .outer_diameter = 0.127, .inner_diameter = 0.0254 * 4.276};
}

/// One inertia on one spring behind a drive of constant speed, with a friction that drops from T_s to T_d.
inline runtime::DrillString one_disc(double inertia, double stiffness, double rotation, double at_rest,
                                     double sliding) {
  runtime::DrillString string;
  string.torsional = {{inertia}, {stiffness}, {0.0}, {0.0}};
  string.drive = {.rotation = rotation};
  string.bit.friction.law = runtime::FrictionLaw::stribeck;
  // the coefficients times 1 N and 1 m are the torques; the drop is over within 1e-9 rad/s
  string.bit.friction.stribeck = {.resting = at_rest, .sliding = sliding, .decay = 1e10};
  string.bit.friction_radius = 1.0;
  string.bit.imposed_weight = 1.0;
  string.bit.advance_law = runtime::AdvanceLaw::none;
  return string;
}

/// The drill string of four discs of [ChengWuChen2018, drillstring.m], uncontrolled.
inline runtime::DrillString four_discs(double torque, double weight) {
  runtime::DrillString string;
  string.torsional = {{930.0, 2782.25, 750.0, 471.9698},
                      {0.0, 698.063, 1080.0, 907.48},
                      {0.0, 139.6126, 190.0, 181.49},
                      {425.0, 0.0, 0.0, 50.0}};
  string.drive = {.imposes_speed = false, .torque = torque};
  string.bit.friction.law = runtime::FrictionLaw::stribeck;  // its default constants are those of that program
  string.bit.friction_radius = 0.155575;
  string.bit.imposed_weight = weight;
  string.bit.advance_law = runtime::AdvanceLaw::none;
  return string;
}

/// The 150 m string, two lumps each way, on rock.
inline runtime::DrillString short_string(double hook_load, double rotation) {
  runtime::DrillString string;
  string.axial = runtime::axial_chain({pipe()}, 2, runtime::Lumping::middle, 0.02);
  string.torsional = runtime::torsional_chain({pipe()}, 2, runtime::Lumping::middle, 0.02);
  string.weights = runtime::lump_weights({pipe()}, 2, 0.0);
  string.drive = {.rotation = rotation, .hook_load = hook_load};
  string.bit.friction.law = runtime::FrictionLaw::smooth;
  string.bit.friction_radius = 0.0802;
  return string;
}

}  // namespace drillstring_test
