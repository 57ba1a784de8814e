#include "views/json/well_json.hpp"

#include "base/units.hpp"
#include "views/json/bit_json.hpp"
#include "views/json/number_or_null.hpp"
#include "views/json/spread_json.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::WellStatics& statics) {
  nlohmann::json joints = nlohmann::json::array();
  for (const runtime::JointAtRest& joint : statics.joints)
    joints.push_back({{"md_m", joint.measured_depth},
                      {"side_force_N", joint.side_force},
                      {"tension_N", joint.tension},
                      {"bending_moment_N_m", joint.moment}});
  return {
      {"hook_load_N", statics.hook_load}, {"torque_N_m", 0.0}, {"bit_depth_m", statics.bit_depth}, {"joints", joints}};
}

nlohmann::json as_json(const runtime::WellCase& well, const runtime::WellRun& run) {
  const runtime::WellSummary& s = run.summary;
  nlohmann::json points = nlohmann::json::array();
  for (const runtime::StressAtEnd& point : run.stresses)
    points.push_back({{"name", point.point.name},
                      {"md_m", point.stress.measured_depth},
                      {"axial_MPa", point.stress.axial / base::MPa},
                      {"von_mises_MPa", point.stress.von_mises / base::MPa},
                      {"normal_MPa", spread_json(point.normal, base::MPa)}});
  return {{"summary",
           {{"hook_load_N", spread_json(s.hook_load, 1.0)},
            {"drive_torque_N_m", spread_json(s.drive_torque, 1.0)},
            {"bit_rotation_rpm", spread_json(s.bit_rotation, base::rpm)},
            {"weight_on_bit_N", spread_json(s.weight_on_bit, 1.0)},
            {"source_force_N", spread_json(s.source_force, 1.0)},
            {"source_torque_N_m", spread_json(s.source_torque, 1.0)},
            {"rop_m_per_h", spread_json(s.rop, base::m_per_h)},
            {"bit_depth_m", s.bit_depth},
            {"fed_m", s.fed},
            {"drilled_m", s.drilled},
            {"segments", s.segments},
            {"top_segment_m", s.longest_bar},
            {"friction_work_J", s.friction_work},
            {"energy_residual_fraction", s.energy_residual},
            {"axial_pass_band_Hz", s.axial_pass_band},
            {"torsional_pass_band_Hz", s.torsional_pass_band},
            {"clamped", as_json(s.clamps)},
            {"windows", as_json(s.draws)}}},
          {"stress_points", points},
          {"step_s", run.step},
          {"steps", run.steps},
          {"duration_s", well.drill.run.duration},
          {"wall_s", run.wall_time},
          {"times_real_time", well.drill.run.duration / run.wall_time}};
}

nlohmann::json as_json(const studies::ComparedWells& runs) {
  using base::in_units, base::MPa;
  nlohmann::json sources;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    nlohmann::json& of_source = sources[studies::well_source_names[k]] = nlohmann::json::array();
    for (const studies::ComparedWell& run : runs[k]) {
      nlohmann::json points = nlohmann::json::array();
      for (const studies::ComparedPoint& point : run.points)
        points.push_back({{"name", point.damage.name},
                          {"md_m", point.damage.measured_depth},
                          {"damage_per_hour", point.damage.damage_per_hour},
                          {"hours_to_failure", number_or_null(point.damage.hours_to_failure)},
                          {"cycles_per_hour", point.damage.cycles_per_hour},
                          {"largest_range_MPa", in_units(point.damage.largest_range, MPa)},
                          {"mean_MPa", in_units(point.damage.mean, MPa)},
                          {"sd_turning_MPa", in_units(point.bands.turning, MPa)},
                          {"sd_low_MPa", in_units(point.bands.low, MPa)},
                          {"sd_high_MPa", in_units(point.bands.high, MPa)},
                          {"sd_beyond_MPa", in_units(point.bands.beyond, MPa)}});
      of_source.push_back({{"seed", run.seed},
                           {"mismatch", run.mismatch},
                           {"source_force_N", spread_json(run.summary.source_force, 1.0)},
                           {"source_torque_N_m", spread_json(run.summary.source_torque, 1.0)},
                           {"points", points}});
    }
  }
  return {{"sources", sources}};
}

}  // namespace bitrock::views
