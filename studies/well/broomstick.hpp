#pragma once
/// Hook load and torque of the string of a case with a well, off bottom, at several depths of its bit: a broomstick, as
/// drillers call its curves. One steady run a depth, friction and operation, side by side.

#include <limits>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::studies {

/// What the rig does.
enum class Operation {
  run_in,    ///< the string goes down without turning
  pull_out,  ///< and up
  rotate     ///< and turns where it is
};
/// "run_in", "pull_out", "rotate".
const char* name_of(Operation operation);

/// What is computed.
struct Broomstick {
  runtime::WellCase well;         ///< with its stations
  std::vector<double> depths;     ///< [m] measured depths of the bit, downwards
  std::vector<double> frictions;  ///< [1] of the lowest section of the hole; those above keep their share of it
};

/// The shortest string is this deep [m]: all pipes but the first, two segments of that, and a hundredth.
double shortest_depth(const runtime::WellCase& well);
/// The bit gets so deep [m]: to the bottom of the case, or else to the end of the hole.
double greatest_depth(const runtime::WellCase& well);

/// Twenty depths from where the hole begins to bend, or where the shortest string is, to the greatest.
std::vector<double> usual_depths(const runtime::WellCase& well);
/// 0.8, 1 and 1.2 times the friction of the lowest section of the hole; one value where that is 0.
std::vector<double> usual_frictions(const runtime::WellCase& well);

/// Throws `InputError` where depths do not grow or are no depths of this string in this well, where a friction cannot
/// be set, and where the string does not fit its hole.
void require_possible(const Broomstick& broomstick);

/// One run: what was set, and what came of it.
struct BroomstickRow {
  double bit_depth = 0.0, friction = 0.0;                       ///< [m], [1]
  Operation operation = Operation::run_in;                      ///< what the rig does
  double hook_load = std::numeric_limits<double>::quiet_NaN();  ///< [N] NaN where there is no result
  double torque = std::numeric_limits<double>::quiet_NaN();     ///< [N m] of the drive
  bool steady = false;                                          ///< whether they had stopped to change
  std::string failure;                                          ///< why there is no result; empty before the run, too
};

/// All rows, none of which has been run: operation by operation for one depth, then frictions, then depths.
std::vector<BroomstickRow> rows_of(const Broomstick& broomstick);

/// Runs the rows, `jobs` at a time. Those that were finished stay finished when it throws `Interrupted`.
void run_broomstick(const Broomstick& broomstick, int jobs, const base::ProgressCallback& progress,
                    std::vector<BroomstickRow>& rows);

/// A row a run; the columns are listed in docs/reference/columns.md.
std::string broomstick_csv(const std::vector<BroomstickRow>& rows);

/// What to look at: runs that failed or did not become steady, and strings that do not go down by their own weight.
std::vector<std::string> warnings(const std::vector<BroomstickRow>& rows);

}  // namespace bitrock::studies
