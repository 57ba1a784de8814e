#include "studies/drill/drill_map.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/steadiness.hpp"

namespace bitrock::studies {

namespace {

using base::kN, base::rpm;

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double most_steps = 1e12;  // of all runs together: some two months of one core

std::string in_a_cell(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '\n' || c == '"') c = ';';
  }
  return text;
}

void run_point(const DrillMap& map, MapPoint& point) {
  runtime::DrillCase drill = map.drill;
  drill.drive.hook_load = point.hook_load_kN * kN;
  drill.drive.rotation = point.rotation_rpm * rpm;
  drill.source.seed = point.seed;
  const runtime::DrillString string = runtime::assemble(drill);
  point.static_weight = runtime::static_weight_on_bit(string);
  point.steady_limit = runtime::steady_weight_limit(string, drill.drive.rotation);
  if (point.static_weight <= 0.0) {
    point.status = "hook load and jets carry the whole string";
    return;
  }
  try {
    point.summary = runtime::run_drill(drill, string, runtime::make_source(drill, map.model)).summary;
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

/// A map of so many steps is a year of one core, and more.
void refuse_endless(const DrillMap& map) {
  const double steps = runs_of(map) * (map.drill.run.duration / runtime::step_of(map.drill.run));
  if (steps <= most_steps) return;
  throw base::InputError(
      fmt::format("{}: {} runs of {:g} s are {:.3g} steps (at most {:.0e}; fewer points, or a shorter run.duration_s)",
                  map.drill.name, runs_of(map), map.drill.run.duration, steps, most_steps));
}

}  // namespace

int runs_of(const DrillMap& map) {
  return static_cast<int>(map.hook_loads_kN.size() * map.rotations_rpm.size() * map.seeds.size());
}

void require_mappable(const DrillMap& map, const std::string& file) {
  if (!map.drill.drive.imposes_speed)
    throw base::InputError(file +
                           ": the top drive imposes a torque; a map over its speed needs one that imposes speed");
  if (is_fed(map.drill.hoist))
    throw base::InputError(file + ": the hoist is fed; a map over hook loads needs top_drive.hoist = 'load'");
  const runtime::DrillString string = runtime::assemble(map.drill);
  if (string.axial.size() == 0) throw base::InputError(file + ": the string has no axial chain, and so no hook load");
  runtime::require_stable(map.drill, string);
  refuse_endless(map);
  runtime::make_source(map.drill, map.model);  // says what is missing
}

std::vector<MapPoint> points_of(const DrillMap& map) {
  std::vector<MapPoint> points;
  for (const double hook_load : map.hook_loads_kN) {
    for (const double rotation : map.rotations_rpm) {
      for (const int seed : map.seeds)
        points.push_back({.hook_load_kN = hook_load, .rotation_rpm = rotation, .seed = seed});
    }
  }
  return points;
}

void run_map(const DrillMap& map, int jobs, const base::ProgressCallback& progress, std::vector<MapPoint>& points) {
  base::SharedProgress shared(points.size(), progress);
  base::for_each_index(static_cast<int>(points.size()), jobs, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    run_point(map, points[place]);
    shared.set(place, 1.0);
  });
}

std::string map_csv(const std::vector<MapPoint>& points) {
  std::vector<std::string> names, statuses;
  std::vector<std::vector<double>> columns;
  const auto add = [&](const char* name, const auto& value) {
    names.emplace_back(name);
    std::vector<double>& column = columns.emplace_back();
    for (const MapPoint& point : points) column.push_back(value(point));
  };
  const auto add_seen = [&](const char* name, const auto& value) {
    add(name, [&](const MapPoint& point) { return point.summary ? value(*point.summary) : none; });
  };
  using runtime::DrillSummary;
  add("hook_load_kN", [](const MapPoint& point) { return point.hook_load_kN; });
  add("rotation_rpm", [](const MapPoint& point) { return point.rotation_rpm; });
  add("seed", [](const MapPoint& point) { return point.seed; });
  add("static_weight_on_bit_kN", [](const MapPoint& point) { return point.static_weight / kN; });
  add("steady_weight_limit_kN", [](const MapPoint& point) { return point.steady_limit / kN; });
  add_seen("severity", [](const DrillSummary& s) { return s.severity; });
  add_seen("bit_rotation_min_rpm", [](const DrillSummary& s) { return s.bit_rotation.lowest / rpm; });
  add_seen("bit_rotation_max_rpm", [](const DrillSummary& s) { return s.bit_rotation.highest / rpm; });
  add_seen("share_at_rest", [](const DrillSummary& s) { return s.share_at_rest; });
  add_seen("share_backwards", [](const DrillSummary& s) { return s.share_backwards; });
  add_seen("share_off_bottom", [](const DrillSummary& s) { return s.share_off_bottom; });
  add_seen("weight_on_bit_min_kN", [](const DrillSummary& s) { return s.weight_on_bit.lowest / kN; });
  add_seen("weight_on_bit_max_kN", [](const DrillSummary& s) { return s.weight_on_bit.highest / kN; });
  add_seen("rop_mean_m_per_h", [](const DrillSummary& s) { return s.rop.mean / base::m_per_h; });
  add_seen("depth_clamped_share", [](const DrillSummary& s) { return depth_clamped(s.clamps); });
  for (const MapPoint& point : points) statuses.push_back(point.status);
  return base::csv_text(names, columns, "status", statuses);
}

std::vector<double> severities(const DrillMap& map, const std::vector<MapPoint>& points) {
  std::vector<double> means;
  for (std::size_t first = 0; first < points.size(); first += map.seeds.size()) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = first; k < first + map.seeds.size(); ++k) {
      if (!points[k].summary) continue;
      sum += points[k].summary->severity;
      ++count;
    }
    means.push_back(count > 0 ? sum / count : none);
  }
  return means;
}

MapTally tally_of(const DrillMap& map, const std::vector<MapPoint>& points) {
  MapTally tally;
  const double bearable = runtime::most_weight_on_bit(map.drill.bit);
  for (const MapPoint& point : points) {
    if (point.static_weight > bearable) ++tally.overloaded;
    if (!point.summary) {
      ++tally.failed;
      continue;
    }
    tally.clamps += point.summary->clamps;
    const runtime::DrillCondition seen = runtime::condition(*point.summary, point.rotation_rpm * rpm);
    tally.steady += seen.steady ? 1 : 0;
    tally.stick_slip += seen.stick_slip ? 1 : 0;
    tally.bit_bounce += seen.bit_bounce ? 1 : 0;
  }
  return tally;
}

std::vector<std::string> warnings(const DrillMap& map, const MapTally& seen) {
  std::vector<std::string> all;
  if (seen.failed > 0) all.push_back(fmt::format("{} runs failed; column status says why", seen.failed));
  if (seen.overloaded > 0) {
    all.push_back(
        fmt::format("{} of {} runs have a static weight on bit above {:.3g} kN, more than a bit of {:.4g} "
                    "mm bears (rule of thumb, not a maker's table)",
                    seen.overloaded, runs_of(map), runtime::most_weight_on_bit(map.drill.bit) / base::kN,
                    map.drill.bit.diameter * 1e3));
  }
  return all;
}

}  // namespace bitrock::studies
