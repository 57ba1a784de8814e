#pragma once
/// What a `study.toml` says: a grid of cuts over cutting speed, depth of cut and back rake, times a list of seeds.
/// Everything else (cutter, bed, sampling) is common to all cases, so one rock a seed serves them all.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "dem2d/cut/cut_case.hpp"

namespace campaigns {

struct Study {
  dem2d::CutCase common;              ///< speed, depth and rake are filled in case by case
  std::vector<double> cutter_speeds;  ///< [m/s]
  std::vector<double> depths_of_cut;  ///< [m]
  std::vector<double> back_rakes;     ///< [rad]
  std::vector<int> seeds{1};
};

/// One cut to be made.
struct Job {
  int case_number = 0;  ///< from 1, speed slowest, then depth, then rake
  int seed = 0;
  dem2d::CutCase cut;
};

/// Throws `base::InputError` for wrong values, repeated grid values or seeds, and for any case that does not fit its
/// bed.
Study read_study(const std::filesystem::path& path);

/// The study as TOML text with the rock inside: two studies with the same text ask for the same runs.
std::string resolved_toml(const Study& study);

/// All cases times all seeds, in order of case number, then seed.
std::vector<Job> jobs(const Study& study);

}  // namespace campaigns
