#pragma once
/// What `drill run`, `drill compare` and `drill map` share: the model of a case, and what it is asked.

#include <optional>
#include <string>

#include "cli/command.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::cli {

/// The case, and what stands in place of its model and mode.
struct CaseFlags {
  std::string file, model_file, mode;
};

/// "case", `--model` and `--mode`. `example` is a file of campaigns/drill.
void add_case(CLI::App& command, CaseFlags& flags, const std::string& example);

/// The case with the mode of the flags.
runtime::DrillCase read_case(const CaseFlags& flags);

/// The model of the flag or else of the case; nothing where the source of the case needs none. Warns of a model of
/// another rock. The case then names the file that was read.
std::optional<surrogate::Model> model_of(const CommonOptions& common, const CaseFlags& flags,
                                         runtime::DrillCase& drill);

/// Files that the results must not overwrite.
std::vector<std::filesystem::path> inputs_of(const CaseFlags& flags, const runtime::DrillCase& drill);

/// What the networks are asked outside their range at the mean speed and ROP of a run; empty where that is inside.
std::string asked_at_the_mean(const runtime::Bit& bit, const surrogate::Model& model,
                              const runtime::DrillSummary& summary);

/// `drill run` of a case with a well. `seed` below 0: that of the case.
void run_in_well(const CommonOptions& common, const CaseFlags& flags, int seed, const std::string& output);

/// `drill compare` of a case with a well. `seeds` as the user gave them.
void compare_in_well(const CommonOptions& common, const CaseFlags& flags, const std::string& seeds, int jobs,
                     const std::string& folder);
/// `drill modes` of a case with a well.
void show_modes_in_well(const CommonOptions& common, const std::string& file);

/// The case with the stations of its survey file; warns of what deserves a look in that.
runtime::WellCase read_well(const CommonOptions& common, const std::string& file);

/// `drill broomstick`, `drill compare`, `drill fatigue`, `drill map`, `drill statics` and `drill survey`.
void add_drill_broomstick(CLI::App& drill);
void add_drill_compare(CLI::App& drill);
void add_drill_fatigue(CLI::App& drill);
void add_drill_map(CLI::App& drill);
void add_drill_statics(CLI::App& drill);
void add_drill_survey(CLI::App& drill);

}  // namespace bitrock::cli
