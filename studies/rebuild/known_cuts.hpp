#pragma once
/// The force histories that a rebuilt force is held against: of a run, of all runs of a folder, of a forces.h5.

#include <filesystem>
#include <string>
#include <vector>

#include "studies/campaign/forces_file.hpp"

namespace bitrock::studies {

/// Cuts of one condition, in several rocks of one kind.
struct KnownCase {
  std::string file;             ///< where the cuts come from
  int case_number = 0;          ///< in its study; 0: a run by itself
  double mean_diameter = 0.0;   ///< of the grains [m]
  std::vector<CutForces> cuts;  ///< at least one
  const FeatureRow& conditions() const {
    return cuts.front().cut;
  }  ///< of the first cut; speed, depth, rake hold for all
};

/// Travel between the samples [m].
double spacing(const CutForces& cut);

/// A run.h5, a forces.h5, or a folder: its forces.h5, or without one its runs (`*.h5` and `runs/*.h5`). Cuts of the
/// same speed, depth, rake and mud pressure in one file or folder are one case. Throws `base::InputError` for anything
/// else, for a folder without a run, and for runs of one case that are sampled at different distances.
std::vector<KnownCase> read_known_cuts(const std::filesystem::path& path);

}  // namespace bitrock::studies
