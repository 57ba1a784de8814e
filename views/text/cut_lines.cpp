#include "views/text/cut_lines.hpp"

#include <fmt/format.h>

#include "dem2d/step/cost.hpp"
#include "peaks/statistics.hpp"

namespace bitrock::views {

namespace {

std::string energy_line(const dem2d::CutRun& run) {
  if (run.energies.empty()) return "";
  const dem2d::Energies& e = run.energies.back();
  const double percent = e.boundary_work != 0.0 ? 100.0 / e.boundary_work : 0.0;
  return fmt::format(
      "work of the cutter {:.4g} J/m: {:.1f} % friction, {:.1f} % local damping, {:.1f} % dashpots, {:.1f} % breaking, "
      "{:.2f} % switching, {:.1f} % in springs, {:.1f} % in motion, {:.1f} % gone with lost discs; {:.2g} % not "
      "found, {:.2g} % injected\n",
      e.boundary_work, percent * e.friction, percent * e.local_damping, percent * e.dashpots, percent * e.breaking,
      percent * e.switching, percent * (e.strain_joints + e.strain_contacts + e.strain_boundaries), percent * e.kinetic,
      percent * e.removed, 100.0 * run.energy_residual_fraction, 100.0 * run.energy_injected_fraction);
}

std::string mud_line(const dem2d::CutRun& run) {
  if (run.settled.steps == 0) return "";
  std::string line = fmt::format(
      "under the mud the surface sinks by {:.3g} mm before the cut, the bed gets {:.3g} mm "
      "shorter, and {} elements break\n",
      run.settled.surface_drop * 1e3, run.settled.shortening * 1e3, run.settled.cracks);
  if (run.energies.empty()) return line;
  const dem2d::Energies& e = run.energies.back();
  return line + fmt::format("work of the mud {:.4g} J/m, elastic energy of rock that entered {:.4g} J/m\n", e.mud_work,
                            e.entered);
}

std::string peaks_line(const char* axis, const std::vector<double>& force) {
  const peaks::PeakStatistics s = peaks::peak_statistics(force);
  return fmt::format("{}: A_max {:.4g} kN/m, A_mean {:.4g} kN/m, peaks {} + {} + {}\n", axis, s.amax * 1e-3,
                     s.amean * 1e-3, s.np1, s.np23, s.np4);
}

}  // namespace

std::string plan_line(const dem2d::Specimen& bed, double critical_step, const dem2d::CutSchedule& plan) {
  const double steps = static_cast<double>(plan.steps());
  return fmt::format(
      "discs {}, joints {}, critical step {:.3g} s, step {:.3g} s, steps {:.0f}, samples {}, duration {:.4g} s, about "
      "{:.2g} minutes on one core\n",
      bed.x.size(), bed.disc1.size(), critical_step, plan.step, steps, plan.samples, steps * plan.step,
      dem2d::expected_core_seconds(steps, static_cast<double>(bed.x.size())) / 60.0);
}

std::string cut_lines(const dem2d::CutRun& run) {
  return fmt::format(
             "{} discs, {} joints, {} steps of {:.3g} s, {:.1f} s on the clock ({:.0f} ns per disc and step)\n"
             "mean force x {:.4g}, y {:.4g} kN/m; specific energy {:.3g} MPa; cracks {} in tension, {} in shear\n",
             run.discs, run.joints, run.steps, run.step, run.wall_time, run.nanoseconds_per_disc_step,
             run.mean_force_x * 1e-3, run.mean_force_y * 1e-3, run.specific_energy * 1e-6, run.cracks_tensile,
             run.cracks_shear) +
         mud_line(run) + energy_line(run) + peaks_line("x", run.force_x) + peaks_line("y", run.force_y);
}

}  // namespace bitrock::views
