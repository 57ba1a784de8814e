#pragma once
/// What a `target.toml` says: the laboratory numbers wanted of a rock (any subset of the four), the rock file to start
/// from, and how hard to try. A number that is not given is not fitted, and its micro-parameter stays as it is.

#include <filesystem>
#include <string>
#include <vector>

#include "base/config_rows.hpp"
#include "studies/calibrate/properties.hpp"

namespace bitrock::studies {

/// How hard to try: [calibration] of the file.
struct CalibrationSettings {
  int first_seed = 1;                       ///< of the first specimen, 0 or more
  int seeds = 12;                           ///< specimens whose means are fitted: first_seed, first_seed + 1, ...
  int scouting_seeds = 4;                   ///< of them in the first, coarse search
  int most_evaluations = 16;                ///< budget: sets of micro-parameters tested
  double tolerance = 0.01;                  ///< of strengths and E, as a share of the target [1]
  double poissons_ratio_tolerance = 0.005;  ///< [1]
};

/// A target file that was read, with the rock it starts from.
struct CalibrationTarget {
  std::string name;                 ///< that the calibrated rock will have
  PerProperty<double> wanted{};     ///< [Pa], [Pa], [Pa], [1], [Pa]; 0: not given
  std::vector<double> pressures;    ///< confining pressures of the confined strengths [Pa]
  std::filesystem::path rock_file;  ///< where the search starts; found from the folder of the target
  dem2d::Rock start;                ///< what is in `rock_file`
  CalibrationSettings settings;     ///< how hard to try
};

/// Whether the target gives this number.
bool is_wanted(const CalibrationTarget& target, Property property);

/// How far a mean over the seeds may be from the target, in the measure of `error_of`.
double tolerance_of(const CalibrationTarget& target, Property property);

/// Whether compression has anything to measure: UCS.
bool needs_compression(const CalibrationTarget& target);
/// Whether tension has anything to measure: tensile strength, E or nu.
bool needs_tension(const CalibrationTarget& target);

/// What is allowed but out of reach of bonded discs in two dimensions, or hardly wanted, in words.
std::vector<std::string> warnings(const CalibrationTarget& target);

/// Reads and checks the target and its start rock; throws `base::InputError` with file, line and key.
CalibrationTarget read_target(const std::filesystem::path& path);
/// The same of a text; `name` stands for the file in messages and gives the folder of the rock file.
CalibrationTarget parse_target(const std::string& text, const std::string& name);
/// What people are told of the keys of a target file.
std::vector<base::KeyRow> target_keys();

}  // namespace bitrock::studies
