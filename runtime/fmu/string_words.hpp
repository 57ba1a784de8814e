#pragma once
/// The members of strings and of their states, as words.hpp passes them. A structured binding names all members of a
/// struct, so that one that comes new does not compile before it is listed here; a struct with a base is held to its
/// size instead.

#include "runtime/drillstring/drill_string.hpp"
#include "runtime/fmu/words.hpp"
#include "runtime/well/rig.hpp"
#include "runtime/well/stress.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

// In the namespace of what they pass, so that a list of them finds them.
using fmu::pass, fmu::pass_all;

/// All of a `Vector3`.
template <class Io>
void pass(Io& io, Vector3& v) {
  auto& [x, y, z] = v;
  pass_all(io, x, y, z);
}

/// All of a `MovingAverage`.
template <class Io>
void pass(Io& io, MovingAverage& average) {
  auto& [window, time, value, integral, constant_since, first, count] = average;
  for (auto* ring : {&time, &value, &integral}) {
    for (double& number : *ring) pass(io, number);
  }
  pass_all(io, window, constant_since, first, count);
}

// what acts at the bit

/// All of a `Friction`.
template <class Io>
void pass(Io& io, Friction& friction) {
  auto& [law, smooth, stribeck] = friction;
  auto& [mu0, alpha, beta, gamma, nu] = smooth;
  auto& [resting, sliding, decay] = stribeck;
  pass_all(io, law, mu0, alpha, beta, gamma, nu, resting, sliding, decay);
}

/// All of a `BitRock`.
template <class Io>
void pass(Io& io, BitRock& bit) {
  auto& [friction, radius, law, root, regularized, imposed, threshold, contact, hydraulic, fracture, unloading, source,
         engagement, averaging, weight] = bit;
  auto& [c1, c2] = root;
  auto& [a1, a2, a3, x0] = regularized;
  auto& [stiffness, damping] = contact;
  pass(io, friction);
  pass_all(io, radius, law, c1, c2, a1, a2, a3, x0, imposed, threshold, stiffness, damping, hydraulic, fracture,
           unloading, source, engagement, averaging, weight);
}

/// All of a `BitRockState`.
template <class Io>
void pass(Io& io, BitRockState& bit) {
  auto& [face, progression, twist, weight, advance, friction, fracture, force, torque, mean, known, rotation, smooth] =
      bit;
  pass_all(io, face, progression, twist, weight, advance, friction, fracture, force, torque, mean, known, rotation,
           smooth);
}

/// All of a `Excitation`.
template <class Io>
void pass(Io& io, Excitation& excitation) {
  auto& [mean, deviation] = excitation;
  pass_all(io, mean, deviation);
}

// a string in two dimensions

/// All of a `Chain`.
template <class Io>
void pass(Io& io, Chain& chain) {
  auto& [inertia, stiffness, damping, wall_damping] = chain;
  pass_all(io, inertia, stiffness, damping, wall_damping);
}

/// All of a `DriveControl`.
template <class Io>
void pass(Io& io, DriveControl& control) {
  auto& [inertia, damping, stiffness] = control;
  pass_all(io, inertia, damping, stiffness);
}

/// All of a `TopDrive`.
template <class Io>
void pass(Io& io, TopDrive& drive) {
  auto& [speed, rotation, torque, ramp, hook_load, since, angle_then, rotation_then, torque_then, control] = drive;
  pass_all(io, speed, rotation, torque, ramp, hook_load, since, angle_then, rotation_then, torque_then, control);
}

/// All of an `Autodriller`.
template <class Io>
void pass(Io& io, Autodriller& driller) {
  auto& [proportional, integral, fastest] = driller;
  pass_all(io, proportional, integral, fastest);
}

/// All of a `Hoist`.
template <class Io>
void pass(Io& io, Hoist& hoist) {
  auto& [rule, stiffness, damping, feed, weight, autodriller] = hoist;
  pass_all(io, rule, stiffness, damping, feed, weight, autodriller);
}

/// All of a `HoistState`.
template <class Io>
void pass(Io& io, HoistState& hoist) {
  auto& [block, speed, pull, gauge, drift, on_bottom] = hoist;
  pass_all(io, block, speed, pull, gauge, drift, on_bottom);
}

/// All of a `DrillString`.
template <class Io>
void pass(Io& io, DrillString& string) {
  auto& [axial, weights, torsional, drive, hoist, friction, moment, bit] = string;
  pass_all(io, axial, weights, torsional, drive, hoist, friction, moment, bit);
}

/// All of a `EnergyFlows`.
template <class Io>
void pass(Io& io, EnergyFlows& flows) {
  auto& [a, b, c, d, e, f, g, h, i, j, k] = flows;
  pass_all(io, a, b, c, d, e, f, g, h, i, j, k);
}

/// All of a `ChainMotion`.
template <class Io>
void pass(Io& io, ChainMotion& motion) {
  auto& [position, velocity, acceleration] = motion;
  pass_all(io, position, velocity, acceleration);
}

/// All of a `ChainRoom`.
template <class Io>
void pass(Io& io, ChainRoom& room) {
  auto& [predicted, force] = room;
  pass_all(io, predicted, force);
}

/// All of a `DrillState`.
template <class Io>
void pass(Io& io, DrillState& s) {
  static_assert(sizeof(DrillState) == sizeof(BitRockState) + sizeof(double) + 2 * sizeof(ChainMotion) +
                                          sizeof(HoistState) + sizeof(std::vector<int>) + 2 * sizeof(EnergyFlows) +
                                          2 * sizeof(ChainRoom));
  pass(io, static_cast<BitRockState&>(s));
  pass_all(io, s.time, s.axial, s.torsional, s.hoist, s.sliding, s.work, s.power, s.axial_room, s.torsional_room);
}

// a string in a well

/// All of a `Beam`.
template <class Io>
void pass(Io& io, Beam& beam) {
  auto& [axial, shear, torsion, bending, mass, polar, transverse] = beam;
  pass_all(io, axial, shear, torsion, bending, mass, polar, transverse);
}

/// All of a `StringSection`.
template <class Io>
void pass(Io& io, StringSection& section) {
  auto& [beam, length, segments, radius, weight, added, along, across, spinning, bend] = section;
  pass_all(io, beam, length, segments, radius, weight, added, along, across, spinning, bend);
}

/// All of a `WellArc`.
template <class Io>
void pass(Io& io, WellArc& arc) {
  auto& [begin, length, start, tangent, normal, binormal, curvature] = arc;
  pass_all(io, begin, length, start, tangent, normal, binormal, curvature);
}

/// All of a `HolePiece`.
template <class Io>
void pass(Io& io, HolePiece& piece) {
  auto& [arc, radius, friction, more_at_rest, slip_speed, end_tangent, end_reach] = piece;
  pass_all(io, arc, radius, friction, more_at_rest, slip_speed, end_tangent, end_reach);
}

/// All of a `WellString`.
template <class Io>
void pass(Io& io, WellString& string) {
  auto& [sections, damping, hole, wall, upper_end, growth, pushes, control, drive_inertia, block_mass, longest_grown,
         guided, gauge, on_rock, bit, bit_mass, bit_inertia, tip_force, tip_moment, plain] = string;
  auto& [axial, shear, torsion, bending] = damping;
  auto& [stiffness, of_wall] = wall;
  pass_all(io, sections, axial, shear, torsion, bending, hole, stiffness, of_wall, upper_end, growth, pushes, control,
           drive_inertia, block_mass, longest_grown);
  pass_all(io, guided, gauge, on_rock, bit, bit_mass, bit_inertia, tip_force, tip_moment, plain);
}

/// All of a `RigPlan`.
template <class Io>
void pass(Io& io, RigPlan& plan) {
  auto& [run_in, run_in_speed, ramp, rotation, rotation_ramp, weight, slack_off, drilling, holds, autodriller,
         pipe_weight] = plan;
  pass_all(io, run_in, run_in_speed, ramp, rotation, rotation_ramp, weight, slack_off, drilling);
  pass_all(io, holds, autodriller, pipe_weight);
}

/// All of a `RigState`.
template <class Io>
void pass(Io& io, RigState& rig) {
  auto& [phase, began, felt, hook, off_bottom, fed, drift] = rig;
  pass_all(io, phase, began, felt, hook, off_bottom, fed, drift);
}

/// Its name is not passed: only people ask for it.
template <class Io>
void pass(Io& io, StressPoint& point) {
  auto& [name, above_bit, angle, outer, inner] = point;
  pass_all(io, above_bit, angle, outer, inner);
}

/// All of a `TopState`.
template <class Io>
void pass(Io& io, TopState& top) {
  auto& [length, fed, reference, angle, speed, hook_load, torque, set_angle, set_speed, block_speed, pulled_from] = top;
  pass_all(io, length, fed, reference, angle, speed, hook_load, torque, set_angle, set_speed, block_speed, pulled_from);
}

/// All of a `BitState`.
template <class Io>
void pass(Io& io, BitState& s) {
  static_assert(sizeof(BitState) == sizeof(BitRockState) + 5 * sizeof(double) + 4 * sizeof(Vector3));
  pass(io, static_cast<BitRockState&>(s));
  pass_all(io, s.depth, s.side_force, s.gauge_torque, s.gauge_drag, s.friction, s.side, s.tangent, s.velocity, s.rate);
}

/// All of a `WellWork`.
template <class Io>
void pass(Io& io, WellWork& work) {
  auto& [hoist, drive, growth, tip, dampers, bit] = work;
  pass_all(io, hoist, drive, growth, tip, dampers, bit);
}

/// All of a `RigControls`.
template <class Io>
void pass(Io& io, RigControls& controls) {
  auto& [feed, drive, gives_torque, torque, is_pulled, pull] = controls;
  pass_all(io, feed, drive, gives_torque, torque, is_pulled, pull);
}

/// All of a `WellStringState`.
template <class Io>
void pass(Io& io, WellStringState& state) {
  auto& [time, count, columns, top, bit, work] = state;
  auto& [half, memory] = columns;
  pass_all(io, time, count, half, memory, top, bit, work);
}

}  // namespace bitrock::runtime
