// bitrock drill compare: one drilling case under the networks and under the customary simple excitations of the same
// mean and RMS, over several seeds.
#include "cli/drill_compare.hpp"

#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/numbered_files.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/drill_parts.hpp"
#include "cli/ranges.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "runtime/drillstring/matched_source.hpp"

namespace cli {

namespace {

using runtime::DrillCase, runtime::SourceKind;

constexpr double allowed_mismatch = 0.01;  // [1] beyond it the comparison is not on equal terms

struct Options {
  CommonOptions common;
  std::string case_file, model_file, seeds, folder;
  int jobs = 1;
};

struct Study {
  DrillCase drill;
  runtime::DrillString string;
  std::optional<surrogate::Model> model;
  std::string model_fingerprint;
  std::vector<int> seeds;
  std::filesystem::path folder;
};

std::filesystem::path run_file(const Study& study, std::size_t source, int seed) {
  return study.folder / fmt::format("{}_{}.h5", source_names[source], seed);
}

std::vector<std::filesystem::path> outputs_of(const Study& study) {
  std::vector<std::filesystem::path> outputs{study.folder / "summary.csv", study.folder / "summary.md"};
  for (std::size_t source = 0; source < source_names.size(); ++source)
    for (const int seed : study.seeds) outputs.push_back(run_file(study, source, seed));
  return outputs;
}

Study read_study(const Options& options) {
  Study study{.drill = runtime::read_drill_case(options.case_file),
              .string = {},
              .model = {},
              .model_fingerprint = {},
              .seeds = seed_range("--seeds", options.seeds),
              .folder = options.folder};
  if (study.drill.source.kind != SourceKind::bit) {
    throw base::InputError(fmt::format(
        "{}: the source of the case must be 'bit': the simple ones are measured against it", options.case_file));
  }
  study.model = model_of(options.common, options.model_file, study.drill);
  study.string = runtime::assemble(study.drill);
  for (const std::string& warning : runtime::warnings(study.drill, study.string)) warn(options.common, warning);
  runtime::require_stable(study.drill, study.string);
  const runtime::DrillSource tried = runtime::make_source(study.drill, study.model);  // says what is missing
  for (const std::string& warning : runtime::warnings_of_load(study.string, tried.load)) warn(options.common, warning);
  study.model_fingerprint = base::fingerprint_text(base::read_whole(study.drill.source.model_file));
  return study;
}

ComparedRun seen_in(const runtime::DrillRun& run, const Study& study, int seed, double mismatch) {
  const runtime::TopDrive& drive = study.string.drive;
  const double rotation = drive.imposes_speed ? drive.rotation : run.summary.bit_rotation.mean;
  return {.seed = seed,
          .summary = run.summary,
          .condition = runtime::condition(run.summary, rotation),
          .mismatch = mismatch};
}

/// The three runs of one seed. `tell` hears the share that is done, from 0 to 1.
void run_seed(const Study& study, std::size_t place, const std::function<void(double)>& tell, ComparedRuns& runs) {
  const int seed = study.seeds[place];
  DrillCase drill = study.drill;
  drill.source.seed = seed;
  double told = 0.0;
  const auto part = [&](double number) {
    return [&tell, &told, number](double done, double total) {  // a repeated trial does not go back
      told = std::max(told, (number + done / total) / static_cast<double>(source_names.size()));
      tell(told);
    };
  };
  const runtime::DrillRun networks =
      runtime::run_drill(drill, study.string, runtime::make_source(drill, study.model), part(0.0));
  runtime::write_drill_run(networks, drill, study.model_fingerprint, run_file(study, 0, seed));
  runs[0][place] = seen_in(networks, study, seed, 0.0);
  constexpr std::array<SourceKind, 2> simple{SourceKind::sinusoidal, SourceKind::noise};
  for (std::size_t k = 0; k < simple.size(); ++k) {
    const runtime::MatchedRun matched =
        runtime::run_matched(drill, simple[k], networks.summary, part(static_cast<double>(k + 1)));
    runtime::write_drill_run(matched.run, matched.drill, "", run_file(study, k + 1, seed));
    runs[k + 1][place] = seen_in(matched.run, study, seed, matched.mismatch);
  }
}

void warn_of_mismatch(const Options& options, const ComparedRuns& runs) {
  for (std::size_t k = 1; k < runs.size(); ++k) {
    for (const ComparedRun& run : runs[k]) {
      if (run.mismatch <= allowed_mismatch) continue;
      warn(options.common, fmt::format("{}, seed {}: mean and RMS could be matched to {:.2g} % only", source_names[k],
                                       run.seed, 100.0 * run.mismatch));
    }
  }
}

/// The networks' runs of all seeds together.
void tell_clamps_of_all(const Options& options, const Study& study, const ComparedRuns& runs) {
  runtime::ClampTally sum;
  for (const ComparedRun& run : runs[0]) add_clamps(sum, run.summary.clamps);
  tell_clamps(options.common, sum,
              study.model ? asked_at_the_mean(study.drill.bit, *study.model, runs[0].front().summary) : "");
}

nlohmann::json result_json(const ComparedRuns& runs) {
  nlohmann::json sources;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    nlohmann::json list = nlohmann::json::array();
    for (const ComparedRun& run : runs[k]) {
      list.push_back({{"seed", run.seed},
                      {"summary", as_json(run.summary)},
                      {"steady", run.condition.steady},
                      {"stick_slip", run.condition.stick_slip},
                      {"bit_bounce", run.condition.bit_bounce},
                      {"mismatch", run.mismatch}});
    }
    sources[source_names[k]] = list;
  }
  return {{"sources", sources}};
}

/// Runs of other seeds that an earlier call has left in the folder are computations, and stay; the tables are without.
void warn_of_other_runs(const Options& options, const Study& study) {
  std::vector<std::string> others;
  for (const char* source : source_names) {
    for (const base::NumberedFile& file :
         base::numbered_files(study.folder, {.begin = fmt::format("{}_", source), .end = ".h5"})) {
      if (std::find(study.seeds.begin(), study.seeds.end(), file.number) == study.seeds.end())
        others.push_back(file.path.filename().string());
    }
  }
  if (others.empty()) return;
  warn(options.common, fmt::format("{} also holds runs that are not of this call, and not in its tables: {}",
                                   options.folder, fmt::join(others, ", ")));
}

void compare(const Options& options) {
  const Study study = read_study(options);
  const std::vector<std::filesystem::path> inputs{options.case_file, study.drill.bit_file,
                                                  study.drill.source.model_file};
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    say(options.common, "{}: {} runs, {:g} s each, {:.0f} steps each; a simple source may need up to five trials\n",
        study.drill.name, source_names.size() * study.seeds.size(), study.drill.run.duration,
        study.drill.run.duration / runtime::step_of(study.drill.run));
    return write_json(options.common, {{"runs", source_names.size() * study.seeds.size()}});
  }
  base::require_writable_folder(study.folder);
  require_outputs(options.common, inputs, outputs_of(study));
  ComparedRuns runs;
  for (std::vector<ComparedRun>& of_source : runs) of_source.resize(study.seeds.size());
  {
    Progress progress(options.common, "drilling", "seeds");
    base::SharedProgress shared(study.seeds.size(), progress.callback());
    base::for_each_index(static_cast<int>(study.seeds.size()), options.jobs, [&](int i) {
      const auto place = static_cast<std::size_t>(i);
      run_seed(
          study, place, [&](double share) { shared.set(place, share); }, runs);
    });
  }
  const std::string table = compared_table(runs);
  base::write_whole(study.folder / "summary.csv", compared_csv(runs));
  base::write_whole(study.folder / "summary.md", table);
  say(options.common, "{}, {} seeds, mean ± standard deviation over the seeds\n\n{}\n-> {}\n", study.drill.name,
      study.seeds.size(), table, options.folder);
  warn_of_mismatch(options, runs);
  tell_clamps_of_all(options, study, runs);
  warn_of_other_runs(options, study);
  write_json(options.common, result_json(runs));
}

}  // namespace

void add_drill_compare(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  options->jobs = cores();
  CLI::App* command = drill.add_subcommand(
      "compare", "the case under networks, sine and white noise of equal mean and RMS, over several seeds");
  command->add_option("case", options->case_file, "drilling case, e.g. campaigns/drill/normal.toml")->required();
  command->add_option("--model", options->model_file, "model.json, instead of the one the case names")
      ->check(not_empty());
  command->add_option("--seeds", options->seeds, "of the excitation, first:last")->default_val("1:10");
  command->add_option("--jobs", options->jobs, "runs at a time, one core each")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command
      ->add_option("-o,--output", options->folder,
                   "folder to write: each run (.h5), summary.csv with a row a run, summary.md with a row a quantity")
      ->default_val("compare")
      ->check(not_empty());
  add_common(*command, options->common);
  command->add_flag("--check", options->common.check, "read the input, print what follows from it, and stop");
  command->callback([options] { compare(*options); });
}

}  // namespace cli
