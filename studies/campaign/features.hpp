#pragma once
/// From finished runs to the table the networks learn from (docs/reference/formats.md, "features.csv"), and back.

#include <filesystem>
#include <string>
#include <vector>

#include "dem2d/files/run_file.hpp"
#include "peaks/definition.hpp"
#include "peaks/moments.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// One cut: its conditions, and what came of it.
struct FeatureRow {
  int case_number = 0, seed = 0;                                    ///< of its study, from 1; of the rock
  double cutter_speed = 0.0, depth_of_cut = 0.0, back_rake = 0.0;   ///< [m/s], [m], [rad]
  double cut_length = 0.0, duration = 0.0;                          ///< [m], [s]
  peaks::PeakStatistics x, y;                                       ///< heights in N/m
  double mean_force_x = 0.0, mean_force_y = 0.0;                    ///< over the whole cut [N/m]
  double sd_x = 0.0, sd_y = 0.0;                                    ///< standard deviation over the cut [N/m]
  double correlation_length = 0.0, short_correlation_length = 0.0;  ///< means of x and y (peaks/moments.hpp) [m]
  double xy_correlation = 0.0;                                      ///< of the two components [1]
  double low_share_x = 0.0, low_share_y = 0.0;                      ///< of the way, force at most 0.1 of its mean [1]
  int chips = 0;                                                    ///< dem2d/cut/chips.hpp
  int cracks_tensile = 0, cracks_shear = 0;  ///< elements broken in tension, in shear, the run-in included
  double energy_residual_fraction = 0.0;     ///< what the energy ledger cannot find, over the cutter's work [1]
  double energy_injected_fraction = 0.0;     ///< what the scheme gave to the rock, over the cutter's work [1]
  int discs = 0;                             ///< at the start
  double step = 0.0;                         ///< [s]
  double core_time = 0.0;            ///< that the cut took on one core; the only number that depends on the machine [s]
  double sampling = 0.0;             ///< travel between samples of the force [m]
  peaks::PeakDefinition definition;  ///< of the peaks
  double mud_pressure = 0.0;         ///< on the rock (dem2d/fluid/mud.hpp); 0 without mud [Pa]
  std::string hash;                  ///< of case, rock, seed and physics (`dem2d::cut_hash`)
};

/// What is known of a cut beside its forces.
FeatureRow row_of(const Job& job, const dem2d::CutRun& run);
/// All of it.
FeatureRow row_of(const Job& job, const dem2d::CutRun& run, const peaks::PeakDefinition& definition);

/// All that follows from the force histories [N/m] and the length of the cut. Histories are not empty.
void fill_statistics(FeatureRow& row, std::span<const double> force_x, std::span<const double> force_y,
                     const peaks::PeakDefinition& definition);

/// What may be wrong with the statistics of these cuts, in words: correlation lengths that the sampling cannot tell.
std::vector<std::string> warnings(const std::vector<FeatureRow>& rows);

/// Whether two rows tell the same of a cut, whatever time it took and wherever its case stands in a study.
bool same_result(const FeatureRow& a, const FeatureRow& b);

/// Whether a text is what a hash looks like: 16 hexadecimal digits.
bool is_hash(const std::string& text);

/// One row a case and seed.
std::string features_csv(const std::vector<FeatureRow>& rows);

/// Rows of such a table, and the line of each. Throws `base::InputError` with file, line and column for a missing
/// column and for a value that no cut can have given.
struct FeatureTable {
  std::vector<FeatureRow> rows;  ///< in the order of the file
  std::vector<int> lines;        ///< of each row, from 1
};
/// Needs all columns of `features_csv` but those that older tables lack.
FeatureTable read_features(const std::filesystem::path& path);

/// One row a case: number of seeds, mean over the seeds of each number, and standard errors of statistics and mean
/// forces (0 for one seed).
std::string features_mean_csv(const std::vector<FeatureRow>& rows);

}  // namespace bitrock::studies
