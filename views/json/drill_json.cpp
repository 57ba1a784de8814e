#include "views/json/drill_json.hpp"

#include <cmath>

#include "base/units.hpp"
#include "views/json/bit_json.hpp"
#include "views/json/spread_json.hpp"

namespace bitrock::views {

namespace {

using base::m_per_h, base::rpm;

nlohmann::json forms_json(const std::optional<runtime::ClosedForms>& forms) {
  if (!forms)
    return {{"axial_continuous_Hz", nullptr}, {"torsional_continuous_Hz", nullptr}, {"equal_lumps_Hz", nullptr}};
  return {{"axial_continuous_Hz", forms->axial_continuous},
          {"torsional_continuous_Hz", forms->torsional_continuous},
          {"equal_lumps_Hz", forms->equal_lumps}};
}

nlohmann::json control_json(const runtime::DriveControl& control) {
  if (control.inertia == 0.0) return nullptr;
  return {{"inertia_kg_m2", control.inertia},
          {"stiffness_N_m_per_rad", control.stiffness},
          {"damping_N_m_s_per_rad", control.damping}};
}

nlohmann::json steady_json(const std::optional<runtime::Steadiness>& steady) {
  if (!steady) return nullptr;
  return {{"equivalent_damping_N_m_s_per_rad", steady->damping},
          {"friction_demand_N_m_s_per_rad", steady->demand},
          {"stable", steady->demand < steady->damping}};
}

}  // namespace

nlohmann::json as_json(const runtime::DrillSummary& s) {
  return {{"bit_rotation_rpm", spread_json(s.bit_rotation, rpm)},
          {"weight_on_bit_N", spread_json(s.weight_on_bit, 1.0)},
          {"total_force_N", spread_json(s.total_force, 1.0)},
          {"torque_on_bit_N_m", spread_json(s.torque, 1.0)},
          {"source_force_N", spread_json(s.source_force, 1.0)},
          {"source_torque_N_m", spread_json(s.source_torque, 1.0)},
          {"rop_m_per_h", spread_json(s.rop, m_per_h)},
          {"hook_load_N", s.hook_load ? spread_json(*s.hook_load, 1.0) : nullptr},
          {"static_weight_on_bit_N", s.static_weight_on_bit},
          {"severity", s.severity},
          {"share_at_rest", s.share_at_rest},
          {"share_backwards", s.share_backwards},
          {"share_off_bottom", s.share_off_bottom},
          {"longest_stop_s", s.longest_stop},
          {"longest_flight_s", s.longest_flight},
          {"drilled_m", s.drilled},
          {"energy_residual_fraction", s.energy_residual},
          {"clamped", as_json(s.clamps)},
          {"windows", as_json(s.draws)}};
}

nlohmann::json as_json(const runtime::DrillCase& drill, const runtime::DrillRun& run) {
  return {{"summary", as_json(run.summary)},
          {"step_s", run.step},
          {"steps", run.steps},
          {"duration_s", drill.run.duration},
          {"wall_s", run.wall_time},
          {"times_real_time", drill.run.duration / run.wall_time}};
}

nlohmann::json as_json(const studies::StringOutlook& outlook) {
  return {{"axial_Hz", outlook.modes.axial},
          {"axial_off_bottom_Hz", outlook.modes.axial_off_bottom},
          {"torsional_Hz", outlook.modes.torsional},
          {"closed_forms", forms_json(outlook.forms)},
          {"steady_rotation", steady_json(outlook.steady)},
          {"top_drive", control_json(outlook.control)},
          {"longest_stable_step_s", outlook.longest_stable_step}};
}

nlohmann::json as_json(const studies::WellOutlook& outlook) {
  return {{"axial_Hz", outlook.drilling.axial},
          {"axial_off_bottom_Hz", outlook.drilling.axial_off_bottom},
          {"torsional_Hz", outlook.drilling.torsional},
          {"at_the_beginning",
           {{"axial_Hz", outlook.beginning.axial},
            {"axial_off_bottom_Hz", outlook.beginning.axial_off_bottom},
            {"torsional_Hz", outlook.beginning.torsional}}},
          {"top_drive", control_json(outlook.control)},
          {"longest_stable_step_s", outlook.longest_stable_step}};
}

nlohmann::json as_json(const runtime::DrillCase& drill, const studies::DrillPlan& plan) {
  return {{"static_weight_on_bit_N", plan.static_weight},
          {"step_s", plan.step},
          {"longest_stable_step_s", plan.longest_stable_step},
          {"steps", plan.steps},
          {"rows", std::floor(drill.run.duration / drill.run.sample) + 1.0}};
}

nlohmann::json as_json(const studies::MapTally& seen, std::size_t runs, double wall_time) {
  return {{"runs", runs},
          {"steady", seen.steady},
          {"stick_slip", seen.stick_slip},
          {"bit_bounce", seen.bit_bounce},
          {"failed", seen.failed},
          {"wall_s", wall_time}};
}

nlohmann::json as_json(const studies::ComparedRuns& runs) {
  nlohmann::json sources;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    nlohmann::json list = nlohmann::json::array();
    for (const studies::ComparedRun& run : runs[k]) {
      list.push_back({{"seed", run.seed},
                      {"summary", as_json(run.summary)},
                      {"steady", run.condition.steady},
                      {"stick_slip", run.condition.stick_slip},
                      {"bit_bounce", run.condition.bit_bounce},
                      {"mismatch", run.mismatch}});
    }
    sources[studies::source_names[k]] = list;
  }
  return {{"sources", sources}};
}

}  // namespace bitrock::views
