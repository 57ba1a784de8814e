#include "runtime/drillstring/drill_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/errors.hpp"
#include "base/stop.hpp"

namespace bitrock::runtime {

namespace {

/// Longest row of steps in which something held.
struct Longest {
  long long now = 0, ever = 0;

  void add(bool holds) {
    now = holds ? now + 1 : 0;
    ever = std::max(ever, now);
  }
};

struct Observed {
  RunningSpread rotation, weight, total, torque, source_force, source_torque, rop, hook;
  double count = 0.0, at_rest = 0.0, backwards = 0.0, off_bottom = 0.0;
  Longest stop, flight;
};

void observe(const DrillState& state, Observed& seen) {
  seen.hook.add(state.hoist.pull);
  const double rotation = state.torsional.velocity.back();
  seen.rotation.add(rotation);
  seen.weight.add(state.weight_on_bit);
  seen.total.add(state.weight_on_bit + state.source_force);
  seen.torque.add(torque_on_bit(state));
  seen.source_force.add(state.source_force);
  seen.source_torque.add(state.source_torque);
  seen.rop.add(state.rate_of_penetration);
  seen.count += 1.0;
  seen.at_rest += std::abs(rotation) < at_rest ? 1.0 : 0.0;
  seen.backwards += rotation < 0.0 ? 1.0 : 0.0;
  seen.off_bottom += state.weight_on_bit == 0.0 ? 1.0 : 0.0;
  seen.stop.add(rotation < at_rest);
  seen.flight.add(state.weight_on_bit == 0.0);
}

/// `face` [m]: of the rock at the beginning, from where the string counts its own places. Both differ by the lift of a
/// bit that begins off bottom.
void record(const DrillString& string, const DrillState& state, double face, DrillSeries& series) {
  const TopRotation top = top_rotation(string, state);
  series.time_s.push_back(state.time);
  series.bit_rotation_rad_per_s.push_back(state.torsional.velocity.back());
  series.table_rotation_rad_per_s.push_back(top.speed);
  series.weight_on_bit_N.push_back(state.weight_on_bit);
  series.source_force_N.push_back(state.source_force);
  series.rop_m_per_s.push_back(state.rate_of_penetration);
  series.torque_on_bit_N_m.push_back(torque_on_bit(state));
  series.fracture_torque_N_m.push_back(state.fracture_torque);
  series.drive_torque_N_m.push_back(top.torque);
  series.bit_depth_m.push_back(bit_position(string, state) - face);
  series.face_depth_m.push_back(state.face - face);
  series.progression_angle_rad.push_back(state.progression);
  if (!is_fed(string.hoist)) return;
  series.hook_load_N.push_back(hook_load(string, state));
  series.block_speed_m_per_s.push_back(state.hoist.speed);
}

void require_finite(const DrillState& state) {
  if (is_finite(state)) return;
  throw base::SimulationError(
      fmt::format("at {:.6g} s a speed or force of the drill string is no longer a finite number (a shorter "
                  "run.step_ms helps where a vibration grows without limit)",
                  state.time));
}

/// `drilled` [m]: how far the face of the rock has come.
DrillSummary summary_of(const DrillString& string, const DrillState& state, const Observed& seen, double step,
                        double drilled, double residual) {
  DrillSummary summary;
  summary.bit_rotation = seen.rotation.spread();
  summary.weight_on_bit = seen.weight.spread();
  summary.total_force = seen.total.spread();
  summary.torque = seen.torque.spread();
  summary.source_force = seen.source_force.spread();
  summary.source_torque = seen.source_torque.spread();
  summary.rop = seen.rop.spread();
  if (is_fed(string.hoist)) summary.hook_load = seen.hook.spread();
  summary.static_weight_on_bit = static_weight_on_bit(string);
  const Spread& rotation = summary.bit_rotation;
  if (rotation.mean > 0.0) summary.severity = (rotation.highest - rotation.lowest) / (2.0 * rotation.mean);
  summary.share_at_rest = seen.at_rest / seen.count;
  summary.share_backwards = seen.backwards / seen.count;
  summary.share_off_bottom = seen.off_bottom / seen.count;
  summary.longest_stop = static_cast<double>(seen.stop.ever) * step;
  summary.longest_flight = static_cast<double>(seen.flight.ever) * step;
  summary.drilled = drilled;
  const EnergyFlows& work = state.work;
  const double through = std::abs(work.drive) + std::abs(work.weight + work.hook) + std::abs(work.bit_friction) +
                         std::abs(work.dampers) + std::abs(work.fracture);
  summary.energy_residual = through > 0.0 ? residual / through : 0.0;
  return summary;
}

}  // namespace

std::uint64_t seed_of(const DrillCase& drill) {
  if (drill.source.seed >= 0) return static_cast<std::uint64_t>(drill.source.seed);
  return drill.source.kind == SourceKind::bit ? drill.bit.signal.seed : 1;
}

Bit seeded_bit(const DrillCase& drill) {
  Bit bit = drill.bit;
  bit.signal.seed = seed_of(drill);
  return bit;
}

DrillSource make_source(const DrillCase& drill, const std::optional<surrogate::Model>& model) {
  if (drill.source.kind != SourceKind::bit) return {.load = simple_excitation(drill.source, seed_of(drill))};
  require_model(drill, model);
  DrillSource result{.bit = std::make_shared<BitForce>(seeded_bit(drill), *model)};
  result.load = bit_excitation(*result.bit);
  return result;
}

void require_model(const DrillCase& drill, const std::optional<surrogate::Model>& model) {
  if (drill.source.kind == SourceKind::bit && !model)
    throw base::InputError(drill.name + ": the source 'bit' needs a model (excitation.model in the case, or --model)");
}

std::string other_rock(const DrillCase& drill, const surrogate::Model& model) {
  if (drill.rock.empty() || model.rock == drill.rock) return "";
  return fmt::format("the case is about the rock '{}', the model {}", drill.rock,
                     model.rock.empty() ? "does not say of which rock it is" : fmt::format("is of '{}'", model.rock));
}

double step_of(const DrillSchedule& run) {
  return run.sample / std::ceil(run.sample / run.step * (1.0 - 1e-12));  // 10 / 0.1 is a hair above 100 in binary
}

DrillRun run_drill(const DrillCase& drill, const DrillString& string, const DrillSource& source,
                   const base::ProgressCallback& progress) {
  require_stable(drill, string);
  const auto begin = std::chrono::steady_clock::now();
  DrillRun run;
  run.step = step_of(drill.run);
  const auto steps_a_sample = static_cast<long long>(std::llround(drill.run.sample / run.step));
  const auto samples = static_cast<long long>(std::floor(drill.run.duration / drill.run.sample * (1.0 + 1e-12)));

  DrillState state = beginning(string, source.load, drill.run.turning, drill.run.off_bottom);
  const double initial = stored_energy(string, state), face = state.face;
  record(string, state, face, run.series);
  Observed seen;
  for (long long sample = 0; sample < samples; ++sample) {
    if (progress) progress(static_cast<double>(sample) * drill.run.sample, drill.run.duration);
    for (long long i = 0; i < steps_a_sample; ++i) {
      constexpr long long steps_between_looks = 4096;
      if (i % steps_between_looks == 0) base::throw_if_stopped();
      advance(string, state, source.load, run.step);
      if (state.time > drill.run.settling) observe(state, seen);
    }
    require_finite(state);
    record(string, state, face, run.series);
  }
  if (progress) progress(drill.run.duration, drill.run.duration);
  if (seen.count == 0.0) observe(state, seen);

  run.steps = samples * steps_a_sample;
  run.summary = summary_of(string, state, seen, run.step, state.face - face, energy_residual(string, state, initial));
  if (source.bit) {
    run.summary.clamps = source.bit->clamps();
    run.summary.draws = source.bit->draws();
  }
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return run;
}

}  // namespace bitrock::runtime
