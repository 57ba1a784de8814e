#pragma once
/// What holds the upper end of a string in two dimensions along its axis: a force, or a block that is fed and holds the
/// string by the spring of drill line and derrick. Hook load is then an outcome.

#include "runtime/laws/autodriller.hpp"

namespace bitrock::runtime {

/// Who says how the hoist moves.
enum class HoistRule {
  load,        ///< nobody: it is a constant force, `TopDrive::hook_load`
  feed,        ///< the block goes down at one speed
  autodriller  ///< the block goes down so that the hook loses the weight that the bit is to bear
};

/// Parts that do not change.
struct Hoist {
  HoistRule rule = HoistRule::load;  ///< who moves the block
  double stiffness = 0.0;            ///< [N/m] of drill line and derrick, and of the pipe above the first lump
  double damping = 0.0;              ///< [N s/m] beside it
  double feed = 0.0;                 ///< [m/s] of the block, downwards, where it has one speed
  double weight_on_bit = 0.0;        ///< [N] at the beginning on bottom; what an autodriller holds
  Autodriller autodriller;           ///< where it is one
};

/// Of a hoist that is fed.
struct HoistState {
  double block = 0.0;      ///< [m] where the block is, downwards; the line is free when the first lump is there
  double speed = 0.0;      ///< [m/s] of the block, downwards
  double pull = 0.0;       ///< [N] of the line on the string, upwards: the hook load
  double gauge = 0.0;      ///< [N] the same, smoothed as a rig tells it
  double drift = 0.0;      ///< [m/s] integral of the autodriller
  bool on_bottom = false;  ///< the hook has lost weight: the integral runs
};

/// Whether the block is fed.
inline bool is_fed(const Hoist& hoist) {
  return hoist.rule != HoistRule::load;
}

/// Of the line at one instant.
struct LinePull {
  double pull = 0.0;    ///< [N] on the string, upwards
  double energy = 0.0;  ///< [J] in the spring
  double damped = 0.0;  ///< [W] taken by the damper
};

/// **What** Pull of the line on the first lump, as that of the hoist in a well (`load_table`).
/// **Equation** H = max(0, k e + c e') where e > 0, otherwise 0.
/// **Symbols** e [m] how far the lump hangs below the block; k, c of the hoist.
/// **Validity** A line only pulls: it goes slack, and its damper takes at most what the spring has.
LinePull line_pull(const Hoist& hoist, const HoistState& block, double position, double velocity);

/// **What** Speed of the block at the end of a step that begins at `time`, by the rule of the hoist; the gauge and the
/// integral of the autodriller go on by the step `h` [s].
/// **Equation** missing = W* - (H_0 - H), with the smoothed H; the feed follows from it by `feed_of`.
/// **Symbols** H_0 [N] `hanging`: hook load off bottom, which the rig has read before; W* [N] `weight_on_bit`.
/// **Differences and validity** Until the hook has lost 5 % of W* the integral waits, so that a string that is lowered
/// to bottom comes with K_p W*: it is brought to W* as `autodriller_for` says for a weight that is missing whole. A
/// rock that goes away faster than that before it bears 5 % of W* is not caught up with.
double next_block_speed(const Hoist& hoist, HoistState& state, double hanging, double time, double h);

}  // namespace bitrock::runtime
