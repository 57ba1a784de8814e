#pragma once
/// What every subcommand shares: the common flags, the JSON result, a progress line. A subcommand is one file with one
/// `add_<name>(app)` that declares its flags and sets its action; `main.cpp` turns exceptions into exit statuses.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/config.hpp"
#include "base/progress.hpp"

namespace bitrock::cli {

struct CommonOptions {
  std::string json_file;
  bool quiet = false;
  bool check = false;
  int threads = 1;
};

/// `--json` and `--quiet`.
void add_common(CLI::App& command, CommonOptions& options);
/// Also `--threads` and `--check`, for subcommands that compute.
void add_computing(CLI::App& command, CommonOptions& options);

/// `--check`, which `add_computing` adds too.
void add_check(CLI::App& command, CommonOptions& options);

/// The model file, which must be named.
void add_model_file(CLI::App& command, std::string& file);
/// The bit file, which must be named.
void add_bit_file(CLI::App& command, std::string& file);

/// `--jobs`: computations side by side; all cores unless the user says otherwise. `lab`, `calibrate` and `train` called
/// it `--threads` before, which still counts there.
enum class Spelling { jobs, jobs_or_threads };
void add_jobs(CLI::App& command, int& jobs, const std::string& what, Spelling spelling = Spelling::jobs);

/// Call before the work: throws `base::InputError` when an output could not be written later, or would overwrite an
/// input or another output. The JSON file is one of the outputs.
void require_outputs(const CommonOptions& options, const std::vector<std::filesystem::path>& inputs,
                     const std::vector<std::filesystem::path>& outputs);
/// Of inputs that exist: one file under two names would look like two results that agree. Throws `base::InputError`.
void refuse_named_twice(const std::vector<std::string>& inputs);
void write_json(const CommonOptions& options, const nlohmann::json& result);

/// All that goes to standard output goes through here, and is there at once, also in a pipe. Throws `base::OutputError`
/// when it cannot be written to (a full disk, a closed descriptor), and `base::ReaderGone` when its reader has closed
/// the pipe.
void print(const std::string& text);

/// Prints unless --quiet.
template <class... Args>
void say(const CommonOptions& options, fmt::format_string<Args...> format, Args&&... args) {
  if (!options.quiet) print(fmt::format(format, std::forward<Args>(args)...));
}

/// On standard error, with --quiet too: what the user should look at although the work goes on.
void warn(const CommonOptions&, const std::string& what);
/// Many of one kind, of which the first say enough.
void warn(const CommonOptions& options, const std::vector<std::string>& all);
/// One line a message, made fit to be shown; further lines of a text are set in, so that none looks like one of ours.
void tell_user(const std::string& message);

/// A callback that shows a progress line until it goes out of scope.
class Progress {
 public:
  Progress(const CommonOptions& options, const std::string& label, const std::string& unit, double per_unit = 1.0)
      : line_(label, unit, !options.quiet), per_unit_(per_unit) {}
  base::ProgressCallback callback() {
    return [this](double done, double total) { line_.show(done * per_unit_, total * per_unit_); };
  }

 private:
  base::ProgressLine line_;
  double per_unit_;  ///< shown number = number given * per_unit
};

/// For options: a number within `allowed`, which is finite; an empty text is no number. The message says whether
/// another unit than that of the flag's name may be meant.
CLI::Validator within(const std::string& flag, const base::Range& allowed);
/// For file and folder names.
CLI::Validator not_empty();

/// Number of cores that may be used: the default wherever computations run side by side.
int cores();

void add_specimen(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_cut(CLI::App& app);
void add_campaign(CLI::App& app);
void add_lab(CLI::App& app);
void add_peaks(CLI::App& app);
void add_train(CLI::App& app);
void add_predict(CLI::App& app);
void add_hold(CLI::App& app);
void add_learn(CLI::App& app);
/// `bitrock calibrate TARGET -o ROCK` inside another command.
void calibrate_into(const CommonOptions& common, const std::string& target, const std::string& rock, int jobs);
void add_parity(CLI::App& app);
void add_rebuild(CLI::App& app);
void add_signal(CLI::App& app);
void add_drill(CLI::App& app);
void add_report(CLI::App& app);
void add_snapshot(CLI::App& app);
void add_animate(CLI::App& app);
void add_export(CLI::App& app);
/// `export bit`.
void add_export_bit(CLI::App& export_command);
/// `export config`.
void add_export_config(CLI::App& export_command);
/// `export c`, `export matlab` and `export onnx`.
void add_export_model(CLI::App& export_command);
void add_export_fmu(CLI::App& export_command);

}  // namespace bitrock::cli
