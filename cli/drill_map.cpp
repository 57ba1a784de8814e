// bitrock drill map: how a drill string turns over hook load and speed, one short run a point.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/parallel.hpp"
#include "base/stop.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/draw.hpp"
#include "cli/drill_parts.hpp"
#include "cli/ranges.hpp"
#include "report/heat_map.hpp"
#include "runtime/drillstring/condition.hpp"
#include "runtime/drillstring/steadiness.hpp"

namespace cli {

namespace {

constexpr double rpm = 2.0 * std::numbers::pi / 60.0, kN = 1e3, m_per_h = 1.0 / 3600.0;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr int most_runs = 100000;    // a day or so of two cores
constexpr double most_steps = 1e12;  // of all runs together: some two months of one core
// At a severity of 1 the bit comes to rest and swings to double the mean; what turns back is a little above.
constexpr double greatest_severity = 1.2;

struct Options {
  CommonOptions common;
  std::string case_file, model_file, output, picture, hook_loads, rotations, seeds;
  int jobs = 1;
};

struct Study {
  runtime::DrillCase drill;
  std::optional<surrogate::Model> model;
  std::vector<double> hook_loads;  ///< [kN]
  std::vector<double> rotations;   ///< [rpm]
  std::vector<int> seeds;
  int runs() const { return static_cast<int>(hook_loads.size() * rotations.size() * seeds.size()); }
};

struct Point {
  double hook_load = 0.0, rotation = 0.0;  ///< [kN], [rpm]
  int seed = 0;
  double static_weight = 0.0, steady_limit = 0.0;  ///< [N]
  std::optional<runtime::DrillSummary> summary;    ///< none where the run failed
  std::string status = "not run";                  ///< then "ok", or the reason of the failure, without commas
};

/// Seeds side by side, then speeds, then hook loads.
Point point_at(const Study& study, int index) {
  const auto i = static_cast<std::size_t>(index), seeds = study.seeds.size(), rotations = study.rotations.size();
  return {.hook_load = study.hook_loads[i / (seeds * rotations)],
          .rotation = study.rotations[i / seeds % rotations],
          .seed = study.seeds[i % seeds]};
}

std::string in_a_cell(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '\n' || c == '"') c = ';';
  }
  return text;
}

void run_point(const Study& study, Point& point) {
  runtime::DrillCase drill = study.drill;
  drill.drive.hook_load = point.hook_load * kN;
  drill.drive.rotation = point.rotation * rpm;
  drill.source.seed = point.seed;
  const runtime::DrillString string = runtime::assemble(drill);
  point.static_weight = runtime::static_weight_on_bit(string);
  point.steady_limit = runtime::steady_weight_limit(string, drill.drive.rotation);
  if (point.static_weight <= 0.0) {
    point.status = "hook load and jets carry the whole string";
    return;
  }
  try {
    point.summary = runtime::run_drill(drill, string, runtime::make_source(drill, study.model)).summary;
    point.status = "ok";
  } catch (const base::InputError& error) {
    point.status = in_a_cell(error.what());
  } catch (const base::SimulationError& error) {
    point.status = in_a_cell(error.what());
  }
}

double depth_clamped(const runtime::ClampTally& clamps) {
  return clamps.asked > 0
             ? static_cast<double>(clamps.depth_below + clamps.depth_above) / static_cast<double>(clamps.asked)
             : 0.0;
}

std::string map_csv(const std::vector<Point>& points) {
  std::vector<std::string> names, statuses;
  std::vector<std::vector<double>> columns;
  const auto add = [&](const char* name, const auto& value) {
    names.emplace_back(name);
    std::vector<double>& column = columns.emplace_back();
    for (const Point& point : points) column.push_back(value(point));
  };
  const auto add_seen = [&](const char* name, const auto& value) {
    add(name, [&](const Point& point) { return point.summary ? value(*point.summary) : none; });
  };
  using runtime::DrillSummary;
  add("hook_load_kN", [](const Point& point) { return point.hook_load; });
  add("rotation_rpm", [](const Point& point) { return point.rotation; });
  add("seed", [](const Point& point) { return point.seed; });
  add("static_weight_on_bit_kN", [](const Point& point) { return point.static_weight / kN; });
  add("steady_weight_limit_kN", [](const Point& point) { return point.steady_limit / kN; });
  add_seen("severity", [](const DrillSummary& s) { return s.severity; });
  add_seen("bit_rotation_min_rpm", [](const DrillSummary& s) { return s.bit_rotation.lowest / rpm; });
  add_seen("bit_rotation_max_rpm", [](const DrillSummary& s) { return s.bit_rotation.highest / rpm; });
  add_seen("share_at_rest", [](const DrillSummary& s) { return s.share_at_rest; });
  add_seen("share_backwards", [](const DrillSummary& s) { return s.share_backwards; });
  add_seen("share_off_bottom", [](const DrillSummary& s) { return s.share_off_bottom; });
  add_seen("weight_on_bit_min_kN", [](const DrillSummary& s) { return s.weight_on_bit.lowest / kN; });
  add_seen("weight_on_bit_max_kN", [](const DrillSummary& s) { return s.weight_on_bit.highest / kN; });
  add_seen("rop_mean_m_per_h", [](const DrillSummary& s) { return s.rop.mean / m_per_h; });
  add_seen("depth_clamped_share", [](const DrillSummary& s) { return depth_clamped(s.clamps); });
  for (const Point& point : points) statuses.push_back(point.status);
  return base::csv_text(names, columns, "status", statuses);
}

/// Mean severity over the seeds of a cell that did not fail.
double severity_at(const Study& study, const std::vector<Point>& points, std::size_t cell) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < study.seeds.size(); ++k) {
    const Point& point = points[cell * study.seeds.size() + k];
    if (!point.summary) continue;
    sum += point.summary->severity;
    ++count;
  }
  return count > 0 ? sum / count : none;
}

/// Hook load at which friction takes all the damping of the string, where there is such a load.
report::Series limit_of(const Study& study, double total_weight) {
  report::Series limit{.name = "limit of steady rotation: WOB r |μ'| = c_eq",
                       .x = {},
                       .y = {},
                       .style = report::Style::line,
                       .colour = report::Colour::orange};
  const double first = study.rotations.front(), last = study.rotations.back();
  const double half_cell = 0.5 * (last - first) / static_cast<double>(study.rotations.size() - 1);
  const runtime::DrillString string = runtime::assemble(study.drill);
  constexpr int pieces = 200;
  for (int i = 0; i <= pieces; ++i) {
    const double speed = std::max(1e-3, first - half_cell + (last - first + 2.0 * half_cell) * i / pieces);
    limit.x.push_back(speed);
    limit.y.push_back((total_weight - runtime::steady_weight_limit(string, speed * rpm)) / kN);
  }
  return limit;
}

report::HeatMap heat_map(const Study& study, const std::vector<Point>& points) {
  std::vector<double> values;
  for (std::size_t cell = 0; cell < study.hook_loads.size() * study.rotations.size(); ++cell)
    values.push_back(severity_at(study, points, cell));
  runtime::DrillCase unhooked = study.drill;
  unhooked.drive.hook_load = 0.0;
  const double weight = runtime::static_weight_on_bit(runtime::assemble(unhooked));
  const report::Series here{.name = "the case",
                            .x = {study.drill.drive.rotation / rpm},
                            .y = {study.drill.drive.hook_load / kN},
                            .style = report::Style::markers,
                            .colour = report::Colour::vermillion};
  return {.title = study.drill.name,
          .x_label = "speed of the top drive [rpm]",
          .y_label = "hook load [kN]",
          .value_label = "severity (max - min) / (2 mean) of the bit's speed [1]",
          .x = study.rotations,
          .y = study.hook_loads,
          .value = values,
          .value_range = {0.0, greatest_severity},
          .curves = {limit_of(study, weight), here},
          .right = {.label = "static weight on bit [kN]",
                    .at_first = weight / kN - study.hook_loads.front(),
                    .at_last = weight / kN - study.hook_loads.back()},
          .no_value = "no run"};
}

std::filesystem::path script_of(const Options& options) {
  return std::filesystem::path(options.picture).replace_extension(".gp");
}

void write_picture(const Options& options, const Study& study, const std::vector<Point>& points) {
  const std::filesystem::path picture = options.picture;
  const auto format = picture.extension() == ".pdf" ? report::PictureFormat::pdf : report::PictureFormat::png;
  const std::string script = report::heat_map_script(heat_map(study, points), picture.filename().string(), format);
  base::write_whole(script_of(options), script);
  if (!can_draw()) {
    return warn(options.common,
                fmt::format("{}, so nothing was drawn; the script is {}", no_gnuplot, script_of(options).string()));
  }
  draw({.script = script, .table = ""}, picture);
  say(options.common, "-> {}, drawn by {}\n", options.picture, script_of(options).string());
}

/// A map of so many steps is a year of one core, and more.
void refuse_endless(const Study& study) {
  const double steps = study.runs() * (study.drill.run.duration / runtime::step_of(study.drill.run));
  if (steps <= most_steps) return;
  throw base::InputError(
      fmt::format("{}: {} runs of {:g} s are {:.3g} steps (at most {:.0e}; fewer points, or a shorter run.duration_s)",
                  study.drill.name, study.runs(), study.drill.run.duration, steps, most_steps));
}

Study read_study(const Options& options) {
  Study study{.drill = runtime::read_drill_case(options.case_file),
              .model = {},
              .hook_loads = value_range("--hook-load-kN", options.hook_loads, 0.0, 1e5),
              .rotations = value_range("--rotation-rpm", options.rotations, 0.1, 500.0),
              .seeds = seed_range("--seeds", options.seeds)};
  if (study.runs() > most_runs) {
    throw base::InputError(fmt::format("{} hook loads times {} speeds times {} seeds are {} runs (at most {})",
                                       study.hook_loads.size(), study.rotations.size(), study.seeds.size(),
                                       study.runs(), most_runs));
  }
  if (!study.drill.drive.imposes_speed)
    throw base::InputError(options.case_file +
                           ": the top drive imposes a torque; a map over its speed needs one that "
                           "imposes speed");
  if (!options.picture.empty()) {
    const std::string ending = std::filesystem::path(options.picture).extension().string();
    if (ending != ".png" && ending != ".pdf")
      throw base::InputError(fmt::format("--picture {} (must end in .png or .pdf)", options.picture));
    if (study.hook_loads.size() < 2 || study.rotations.size() < 2)
      throw base::InputError("--picture needs at least two hook loads and two speeds");
  }
  study.model = model_of(options.common, options.model_file, study.drill);
  const runtime::DrillString string = runtime::assemble(study.drill);
  for (const std::string& warning : runtime::warnings(study.drill.bit)) warn(options.common, warning);
  if (string.axial.size() == 0)
    throw base::InputError(options.case_file + ": the string has no axial chain, and so no hook load");
  runtime::require_stable(study.drill, string);
  refuse_endless(study);
  runtime::make_source(study.drill, study.model);  // says what is missing
  return study;
}

void report_points(const Options& options, const Study& study, const std::vector<Point>& points, double wall_time) {
  int failed = 0, steady = 0, stick_slip = 0, bounce = 0;
  runtime::ClampTally clamps;
  const double bearable = runtime::most_weight_on_bit(study.drill.bit);
  const auto overloaded =
      std::count_if(points.begin(), points.end(), [&](const Point& point) { return point.static_weight > bearable; });
  for (const Point& point : points) {
    if (!point.summary) {
      ++failed;
      continue;
    }
    add_clamps(clamps, point.summary->clamps);
    const runtime::DrillCondition seen = runtime::condition(*point.summary, point.rotation * rpm);
    steady += seen.steady ? 1 : 0;
    stick_slip += seen.stick_slip ? 1 : 0;
    bounce += seen.bit_bounce ? 1 : 0;
  }
  say(options.common, "{} runs in {:.3g} s: {} steady, {} with stick-slip, {} with bit bounce, {} failed -> {}\n",
      points.size(), wall_time, steady, stick_slip, bounce, failed, options.output);
  if (failed > 0) warn(options.common, fmt::format("{} runs failed; column status says why", failed));
  if (overloaded > 0) {
    warn(options.common,
         fmt::format("{} of {} runs have a static weight on bit above {:.3g} kN, more than a bit of {:.4g} "
                     "mm bears (rule of thumb, not a maker's table)",
                     overloaded, points.size(), bearable / kN, study.drill.bit.diameter * 1e3));
  }
  tell_clamps(options.common, clamps, "column depth_clamped_share says where");
  write_json(options.common, {{"runs", points.size()},
                              {"steady", steady},
                              {"stick_slip", stick_slip},
                              {"bit_bounce", bounce},
                              {"failed", failed},
                              {"wall_s", wall_time}});
}

void run_all(const Options& options, const Study& study, std::vector<Point>& points) {
  for (int i = 0; i < study.runs(); ++i) points[static_cast<std::size_t>(i)] = point_at(study, i);
  Progress progress(options.common, "drilling", "runs");
  base::SharedProgress shared(points.size(), progress.callback());
  base::for_each_index(study.runs(), options.jobs, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    run_point(study, points[place]);
    shared.set(place, 1.0);
  });
}

void map(const Options& options) {
  const Study study = read_study(options);
  std::vector<std::filesystem::path> outputs{options.output};
  if (!options.picture.empty()) outputs.insert(outputs.end(), {options.picture, script_of(options)});
  const std::vector<std::filesystem::path> inputs{options.case_file, study.drill.bit_file,
                                                  study.drill.source.model_file};
  if (options.common.check) {
    require_outputs(options.common, inputs, {});
    say(options.common, "{}: {} hook loads, {} speeds, {} seeds: {} runs of {:g} s and {:.0f} steps\n",
        study.drill.name, study.hook_loads.size(), study.rotations.size(), study.seeds.size(), study.runs(),
        study.drill.run.duration, study.drill.run.duration / runtime::step_of(study.drill.run));
    return write_json(options.common, {{"runs", study.runs()}});
  }
  require_outputs(options.common, inputs, outputs);
  const auto begin = std::chrono::steady_clock::now();
  std::vector<Point> points(static_cast<std::size_t>(study.runs()));
  std::optional<base::Saving> saving(std::in_place);
  try {
    run_all(options, study, points);
  } catch (const base::Interrupted&) {
    base::write_whole(options.output, map_csv(points));
    warn(options.common,
         fmt::format("stopped: {} holds the finished runs; column status names the others", options.output));
    throw;
  }
  saving.reset();
  base::write_whole(options.output, map_csv(points));
  report_points(options, study, points,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (!options.picture.empty()) write_picture(options, study, points);
}

}  // namespace

void add_drill_map(CLI::App& drill) {
  auto options = std::make_shared<Options>();
  options->jobs = cores();
  CLI::App* command =
      drill.add_subcommand("map", "stick-slip and bit bounce over hook load and speed of the top drive");
  command->add_option("case", options->case_file, "drilling case, e.g. campaigns/drill/stick_slip.toml")->required();
  command->add_option("--model", options->model_file, "model.json, instead of the one the case names")
      ->check(not_empty());
  command->add_option("--hook-load-kN", options->hook_loads, "lowest:highest:count, instead of the case's own")
      ->default_val("5:38:12");
  command->add_option("--rotation-rpm", options->rotations, "lowest:highest:count, instead of the case's own")
      ->default_val("20:140:12");
  command->add_option("--seeds", options->seeds, "of the excitation, first:last; the picture shows their mean")
      ->default_val("1:1");
  command->add_option("--jobs", options->jobs, "runs at a time, one core each")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "table to write, a row a run (.csv)")
      ->default_val("map.csv")
      ->check(not_empty());
  command->add_option("--picture", options->picture, "heat map to draw with gnuplot (.png, .pdf), and its script (.gp)")
      ->check(not_empty());
  add_common(*command, options->common);
  command->add_flag("--check", options->common.check, "read the input, print what follows from it, and stop");
  command->callback([options] { map(*options); });
}

}  // namespace cli
