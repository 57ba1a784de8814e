// bitrock drill map: how a drill string turns over hook load and speed, one short run a point.
#include <chrono>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "base/value_lists.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/drill_parts.hpp"
#include "report/draw.hpp"
#include "studies/drill/drill_map.hpp"
#include "views/drill/map_picture.hpp"
#include "views/json/drill_json.hpp"
#include "views/text/drill_plan_lines.hpp"

namespace bitrock::cli {

namespace {

constexpr int most_runs = 100000;  // a day or so of two cores

struct Options {
  CommonOptions common;
  CaseFlags drill;
  std::string output, picture, hook_loads, rotations, seeds;
  int jobs = 1;
};

std::filesystem::path script_of(const Options& options) {
  return std::filesystem::path(options.picture).replace_extension(".gp");
}

void write_picture(const Options& options, const studies::DrillMap& map, const std::vector<studies::MapPoint>& points) {
  const std::filesystem::path picture = options.picture;
  const auto format = picture.extension() == ".pdf" ? report::PictureFormat::pdf : report::PictureFormat::png;
  const std::string script =
      report::heat_map_script(views::drill_map_picture(map, points), picture.filename().string(), format);
  base::write_whole(script_of(options), script);
  if (!report::can_draw()) {
    return warn(options.common, fmt::format("{}, so nothing was drawn; the script is {}", report::no_gnuplot,
                                            script_of(options).string()));
  }
  report::draw({.script = script, .table = ""}, picture);
  say(options.common, "-> {}, drawn by {}\n", options.picture, script_of(options).string());
}

studies::DrillMap read_map(const Options& options) {
  studies::DrillMap map{.drill = read_case(options.drill),
                        .model = {},
                        .hook_loads_kN = base::value_range("--hook-load-kN", options.hook_loads, 0.0, 1e5),
                        .rotations_rpm = base::value_range("--rotation-rpm", options.rotations, 0.1, 500.0),
                        .seeds = base::seeds_in("--seeds", options.seeds)};
  if (studies::runs_of(map) > most_runs) {
    throw base::InputError(fmt::format("{} hook loads times {} speeds times {} seeds are {} runs (at most {})",
                                       map.hook_loads_kN.size(), map.rotations_rpm.size(), map.seeds.size(),
                                       studies::runs_of(map), most_runs));
  }
  if (!options.picture.empty()) {
    const std::string ending = std::filesystem::path(options.picture).extension().string();
    if (ending != ".png" && ending != ".pdf")
      throw base::InputError(fmt::format("--picture {} (must end in .png or .pdf)", options.picture));
    if (map.hook_loads_kN.size() < 2 || map.rotations_rpm.size() < 2)
      throw base::InputError("--picture needs at least two hook loads and two speeds");
  }
  map.model = model_of(options.common, options.drill, map.drill);
  for (const std::string& warning : runtime::warnings(map.drill.bit)) warn(options.common, warning);
  studies::require_mappable(map, options.drill.file);
  return map;
}

void report_points(const Options& options, const studies::DrillMap& map, const std::vector<studies::MapPoint>& points,
                   double wall_time) {
  const studies::MapTally seen = studies::tally_of(map, points);
  say(options.common, "{} runs in {:.3g} s: {} steady, {} with stick-slip, {} with bit bounce, {} failed -> {}\n",
      points.size(), wall_time, seen.steady, seen.stick_slip, seen.bit_bounce, seen.failed, options.output);
  warn(options.common, studies::warnings(map, seen));
  tell(options.common, views::remarks(seen.clamps, "column depth_clamped_share says where"));
  write_json(options.common, views::as_json(seen, points.size(), wall_time));
}

void run(const Options& options) {
  const studies::DrillMap map = read_map(options);
  std::vector<std::filesystem::path> outputs{options.output};
  if (!options.picture.empty()) outputs.insert(outputs.end(), {options.picture, script_of(options)});
  const std::vector<std::filesystem::path> inputs = inputs_of(options.drill, map.drill);
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    say(options.common, "{}", views::plan_line(map));
    return write_json(options.common, {{"runs", studies::runs_of(map)}});
  }
  require_outputs(options.common, inputs, outputs);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<studies::MapPoint> points = studies::points_of(map);
  std::optional<base::Saving> saving(std::in_place);
  try {
    Progress progress(options.common, "drilling", "runs");
    studies::run_map(map, options.jobs, progress.callback(), points);
  } catch (const base::Interrupted&) {
    base::write_whole(options.output, studies::map_csv(points));
    warn(options.common,
         fmt::format("stopped: {} holds the finished runs; column status names the others", options.output));
    throw;
  }
  saving.reset();
  base::write_whole(options.output, studies::map_csv(points));
  report_points(options, map, points, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (!options.picture.empty()) write_picture(options, map, points);
}

}  // namespace

void add_drill_map(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      drill.add_subcommand("map", "Maps stick-slip and bit bounce over the hook load and the speed of the top drive.");
  add_case(*command, options->drill, "stick_slip.toml");
  command
      ->add_option("--hook-load-kN", options->hook_loads,
                   "The map covers these hook loads, lowest:highest:count, not the one of the case.")
      ->default_val("5:38:12");
  command
      ->add_option("--rotation-rpm", options->rotations,
                   "The map covers these speeds of the top drive, lowest:highest:count, not the one of the case.")
      ->default_val("20:140:12");
  command
      ->add_option(
          "--seeds", options->seeds,
          "Each seed draws another force of the same kind, e.g. 1,2,5:10. The picture shows the mean over the seeds.")
      ->default_val("1");
  add_jobs(*command, options->jobs, "runs");
  command->add_option("-o,--output", options->output, "The table goes to this file, with a row a run (.csv).")
      ->default_val("map.csv")
      ->check(not_empty());
  command
      ->add_option(
          "--picture", options->picture,
          "The map is also drawn to this picture (.png, .pdf) with gnuplot, whose script stands beside it (.gp).")
      ->check(not_empty());
  add_common(*command, options->common);
  add_check(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
