#include "cli/command.hpp"

#include <algorithm>
#include <optional>
#include <thread>

#include "base/files.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/unit_hint.hpp"

namespace cli {

void add_common(CLI::App& command, CommonOptions& options) {
  command.add_option("--json", options.json_file, "write the result as JSON to this file")->check(not_empty());
  command.add_flag("--quiet", options.quiet, "print nothing but errors");
}

void add_computing(CLI::App& command, CommonOptions& options) {
  add_common(command, options);
  command.add_option("--threads", options.threads, "threads inside one computation (the result does not depend on it)")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command.add_flag("--check", options.check, "read the input, print what follows from it, and stop");
}

void require_outputs(const CommonOptions& options, const std::vector<std::filesystem::path>& inputs,
                     const std::vector<std::filesystem::path>& outputs) {
  std::vector<std::filesystem::path> all = outputs;
  if (!options.json_file.empty()) all.emplace_back(options.json_file);
  base::refuse_overwriting(inputs, all);
  for (const auto& output : all) base::require_writable(output);
}

CLI::Validator within(const std::string& flag, const base::Range& allowed) {
  return {[flag, allowed](std::string& text) {
            const std::optional<double> value = base::number_in(text);
            if (!value) return fmt::format("'{}' is not a number", text);
            return allowed.contains(*value) ? std::string()
                                            : fmt::format("'{}' ({})", text, base::out_of_range(flag, *value, allowed));
          },
          "NUMBER " + allowed.text(), "within"};
}

CLI::Validator not_empty() {
  return {[](std::string& text) { return text.empty() ? std::string("an empty name") : std::string(); }, "",
          "not_empty"};
}

void write_json(const CommonOptions& options, const nlohmann::json& result) {
  if (!options.json_file.empty())
    base::write_whole(options.json_file, result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

void warn(const CommonOptions& options, const std::string& what) {
  if (!options.quiet) fmt::print(stderr, "bitrock: warning: {}\n", what);
}

int cores() {
  return base::available_cores();
}

}  // namespace cli
