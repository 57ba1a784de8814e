#pragma once
/// A drill string in a deviated well: rigid segments that are held together by springs, hang from the table, lie
/// against the wall of a curved hole, and carry the bit. This header holds its parts and its state. It reads no files.

#include <cstdint>
#include <vector>

#include "runtime/drillstring/drill_string.hpp"
#include "runtime/well/beam.hpp"
#include "runtime/well/columns.hpp"
#include "runtime/well/hole.hpp"
#include "runtime/well/wall_law.hpp"

namespace bitrock::runtime {

/// Of travelling block, hook and top drive, which move together: some 10 t and 12 t for rigs of 500 t, as recalled from
/// makers' data sheets, not from a table [kg]. A heavier one answers later.
inline constexpr double usual_block_mass = 22e3;

/// A stretch of string of one kind, cut into segments of equal length.
struct StringSection {
  Beam beam;                    ///< of the pipe
  double length = 0.0;          ///< [m]
  int segments = 0;             ///< 1 or more
  double contact_radius = 0.0;  ///< [m] with which its joints touch the wall: of the body, or of tool joints
  double weight = 0.0;          ///< [N/m] in the mud
  double added_mass = 0.0;      ///< [kg/m] of mud that moves with the pipe across its axis
  double drag_along = 0.0;      ///< [N s/m^2] of the mud, per metre, against motion along the axis
  double drag_across = 0.0;     ///< [N s/m^2] the same, across
  double drag_spinning = 0.0;   ///< [N s] per metre, against spin
  Vector3 bend;                 ///< [rad/m] of the unloaded pipe, in the frame of its segments
};

/// Material damping: each damper of a joint is its spring times this.
struct MaterialDamping {
  double axial = 2e-4, shear = 2e-4, torsion = 2e-4;  ///< [s] 10 % of critical at the top of the pass band of 10 m
  double bending = 2e-5;  ///< [s] less: a bent string that turns feels 2 U beta Omega of it as torque
};

/// What holds the upper end.
enum class UpperEnd {
  free,     ///< nothing
  clamped,  ///< a wall that does not move, through half a joint
  table     ///< hoist and drive: see `top_end.hpp`
};

/// How the string becomes longer at the table.
enum class Growth {
  grow,  ///< the uppermost segment alone becomes longer [BitRock2026, sec. 4.2]
  split  ///< and gives off a segment of the usual length when it is twice as long
};

/// Parts that do not change.
struct WellString {
  std::vector<StringSection> sections;         ///< from top to bottom
  MaterialDamping damping;                     ///< of the joints
  std::vector<HolePiece> hole;                 ///< from top to bottom; empty: no wall
  WallSpring wall;                             ///< of the hole
  UpperEnd upper_end = UpperEnd::free;         ///< what holds it
  Growth growth = Growth::split;               ///< at the table
  bool hoist_pushes = false;                   ///< a hoist that holds both ways; otherwise a line, which goes slack
  DriveControl control;                        ///< of a drive at the table that gives way; without inertia: a stiff one
  double drive_inertia = usual_drive_inertia;  ///< [kg m^2] of a drive that gives a torque (`RigControls`)
  double block_mass = usual_block_mass;        ///< [kg] of a block that a pull moves (`RigControls`)
  double longest_grown = 0.0;                  ///< [m] most pipe that is added
  bool guided = false;                         ///< the lower end is held on the centre line of the hole
  double gauge_radius = 0.0;      ///< [m] of a guided bit that rubs on the hole like a joint; 0: it does not
  bool on_rock = false;           ///< the laws at the bit act, on the piece of the hole it is in
  BitRock bit;                    ///< those laws
  double bit_mass = 0.0;          ///< [kg] at the centre of the lowest segment
  double bit_inertia = 0.0;       ///< [kg m^2] of the bit about the axis
  Vector3 tip_force, tip_moment;  ///< [N], [N m] on the lower end, in the world
  bool plain_vectors = false;     ///< on a machine with wide vectors, too: the same bits, only slower
};

/// What the rig does in one step.
struct RigControls {
  double feed_speed = 0.0;    ///< [m/s] of new pipe through the table, downwards
  double drive_speed = 0.0;   ///< [rad/s] of the drive; of one that gives way, the set speed
  bool gives_torque = false;  ///< the drive is an inertia under `torque` instead
  double torque = 0.0;        ///< [N m] of the motor, forward
  bool is_pulled = false;     ///< the block is a mass under `pull` instead, and feeds with the speed that it comes to
  double pull = 0.0;  ///< [N] of the drill line, upwards, less the weight of block, drive and the pipe above the
                      ///< table: the hook load that it is in balance with
};

/// At the table.
struct TopState {
  double length = 0.0;        ///< [m] of the uppermost segment
  double fed = 0.0;           ///< [m] pipe that came through the table
  double reference = 0.0;     ///< [m] depth at which the hoist's spring is free
  double drive_angle = 0.0;   ///< [rad] turned
  double drive_speed = 0.0;   ///< [rad/s] of the last step
  double hook_load = 0.0;     ///< [N] of the hoist on the string, upwards
  double drive_torque = 0.0;  ///< [N m] of the drive on the string, forward
  double set_angle = 0.0;     ///< [rad] that a drive which gives way is to have turned
  double set_speed = 0.0;     ///< [rad/s] that it was to have in the last step
  double block_speed = 0.0;   ///< [m/s] of the hoist in the last step, downwards
  double pulled_from = 0.0;   ///< [m] `fed` when the block began to be pulled; now, while it is not
};

/// At the bit.
struct BitState : BitRockState {
  double depth = 0.0;       ///< [m] measured depth of the bit, along the hole; `face` is measured alike
  double side_force = 0.0;  ///< [N] of the hole that guides the bit
  double gauge_torque = 0.0, gauge_drag = 0.0;  ///< [N m], [N] of its friction there, against turning and down the hole
  double friction = 0.0;                        ///< [1] of the hole at the bit
  Vector3 side;                                 ///< unit vector from the centre line to the lower end
  Vector3 tangent;                              ///< down the hole at the bit
  Vector3 velocity;                             ///< [m/s] of the lower end before the step
  Vector3 rate;                                 ///< [rad/s] of the lowest segment before the step
};

/// Work so far [J]; besides the columns of joints and segments.
struct WellWork {
  double hoist = 0.0;    ///< done on the string by moving the hoist's reference; 0 while it stands
  double drive = 0.0;    ///< done on the string
  double growth = 0.0;   ///< done on the string by new pipe
  double tip = 0.0;      ///< done by `tip_force` and `tip_moment`
  double dampers = 0.0;  ///< taken by the dampers of hoist, drive and guide
  double bit = 0.0;      ///< taken by the rock: push, source, friction and breaking
};

/// All that changes. Copying it saves it, to the last bit; a bit's source has its own (`BitForce::save`).
struct WellStringState {
  double time = 0.0;      ///< [s] of positions; velocities are half a step older
  std::size_t count = 0;  ///< segments
  Columns columns;        ///< of segments and joints
  TopState top;           ///< at the table
  BitState bit;           ///< at the bit
  WellWork work;          ///< so far
};

/// What segment i, counted from the bit, is cut from; and its length [m] when it was.
const StringSection& section_of(const WellString& string, std::size_t i);
/// Its length when it was cut [m].
double segment_length_of(const WellString& string, std::size_t i);
/// Segments at the beginning.
std::size_t segment_count(const WellString& string);

/// Throws `InputError` when the parts do not make a string.
void require_consistent(const WellString& string);

/// The string without any load in it, at rest: its upper end at `origin`, its uppermost segment along `frame`.
WellStringState unloaded(const WellString& string, const Vector3& origin, const Rotation& frame);

/// The string laid along the centre line of its hole from the table down, stretched by its weight as if it hung without
/// friction, at rest. In a vertical hole this is its equilibrium.
WellStringState hung_in_hole(const WellString& string);

/// Sets what segment i is: mass, inertia, weight, drag, for a length [m].
void set_segment(const WellString& string, Columns& columns, std::size_t i, double length);
/// Sets springs and dampers of joint i, below segment i + 1; a `wall` above it has no compliance.
void set_joint(const WellString& string, Columns& columns, std::size_t i, bool wall);
/// Sets direction and rate of the segment at a place from frame and momentum.
void renew_derived(Columns& columns, std::size_t place);
/// Puts joint i into the piece of the hole it lies in.
void renew_piece(const WellString& string, Columns& columns, std::size_t i);

/// The upper end of segment i [m].
Vector3 upper_end_of(const Columns& columns, std::size_t i);
/// The lower end [m].
Vector3 lower_end_of(const Columns& columns, std::size_t i);
/// Velocity of the upper end [m/s].
Vector3 upper_velocity_of(const Columns& columns, std::size_t i);
/// Velocity of the lower end [m/s].
Vector3 lower_velocity_of(const Columns& columns, std::size_t i);
/// Spin about the axis [rad/s].
double spin_of(const Columns& columns, std::size_t i);

}  // namespace bitrock::runtime
