#include "runtime/well/well_run.hpp"

#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/stop.hpp"
#include "runtime/well/energy.hpp"
#include "runtime/well/equilibrium.hpp"
#include "runtime/well/saved_state.hpp"
#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

void record(const WellStringState& state, WellSeries& series) {
  series.time_s.push_back(state.time);
  series.hook_load_N.push_back(state.top.hook_load);
  series.drive_torque_N_m.push_back(state.top.drive_torque);
  series.drive_rotation_rad_per_s.push_back(state.top.drive_speed);
  series.bit_rotation_rad_per_s.push_back(spin_of(state.columns, 0));
  series.weight_on_bit_N.push_back(state.bit.weight_on_bit);
  series.source_force_N.push_back(state.bit.source_force);
  series.torque_on_bit_N_m.push_back(torque_on_bit(state.bit));
  series.rop_m_per_s.push_back(state.bit.rate_of_penetration);
  series.bit_depth_m.push_back(state.bit.depth);
  series.fed_m.push_back(state.top.fed);
  series.bit_side_force_N.push_back(state.bit.side_force);
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

WellStringState brought_to_rest(const WellCase& well, const WellString& string) {
  WellStringState state = hung_in_hole(string);
  relax(string, state, well.drill.run.step);
  state.bit.face = well.bottom_depth;
  return state;
}

WellStatics statics(const WellCase& well, const WellString& string) {
  require_stable(well, string);
  WellString smooth = string;
  for (HolePiece& piece : smooth.hole) piece.friction = piece.more_at_rest = 0.0;
  WellStringState state = brought_to_rest(well, smooth);
  advance(smooth, state, {}, no_excitation(), well.drill.run.step);
  require_sound(smooth, state);
  WellStatics result{.hook_load = state.top.hook_load, .bit_depth = state.bit.depth};
  const Columns& columns = state.columns;
  for (std::size_t i = state.count - 1; i-- > 0;) {
    const JointLoad<double> load = joint_now(columns, i);
    const Vector3 middle = 0.5 * (lower_end_of(columns, i + 1) + upper_end_of(columns, i));
    const HolePiece& hole = smooth.hole[static_cast<std::size_t>(columns.at(piece, i))];
    result.joints.push_back({.measured_depth = foot_on(hole.arc, middle).measured_depth,
                             .side_force = columns.at(wall_force, i),
                             .tension = load.section_force.x,
                             .moment = std::hypot(load.section_moment.y, load.section_moment.z)});
  }
  return result;
}

void SeenAfterSettling::add(const WellStringState& state) {
  hook.add(state.top.hook_load);
  torque.add(state.top.drive_torque);
  rotation.add(spin_of(state.columns, 0));
  weight.add(state.bit.weight_on_bit);
  source.add(state.bit.source_force);
  source_torque.add(state.bit.source_torque);
  rop.add(state.bit.rate_of_penetration);
}

WellUnderWay begun_run(const WellCase& well, const WellString& string) {
  require_stable(well, string);
  const auto begin = std::chrono::steady_clock::now();
  WellUnderWay way;
  way.run.step = step_of(well.drill.run);
  way.state = brought_to_rest(well, string);
  way.initial = stored_energy(string, way.state, way.run.step).total();
  way.stress.resize(well.stress_points.size());
  way.run.series.stress_Pa.resize(well.stress_points.size());
  way.run.orbits.resize(well.stress_points.size());
  if (well.frames > 0) add_frame(string, way.state, well.drill.pipes, well.drill.fluid_density, way.run.frames);
  way.run.wall_time = seconds_since(begin);
  return way;
}

long long samples_of(const WellCase& well) {
  const DrillSchedule& schedule = well.drill.run;
  return static_cast<long long>(std::floor(schedule.duration / schedule.sample * (1.0 + 1e-12)));
}

void take_sample(const WellCase& well, const WellString& string, const DrillSource& source, WellUnderWay& way) {
  const DrillSchedule& schedule = well.drill.run;
  const double h = way.run.step;
  WellStringState& state = way.state;
  const auto steps = static_cast<long long>(std::llround(schedule.sample / h));
  for (long long i = 0; i < steps; ++i) {
    advance(string, state, controls(well.plan, way.rig, state, h), source.load, h);
    if (state.time > schedule.settling) way.seen.add(state);
  }
  way.run.steps += steps;
  require_sound(string, state);
  record(state, way.run.series);
  for (std::size_t p = 0; p < way.stress.size(); ++p) {
    const double stress = stress_at(string, state, well.stress_points[p], well.drill.fluid_density).normal;
    way.run.series.stress_Pa[p].push_back(stress);
    if (state.time <= schedule.settling) continue;
    way.stress[p].add(stress);
    add_to_orbit(string, state, well.stress_points[p].above_bit, way.run.orbits[p]);
  }
  if (well.every_joint && state.time > schedule.settling) {
    if (way.run.joints.empty()) way.run.joints = joints_of(well, state);
    record_joints(string, state, well.drill.fluid_density, way.run.joints);
  }
  ++way.samples;
  if (is_kept(way.samples, samples_of(well), well.frames))
    add_frame(string, state, well.drill.pipes, well.drill.fluid_density, way.run.frames);
}

WellRun finished_run(const WellCase& well, const WellString& string, const DrillSource& source, WellUnderWay way,
                     const base::ProgressCallback& progress) {
  const auto begin = std::chrono::steady_clock::now();
  const DrillSchedule& schedule = well.drill.run;
  for (const long long samples = samples_of(well); way.samples < samples;) {
    if (progress) progress(static_cast<double>(way.samples) * schedule.sample, schedule.duration);
    base::throw_if_stopped();
    take_sample(well, string, source, way);
  }
  if (progress) progress(schedule.duration, schedule.duration);

  const WellStringState& state = way.state;
  const SeenAfterSettling& seen = way.seen;
  const double work = friction_work_of(state);
  const StringSection& lowest = section_of(string, 0);
  const double bar = segment_length_of(string, 0), passes = 1.0 / (std::numbers::pi * bar);
  WellRun run = std::move(way.run);
  run.summary = {.hook_load = seen.hook.spread(),
                 .drive_torque = seen.torque.spread(),
                 .bit_rotation = seen.rotation.spread(),
                 .weight_on_bit = seen.weight.spread(),
                 .source_force = seen.source.spread(),
                 .rop = seen.rop.spread(),
                 .source_torque = seen.source_torque.spread(),
                 .bit_depth = state.bit.depth,
                 .fed = state.top.fed,
                 .drilled = well.bottom_depth > 0.0 ? state.bit.face - well.bottom_depth : 0.0,
                 .segments = static_cast<int>(state.count),
                 .friction_work = work,
                 .energy_residual = work > 0.0 ? energy_residual(string, state, way.initial, run.step) / work : 0.0,
                 .longest_bar = state.top.length,
                 .axial_pass_band = passes * std::sqrt(lowest.beam.axial / lowest.beam.mass),
                 .torsional_pass_band = passes * std::sqrt(lowest.beam.torsion / lowest.beam.polar_inertia)};
  if (source.bit) {
    run.summary.clamps = source.bit->clamps();
    run.summary.draws = source.bit->draws();
  }
  for (std::size_t p = 0; p < way.stress.size(); ++p)
    run.stresses.push_back({.point = well.stress_points[p],
                            .stress = stress_at(string, state, well.stress_points[p], well.drill.fluid_density),
                            .normal = way.stress[p].spread()});
  run.wall_time += seconds_since(begin);
  return run;
}

WellRun run_well(const WellCase& well, const WellString& string, const DrillSource& source,
                 const base::ProgressCallback& progress) {
  return finished_run(well, string, source, begun_run(well, string), progress);
}

}  // namespace bitrock::runtime
