#pragma once
/// What the driller does from tripping in to drilling, step by step: run in, begin to turn, go to bottom, drill.

#include "runtime/laws/autodriller.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// The plan. Every change of speed takes a ramp, a smooth step of degree five.
struct RigPlan {
  double run_in = 0.0;            ///< [m] of pipe that is fed while the string does not turn
  double run_in_speed = 1.0;      ///< [m/s]
  double ramp = 2.0;              ///< [s] to that speed, and from it
  double rotation = 0.0;          ///< [rad/s] of the drive afterwards
  double rotation_ramp = 6.0;     ///< [s]
  double weight_on_bit = 0.0;     ///< [N] to slack off to; 0: the bit stays where it is, off bottom
  double slack_off_speed = 0.05;  ///< [m/s] of that
  double drilling_speed = 0.0;    ///< [m/s] of the feed afterwards; 0: as fast as the rock's face goes
  bool holds_weight = false;      ///< the autodriller feeds instead, so that the weight on bit stays
  Autodriller autodriller;        ///< of that
  double pipe_weight = 0.0;       ///< [N/m] of new pipe in the mud, which the hook bears besides
};

/// What it is at.
enum class RigPhase : int {
  running_in,        ///< pipe is fed, nothing turns
  starting_to_turn,  ///< the drive comes to its speed
  slacking_off,      ///< pipe is fed until the rock bears the weight on bit
  drilling           ///< pipe is fed at the drilling speed
};

/// Where the plan stands.
struct RigState {
  RigPhase phase = RigPhase::running_in;  ///< now
  double began = 0.0;                     ///< [s] time at which the phase began
  double felt = 0.0;                      ///< [N] push of the rock, smoothed over a second
  double hook = 0.0;                      ///< [N] hook load, smoothed alike
  double off_bottom = 0.0;                ///< [N] the same when the string turned off bottom, before it was slacked off
  double fed = 0.0;                       ///< [m] pipe that had come through the table by then
  double drift = 0.0;                     ///< [m/s] integral of the autodriller
};

/// Speed of the feed and of the drive for the step that begins now; goes on to the next phase where it is time. `h` [s]
/// is the length of the step.
RigControls controls(const RigPlan& plan, RigState& rig, const WellStringState& state, double h);

}  // namespace bitrock::runtime
