#pragma once
/// From finished runs to the table the networks learn from (docs/formats.md, "features.csv").

#include <filesystem>
#include <string>
#include <vector>

#include "campaigns/study.hpp"
#include "peaks/statistics.hpp"

namespace campaigns {

struct FeatureRow {
  int case_number = 0, seed = 0;
  double cutter_speed = 0.0, depth_of_cut = 0.0, back_rake = 0.0;  ///< [m/s], [m], [rad]
  double cut_length = 0.0, duration = 0.0;                         ///< [m], [s]
  peaks::PeakStatistics x, y;                                      ///< heights in N/m
};

/// Rows of all jobs that are done, in job order.
std::vector<FeatureRow> collect(const Study& study, const std::filesystem::path& folder);

/// One row a case and seed.
std::string features_csv(const std::vector<FeatureRow>& rows);

/// One row a case: number of seeds, mean over the seeds of each statistic, and its standard error (0 for one seed).
std::string features_mean_csv(const std::vector<FeatureRow>& rows);

}  // namespace campaigns
