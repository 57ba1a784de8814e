// bitrock drill compare of a case with a [well]: stresses and damage of its string under the networks, under a sinusoid
// of the same mean and RMS, and without excitation.
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "base/value_lists.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/drill_parts.hpp"
#include "studies/well/comparison.hpp"
#include "views/json/well_json.hpp"

namespace bitrock::cli {

namespace {

using studies::well_source_names, studies::WellComparison;

WellComparison read_comparison(const CommonOptions& common, const CaseFlags& flags, const std::string& seeds,
                               const std::string& folder) {
  WellComparison comparison{.well = read_well(common, flags.file),
                            .string = {},
                            .model = {},
                            .model_fingerprint = {},
                            .seeds = base::seeds_in("--seeds", seeds),
                            .folder = folder};
  runtime::WellCase& well = comparison.well;
  take_mode(flags.mode, well.drill.bit);
  if (well.drill.source.kind != runtime::SourceKind::bit)
    throw base::InputError(
        fmt::format("{}: the source of the case must be 'bit': the others are measured against it", flags.file));
  if (well.stress_points.empty())
    throw base::InputError(fmt::format("{}: the case has no [[stress_point]] to compare", flags.file));
  comparison.model = model_of(common, flags, well.drill);
  comparison.string = runtime::assemble(well);
  runtime::require_stable(well, comparison.string);
  runtime::make_source(well.drill, comparison.model);  // says what is missing
  comparison.model_fingerprint = base::fingerprint_text(base::read_whole(well.drill.source.model_file));
  return comparison;
}

std::vector<std::filesystem::path> outputs_of(const WellComparison& comparison) {
  std::vector<std::filesystem::path> outputs{comparison.folder / "summary.csv", comparison.folder / "summary.md"};
  for (std::size_t source = 0; source < well_source_names.size(); ++source) {
    for (const int seed : comparison.seeds) {
      const std::filesystem::path file = studies::run_file(comparison, source, seed);
      if (file != outputs.back()) outputs.push_back(file);
    }
  }
  return outputs;
}

}  // namespace

void compare_in_well(const CommonOptions& common, const CaseFlags& flags, const std::string& seeds, int jobs,
                     const std::string& folder) {
  const WellComparison comparison = read_comparison(common, flags, seeds, folder);
  std::vector<std::filesystem::path> inputs = inputs_of(flags, comparison.well.drill);
  inputs.push_back(comparison.well.survey_file);
  const std::size_t runs_in_all = 2 * comparison.seeds.size() + 1;
  if (common.check) {
    require_outputs(common, inputs, {});
    say(common, "{}: {} runs of {:.0f} s, which share their trip; sinusoids take some trials each\n",
        comparison.well.drill.name, runs_in_all, comparison.well.drill.run.duration);
    return write_json(common, {{"runs", runs_in_all}});
  }
  base::require_writable_folder(comparison.folder);
  require_outputs(common, inputs, outputs_of(comparison));
  studies::ComparedWells runs;
  {
    Progress progress(common, "drilling", "seeds");
    runs = studies::run_comparison(comparison, jobs, progress.callback());
  }
  const std::string table = studies::compared_table(runs);
  base::write_whole(comparison.folder / "summary.csv", studies::compared_csv(runs));
  base::write_whole(comparison.folder / "summary.md", table);
  say(common, "{}, {} seeds, mean ± standard deviation over the seeds\n\n{}\n-> {}\n", comparison.well.drill.name,
      comparison.seeds.size(), table, folder);
  for (const std::string& warning : studies::warnings(runs)) warn(common, warning);
  write_json(common, views::as_json(runs));
}

}  // namespace bitrock::cli
