#pragma once
/// Where the results of a series of strength tests go in a folder, and what else is there.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "studies/lab/series.hpp"

namespace bitrock::studies {

/// Curve or picture of one core: TEST_seed_N with this ending, triaxial_PMPa_seed_N under a pressure P.
std::filesystem::path file_of(const std::filesystem::path& folder, dem2d::LabTest test, const LabCore& core,
                              const char* ending);
/// The curves of all seeds together.
std::filesystem::path file_of_all(const std::filesystem::path& folder, dem2d::LabTest test);
/// The rock that was tested.
std::filesystem::path rock_file_of(const std::filesystem::path& folder, dem2d::LabTest test);

/// All of them; none without a folder.
std::vector<std::filesystem::path> files_of(const LabSeries& series, const std::filesystem::path& folder);

/// Names of curves in the folder that belong to other seeds: an earlier call left them. They are computations, and
/// stay.
std::vector<std::string> other_curves(const LabSeries& series, const std::filesystem::path& folder);

}  // namespace bitrock::studies
