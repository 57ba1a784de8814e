#pragma once
/// What the networks learn from: the peak statistics of many cuts, read from features.csv (one row a case and seed) or
/// features_mean.csv (one row a case). Any CSV with these columns will do, so data from another DEM code or from a test
/// rig can be used. Reads and checks; neither scales (`scaling.hpp`) nor splits (`split.hpp`).

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

using Outputs = OutputValues;  ///< in the order of `output_names`

/// One cut, or the mean over the cuts of a case, in the units of the file, in the order of `input_names` and
/// `output_names`.
struct TrainingRow {
  int case_number = 0;                       ///< one speed, depth and rake
  long long seed = 0;                        ///< of the rock; 0 when the file has no seeds
  std::array<double, input_count> inputs{};  ///< [m/s], [mm], [deg]
  std::vector<double> further{};             ///< values of `TrainingData::further`, in their units
  double cut_length = 0.0;                   ///< [m]
  Outputs outputs{};                         ///< in the units of `output_names`; peak counts over the length of cut
  int cuts = 1;                              ///< of which this is the mean
  std::optional<Outputs> standard_errors{};  ///< of the mean, in the units of `outputs`; known from two cuts on
  int line = 0;                              ///< in the file, the first one of a mean
};

/// The rows of one table, or of several joined.
struct TrainingData {
  std::string file;                        ///< name without folder
  std::string fingerprint;                 ///< `base::fingerprint_text` of the file's bytes
  bool has_seeds = false;                  ///< the file has a seed column
  std::vector<TrainingRow> rows;           ///< of all tables
  std::vector<DataPart> parts{};           ///< when it was several files
  std::optional<PeakCounting> counting{};  ///< empty where the tables do not say
  /// Further inputs that the table has, whether they vary or not: the pressure of the mud, which is 0 where the table
  /// does not say, then columns that begin with rock_, in the order of the file.
  std::vector<std::string> further{};
  bool moments_left_out = false;  ///< some of several tables have more than the article's ten outputs
};

/// Needs the columns case, cutter_speed_m_per_s, depth_of_cut_mm, back_rake_deg, cut_length_m, and for x and y
/// {amax_N_per_m, amean_N_per_m, np1, np23, np4}; takes seed when there, and without it seeds (the number of cuts of a
/// mean) and ..._standard_error when they are there; ignores all others. With the columns x_sd_N_per_m, y_sd_N_per_m,
/// x_mean_N_per_m, y_mean_N_per_m, correlation_length_mm, short_correlation_length_mm and xy_correlation there are
/// seventeen outputs; a mean or a correlation below 0, which only noise can make, counts as 0. (A mean alone makes no
/// output: older tables have it.) Throws `base::InputError` with file and line for: a case or seed that is no whole
/// number, speed, depth or length of cut not above 0, a rake outside -90 to 90 degrees, negative amplitudes or counts,
/// numbers beyond 1e12 or below 1e-12, a mean height of peaks above the highest, rows whose peaks were counted in
/// different ways (columns peak_smoothing_um, peak_min_prominence, peak_min_distance_mm, sampling_um), cuts under
/// more than thirteen further inputs, a case and seed that come twice (without seeds: a case that
/// comes twice), one case with two conditions, fewer than two cases. Further inputs of a model (further_inputs.hpp) are
/// the columns fluid_pressure_MPa and rock_..., where they vary over the rows.
TrainingData read_training_data(const std::filesystem::path& path);

/// The same of several files, `joined`.
TrainingData read_training_data(const std::vector<std::string>& paths);

/// Several tables as one: the cases of a later table get numbers above those of the earlier ones. One table stays what
/// it is. Throws `InputError` when there is none, when one comes twice, or when some have seeds and others have not, or
/// when peaks were counted in different ways (a table that does not say is taken for the article's), or when one has
/// properties of the rock that another has not. Outputs that not all tables have are left out.
TrainingData joined(const std::vector<TrainingData>& tables);

/// Whether peaks were counted in one way, as far as 9 digits tell. Who does not say is taken for the article's way,
/// whatever the sampling.
bool mix(const std::optional<PeakCounting>& a, const std::optional<PeakCounting>& b);
/// "with smoothing 40 um, prominence 0.02, distance 0 mm": how peaks were counted, for messages.
std::string in_words(const std::optional<PeakCounting>& counting);

/// One row a case: the mean over its rows, each weighing as many cuts as it is the mean of, and the standard error of
/// that mean (over the rows when there are several, the file's own otherwise).
TrainingData averaged(const TrainingData& data);

/// The further inputs that vary over the rows, as places in `TrainingData::further`: those the networks learn from.
std::vector<std::size_t> varying_further(const TrainingData& data);

/// The pressure of the mud, the same over all rows; nothing when it varies.
std::optional<double> one_pressure(const TrainingData& data);

/// Ten or seventeen: all rows have the same number.
std::size_t output_count(const TrainingData& data);

/// The conditions of a row in SI, as `predict` wants them.
CutConditions conditions_of(const TrainingRow& row);

/// Each case number once, in the order of the rows.
std::vector<int> case_numbers(const TrainingData& data);

}  // namespace bitrock::surrogate
