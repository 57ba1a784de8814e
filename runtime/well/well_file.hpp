#pragma once
/// The result of a case with a well as a file: series of samples and what they were computed from.

#include <filesystem>
#include <string>

#include "runtime/well/well_run.hpp"

namespace bitrock::runtime {

/// `config_toml`: the case as it was read. `model`: fingerprint of the networks, empty without.
void write_well_run(const WellRun& run, const std::string& config_toml, const std::string& model,
                    const std::filesystem::path& path);

}  // namespace bitrock::runtime
