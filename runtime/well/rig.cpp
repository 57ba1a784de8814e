#include "runtime/well/rig.hpp"

#include <algorithm>

#include "runtime/signal/step5.hpp"

namespace bitrock::runtime {

namespace {

/// 0 to 1 within a ramp, in the middle of the step.
double risen(double time, double ramp) {
  return ramp > 0.0 ? step5(time, 0.0, 0.0, ramp, 1.0) : 1.0;
}

/// As fast as the rock goes away.
double drilling_speed(const RigPlan& plan, const BitState& bit) {
  return plan.drilling_speed > 0.0 ? plan.drilling_speed : mean(bit.smooth_advance);
}

}  // namespace

RigControls controls(const RigPlan& plan, RigState& rig, const WellStringState& state, double h) {
  const BitState& bit = state.bit;
  const double newer = std::min(1.0, h / load_smoothing);
  rig.felt += newer * (bit.weight_on_bit + bit.source_force - rig.felt);
  rig.hook = smoothed_load(rig.hook, state.top.hook_load, state.time, h);
  const double since = state.time - rig.began, middle = since + 0.5 * h;
  const auto next = [&](RigPhase phase) {
    rig.phase = phase;
    rig.began = state.time;
    return controls(plan, rig, state, 0.0);
  };
  switch (rig.phase) {
    case RigPhase::running_in: {
      // the two ramps together are as long a way as one of them at full speed
      const double whole = plan.run_in > 0.0 ? plan.run_in / plan.run_in_speed + plan.ramp : 0.0;
      if (since >= whole) return next(RigPhase::starting_to_turn);
      return {.feed_speed = plan.run_in_speed * risen(middle, plan.ramp) * risen(whole - middle, plan.ramp)};
    }
    case RigPhase::starting_to_turn:
      if (since >= plan.rotation_ramp && plan.weight_on_bit > 0.0) {
        rig.off_bottom = rig.hook;
        rig.fed = state.top.fed;
        return next(RigPhase::slacking_off);
      }
      return {.drive_speed = plan.rotation * risen(middle, plan.rotation_ramp)};
    case RigPhase::slacking_off: {
      if (rig.felt >= 0.95 * plan.weight_on_bit) {
        rig.drift = drilling_speed(plan, bit);
        return next(RigPhase::drilling);
      }
      // slower as the weight comes near what is asked: what is felt lags behind
      const double missing = std::clamp(1.0 - rig.felt / plan.weight_on_bit, 0.0, 1.0);
      const double extra = (plan.slack_off_speed - drilling_speed(plan, bit)) * missing;
      return {.feed_speed = risen(middle, plan.ramp) * (drilling_speed(plan, bit) + extra),
              .drive_speed = plan.rotation};
    }
    case RigPhase::drilling:
      break;
  }
  if (!plan.holds_weight) return {.feed_speed = drilling_speed(plan, bit), .drive_speed = plan.rotation};
  // what the hook has lost since the string turned off bottom is on the bit, as far as a rig can know
  const double heavier = plan.pipe_weight * (state.top.fed - rig.fed);
  const double missing = plan.weight_on_bit - (rig.off_bottom + heavier - rig.hook);
  return {.feed_speed = feed_of(plan.autodriller, missing, h, rig.drift), .drive_speed = plan.rotation};
}

}  // namespace bitrock::runtime
