#include "cli/command.hpp"

#include <algorithm>
#include <optional>
#include <thread>

#include "base/files.hpp"
#include "base/number.hpp"

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

namespace {

std::string check_number(const std::string& text, bool positive) {
  const std::optional<double> value = base::number_in(text);
  const bool good = value && (!positive || *value > 0.0);
  return good ? "" : fmt::format("'{}' (must be a finite number{})", text, positive ? " above 0" : "");
}

}  // namespace

CLI::Validator finite() {
  return {[](std::string& text) { return check_number(text, false); }, "NUMBER", "finite"};
}

CLI::Validator finite_positive() {
  return {[](std::string& text) { return check_number(text, true); }, "NUMBER > 0", "finite_positive"};
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
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace cli
