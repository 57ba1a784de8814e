#pragma once
/// The result of a case with a well as a file: series of samples and what they were computed from.

#include <filesystem>
#include <string>

#include "runtime/well/well_run.hpp"

namespace bitrock::runtime {

/// Root attributes of the file.
inline constexpr const char* well_format = "bitrock-well";
inline constexpr long long well_format_version = 1;  ///< raised when a reader of the old one would read it wrong

/// `config_toml`: the case as it was read. `model`: fingerprint of the networks, empty without. `settling`
/// [s]: of the case.
void write_well_run(const WellRun& run, const std::string& config_toml, const std::string& model, double settling,
                    const std::filesystem::path& path);

}  // namespace bitrock::runtime
