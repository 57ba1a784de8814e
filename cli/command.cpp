#include "cli/command.hpp"

#include <algorithm>
#include <thread>

#include "base/files.hpp"

namespace cli {

void add_common(CLI::App& command, CommonOptions& options) {
  command.add_option("--json", options.json_file, "write the result as JSON to this file");
  command.add_flag("--quiet", options.quiet, "print nothing but errors");
}

void add_computing(CLI::App& command, CommonOptions& options) {
  add_common(command, options);
  command.add_option("--threads", options.threads, "threads inside one computation (the result does not depend on it)")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_flag("--check", options.check, "read the input, print what follows from it, and stop");
}

void require_json_writable(const CommonOptions& options) {
  if (!options.json_file.empty()) base::require_writable(options.json_file);
}

void write_json(const CommonOptions& options, const nlohmann::json& result) {
  if (!options.json_file.empty()) base::write_whole(options.json_file, result.dump(2) + "\n");
}

int cores() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace cli
