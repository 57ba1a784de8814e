#pragma once
/// What a `target.toml` says: the laboratory numbers wanted of a rock (any subset of the four), the rock file to start
/// from, and how hard to try. A number that is not given is not fitted, and its micro-parameter stays as it is.

#include <filesystem>
#include <string>
#include <vector>

#include "base/config_rows.hpp"
#include "studies/calibrate/properties.hpp"

namespace bitrock::studies {

struct CalibrationSettings {
  int first_seed = 1;
  int seeds = 12;                           ///< specimens whose means are fitted: first_seed, first_seed + 1, ...
  int scouting_seeds = 4;                   ///< of them in the first, coarse search
  int most_evaluations = 16;                ///< budget: sets of micro-parameters tested
  double tolerance = 0.01;                  ///< of strengths and E, as a share of the target [1]
  double poissons_ratio_tolerance = 0.005;  ///< [1]
};

struct CalibrationTarget {
  std::string name;
  PerProperty<double> wanted{};  ///< [Pa], [Pa], [Pa], [1]; 0: not given
  std::filesystem::path rock_file;
  dem2d::Rock start;
  CalibrationSettings settings;
};

bool is_wanted(const CalibrationTarget& target, Property property);

/// How far a mean over the seeds may be from the target, in the measure of `error_of`.
double tolerance_of(const CalibrationTarget& target, Property property);

/// Whether this test has anything to measure: tension gives the tensile strength, E and nu.
bool needs_compression(const CalibrationTarget& target);
bool needs_tension(const CalibrationTarget& target);

/// What is allowed but out of reach of bonded discs in two dimensions, or hardly wanted, in words.
std::vector<std::string> warnings(const CalibrationTarget& target);

/// Reads and checks the target and its start rock; throws `base::InputError` with file, line and key.
CalibrationTarget read_target(const std::filesystem::path& path);
CalibrationTarget parse_target(const std::string& text, const std::string& name);
/// What people are told of the keys of a target file.
std::vector<base::KeyRow> target_keys();

}  // namespace bitrock::studies
