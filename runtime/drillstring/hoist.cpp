#include "runtime/drillstring/hoist.hpp"

namespace bitrock::runtime {

namespace {

constexpr double noticed = 0.05;  // [1] of the wanted weight: a rig knows by it that the bit is on bottom

}  // namespace

LinePull line_pull(const Hoist& hoist, const HoistState& block, double position, double velocity) {
  const double stretch = position - block.block, rate = velocity - block.speed;
  if (!(stretch > 0.0)) return {};
  const double spring = hoist.stiffness * stretch;
  const double pull = std::max(0.0, spring + hoist.damping * rate);
  return {.pull = pull, .energy = 0.5 * spring * stretch, .damped = (pull - spring) * rate};
}

double next_block_speed(const Hoist& hoist, HoistState& state, double hanging, double time, double h) {
  state.gauge = smoothed_load(state.gauge, state.pull, time, h);
  if (hoist.rule != HoistRule::autodriller) return hoist.feed;
  const double lost = hanging - state.gauge;
  state.on_bottom = state.on_bottom || lost > noticed * hoist.weight_on_bit;
  double drift = state.drift;
  const double feed = feed_of(hoist.autodriller, hoist.weight_on_bit - lost, h, drift);
  if (state.on_bottom) state.drift = drift;
  return feed;
}

}  // namespace bitrock::runtime
