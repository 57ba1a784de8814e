#pragma once
/// What a `study.toml` says: cases (cutting speed, depth of cut, back rake, pressure of the mud) from a grid or a
/// table, times a list of seeds. Cutter and sampling are common to all cases. Cut and bed are too, unless `[by_depth]`
/// sizes them by the depth of each case, so that all cuts travel the same number of depths and their maxima compare.
///
/// A rock is made for each size of bed and seed, and serves every case of that size.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/config_rows.hpp"
#include "dem2d/cut/cut_case.hpp"

namespace bitrock::studies {

/// Every combination of these; no value twice.
struct Grid {
  std::vector<double> cutter_speeds;  ///< [m/s]
  std::vector<double> depths_of_cut;  ///< [m]
  std::vector<double> back_rakes;     ///< [rad]
  std::vector<double> mud_pressures;  ///< on the rock; empty: that of `Study::common` [Pa]
};

/// One case an index; no case twice.
struct Table {
  std::vector<double> cutter_speed;  ///< [m/s]
  std::vector<double> depth_of_cut;  ///< [m]
  std::vector<double> back_rake;     ///< [rad]
  std::vector<double> mud_pressure;  ///< on the rock; empty: that of `Study::common` [Pa]
};

/// Sizes in depths of cut, each with the least it may be.
struct ByDepth {
  double run_in_depths = 0.0;                                    ///< travel before forces count [1]
  double cut_length_depths = 0.0;                                ///< travel of the cutter after that [1]
  double bed_height_depths = 0.0;                                ///< [1]
  double bed_beyond_depths = 0.0;                                ///< rock past the end of the cut [1]
  double moving_ahead_depths = 0.0, moving_behind_depths = 0.0;  ///< of the tip; 0: all of the rock [1]
  double fine_bed_depths = 0.0;                                  ///< as `Rock::fine_depth`; 0: as the rock says [1]
  double cut_length_least = 0.0;                                 ///< [m]
  double bed_height_least = 0.0;                                 ///< [m]
  double bed_beyond_least = 0.0;                                 ///< [m]
  double moving_ahead_least = 0.0, moving_behind_least = 0.0;    ///< where not all of it moves [m]
  double fine_bed_least = 0.0;                                   ///< where the bed is graded [m]
};

/// A study that was read and checked.
struct Study {
  dem2d::CutCase common;   ///< speed, depth and rake, and what `by_depth` sizes, are filled in case by case
  std::string table_file;  ///< as written, relative to the study; empty where the cases stand in the study itself
  Grid grid;               ///< empty where there is a table
  Table table;             ///< empty: the cases are those of the grid
  std::optional<ByDepth> by_depth;  ///< sizes of cut and bed; none: those of `common`
  std::vector<int> seeds{1};        ///< of the rocks; every case is cut with each
};

/// One cut to be made.
struct Job {
  int case_number = 0;  ///< from 1, in the order of the table; of a grid: pressure slowest, then speed, depth, rake
  int seed = 0;         ///< of the rock
  dem2d::CutCase cut;   ///< of this case: speed, depth, rake and all sizes
};

/// The most cuts of a study, cases times seeds. A cut of campaigns/paper240.toml takes a core some 42 s (`bitrock
/// campaign plan`), so many of them more than a year; lists that give more have values too many.
inline constexpr int most_jobs = 1000000;

/// Throws `base::InputError` for wrong values, repeated values, cases or seeds, sizes given twice, for any case that
/// does not fit its bed, and for more than `most_jobs`.
Study read_study(const std::filesystem::path& path);
/// What people are told of the keys of a study.
std::vector<base::KeyRow> study_keys();

/// The study as TOML text with table and rock inside: two studies with the same text ask for the same runs.
std::string resolved_toml(const Study& study);

/// The same, read back to the same bits: a study that needs no other file.
std::string exact_toml(const Study& study);

/// Whether the cases say under which pressure of the mud they are cut; otherwise all are under that of `common`.
bool has_pressures(const Study& study);

/// Cases times seeds; at most `most_jobs`.
int count_jobs(const Study& study);

/// Of the grains [m].
double mean_diameter(const Study& study);

/// All cases times all seeds, in order of case number, then seed, one after the other: a list of a million would fill
/// the memory. Throws `base::Interrupted` when the user stops the program meanwhile.
void for_each_job(const Study& study, const std::function<void(const Job&)>& function);

/// The same as a list.
std::vector<Job> jobs(const Study& study);

/// Warnings of the cases (`dem2d::warnings`), each once.
std::vector<std::string> warnings(const Study& study);

}  // namespace bitrock::studies
