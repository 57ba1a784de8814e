#pragma once
/// What the actions of `bitrock campaign` share.

#include <memory>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "studies/campaign/status.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::cli {

struct CampaignOptions {
  CommonOptions common;
  std::string study_file, folder;
};

struct AcceptOptions {
  CampaignOptions campaign;
  std::vector<std::string> accept;  ///< files of cuts made elsewhere
};

/// Where no study is named, the one that the folder of the campaign holds.
void find_study(CampaignOptions& options);

/// The study, with its warnings printed.
studies::Study study_of(const CampaignOptions& options);

/// `study` (which may be left out: `find_study`), `--json`, `--quiet`.
CLI::App* add_campaign_action(CLI::App& campaign, const std::string& name, const std::string& meaning,
                              CampaignOptions& options);
/// `--dir`, which must be given.
void add_campaign_folder(CLI::App& action, CampaignOptions& options);

/// `--accept`, and what it asks for: the folder keeps the cuts of these files.
void add_accept(CLI::App& action, AcceptOptions& options);
void accept_cuts(const AcceptOptions& options, const studies::Study& study);

void print(const CampaignOptions& options, const studies::Status& status);

void add_campaign_plan(CLI::App& campaign);
/// Prints the plan of a study; `folder` may be empty.
void print_plan(const CampaignOptions& options, const studies::Study& study, double ns_per_disc_step);
void add_campaign_collect(CLI::App& campaign);
void add_campaign_features(CLI::App& campaign);
void add_campaign_submit(CLI::App& campaign);

}  // namespace bitrock::cli
