#include "studies/well/steady_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/stop.hpp"
#include "runtime/well/saved_state.hpp"
#include "runtime/well/step.hpp"

namespace bitrock::studies {

namespace {

using runtime::Columns, runtime::RigControls, runtime::Vector3, runtime::WellString, runtime::WellStringState;

constexpr double swing = 3.0;  // [s] of drill pipe over some 30 m, the span that a joint of a build may hang free

/// Takes from all motion but the one asked for: `kept` 1 leaves it as it is, 0 leaves nothing.
void fade(WellStringState& state, const RigControls& speeds, double kept) {
  Columns& columns = state.columns;
  for (std::size_t i = 0; i < state.count; ++i) {
    const Vector3 d = vector_at(columns, runtime::direction, i);
    const double inertia =
        1.0 / (columns.at(runtime::inverse_inertia, i) + columns.at(runtime::inverse_inertia_along, i));
    const double lost = 1.0 - kept;
    const auto pull = [&](runtime::Column column, double speed) {
      set_vector(columns, column, i, kept * vector_at(columns, column, i) + (lost * speed) * d);
    };
    pull(runtime::velocity, speeds.feed_speed);
    pull(runtime::momentum, inertia * speeds.drive_speed);
    pull(runtime::rate, speeds.drive_speed);
  }
}

SteadySliding mean_over(const WellString& string, WellStringState& state, const RigControls& speeds, double h,
                        long steps, double kept) {
  const runtime::BitRockSource nothing = runtime::no_excitation();
  SteadySliding mean;
  for (long step = 0; step < steps; ++step) {
    advance(string, state, speeds, nothing, h);
    fade(state, speeds, kept);
    mean.hook_load += state.top.hook_load;
    mean.torque += state.top.drive_torque;
    mean.bit_depth += state.bit.depth;
  }
  for (double SteadySliding::*value : {&SteadySliding::hook_load, &SteadySliding::torque, &SteadySliding::bit_depth})
    mean.*value /= static_cast<double>(steps);
  return mean;
}

}  // namespace

double slow_period(const WellString& string) {
  double quarter = 0.0;
  for (const runtime::StringSection& section : string.sections)
    quarter += section.length / std::sqrt(section.beam.torsion / section.beam.polar_inertia);
  return std::max(swing, 4.0 * quarter);
}

SteadySliding slide_steadily(const WellString& string, const RigControls& speeds, double h) {
  const double period = slow_period(string), rate = 4.0 * std::numbers::pi / period;
  const auto steps = static_cast<long>(std::ceil(period / h));
  double weight = 0.0;
  for (const runtime::StringSection& section : string.sections) weight += section.weight * section.length;
  const double least_torque = 0.01 * weight * string.sections.front().contact_radius;  // that counts as one
  WellStringState state = hung_in_hole(string);
  fade(state, speeds, 0.0);
  RigControls now_at = speeds;
  SteadySliding before;
  bool tight = false;
  for (int k = 1;; ++k) {
    base::throw_if_stopped();
    SteadySliding now = mean_over(string, state, now_at, h, steps, std::exp(-rate * h));
    require_sound(string, state);
    const double change =
        std::max(std::abs(now.hook_load - before.hook_load) / weight,
                 0.1 * std::abs(now.torque - before.torque) / std::max(std::abs(now.torque), least_torque));
    now.steady = tight && change < 2e-4;
    if (now.steady || k == most_periods) return now;
    if (!tight && k >= least_periods && change < 1e-3) {
      tight = true;
      now_at.feed_speed *= 0.1;
    }
    before = now;
  }
}

}  // namespace bitrock::studies
