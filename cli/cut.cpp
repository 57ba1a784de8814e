// bitrock cut: one cut of one cutter through a bed of rock.
#include <memory>

#include "base/errors.hpp"
#include "cli/command.hpp"
#include "dem2d/files/run_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "views/json/cut_json.hpp"
#include "views/text/cut_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string case_file, output, specimen_file;
  int seed = 1;
  int frames = 0;
  bool without_energy = false;
};

/// The bed of the case: from a file when one is named, otherwise made.
dem2d::Specimen bed_of(const Options& options, const dem2d::CutCase& cut) {
  if (options.specimen_file.empty()) {
    Progress progress(options.common, "packing the rock", "");
    return dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, static_cast<std::uint64_t>(options.seed),
                                options.common.threads, progress.callback());
  }
  dem2d::Specimen specimen = dem2d::read_specimen(options.specimen_file);
  const std::string why =
      dem2d::mismatch(specimen, cut.rock, cut.bed_length, cut.bed_height, static_cast<std::uint64_t>(options.seed));
  if (!why.empty()) throw base::InputError(options.specimen_file + ": " + why);
  specimen.seed = static_cast<std::uint64_t>(options.seed);  // of discs packed elsewhere: what is random in the joints
  return specimen;
}

void print_plan(const Options& options, const dem2d::CutCase& cut) {
  const dem2d::Specimen bed = bed_of(options, cut);
  const dem2d::World world = dem2d::make_cut_world(cut, bed);
  const dem2d::CutSchedule plan = dem2d::plan_steps(cut, world.step);
  say(options.common, "{}", views::plan_line(bed, world.step, plan));
  write_json(options.common, views::plan_json(bed, world.step, plan));
}

void run(const Options& options) {
  const dem2d::CutCase cut = dem2d::read_cut_case(options.case_file);
  for (const std::string& warning : dem2d::warnings(cut)) warn(options.common, warning);
  dem2d::check_frames(options.frames, dem2d::expected_discs(cut.rock, cut.bed_length, cut.bed_height));
  if (options.common.check) {
    require_outputs(options.common, {options.case_file, options.specimen_file}, {});
    return print_plan(options, cut);
  }
  require_outputs(options.common, {options.case_file, options.specimen_file}, {options.output});
  const dem2d::Specimen bed = bed_of(options, cut);
  for (const std::string& warning : dem2d::warnings(bed)) warn(options.common, warning);
  dem2d::CutRun result;
  {
    Progress settling(options.common, "pressing the rock", ""), progress(options.common, "cutting", "ms", 1e3);
    result = dem2d::run_cut(cut, bed,
                            {.threads = options.common.threads,
                             .frames = options.frames,
                             .settling = settling.callback(),
                             .measure_energy = !options.without_energy},
                            progress.callback());
  }
  dem2d::write_run(result, cut, static_cast<std::uint64_t>(options.seed), options.output);

  write_json(options.common, views::as_json(result));
  say(options.common, "{}-> {}\n", views::cut_lines(result), options.output);
  warn(options.common, dem2d::warnings(result));
}

}  // namespace

void add_cut(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("cut", "Cuts synthetic rock with one PDC cutter and records the force on it.");
  command->add_option("case", options->case_file, "The cut file, e.g. campaigns/cuts/example.toml.")->required();
  command
      ->add_option("--seed", options->seed,
                   "The seed chooses the rock: another seed packs another one of the same kind.")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "The force, the cracks and the discs go to this run file (.h5).")
      ->default_val("run.h5");
  command
      ->add_option("--specimen", options->specimen_file,
                   "The cutter cuts this specimen, made by `bitrock specimen`, instead of a new rock.")
      ->check(not_empty());
  command
      ->add_option("--frames", options->frames,
                   "The run file keeps all discs at so many evenly spaced instants, for pictures and animations.")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  command->add_flag("--no-energy", options->without_energy,
                    "The program does not measure where the energy goes. The cut is a sixth faster.");
  add_computing(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
