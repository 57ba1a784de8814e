#include "cli/shipped.hpp"

#include <set>
#include <string>

#include "base/errors.hpp"
#include "base/shipped.hpp"

namespace bitrock::cli {

namespace fs = std::filesystem;

std::optional<fs::path> data_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return std::nullopt;
  const fs::path folder = (program.parent_path() / BITROCK_WAY_TO_DATA).lexically_normal();
  if (!fs::is_directory(folder / base::shipped_folder, error)) return std::nullopt;
  return folder;
}

namespace {

/// Options that name a file to read.
const std::set<std::string> inputs{"bit",    "case",   "data",     "model",       "rock",   "study",
                                   "survey", "target", "--accept", "--init-from", "--model"};

/// A path as the user wrote it becomes that of the shipped file, where it means one.
std::string look_among_shipped(std::string& text) {
  text = base::or_shipped(text, data_folder()).string();
  return "";
}

void look_among_shipped_in(CLI::App& command) {
  for (CLI::Option* option : command.get_options()) {
    if (inputs.contains(option->get_name())) option->transform(CLI::Validator(look_among_shipped, "", "shipped"));
  }
  for (CLI::App* action : command.get_subcommands({})) look_among_shipped_in(*action);
}

}  // namespace

void let_shipped_files_be_named(CLI::App& app) {
  look_among_shipped_in(app);
  app.add_flag_callback(
      "--data-dir",
      [] {
        const std::optional<fs::path> folder = data_folder();
        if (!folder) throw base::InputError("no shipped files beside this program (its share/bitrock is missing)");
        throw CLI::CallForVersion(folder->string(), 0);  // printed like the version, and no subcommand is asked for
      },
      "The program prints the folder of the shipped files (campaigns/...), and stops.");
}

}  // namespace bitrock::cli
