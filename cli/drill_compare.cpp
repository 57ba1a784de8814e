// bitrock drill compare: one drilling case under the networks and under the customary simple excitations of the same
// mean and RMS, over several seeds.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "base/value_lists.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/drill_parts.hpp"
#include "studies/drill/comparison.hpp"
#include "views/json/drill_json.hpp"
#include "views/text/drill_plan_lines.hpp"

namespace bitrock::cli {

namespace {

using studies::ComparedRuns, studies::Comparison, studies::source_names;

struct Options {
  CommonOptions common;
  CaseFlags drill;
  std::string seeds, folder;
  int jobs = 1;
};

std::vector<std::filesystem::path> outputs_of(const Comparison& comparison) {
  std::vector<std::filesystem::path> outputs{comparison.folder / "summary.csv", comparison.folder / "summary.md"};
  for (std::size_t source = 0; source < source_names.size(); ++source)
    for (const int seed : comparison.seeds) outputs.push_back(studies::run_file(comparison, source, seed));
  return outputs;
}

Comparison read_comparison(const Options& options) {
  Comparison comparison{.drill = read_case(options.drill),
                        .string = {},
                        .model = {},
                        .model_fingerprint = {},
                        .seeds = base::seeds_in("--seeds", options.seeds),
                        .folder = options.folder};
  if (comparison.drill.source.kind != runtime::SourceKind::bit) {
    throw base::InputError(fmt::format(
        "{}: the source of the case must be 'bit': the simple ones are measured against it", options.drill.file));
  }
  comparison.model = model_of(options.common, options.drill, comparison.drill);
  comparison.string = runtime::assemble(comparison.drill);
  for (const std::string& warning : runtime::warnings(comparison.drill, comparison.string))
    warn(options.common, warning);
  runtime::require_stable(comparison.drill, comparison.string);
  const runtime::DrillSource tried = runtime::make_source(comparison.drill, comparison.model);  // says what is missing
  for (const std::string& warning : runtime::warnings_of_load(comparison.string, tried.load))
    warn(options.common, warning);
  comparison.model_fingerprint = base::fingerprint_text(base::read_whole(comparison.drill.source.model_file));
  return comparison;
}

void warn_of_other_runs(const Options& options, const Comparison& comparison) {
  const std::vector<std::string> others = studies::other_runs(comparison);
  if (others.empty()) return;
  warn(options.common, fmt::format("{} also holds runs that are not of this call, and not in its tables: {}",
                                   options.folder, fmt::join(others, ", ")));
}

void compare(const Options& options) {
  if (runtime::has_well(options.drill.file))
    return compare_in_well(options.common, options.drill, options.seeds, options.jobs, options.folder);
  const Comparison comparison = read_comparison(options);
  const std::vector<std::filesystem::path> inputs = inputs_of(options.drill, comparison.drill);
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    say(options.common, "{}", views::plan_line(comparison));
    return write_json(options.common, {{"runs", studies::runs_of(comparison)}});
  }
  base::require_writable_folder(comparison.folder);
  require_outputs(options.common, inputs, outputs_of(comparison));
  ComparedRuns runs;
  {
    Progress progress(options.common, "drilling", "seeds");
    runs = studies::run_comparison(comparison, options.jobs, progress.callback());
  }
  const std::string table = studies::compared_table(runs);
  base::write_whole(comparison.folder / "summary.csv", studies::compared_csv(runs));
  base::write_whole(comparison.folder / "summary.md", table);
  say(options.common, "{}, {} seeds, mean ± standard deviation over the seeds\n\n{}\n-> {}\n", comparison.drill.name,
      comparison.seeds.size(), table, options.folder);
  for (const std::string& warning : studies::warnings(runs)) warn(options.common, warning);
  const std::string asked =
      comparison.model ? asked_at_the_mean(comparison.drill.bit, *comparison.model, runs[0].front().summary) : "";
  tell(options.common, views::remarks(studies::clamps_of_all(runs), asked));
  warn_of_other_runs(options, comparison);
  write_json(options.common, views::as_json(runs));
}

}  // namespace

void add_drill_compare(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      drill.add_subcommand("compare",
                           "Runs the case with the force of the networks, with a sine and with white "
                           "noise of equal mean and RMS, for several seeds. A case with a [well] is run "
                           "with the networks, with such a sine and without excitation, and the stresses "
                           "and the damage of its stress points are compared.");
  add_case(*command, options->drill, "normal.toml");
  command->add_option("--seeds", options->seeds, "Each seed draws another force of the same kind, e.g. 1,2,5:10.")
      ->default_val("1:10");
  add_jobs(*command, options->jobs, "runs");
  command
      ->add_option(
          "-o,--output", options->folder,
          "This folder gets each run (.h5), summary.csv with a row a run, and summary.md with a row a quantity.")
      ->default_val("compare")
      ->check(not_empty());
  add_common(*command, options->common);
  add_check(*command, options->common);
  command->callback([options] { compare(*options); });
}

}  // namespace bitrock::cli
