#pragma once
/// What `drill run`, `drill compare` and `drill map` share: the model of a case, and what it is asked.

#include <optional>
#include <string>

#include "cli/command.hpp"
#include "runtime/drillstring/drill_run.hpp"

namespace bitrock::cli {

/// The model of the flag or else of the case; nothing where the source of the case needs none. Warns of a model of
/// another rock. The case then names the file that was read.
std::optional<surrogate::Model> model_of(const CommonOptions& common, const std::string& flag,
                                         runtime::DrillCase& drill);

/// What the networks are asked outside their range at the mean speed and ROP of a run; empty where that is inside.
std::string asked_at_the_mean(const runtime::Bit& bit, const surrogate::Model& model,
                              const runtime::DrillSummary& summary);

/// `--model`, in place of that of the case.
void add_model_of_case(CLI::App& command, std::string& file);

/// `drill compare` and `drill map`.
void add_drill_compare(CLI::App& drill);
void add_drill_map(CLI::App& drill);

}  // namespace bitrock::cli
