#include "studies/drill/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/numbered_files.hpp"
#include "base/parallel.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "runtime/drillstring/matched_source.hpp"

namespace bitrock::studies {

namespace {

using runtime::DrillCase, runtime::SourceKind;

ComparedRun seen_in(const runtime::DrillRun& run, const Comparison& comparison, int seed, double mismatch) {
  const runtime::TopDrive& drive = comparison.string.drive;
  const double rotation = drive.imposes_speed ? drive.rotation : run.summary.bit_rotation.mean;
  return {.seed = seed,
          .summary = run.summary,
          .condition = runtime::condition(run.summary, rotation),
          .mismatch = mismatch};
}

/// The three runs of one seed. `tell` hears the share that is done, from 0 to 1.
void run_seed(const Comparison& comparison, std::size_t place, const std::function<void(double)>& tell,
              ComparedRuns& runs) {
  const int seed = comparison.seeds[place];
  DrillCase drill = comparison.drill;
  drill.source.seed = seed;
  double told = 0.0;
  const auto part = [&](double number) {
    return [&tell, &told, number](double done, double total) {  // a repeated trial does not go back
      told = std::max(told, (number + done / total) / static_cast<double>(source_names.size()));
      tell(told);
    };
  };
  const runtime::DrillRun networks =
      runtime::run_drill(drill, comparison.string, runtime::make_source(drill, comparison.model), part(0.0));
  runtime::write_drill_run(networks, drill, comparison.model_fingerprint, run_file(comparison, 0, seed));
  runs[0][place] = seen_in(networks, comparison, seed, 0.0);
  constexpr std::array<SourceKind, 2> simple{SourceKind::sinusoidal, SourceKind::noise};
  for (std::size_t k = 0; k < simple.size(); ++k) {
    const runtime::MatchedRun matched =
        runtime::run_matched(drill, simple[k], networks.summary, part(static_cast<double>(k + 1)));
    runtime::write_drill_run(matched.run, matched.drill, "", run_file(comparison, k + 1, seed));
    runs[k + 1][place] = seen_in(matched.run, comparison, seed, matched.mismatch);
  }
}

}  // namespace

std::filesystem::path run_file(const Comparison& comparison, std::size_t source, int seed) {
  return comparison.folder / fmt::format("{}_{}.h5", source_names[source], seed);
}

ComparedRuns run_comparison(const Comparison& comparison, int jobs, const base::ProgressCallback& progress) {
  const std::size_t seeds = comparison.seeds.size();
  ComparedRuns runs;
  for (std::vector<ComparedRun>& of_source : runs) of_source.resize(seeds);
  base::SharedProgress shared(seeds, progress);
  base::for_each_index(static_cast<int>(seeds), jobs, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    run_seed(
        comparison, place, [&](double share) { shared.set(place, share); }, runs);
  });
  return runs;
}

std::size_t runs_of(const Comparison& comparison) {
  return source_names.size() * comparison.seeds.size();
}

std::vector<std::string> warnings(const ComparedRuns& runs) {
  std::vector<std::string> all;
  for (std::size_t k = 1; k < runs.size(); ++k) {
    for (const ComparedRun& run : runs[k]) {
      if (run.mismatch <= allowed_mismatch) continue;
      all.push_back(fmt::format("{}, seed {}: mean and RMS could be matched to {:.2g} % only", source_names[k],
                                run.seed, 100.0 * run.mismatch));
    }
  }
  return all;
}

runtime::ClampTally clamps_of_all(const ComparedRuns& runs) {
  runtime::ClampTally sum;
  for (const ComparedRun& run : runs[0]) sum += run.summary.clamps;
  return sum;
}

std::vector<std::string> other_runs(const Comparison& comparison) {
  std::vector<std::string> others;
  for (const char* source : source_names) {
    for (const base::NumberedFile& file :
         base::numbered_files(comparison.folder, {.begin = fmt::format("{}_", source), .end = ".h5"})) {
      if (std::find(comparison.seeds.begin(), comparison.seeds.end(), file.number) == comparison.seeds.end())
        others.push_back(file.path.filename().string());
    }
  }
  return others;
}

}  // namespace bitrock::studies
