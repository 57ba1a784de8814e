#include "views/json/cut_json.hpp"

#include "dem2d/step/cost.hpp"

namespace bitrock::views {

namespace {

nlohmann::json as_json(const dem2d::Settled& settled, int forced_entries) {
  if (settled.steps == 0) return {};
  return {{"surface_drop_m", settled.surface_drop},
          {"shortening_m", settled.shortening},
          {"broken_elements", settled.cracks},
          {"settling_steps", settled.steps},
          {"forced_entries", forced_entries}};
}

}  // namespace

nlohmann::json as_json(const peaks::PeakStatistics& s) {
  return {{"amax", s.amax}, {"amean", s.amean}, {"np1", s.np1}, {"np23", s.np23}, {"np4", s.np4}};
}

nlohmann::json as_json(const dem2d::CutRun& run) {
  return {{"discs", run.discs},
          {"joints", run.joints},
          {"step_s", run.step},
          {"steps", run.steps},
          {"cut_length_m", run.cut_length},
          {"duration_s", run.duration},
          {"mean_force_x_N_per_m", run.mean_force_x},
          {"mean_force_y_N_per_m", run.mean_force_y},
          {"specific_energy_Pa", run.specific_energy},
          {"cracks_tensile", run.cracks_tensile},
          {"cracks_shear", run.cracks_shear},
          {"removed_discs", run.removed_discs},
          {"energy_residual_fraction",
           run.energies.empty() ? nlohmann::json() : nlohmann::json(run.energy_residual_fraction)},
          {"energy_injected_fraction",
           run.energies.empty() ? nlohmann::json() : nlohmann::json(run.energy_injected_fraction)},
          {"under_mud", as_json(run.settled, run.forced_entries)},
          {"wall_s", run.wall_time},
          {"ns_per_disc_step", run.nanoseconds_per_disc_step},
          {"features",
           {{"x", as_json(peaks::peak_statistics(run.force_x))}, {"y", as_json(peaks::peak_statistics(run.force_y))}}}};
}

nlohmann::json plan_json(const dem2d::Specimen& bed, double critical_step, const dem2d::CutSchedule& plan) {
  const double steps = static_cast<double>(plan.steps());
  return {{"discs", bed.x.size()},
          {"joints", bed.disc1.size()},
          {"critical_step_s", critical_step},
          {"step_s", plan.step},
          {"steps", steps},
          {"duration_s", steps * plan.step},
          {"expected_minutes", dem2d::expected_core_seconds(steps, static_cast<double>(bed.x.size())) / 60.0}};
}

}  // namespace bitrock::views
