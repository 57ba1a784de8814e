// bitrock campaign plan: what a study will cost.
#include "studies/campaign/plan.hpp"

#include <ranges>

#include "base/units.hpp"
#include "cli/campaign.hpp"

namespace bitrock::cli {

namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr std::size_t most_lines = 20;  // of depths: a table may hold a million

struct Options {
  CampaignOptions campaign;
  double ns_per_disc_step = dem2d::typical_ns_per_disc_step;
};

}  // namespace

void print_plan(const CampaignOptions& options, const studies::Study& study, double ns_per_disc_step) {
  const studies::Plan plan = studies::plan(study, options.folder, ns_per_disc_step);
  const int remaining = plan.jobs - plan.done - plan.failed;
  say(options.common, "{} cases, {} cuts: {} done, {} failed, {} remaining; {} rocks, {} to be made\n", plan.cases,
      plan.jobs, plan.done, plan.failed, remaining, plan.rocks, plan.rocks_to_make);
  for (const studies::PlanPart& part : plan.parts | std::views::take(most_lines)) {
    say(options.common,
        "depth {:g} mm: {} cuts of {:g} mm in {:g} x {:g} mm, {:.0f} discs; {:.3g} steps, {:.3g} core-hours\n",
        base::in_units(part.depth_of_cut, base::mm), part.jobs, base::in_units(part.cut_length, base::mm),
        base::in_units(part.bed_length, base::mm), base::in_units(part.bed_height, base::mm), part.discs, part.steps,
        part.core_time / seconds_per_hour);
  }
  if (plan.parts.size() > most_lines) say(options.common, "and {} more depths\n", plan.parts.size() - most_lines);
  say(options.common,
      "{:.3g} steps, {:.3g} disc-steps: about {:.3g} core-hours at {:g} ns per disc and step; the longest "
      "cut {}\n",
      plan.steps, plan.disc_steps, plan.core_time / seconds_per_hour, ns_per_disc_step,
      base::readable_duration(plan.longest_cut));
  write_json(options.common, {{"cases", plan.cases},
                              {"jobs", plan.jobs},
                              {"done", plan.done},
                              {"failed", plan.failed},
                              {"remaining", remaining},
                              {"core_seconds", plan.core_seconds},
                              {"rocks", plan.rocks},
                              {"rocks_to_make", plan.rocks_to_make},
                              {"most_discs", plan.most_discs},
                              {"steps", plan.steps},
                              {"disc_steps", plan.disc_steps},
                              {"core_hours", plan.core_time / seconds_per_hour},
                              {"longest_cut_s", plan.longest_cut},
                              {"ns_per_disc_step", ns_per_disc_step}});
}

void add_campaign_plan(CLI::App& campaign) {
  auto options = std::make_shared<Options>();
  CLI::App* command = add_campaign_action(campaign, "plan", "Says how many discs, steps and core-hours a study costs.",
                                          options->campaign);
  command->add_option("--dir", options->campaign.folder, "What is already cut in this folder does not count.")
      ->check(not_empty());
  command
      ->add_option("--ns-per-disc-step", options->ns_per_disc_step,
                   "One core of your machine takes so many nanoseconds for one step of one disc.")
      ->check(within("--ns-per-disc-step", base::between(0.01, 1e6)))
      ->capture_default_str();
  command->callback([options] {
    find_study(options->campaign);
    require_outputs(options->campaign.common, {options->campaign.study_file}, {});
    print_plan(options->campaign, study_of(options->campaign), options->ns_per_disc_step);
  });
}

}  // namespace bitrock::cli
