#pragma once
/// A drill string in two dimensions: an axial and a torsional chain that meet at the bit, driven from the top, resisted
/// by the rock. This header holds its parts, its state and one step of time. It reads no files and keeps no history.

#include <vector>

#include "runtime/drillstring/bit_rock.hpp"
#include "runtime/drillstring/chain.hpp"
#include "runtime/drillstring/excitation.hpp"
#include "runtime/drillstring/hoist.hpp"
#include "runtime/laws/top_drive_control.hpp"

namespace bitrock::runtime {

/// Rotation imposed on the first spring, or torque on a drive that is itself the first lump of the torsional chain. So
/// is a drive that gives way: then its control is the first spring, and the rotation is the set one.
struct TopDrive {
  bool imposes_speed = true;                     ///< otherwise a torque
  double rotation = 0.0;                         ///< [rad/s] 0 or more, where it imposes speed
  double torque = 0.0;                           ///< [N m] where it does not
  double ramp = 0.0;                             ///< [s] both grow from 0 to full with `step5` in this time; 0: at once
  double hook_load = 0.0;                        ///< [N] upwards on the first axial lump; of no hoist that is fed
  double since = 0.0;                            ///< [s] time at which it began to go to this rotation or torque
  double angle_then = 0.0, rotation_then = 0.0;  ///< [rad], [rad/s] at that time
  double torque_then = 0.0;                      ///< [N m] at that time
  DriveControl control;                          ///< of a drive that gives way; without inertia: a stiff one
};

/// **What** Angle and speed of an imposing drive at time t.
/// **Equation** omega = omega_0 + (omega_1 - omega_0) step5(s), theta = theta_0 + omega_0 (t - t_0) +
/// (omega_1 - omega_0) T S(s), S(s) = 5/2 s^4 - 3 s^5 + s^6 the integral of step5; s = (t - t_0) / T, from 0 to 1.
/// **Symbols** t_0 [s] `since`; T [s] ramp; omega_0, theta_0 of then; omega_1 [rad/s] `rotation`.
Drive drive_at(const TopDrive& drive, double time);
/// Torque [N m] of a drive that imposes it.
double drive_torque_at(const TopDrive& drive, double time);
/// The drive, which at `time` [s] begins to go from where it is to another rotation [rad/s] or torque [N m], in its
/// ramp.
TopDrive redirected(const TopDrive& drive, double time, double rotation, double torque);
/// Whether the drive is the first lump of the torsional chain.
bool is_lump(const TopDrive& drive);

/// Parts that do not change.
struct DrillString {
  Chain axial;                      ///< empty: the weight on bit is imposed
  std::vector<double> weights;      ///< [N] of each axial lump, downwards
  Chain torsional;                  ///< with the drive as first lump when that imposes torque or gives way
  TopDrive drive;                   ///< what turns the upper end
  Hoist hoist;                      ///< what holds it; one that is fed has the axial spring above the first lump
  Friction wall_friction;           ///< of the wall on the string
  std::vector<double> wall_moment;  ///< [N m] normal force times radius at each torsional lump; empty: none
  BitRock bit;                      ///< what acts at the lower end
};

/// One number for every way energy enters or leaves the string: work since the beginning [J], or power [W].
struct EnergyFlows {
  double drive = 0.0, weight = 0.0, hook = 0.0, hydraulic = 0.0;  ///< done on the string
  double dampers = 0.0, wall_friction = 0.0, bit_friction = 0.0;  ///< taken from it
  double fracture = 0.0, rock_push = 0.0, source = 0.0;           ///< taken by the rock
  double drilling = 0.0;  ///< part of `rock_push` that goes with the moving face; the rest is in spring and damper
};

/// Room a step needs for each chain.
struct ChainRoom {
  std::vector<double> predicted, force;  ///< of one step
};

/// All that changes. Positions are positive downwards, angles in the direction of drilling; everything is of one
/// instant.
struct DrillState : BitRockState {
  double time = 0.0;                     ///< [s]
  ChainMotion axial, torsional;          ///< of both chains
  HoistState hoist;                      ///< of one that is fed
  std::vector<int> sliding;              ///< direction of each torsional lump where dry friction acts, 0: sticks
  EnergyFlows work, power;               ///< [J] so far, [W] at this instant
  ChainRoom axial_room, torsional_room;  ///< what a step needs in between
};

/// Throws `InputError` when the chains and lists do not fit together.
void require_consistent(const DrillString& string);

/// State at the beginning of a string that is consistent. `turning`: already at the speed of the drive, without twist;
/// otherwise at rest. The axial chain is in balance on the bottom when its weight exceeds hook load and jets;
/// `off_bottom` [m] above 0 lifts the bit, unstretched. Under a hoist that is fed the string hangs in balance, on the
/// bottom with its `weight_on_bit`, and sinks as the rock goes away; an autodriller has its integral there.
DrillState beginning(const DrillString& string, const BitRockSource& source, bool turning, double off_bottom);

/// **What** One step of `h` seconds.
/// **Equation** u = v + h a / 2;  q' = q + h u;  a' = F(q', v + h a, t + h) / M;  v' = u + h a' / 2.
/// **Symbols** q, v, a of every lump; F all forces; u velocity half-way.
/// **Source** velocity Verlet with a predicted velocity for forces that depend on it [GrootWarren1997]; forces of the
/// bit as in `runtime/laws/`.
/// **Differences and validity** Second order in h while nothing switches; contact with the rock, sticking, breaking
/// away and the fracture limit are switched at ends of steps, with a first-order error at these instants. Stable for
/// linear chains up to `longest_stable_step`. One call of the source a step. The face moves with the ROP of the
/// instant: with the 0.1 s mean the loop of face and weight would oscillate. Takes no memory (a source may).
void advance(const DrillString& string, DrillState& state, const BitRockSource& source, double h);

/// The same with the speed of the block of a hoist that is fed [m/s] at the end of the step, which it comes to evenly;
/// `planned_block_speed` is that of the case.
void advance(const DrillString& string, DrillState& state, const BitRockSource& source, double h, double block_speed);

/// What the rule of the hoist wants for the end of the next step `h`; what it measures goes on by that step. 0 where
/// the hook load is imposed.
double planned_block_speed(const DrillString& string, DrillState& state, double h);

/// The chain as its modes and its stability have it: a hoist that is fed is the spring above the first lump, taut.
Chain held_axial_chain(const DrillString& string);

/// What the hook bears while the bit is off bottom [N]: weight less jets.
double hanging_load(const DrillString& string);

/// Hook load at this instant [N].
double hook_load(const DrillString& string, const DrillState& state);

/// What the top drive does at this instant.
struct TopRotation {
  double speed = 0.0;   ///< [rad/s] of the drive
  double torque = 0.0;  ///< [N m] of the drive on the string
};
/// For any kind of drive.
TopRotation top_rotation(const DrillString& string, const DrillState& state);

/// Static weight on bit [N]: weight of the string less hook load and jets; imposed where it is imposed; under a hoist
/// that is fed its `weight_on_bit`.
double static_weight_on_bit(const DrillString& string);

/// Where the bit is [m], downwards; on the face of the rock where there is no axial chain.
double bit_position(const DrillString& string, const DrillState& state);

/// Whether speeds and forces are numbers still.
bool is_finite(const DrillState& state);

/// Energy of motion and springs of the string [J], without the rock's.
double stored_energy(const DrillString& string, const DrillState& state);

/// Work done on the string less work taken from it and stored in it since `initial` = stored_energy at the beginning
/// [J]: what the solver lost or made. Of second order in the step.
double energy_residual(const DrillString& string, const DrillState& state, double initial);

}  // namespace bitrock::runtime
