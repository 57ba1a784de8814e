#include "views/json/well_json.hpp"

#include "base/units.hpp"
#include "views/json/bit_json.hpp"
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

}  // namespace bitrock::views
