// bitrock campaign submit: a campaign as a job array of a cluster.
#include <regex>

#include "base/errors.hpp"
#include "cli/campaign.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/slurm.hpp"
#include "views/json/campaign_json.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CampaignOptions campaign;
  std::string engine = "slurm";
  studies::SlurmOptions slurm;
  bool dry_run = false;
};

CLI::Validator matching(const std::string& pattern, const std::string& meaning) {
  return {[=](std::string& text) {
            return std::regex_match(text, std::regex(pattern)) ? "" : fmt::format("'{}' (must be {})", text, meaning);
          },
          "", "matching"};
}

void submit(const Options& options) {
  const CampaignOptions& campaign = options.campaign;
  require_outputs(campaign.common, {campaign.study_file}, {});
  const studies::Study study = study_of(campaign);
  studies::open_folder(study, campaign.folder);
  const studies::Status status = studies::status(study, campaign.folder);
  const studies::SlurmScripts scripts = studies::write_slurm_scripts(
      study, campaign.folder, std::filesystem::read_symlink("/proc/self/exe"), options.slurm);
  if (!options.slurm.time_limit.empty()) {
    const studies::Plan plan = studies::plan(study, campaign.folder);
    for (const std::string& warning : studies::warnings(plan, options.slurm, scripts.tasks))
      warn(campaign.common, warning);
  }
  nlohmann::json json = views::as_json(status);
  json["tasks"] = scripts.tasks;
  json["scripts"] = {scripts.array.string(), scripts.collect.string()};
  json["array_job"] = json["collect_job"] = nullptr;
  say(campaign.common, "{} tasks -> {}, {}\n", scripts.tasks, scripts.array.string(), scripts.collect.string());
  const bool all_done = status.done == status.cases;
  if (all_done) say(campaign.common, "all {} runs are done: nothing to submit\n", status.cases);
  if (!all_done && !options.dry_run) {
    const studies::SlurmJobs submitted = studies::submit(scripts);
    json["array_job"] = submitted.array;
    json["collect_job"] = submitted.collect;
    say(campaign.common, "submitted: array job {}, collect job {} when it has ended\n", submitted.array,
        submitted.collect);
  }
  write_json(campaign.common, json);
}

}  // namespace

void add_campaign_submit(CLI::App& campaign) {
  auto options = std::make_shared<Options>();
  CLI::App* command = add_campaign_action(
      campaign, "submit", "Gives what is not cut yet to a cluster, and collects the results at the end.",
      options->campaign);
  add_campaign_folder(*command, options->campaign);
  command->add_option("--engine", options->engine, "This queueing system runs the cluster.")
      ->check(CLI::IsMember({"slurm"}))
      ->capture_default_str();
  command
      ->add_option("--tasks", options->slurm.tasks,
                   "So many tasks share the cuts (default: one task a cut, at most 1000).")
      ->check(CLI::Range(1, studies::most_tasks));
  command
      ->add_option("--time", options->slurm.time_limit,
                   "The cluster ends a task after this time, HH:MM:SS or D-HH:MM:SS.")
      ->check(matching("([0-9]+-)?[0-9]+:[0-5][0-9]:[0-5][0-9]", "HH:MM:SS or D-HH:MM:SS"));
  command->add_option("--mem", options->slurm.memory_MB, "A task may use so much memory [MB].")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      ->add_option("--partition", options->slurm.partition,
                   "The tasks run in this partition (default: the cluster's own).")
      ->check(matching("[A-Za-z0-9_.,-]+", "the name of a partition"));
  command->add_flag("--dry-run", options->dry_run, "The program writes the scripts and submits nothing.");
  command->callback([options] {
    find_study(options->campaign);
    submit(*options);
  });
}

}  // namespace bitrock::cli
