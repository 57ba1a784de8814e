#include "views/text/drill_plan_lines.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

/// The lowest six.
std::string listed(const std::vector<double>& frequencies) {
  std::string text;
  for (std::size_t i = 0; i < frequencies.size() && i < 6; ++i)
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", frequencies[i]);
  return frequencies.size() > 6 ? text + ", ..." : text;
}

std::string lines_of(const runtime::DrillModes& modes) {
  std::string lines;
  if (!modes.axial.empty()) lines += fmt::format("axial, bit on rock:   {} Hz\n", listed(modes.axial));
  if (!modes.axial_off_bottom.empty())
    lines += fmt::format("axial, bit off bottom: {} Hz\n", listed(modes.axial_off_bottom));
  return lines + fmt::format("torsional, bit free:  {} Hz\n", listed(modes.torsional));
}

/// What a top drive that gives way is tuned to.
std::string control_line(const runtime::DriveControl& control) {
  if (control.inertia == 0.0) return "";
  return fmt::format("the top drive gives way: {:.4g} kg m2 on {:.4g} N m/rad and {:.4g} N m s/rad\n", control.inertia,
                     control.stiffness, control.damping);
}

double steps_of(const runtime::DrillSchedule& run) {
  return run.duration / runtime::step_of(run);
}

}  // namespace

std::string modes_lines(const runtime::DrillCase& drill, const studies::StringOutlook& outlook) {
  std::string lines = drill.name + "\n" + lines_of(outlook.modes) + control_line(outlook.control);
  if (outlook.forms) {
    lines += fmt::format(
        "closed forms for the pipe alone: continuous, free at the bit: axial ({}) {:.4g}, torsional {:.4g} Hz; equal "
        "lumps: {} Hz\n",
        runtime::is_fed(drill.hoist) ? "on its line" : "free at the top, too", outlook.forms->axial_continuous,
        outlook.forms->torsional_continuous, listed(outlook.forms->equal_lumps));
  }
  if (outlook.steady) {
    const auto [damping, demand] = *outlook.steady;
    lines += fmt::format(
        "steady rotation at {:.4g} rpm: friction takes {:.3g} N m s/rad of damping, the string has {:.3g}: {}\n",
        drill.drive.rotation / base::rpm, demand, damping, demand < damping ? "stable" : "not stable");
  }
  return lines;
}

std::string modes_lines(const runtime::WellCase& well, const studies::WellOutlook& outlook) {
  std::string lines = fmt::format("{}, hanging free of the wall\nat the beginning\n", well.drill.name);
  lines += lines_of(outlook.beginning);
  if (well.plan.run_in > 0.0)
    lines += fmt::format("with the {:g} m of the trip\n", well.plan.run_in) + lines_of(outlook.drilling);
  return lines + control_line(outlook.control);
}

std::string plan_line(const runtime::DrillCase& drill, const studies::DrillPlan& plan) {
  return fmt::format(
      "{}: static weight on bit {:.4g} kN, step {:.4g} ms (stable up to {:.4g} ms), {:.0f} steps, {:.0f} rows\n",
      drill.name, plan.static_weight * 1e-3, plan.step * 1e3, plan.longest_stable_step * 1e3, plan.steps,
      drill.run.duration / drill.run.sample);
}

std::string plan_line(const studies::Comparison& comparison) {
  const runtime::DrillCase& drill = comparison.drill;
  return fmt::format("{}: {} runs, {:g} s each, {:.0f} steps each; a simple source may need up to five trials\n",
                     drill.name, studies::runs_of(comparison), drill.run.duration, steps_of(drill.run));
}

std::string plan_line(const studies::DrillMap& map) {
  const runtime::DrillCase& drill = map.drill;
  return fmt::format("{}: {} hook loads, {} speeds, {} seeds: {} runs of {:g} s and {:.0f} steps\n", drill.name,
                     map.hook_loads_kN.size(), map.rotations_rpm.size(), map.seeds.size(), studies::runs_of(map),
                     drill.run.duration, steps_of(drill.run));
}

}  // namespace bitrock::views
