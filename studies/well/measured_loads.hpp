#pragma once
/// Hook loads and torques that were measured at a rig, to be shown beside a broomstick.

#include <filesystem>
#include <vector>

#include "studies/well/broomstick.hpp"

namespace bitrock::studies {

/// At one depth.
struct MeasuredLoad {
  double bit_depth = 0.0;                                       ///< [m]
  Operation operation = Operation::run_in;                      ///< what the rig did
  double hook_load = std::numeric_limits<double>::quiet_NaN();  ///< [N] NaN where it was not measured
  double torque = std::numeric_limits<double>::quiet_NaN();     ///< [N m] the same
};

/// From a CSV file with the depths `bit_depth_m` or `bit_depth_ft`, and any of `run_in_hook_load_kN`,
/// `pull_out_hook_load_kN`, `rotate_hook_load_kN` (also _N, _klbf) and `rotate_torque_kN_m` (also _N_m, _ft_lbf); nan
/// where nothing was measured. Other columns may hold what they like. Throws `InputError` with file and place.
std::vector<MeasuredLoad> read_measured_loads(const std::filesystem::path& file);

/// What a curve of the broomstick has at a depth: between its two nearest depths a straight line. Of hook load, or of
/// torque. NaN outside its depths and where there is no result.
double curve_at(const std::vector<BroomstickRow>& rows, double BroomstickRow::*value, double friction,
                Operation operation, double depth);

}  // namespace bitrock::studies
