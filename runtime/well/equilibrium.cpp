#include "runtime/well/equilibrium.hpp"

#include <cmath>

#include "runtime/well/step.hpp"

namespace bitrock::runtime {

void slow_down(WellStringState& state, double factor) {
  for (const Column column : {velocity, momentum, rate}) {
    double* values = state.columns[column];
    for (std::size_t k = 0; k < 3 * state.columns.stride(); ++k) values[k] *= factor;
  }
}

void forget_motion(WellStringState& state) {
  slow_down(state, 0.0);
  state.work = {};
  for (const Column column : {damper_work, wall_work, friction_work, drag_work}) {
    double* values = state.columns[column];
    for (std::size_t k = 0; k < state.columns.stride(); ++k) values[k] = 0.0;
  }
}

void relax(const WellString& string, WellStringState& state, double h) {
  WellString smooth = string;
  for (HolePiece& hole : smooth.hole) hole.friction = hole.more_at_rest = 0.0;
  smooth.on_rock = false;
  const BitRockSource nothing = no_excitation();
  const double time = state.time;
  for (const Column column : {friction, friction_more}) {
    double* mu = state.columns[column];
    for (std::size_t k = 0; k < state.columns.stride(); ++k) mu[k] = 0.0;
  }
  const struct { double rate, duration; } phases[] = {{3.0, 8.0}, {0.8, 4.0}};
  for (const auto& phase : phases) {
    const double factor = std::exp(-phase.rate * h);
    for (long step = 0; step < static_cast<long>(phase.duration / h); ++step) {
      advance(smooth, state, {}, nothing, h);
      slow_down(state, factor);
    }
  }
  forget_motion(state);
  state.time = time;
  for (std::size_t i = 0; i + 1 < state.count; ++i) renew_piece(string, state.columns, i);
}

}  // namespace bitrock::runtime
