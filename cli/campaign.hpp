#pragma once
/// What the actions of `bitrock campaign` share.

#include <memory>
#include <string>

#include "campaigns/status.hpp"
#include "campaigns/study.hpp"
#include "cli/command.hpp"

namespace cli {

struct CampaignOptions {
  CommonOptions common;
  std::string study_file, folder;
};

/// Where no study is named, the one that the folder of the campaign holds.
void find_study(CampaignOptions& options);

/// The study, with its warnings printed.
campaigns::Study study_of(const CampaignOptions& options);

/// `study` (which may be left out: `find_study`), `--json`, `--quiet`.
CLI::App* add_campaign_action(CLI::App& campaign, const std::string& name, const std::string& meaning,
                              CampaignOptions& options);
/// `--dir`, which must be given.
void add_campaign_folder(CLI::App& action, CampaignOptions& options);

nlohmann::json as_json(const campaigns::Status& status);
void print(const CampaignOptions& options, const campaigns::Status& status);

void add_campaign_plan(CLI::App& campaign);
/// Prints the plan of a study; `folder` may be empty.
void print_plan(const CampaignOptions& options, const campaigns::Study& study, double ns_per_disc_step);
void add_campaign_submit(CLI::App& campaign);

}  // namespace cli
