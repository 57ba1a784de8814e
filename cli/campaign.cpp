// bitrock campaign: a grid of cuts, resumable, one cut a core.
#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "campaigns/features.hpp"
#include "campaigns/runner.hpp"
#include "cli/command.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string study_file, folder;
  int workers = cores();
  std::string shard = "1/1";
};

nlohmann::json as_json(const campaigns::Status& status) {
  return {{"cases", status.cases},
          {"done", status.done},
          {"failed", status.failed},
          {"remaining", status.remaining},
          {"core_seconds", status.core_seconds}};
}

void print(const Options& options, const campaigns::Status& status) {
  say(options.common, "{} of {} runs done, {} failed, {} remaining; {} of one core spent\n", status.done, status.cases,
      status.failed, status.remaining, base::readable_duration(status.core_seconds));
  write_json(options.common, as_json(status));
}

/// "i/n" with 1 <= i <= n.
void parse_shard(const std::string& text, campaigns::RunOptions& run) {
  int used = 0;
  const bool good = std::sscanf(text.c_str(), "%6d/%6d%n", &run.shard, &run.shards, &used) == 2 &&
                    used == static_cast<int>(text.size()) && run.shard >= 1 && run.shard <= run.shards;
  if (!good) throw base::InputError(fmt::format("--shard {} (write i/n with 1 <= i <= n, e.g. 2/8)", text));
}

void print_job(const campaigns::JobReport& report, double core_seconds, int workers) {
  const campaigns::Job& job = *report.job;
  const std::string name =
      fmt::format("case {} seed {}: {:g} m/s, {:g} mm, {:g} deg", job.case_number, job.seed, job.cut.cutter_speed,
                  base::in_units(job.cut.depth_of_cut, base::mm), base::in_units(job.cut.back_rake, base::deg));
  const double left = core_seconds / report.share_done * (1.0 - report.share_done) / workers;
  if (report.failed) {
    fmt::print("[{}/{}] {} FAILED: {}\n", report.finished, report.total, name, report.message);
  } else {
    fmt::print("[{}/{}] {} in {:.1f} s; about {} left\n", report.finished, report.total, name, report.wall_time,
               base::readable_duration(left));
  }
  std::fflush(stdout);
}

void run_campaign(const Options& options) {
  const campaigns::Study study = campaigns::read_study(options.study_file);
  campaigns::RunOptions run{.workers = options.workers};
  parse_shard(options.shard, run);
  const std::filesystem::path folder = options.folder;
  require_outputs(options.common, {options.study_file, folder / "study.toml", folder / "features.csv"}, {});
  if (options.common.check) return print(options, campaigns::status(study, options.folder));
  double core_seconds = 0.0;  // of the jobs of this call
  if (!options.common.quiet) {
    run.on_job = [&](const campaigns::JobReport& report) {
      core_seconds += report.wall_time;
      print_job(report, core_seconds, std::min(options.workers, report.total));
    };
    run.on_stage = [](const std::string& text) {
      fmt::print("{}\n", text);
      std::fflush(stdout);
    };
  }
  campaigns::run(study, options.folder, run);
  const campaigns::Status status = campaigns::status(study, options.folder);
  print(options, status);
  if (status.failed > 0) {
    throw base::SimulationError(
        fmt::format("{} runs failed; the reasons are in {}/failed (the same command tries them again)", status.failed,
                    options.folder));
  }
}

void collect(const Options& options) {
  const campaigns::Study study = campaigns::read_study(options.study_file);
  const campaigns::Status status = campaigns::status(study, options.folder);
  if (status.done == 0)
    throw base::InputError(
        fmt::format("{}: no finished runs to collect (first: bitrock campaign run)", options.folder));
  const auto rows = campaigns::collect(study, options.folder);
  const std::filesystem::path folder = options.folder;
  base::write_whole(folder / "features.csv", campaigns::features_csv(rows));
  base::write_whole(folder / "features_mean.csv", campaigns::features_mean_csv(rows));
  say(options.common, "{} rows -> {}, {}\n", rows.size(), (folder / "features.csv").string(),
      (folder / "features_mean.csv").string());
  print(options, status);
}

CLI::App* add_action(CLI::App& campaign, const std::string& name, const std::string& meaning,
                     const std::shared_ptr<Options>& options) {
  CLI::App* command = campaign.add_subcommand(name, meaning);
  command->add_option("study", options->study_file, "study file, e.g. campaigns/demo.toml")->required();
  command->add_option("--dir", options->folder, "folder of the campaign")->required()->check(not_empty());
  add_common(*command, options->common);
  return command;
}

}  // namespace

void add_campaign(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* campaign = app.add_subcommand("campaign", "a grid of cuts, resumable");
  campaign->require_subcommand(1);
  CLI::App* run = add_action(*campaign, "run", "run what is not done yet; stop and repeat at will", options);
  run->add_option("--jobs", options->workers, "cuts at a time, one core each")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  run->add_option("--shard", options->shard, "only every n-th job, beginning with the i-th: i/n")
      ->capture_default_str();
  run->add_flag("--check", options->common.check, "read the study, say what is to be done, and stop");
  run->callback([options] { run_campaign(*options); });
  add_action(*campaign, "status", "what is done, failed, remaining", options)->callback([options] {
    print(*options, campaigns::status(campaigns::read_study(options->study_file), options->folder));
  });
  add_action(*campaign, "collect", "write features.csv and features_mean.csv of the finished runs", options)
      ->callback([options] { collect(*options); });
}

}  // namespace cli
