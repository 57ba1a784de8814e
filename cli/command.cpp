#include "cli/command.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/number.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "base/unit_hint.hpp"
#include "base/watch.hpp"

namespace bitrock::cli {

namespace {

/// "bitrock campaign run".
std::string full_name(const CLI::App& command) {
  const CLI::App* above = command.get_parent();
  return above == nullptr ? command.get_name() : full_name(*above) + " " + command.get_name();
}

/// Text from files and names of files stands in many results.
std::string one_message(const std::string& text) {
  std::string shown = base::printable(text, base::all_of_it);
  for (std::size_t at = 0; (at = shown.find('\n', at)) != std::string::npos; at += 3) shown.replace(at, 1, "\n  ");
  return shown;
}

[[noreturn]] void fail_printing(int error) {
  if (error == EPIPE) throw base::ReaderGone();
  throw base::OutputError(
      fmt::format("cannot write to standard output: {}", error == EBADF ? "it is closed" : std::strerror(error)));
}

}  // namespace

void add_common(CLI::App& command, CommonOptions& options) {
  command.add_option("--json", options.json_file, "The program also writes the result to this file, as JSON.")
      ->check(not_empty());
  command.add_flag("--quiet", options.quiet, "The program prints only warnings and errors.");
  command.parse_complete_callback([&command, &options] { base::at_work(options.quiet ? "" : full_name(command)); });
}

void add_computing(CLI::App& command, CommonOptions& options) {
  add_common(command, options);
  command
      .add_option("--threads", options.threads,
                  "So many threads share one computation. The result does not depend on it.")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  add_check(command, options);
}

void add_check(CLI::App& command, CommonOptions& options) {
  command.add_flag(
      "--check", options.check,
      "The program reads the input, prints what follows from it (sizes, steps, expected time), and stops.");
}

void add_model_file(CLI::App& command, std::string& file) {
  command.add_option("model", file, "The model file with the networks, e.g. campaigns/paper240/model.json.")
      ->required();
}

void add_bit_file(CLI::App& command, std::string& file) {
  command.add_option("bit", file, "The bit file, e.g. campaigns/bits/pdc15.toml.")->required();
}

void add_jobs(CLI::App& command, int& jobs, const std::string& what, Spelling spelling) {
  jobs = cores();
  command
      .add_option(spelling == Spelling::jobs_or_threads ? "--jobs,--threads" : "--jobs", jobs,
                  fmt::format("So many {} run side by side, one core each. The result does not depend on it.", what))
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
}

void require_outputs(const CommonOptions& options, const std::vector<std::filesystem::path>& inputs,
                     const std::vector<std::filesystem::path>& outputs) {
  std::vector<std::filesystem::path> all = outputs;
  if (!options.json_file.empty()) all.emplace_back(options.json_file);
  base::refuse_overwriting(inputs, all);
  for (const auto& output : all) base::require_writable(output);
}

void refuse_named_twice(const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code missing;  // said where the file is read
      if (std::filesystem::equivalent(inputs[i], inputs[j], missing))
        throw base::InputError(fmt::format("{} and {} are one file (name each once)", inputs[j], inputs[i]));
    }
  }
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
    base::write_whole(
        options.json_file,
        base::json_with_visible_text(result.dump(2, ' ', false, nlohmann::json::error_handler_t::replace)) + "\n");
}

void print(const std::string& text) {
  base::spoke();
  const std::string shown = base::printable(text, base::all_of_it);
  errno = 0;
  const bool written = std::fwrite(shown.data(), 1, shown.size(), stdout) == shown.size();
  if (!written || std::fflush(stdout) != 0) fail_printing(errno);
}

void tell_user(const std::string& message) {
  base::tell("bitrock: " + one_message(message) + "\n");
}

void warn(const CommonOptions&, const std::string& what) {
  tell_user("warning: " + what);
}

void warn(const CommonOptions& options, const std::vector<std::string>& all) {
  constexpr std::size_t enough = 10;  // a study may have a million cases
  for (std::size_t i = 0; i < std::min(enough, all.size()); ++i) warn(options, all[i]);
  if (all.size() > enough) warn(options, fmt::format("and {} more of this kind", all.size() - enough));
}

int cores() {
  return base::available_cores();
}

}  // namespace bitrock::cli
