#pragma once
/// The files that bitrock brings along (`campaigns/`: rocks, cuts, bits, drilling cases, studies, and the networks of
/// the article's cases). They are found from the place of the program itself, wherever that has been moved to.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>

namespace bitrock::cli {

/// The folder that holds `campaigns/`; empty when there is none beside this program.
std::optional<std::filesystem::path> data_folder();

/// Call when all subcommands are there. Wherever one of them reads a rock, cut, bit, drilling case, study, target,
/// model or data file, `campaigns/...` that is not to be found from here then means the shipped one; what is here comes
/// first. `--data-dir` prints the folder, and ends the program.
void let_shipped_files_be_named(CLI::App& app);

}  // namespace bitrock::cli
