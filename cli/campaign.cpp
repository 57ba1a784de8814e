// bitrock campaign: many cuts, resumable, one cut a core.
#include "cli/campaign.hpp"

#include "base/errors.hpp"
#include "base/value_lists.hpp"
#include "studies/campaign/accepted.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/plan.hpp"
#include "studies/campaign/runner.hpp"
#include "views/json/campaign_json.hpp"
#include "views/text/campaign_lines.hpp"

namespace bitrock::cli {

namespace {

struct RunFlags : AcceptOptions {
  int workers = 1;
  std::string shard = "1/1";
};

/// "i/n" with 1 <= i <= n.
void parse_shard(const std::string& text, studies::RunOptions& run) {
  const auto numbers = base::two_counts(text, '/');
  if (!numbers || (*numbers)[0] < 1 || (*numbers)[0] > (*numbers)[1]) {
    throw base::InputError(fmt::format("--shard {} (write i/n with 1 <= i <= n, e.g. 2/8)", text));
  }
  run.shard = (*numbers)[0];
  run.shards = (*numbers)[1];
}

void run_campaign(const RunFlags& flags) {
  const CampaignOptions& options = flags.campaign;
  const studies::Study study = study_of(options);
  studies::RunOptions run{.workers = flags.workers};
  parse_shard(flags.shard, run);
  const std::filesystem::path folder = options.folder;
  if (options.common.check) {
    require_outputs(options.common, {options.study_file}, {});
    return print_plan(options, study, dem2d::typical_ns_per_disc_step);
  }
  require_outputs(options.common, {options.study_file, folder / "study.toml", folder / "features.csv"}, {});
  accept_cuts(flags, study);
  if (!options.common.quiet) {
    run.on_job = [](const studies::JobReport& report) { print(views::job_line(report)); };
    run.on_stage = [](const std::string& text) { print(text + "\n"); };
  }
  studies::run(study, folder, run);
  const studies::Status status = studies::status(study, folder);
  print(options, status);
  if (status.failed > 0) {
    throw base::SimulationError(
        fmt::format("{} runs failed; the reasons are in {}/failed (the same command tries them again)", status.failed,
                    options.folder));
  }
}

void show_status(const CampaignOptions& options) {
  require_outputs(options.common, {options.study_file}, {});
  const studies::Survey survey = studies::look(studies::read_study(options.study_file), options.folder);
  for (const studies::RunningJob& running : survey.running)
    say(options.common, "{}", views::running_line(running, studies::now()));
  print(options, survey.status);
}

void add_run(CLI::App& campaign) {
  auto flags = std::make_shared<RunFlags>();
  CLI::App* command = add_campaign_action(
      campaign, "run", "Makes the cuts that are not there yet. It may be stopped and started again at any time.",
      flags->campaign);
  add_campaign_folder(*command, flags->campaign);
  add_jobs(*command, flags->workers, "cuts");
  command
      ->add_option("--shard", flags->shard,
                   "With i/n the program makes every n-th cut, beginning with the i-th: a share of the study for one "
                   "of n machines.")
      ->capture_default_str();
  add_accept(*command, *flags);
  command->add_flag("--check", flags->campaign.common.check, "The program prints what the study costs, and stops.");
  command->callback([flags] {
    find_study(flags->campaign);
    run_campaign(*flags);
  });
}

}  // namespace

void accept_cuts(const AcceptOptions& flags, const studies::Study& study) {
  if (flags.accept.empty()) return;
  studies::open_folder(study, flags.campaign.folder);
  for (const std::string& table : flags.accept) {
    const studies::Acceptance accepted = studies::keep_accepted(study, flags.campaign.folder, table);
    say(flags.campaign.common, "{}: {} cuts accepted, {} of no job of this study; {} accepted in all\n", table,
        accepted.added, accepted.all.strangers, accepted.all.rows.size() + accepted.all.forces.size());
    warn(flags.campaign.common, accepted.all.warnings);
  }
}

void add_accept(CLI::App& action, AcceptOptions& flags) {
  action
      .add_option(
          "--accept", flags.accept,
          "The cuts of this forces.h5, or the rows of this features.csv, count as finished where their hash is that of "
          "a cut of the study. "
          "The flag may stand several times.")
      ->allow_extra_args(false)
      ->check(not_empty());
}

void find_study(CampaignOptions& options) {
  if (options.study_file.empty()) options.study_file = studies::study_in(options.folder).string();
}

studies::Study study_of(const CampaignOptions& options) {
  studies::Study study = studies::read_study(options.study_file);
  warn(options.common, studies::warnings(study));
  return study;
}

CLI::App* add_campaign_action(CLI::App& campaign, const std::string& name, const std::string& meaning,
                              CampaignOptions& options) {
  CLI::App* command = campaign.add_subcommand(name, meaning);
  command
      ->add_option("study", options.study_file,
                   "The study file, e.g. campaigns/demo.toml. It may be left out when the folder of --dir already "
                   "belongs to a study.")
      ->check(not_empty());
  add_common(*command, options.common);
  return command;
}

void add_campaign_folder(CLI::App& action, CampaignOptions& options) {
  action.add_option("--dir", options.folder, "The folder that holds the cuts of the study.")
      ->required()
      ->check(not_empty());
}

void print(const CampaignOptions& options, const studies::Status& status) {
  say(options.common, "{}", views::status_line(status));
  write_json(options.common, views::as_json(status));
}

void add_campaign(CLI::App& app) {
  CLI::App* campaign = app.add_subcommand("campaign", "Makes many cuts, and goes on after a stop.");
  campaign->require_subcommand(1);
  add_campaign_plan(*campaign);
  add_run(*campaign);
  auto options = std::make_shared<CampaignOptions>();
  CLI::App* status =
      add_campaign_action(*campaign, "status", "Says how many cuts are done, running, failed and remaining.", *options);
  add_campaign_folder(*status, *options);
  status->callback([options] {
    find_study(*options);
    show_status(*options);
  });
  add_campaign_collect(*campaign);
  add_campaign_features(*campaign);
  add_campaign_submit(*campaign);
}

}  // namespace bitrock::cli
