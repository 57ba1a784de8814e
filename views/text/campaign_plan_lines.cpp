#include "views/text/campaign_plan_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/progress.hpp"
#include "base/units.hpp"

namespace bitrock::views {

namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr std::size_t most_lines = 20;  // of depths: a table may hold a million

}  // namespace

std::string plan_lines(const studies::Plan& plan, double ns_per_disc_step) {
  std::string text = fmt::format("{} cases, {} cuts: {} done, {} failed, {} remaining; {} rocks, {} to be made\n",
                                 plan.cases, plan.jobs, plan.done, plan.failed, plan.jobs - plan.done - plan.failed,
                                 plan.rocks, plan.rocks_to_make);
  for (const studies::PlanPart& part : std::span(plan.parts).first(std::min(most_lines, plan.parts.size()))) {
    text += fmt::format(
        "depth {:g} mm: {} cuts of {:g} mm in {:g} x {:g} mm, {:.0f} discs; {:.3g} steps, {:.3g} core-hours\n",
        base::in_units(part.depth_of_cut, base::mm), part.jobs, base::in_units(part.cut_length, base::mm),
        base::in_units(part.bed_length, base::mm), base::in_units(part.bed_height, base::mm), part.discs, part.steps,
        part.core_time / seconds_per_hour);
  }
  if (plan.parts.size() > most_lines) text += fmt::format("and {} more depths\n", plan.parts.size() - most_lines);
  return text + fmt::format(
                    "{:.3g} steps, {:.3g} disc-steps: about {:.3g} core-hours at {:g} ns per disc and step; the "
                    "longest cut {}\n",
                    plan.steps, plan.disc_steps, plan.core_time / seconds_per_hour, ns_per_disc_step,
                    base::readable_duration(plan.longest_cut));
}

}  // namespace bitrock::views
