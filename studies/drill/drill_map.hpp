#pragma once
/// How a drill string turns over hook load and speed of the top drive: one short run a point and seed, side by side.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/drillstring/condition.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::studies {

struct DrillMap {
  runtime::DrillCase drill;               ///< all but hook load, speed and seed; its drive imposes speed
  std::optional<surrogate::Model> model;  ///< the networks, where the source is a bit
  std::vector<double> hook_loads_kN;      ///< [kN] one row of points each
  std::vector<double> rotations_rpm;      ///< [rpm] of the top drive
  std::vector<int> seeds;                 ///< of the excitation
};

/// Number of runs: a hook load, a speed and a seed each.
int runs_of(const DrillMap& map);

/// One run: what was set, and what came of it.
struct MapPoint {
  double hook_load_kN = 0.0, rotation_rpm = 0.0;  ///< [kN], [rpm]
  int seed = 0;                                   ///< of the excitation
  /// Weight on bit when nothing moves, and `runtime::steady_weight_limit` at this speed [N].
  double static_weight = 0.0, steady_limit = 0.0;
  std::optional<runtime::DrillSummary> summary;  ///< none where the run failed
  std::string status = "not run";                ///< then "ok", or the reason of the failure, without commas
};

/// Throws `InputError` when the case cannot be mapped: it has no axial chain, imposes a torque, has an unstable step or
/// lacks a model, or all runs together would take months. `file` is the case's, for the message.
void require_mappable(const DrillMap& map, const std::string& file);

/// All points, none of which has been run: seeds side by side, then speeds, then hook loads.
std::vector<MapPoint> points_of(const DrillMap& map);

/// Runs the points, `jobs` at a time. Those that were finished stay finished when it throws `Interrupted`.
void run_map(const DrillMap& map, int jobs, const base::ProgressCallback& progress, std::vector<MapPoint>& points);

/// A row a point; the columns are listed in docs/reference/formats.md.
std::string map_csv(const std::vector<MapPoint>& points);

/// Mean severity over the seeds, one value a pair of hook load and speed [1]; NaN where every run failed.
std::vector<double> severities(const DrillMap& map, const std::vector<MapPoint>& points);

/// What was seen, in numbers of runs.
struct MapTally {
  /// Without a summary; what `runtime::condition` says of the others: one of these, both of the last two, or nothing.
  int failed = 0, steady = 0, stick_slip = 0, bit_bounce = 0;
  int overloaded = 0;          ///< static weight on bit above what the bit bears (`runtime::most_weight_on_bit`)
  runtime::ClampTally clamps;  ///< of all runs together
};
/// Counts the points, all of which have been run.
MapTally tally_of(const DrillMap& map, const std::vector<MapPoint>& points);

/// What to look at in a map of so many runs: failed ones, and more weight on bit than the bit bears.
std::vector<std::string> warnings(const DrillMap& map, const MapTally& seen);

}  // namespace bitrock::studies
