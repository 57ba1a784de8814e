#include "studies/well/broomstick.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "runtime/well/step.hpp"
#include "studies/well/steady_sliding.hpp"

namespace bitrock::studies {

namespace {

using runtime::WellCase, runtime::WellString;

// [1] of its length is what a string is fed or pulled in a period at first. Friction does not depend on speed; the way
// must be long enough for friction to stretch the string: 70 kN in 5 in drill pipe in a period.
constexpr double way_over_length = 1e-4;
constexpr double usual_rotation = 60 * base::rpm;  // [rad/s] where the case does not turn its string
constexpr int usual_count = 20;

/// [m] of all pipes but the first.
double lower_length(const WellCase& well) {
  double length = 0.0;
  for (std::size_t i = 1; i < well.pipes.size(); ++i) length += well.pipes[i].pipe.length;
  return length;
}

/// Sets the friction of the lowest section of the hole, and those above in proportion.
void set_friction(WellCase& well, double friction) {
  const double lowest = well.hole.back().friction;
  for (runtime::HoleSection& hole : well.hole) {
    hole.friction = hole.friction == lowest ? friction : hole.friction * (friction / lowest);
    hole.resting_friction = 0.0;  // one coefficient a curve
  }
}

/// The string of the case cut to a length at its upper end, off bottom. Its lower end rubs as its joints do, also where
/// the case gives the bit no gauge: something must carry the last half segment.
WellString string_of(const Broomstick& broomstick, double length, double friction) {
  WellCase well = broomstick.well;
  set_friction(well, friction);
  well.pipes.front().pipe.length = length - lower_length(well);
  WellString string = runtime::assemble(well);
  string.on_rock = false;
  string.control = {};         // steady: the drive does not give way
  string.hoist_pushes = true;  // what it would take is told, also where a line could not
  string.growth = runtime::Growth::grow;
  string.longest_grown = 0.0;
  string.gauge_radius = std::max(string.gauge_radius, string.sections.back().contact_radius);
  return string;
}

/// A string, the step that is short enough for it, and how fast it is fed or pulled.
struct Cut {
  WellString string;
  double step, feed_speed;  // [s], [m/s]
};

/// The string whose bit is at a depth when it has moved for the shortest time. It is stretched by its weight, so less
/// pipe reaches there. Its uppermost segment is one of its own, which gets longer, or is longer and gets shorter.
Cut cut_for(const Broomstick& broomstick, const BroomstickRow& row) {
  WellString string = string_of(broomstick, row.bit_depth, row.friction);
  const double stretch = hung_in_hole(string).bit.depth - row.bit_depth;
  const double way = way_over_length * row.bit_depth;  // in a period
  const double least = least_periods * way, most = most_periods * way;
  double shortest = string.sections.front().length - stretch;
  if (row.operation == Operation::run_in) shortest -= least;
  if (row.operation == Operation::pull_out) shortest += least - most;

  runtime::StringSection& rest = string.sections.front();
  const int bars =
      std::max(2, static_cast<int>(std::ceil(shortest / broomstick.well.pipes.front().segment_length * (1.0 - 1e-12))));
  const double bar = shortest / bars;
  rest.segments = bars - 1;
  rest.length = bar * rest.segments;
  runtime::StringSection top = rest;
  top.segments = 1;
  top.length = bar;
  string.sections.insert(string.sections.begin(), top);
  runtime::require_consistent(string);
  const double step = longest_allowed_step(string);
  if (row.operation == Operation::pull_out) string.sections.front().length += most;
  return {string, step, way / slow_period(string)};
}

runtime::RigControls speeds_of(const Broomstick& broomstick, Operation operation, double feed_speed) {
  const double rotation = broomstick.well.plan.rotation;
  switch (operation) {
    case Operation::run_in:
      return {.feed_speed = feed_speed};
    case Operation::pull_out:
      return {.feed_speed = -feed_speed};
    case Operation::rotate:
      break;
  }
  return {.drive_speed = rotation != 0.0 ? rotation : usual_rotation};
}

void run_row(const Broomstick& broomstick, BroomstickRow& row) {
  try {
    const Cut cut = cut_for(broomstick, row);
    const SteadySliding found =
        slide_steadily(cut.string, speeds_of(broomstick, row.operation, cut.feed_speed), cut.step);
    row.hook_load = found.hook_load;
    row.torque = found.torque;
    row.steady = found.steady;
  } catch (const base::InputError& error) {
    row.failure = error.what();
  } catch (const base::SimulationError& error) {
    row.failure = error.what();
  }
}

std::string where(const BroomstickRow& row) {
  return fmt::format("{} at {:g} m with friction {:g}", name_of(row.operation), row.bit_depth, row.friction);
}

}  // namespace

const char* name_of(Operation operation) {
  switch (operation) {
    case Operation::run_in:
      return "run_in";
    case Operation::pull_out:
      return "pull_out";
    case Operation::rotate:
      break;
  }
  return "rotate";
}

double shortest_depth(const WellCase& well) {
  return 1.01 * lower_length(well) + 2.0 * well.pipes.front().segment_length;
}

double greatest_depth(const WellCase& well) {
  if (well.bottom_depth > 0.0) return well.bottom_depth;
  return std::min(well.stations.back().measured_depth, well.hole.back().to_depth);
}

std::vector<double> usual_depths(const WellCase& well) {
  const double to = greatest_depth(well);
  double from = shortest_depth(well);
  for (const runtime::WellArc& arc : runtime::well_path(well.stations).arcs) {
    if (arc.curvature == 0.0) continue;
    from = std::max(from, arc.begin);
    break;
  }
  if (from >= to) return {to};
  std::vector<double> depths;
  depths.reserve(usual_count);
  for (int i = 0; i < usual_count; ++i) depths.push_back(from + (to - from) * i / (usual_count - 1));
  return depths;
}

std::vector<double> usual_frictions(const WellCase& well) {
  const double friction = well.hole.back().friction;
  if (friction == 0.0) return {0.0};
  return {0.8 * friction, friction, 1.2 * friction};
}

void require_possible(const Broomstick& broomstick) {
  const WellCase& well = broomstick.well;
  const auto refuse = [&](const std::string& what) { throw base::InputError(well.drill.name + ": " + what); };
  const double least = shortest_depth(well), most = greatest_depth(well);
  for (std::size_t i = 0; i < broomstick.depths.size(); ++i) {
    const double depth = broomstick.depths[i];
    if (!(depth >= least))
      refuse(
          fmt::format("bit at {:g} m (at least {:g} m: the pipes below the first one, two segments of that and a "
                      "hundredth)",
                      depth, least));
    if (!(depth <= most)) refuse(fmt::format("bit at {:g} m (at most {:g} m: the hole ends there)", depth, most));
    if (i > 0 && !(depth > broomstick.depths[i - 1]))
      refuse(fmt::format("depths {:g} m, then {:g} m (each must be below the one before)", broomstick.depths[i - 1],
                         depth));
  }
  const double lowest = well.hole.back().friction;
  const bool alike = std::all_of(well.hole.begin(), well.hole.end(),
                                 [lowest](const runtime::HoleSection& hole) { return hole.friction == lowest; });
  if (lowest == 0.0 && !alike)
    refuse(
        "the lowest [[hole]] has no friction, but one above it has (other frictions keep their share of the lowest)");
  for (const double friction : broomstick.frictions)
    if (!(friction >= 0.0 && std::isfinite(friction)))
      refuse(fmt::format("friction {:g} (must be 0 or more)", friction));
  for (const BroomstickRow& row : rows_of(broomstick)) cut_for(broomstick, row);
}

std::vector<BroomstickRow> rows_of(const Broomstick& broomstick) {
  std::vector<BroomstickRow> rows;
  for (const double depth : broomstick.depths)
    for (const double friction : broomstick.frictions)
      for (const Operation operation : {Operation::run_in, Operation::pull_out, Operation::rotate})
        rows.push_back({.bit_depth = depth, .friction = friction, .operation = operation, .failure = {}});
  return rows;
}

void run_broomstick(const Broomstick& broomstick, int jobs, const base::ProgressCallback& progress,
                    std::vector<BroomstickRow>& rows) {
  base::SharedProgress shared(rows.size(), progress);
  base::for_each_index(static_cast<int>(rows.size()), jobs, [&](int i) {
    const auto place = static_cast<std::size_t>(i);
    run_row(broomstick, rows[place]);
    shared.set(place, 1.0);
  });
}

std::string broomstick_csv(const std::vector<BroomstickRow>& rows) {
  std::vector<std::vector<double>> columns(5);
  std::vector<std::string> operations;
  for (const BroomstickRow& row : rows) {
    columns[0].push_back(row.bit_depth);
    columns[1].push_back(row.friction);
    columns[2].push_back(row.hook_load);
    columns[3].push_back(row.torque);
    columns[4].push_back(row.steady ? 1.0 : 0.0);
    operations.emplace_back(name_of(row.operation));
  }
  return base::csv_text({"bit_depth_m", "friction", "hook_load_N", "torque_N_m", "steady"}, columns, "operation",
                        operations);
}

std::vector<std::string> warnings(const std::vector<BroomstickRow>& rows) {
  std::vector<std::string> found;
  for (const BroomstickRow& row : rows) {
    if (!row.failure.empty()) found.push_back(where(row) + ": " + row.failure);
    if (std::isnan(row.hook_load)) continue;
    if (!row.steady)
      found.push_back(fmt::format("{}: hook load and torque still change after {} periods of the string", where(row),
                                  most_periods));
    if (row.operation == Operation::run_in && row.hook_load < 0.0)
      found.push_back(where(row) + ": the hook load is below 0, the string must be pushed");
  }
  return found;
}

}  // namespace bitrock::studies
