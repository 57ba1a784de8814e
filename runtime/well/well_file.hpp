#pragma once
/// The result of a case with a well as a file: the case, series of samples, the whole string at some instants.

#include <filesystem>
#include <string>

#include "runtime/well/stress_histories.hpp"
#include "runtime/well/well_run.hpp"

namespace bitrock::runtime {

/// Root attributes of the file.
inline constexpr const char* well_format = "bitrock-well";
inline constexpr long long well_format_version = 1;  ///< raised when a reader of the old one would read it wrong

/// A run as its file holds it.
struct WellFile {
  WellCase well;           ///< as it was run; without stations where an earlier version left them in their survey file
  std::string model;       ///< fingerprint of the networks, empty without
  WellSeries series;       ///< without the stress histories
  StressHistories stress;  ///< of the points of the case
  std::vector<Orbit> orbits;  ///< of the joints nearest to them, from the first sample after `settling` on; or none
  StringFrames frames;        ///< the whole string; empty in a file of an earlier version
  double step = 0.0;          ///< [s]
  double wall_time = 0.0;     ///< [s] on the clock
  double axial_pass_band = 0.0, torsional_pass_band = 0.0;  ///< [Hz]
};

/// `model`: fingerprint of the networks, empty without.
void write_well_run(const WellRun& run, const WellCase& well, const std::string& model,
                    const std::filesystem::path& path);

/// Throws `base::InputError` for a file that is none of a run in a well, or whose arrays do not fit together.
WellFile read_well_run(const std::filesystem::path& path);

/// Whether a file is one of a run in a well. Throws `base::InputError` when it is none of ours.
bool holds_well_run(const std::filesystem::path& path);

}  // namespace bitrock::runtime
