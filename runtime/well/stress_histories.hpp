#pragma once
/// The stress histories that a run in a well has written (`well_file.hpp`), read back: what fatigue counts.

#include <filesystem>
#include <string>
#include <vector>

#include "base/hdf5_file.hpp"
#include "runtime/well/joint_histories.hpp"

namespace bitrock::runtime {

/// Of one point of the string that turns with the pipe.
struct StressHistory {
  std::string name;             ///< of the case
  double measured_depth = 0.0;  ///< [m] where it was at the end
  std::vector<double> stress;   ///< [Pa] of tension and bending, one a sample
};

/// Of all points of a run.
struct StressHistories {
  std::vector<double> time;           ///< [s] of the samples, rising
  double settling = 0.0;              ///< [s] before it the run did not count
  std::vector<StressHistory> points;  ///< in the order of the case
  std::vector<JointHistory> joints;   ///< from the bit up, a row a sample after settling; empty: not kept
};

/// Throws `base::InputError` for a file that is none of a run in a well, or whose arrays do not fit together.
StressHistories read_stress_histories(const std::filesystem::path& path);
/// The same of a file that is open.
StressHistories read_stress_histories(const base::Hdf5Reader& file);

}  // namespace bitrock::runtime
