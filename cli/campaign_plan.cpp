// bitrock campaign plan: what a study will cost.
#include "studies/campaign/plan.hpp"

#include "cli/campaign.hpp"
#include "views/json/campaign_json.hpp"
#include "views/text/campaign_plan_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CampaignOptions campaign;
  double ns_per_disc_step = dem2d::typical_ns_per_disc_step;
};

}  // namespace

void print_plan(const CampaignOptions& options, const studies::Study& study, double ns_per_disc_step) {
  const studies::Plan plan = studies::plan(study, options.folder, ns_per_disc_step);
  say(options.common, "{}", views::plan_lines(plan, ns_per_disc_step));
  nlohmann::json json = views::as_json(plan);
  json["ns_per_disc_step"] = ns_per_disc_step;
  write_json(options.common, json);
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
