// bitrock campaign collect, features: from finished cuts to the tables that networks learn from.
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "cli/campaign.hpp"
#include "studies/campaign/collect.hpp"

namespace bitrock::cli {

namespace {

/// What counts as a peak.
struct DefinitionFlags {
  std::string name = "converging";
  std::optional<double> smoothing_um, min_prominence, min_distance_mm;
};

void add_definition(CLI::App& action, DefinitionFlags& flags) {
  action
      .add_option("--peaks", flags.name,
                  "What counts as a peak: by the converging definition counts do not depend on the sampling; the "
                  "article counts every maximum above 1 % of the largest force.")
      ->check(CLI::IsMember({"converging", "article"}))
      ->capture_default_str();
  action
      .add_option("--smoothing-um", flags.smoothing_um,
                  "A moving mean over this travel is taken twice before peaks are looked for (default: 0.08 of the "
                  "mean grain diameter; article: none).")
      ->check(CLI::Range(0.0, 1e5));
  action
      .add_option("--min-prominence", flags.min_prominence,
                  "A peak stands out from the higher of its two valleys by at least this share of the largest force "
                  "(default: 0.02; article: 0).")
      ->check(CLI::Range(0.0, 1.0));
  action
      .add_option("--min-distance-mm", flags.min_distance_mm,
                  "Of peaks at most this travel apart only the highest counts (default: 0).")
      ->check(CLI::Range(0.0, 1e4));
}

peaks::PeakDefinition definition_of(const DefinitionFlags& flags, double mean_diameter) {
  peaks::PeakDefinition definition =
      flags.name == "article" ? peaks::as_in_the_article() : peaks::converging(mean_diameter);
  if (flags.smoothing_um) definition.smoothing = *flags.smoothing_um * base::um;
  if (flags.min_prominence) definition.min_prominence = *flags.min_prominence;
  if (flags.min_distance_mm) definition.min_distance = *flags.min_distance_mm * base::mm;
  return definition;
}

struct CollectFlags : AcceptOptions {
  DefinitionFlags definition;
};

struct FeaturesFlags {
  CommonOptions common;
  DefinitionFlags definition;
  std::string forces, output;
};

/// features.csv -> features_mean.csv
std::filesystem::path means_beside(const std::filesystem::path& table) {
  return table.parent_path() / (table.stem().string() + "_mean" + table.extension().string());
}

void write_tables(const std::vector<studies::FeatureRow>& rows, const std::filesystem::path& table) {
  base::write_whole(table, studies::features_csv(rows));
  base::write_whole(means_beside(table), studies::features_mean_csv(rows));
}

void collect(const CollectFlags& flags) {
  const CampaignOptions& options = flags.campaign;
  const std::filesystem::path folder = options.folder, table = folder / "features.csv";
  require_outputs(options.common, {options.study_file}, {});
  const studies::Study study = studies::read_study(options.study_file);
  accept_cuts(flags, study);
  const studies::Status status = studies::status(study, folder);
  studies::Collection collection =
      studies::collect(study, folder, definition_of(flags.definition, studies::mean_diameter(study)));
  warn(options.common, collection.warnings);
  if (collection.rows.empty()) {
    throw base::InputError(
        fmt::format("{}: no finished runs to collect (first: bitrock campaign run)", options.folder));
  }
  write_tables(collection.rows, table);
  say(options.common, "{} rows -> {}, {}\n", collection.rows.size(), table.string(), means_beside(table).string());
  if (!collection.forces.cuts.empty()) {
    collection.forces.study = std::filesystem::path(options.study_file).filename().string();
    studies::write_forces(collection.forces, folder / "forces.h5");
    say(options.common, "{} force histories -> {}\n", collection.forces.cuts.size(), (folder / "forces.h5").string());
  }
  print(options, status);
}

void make_features(const FeaturesFlags& flags) {
  require_outputs(flags.common, {flags.forces}, {flags.output, means_beside(flags.output)});
  const studies::ForcesFile forces = studies::read_forces(flags.forces);
  if (forces.cuts.empty()) throw base::InputError(flags.forces + ": holds no cut");
  const peaks::PeakDefinition definition = definition_of(flags.definition, forces.mean_diameter);
  std::vector<studies::FeatureRow> rows;
  for (const studies::CutForces& cut : forces.cuts) rows.push_back(studies::row_of(cut, definition));
  warn(flags.common, studies::warnings(rows));
  write_tables(rows, flags.output);
  say(flags.common, "{} rows -> {}, {}\n", rows.size(), flags.output, means_beside(flags.output).string());
  write_json(flags.common, {{"rows", rows.size()},
                            {"peak_smoothing_um", base::in_units(definition.smoothing, base::um)},
                            {"peak_min_prominence", definition.min_prominence},
                            {"peak_min_distance_mm", base::in_units(definition.min_distance, base::mm)}});
}

}  // namespace

void add_campaign_collect(CLI::App& campaign) {
  auto flags = std::make_shared<CollectFlags>();
  CLI::App* command = add_campaign_action(campaign, "collect",
                                          "Writes features.csv, features_mean.csv and forces.h5 of the finished cuts.",
                                          flags->campaign);
  add_campaign_folder(*command, flags->campaign);
  add_accept(*command, *flags);
  add_definition(*command, flags->definition);
  command->callback([flags] {
    find_study(flags->campaign);
    collect(*flags);
  });
}

void add_campaign_features(CLI::App& campaign) {
  auto flags = std::make_shared<FeaturesFlags>();
  CLI::App* command = campaign.add_subcommand(
      "features", "Writes features.csv and features_mean.csv anew from the force histories of a data set.");
  command->add_option("forces", flags->forces, "The force histories: the forces.h5 of bitrock campaign collect.")
      ->required()
      ->check(not_empty());
  command
      ->add_option("-o,--output", flags->output,
                   "The table is written here, and its means beside it with _mean in their name.")
      ->required()
      ->check(not_empty());
  add_definition(*command, flags->definition);
  add_common(*command, flags->common);
  command->callback([flags] { make_features(*flags); });
}

}  // namespace bitrock::cli
