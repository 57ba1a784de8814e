#pragma once
/// The force histories of a whole data set in one file (docs/reference/formats.md, "forces.h5"): statistics of any
/// later definition come from it in seconds, without cutting again. Forces are kept with the 24 bits of a float, a
/// rounding of 6e-8; sums of thousands of samples keep 7 digits.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/campaign/features.hpp"

namespace bitrock::studies {

/// One cut: what is known of it beside its forces, and the forces. `sampling` of the cut is its length over the number
/// of samples.
struct CutForces {
  FeatureRow cut;           ///< all but what `fill_statistics` finds
  std::vector<float> x, y;  ///< resistance to cutting, push out of the rock; of equal length, not empty [N/m]
};

/// What the file holds.
struct ForcesFile {
  std::string study;            ///< name of the study file without folder, or empty
  double mean_diameter = 0.0;   ///< of the grains [m]
  std::vector<CutForces> cuts;  ///< none twice
};

/// The most samples of all cuts together that are written into one file: 2 GB of memory while it is made.
inline constexpr double most_samples = 1e8;

/// Of a run that was finished.
CutForces forces_of(const Job& job, const dem2d::CutRun& run);

/// Cuts in the order given. Throws `OutputError` when the file cannot be written.
void write_forces(const ForcesFile& forces, const std::filesystem::path& path);

/// Whether it says that it is one. Throws `base::InputError` when it is no HDF5 file.
bool is_forces_file(const std::filesystem::path& path);

/// Throws `base::InputError` for a file that is no forces file, was cut short or changed, holds a cut twice, a force
/// that is not finite, or a value that no cut can have given.
ForcesFile read_forces(const std::filesystem::path& path);

/// The row of a cut by a definition of peaks.
FeatureRow row_of(const CutForces& forces, const peaks::PeakDefinition& definition);

}  // namespace bitrock::studies
