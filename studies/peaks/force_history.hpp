#pragma once
/// A force over time from a file of anybody: a run of bitrock, or a CSV with a header; and what its peaks say.

#include <string>
#include <vector>

#include "peaks/definition.hpp"
#include "peaks/parts.hpp"
#include "peaks/statistics.hpp"
#include "peaks/zero_force.hpp"

namespace bitrock::studies {

struct ForceHistory {
  std::string column;                      ///< of the force
  std::string time_column;                 ///< empty when there is none
  std::vector<double> time;                ///< [s]; empty when there are none
  std::vector<double> force;               ///< [unit of the column]; NaN where a sample is missing
  std::vector<std::string> other_columns;  ///< of a CSV: beside force and time
  double spacing = 0.0;                    ///< travel between samples, of a run file; 0: not known [m]
  double mean_diameter = 0.0;              ///< of the grains, of a run file; 0: not known [m]
};

/// `column`: which force; empty for x_N_per_m of a run, or the only CSV column beside the time. `time`: which CSV
/// column holds the times in seconds; empty for time_s, if there is one. Throws `InputError` with file and column when
/// they are not there, are not in seconds, do not rise, or hold no number.
ForceHistory read_force_history(const std::string& file, const std::string& column, const std::string& time);

/// What is found in a history.
struct ForceFindings {
  peaks::PeakStatistics all;                   ///< of the whole history [unit of the column]
  peaks::ZeroForce zero;                       ///< of the whole history
  std::vector<peaks::Part> parts;              ///< in the order of time
  std::size_t not_a_number = 0, infinite = 0;  ///< samples that are NaN, +infinity
  double mean_period = 0.0;                    ///< without force [s]
  bool even = true;                            ///< samples are evenly spaced, as far as is known
  double mean = 0.0;                           ///< of the finite samples
};

/// `parts`: so many equal parts of the time, or of the samples when there are no times.
ForceFindings find_in(const ForceHistory& history, int parts, const peaks::Selection& selection = {});

/// What stands for the times when no column gives them.
inline constexpr const char* without_times = "samples are taken for evenly spaced, and lengths are in samples";

/// " N/m" of a column like x_N_per_m: the unit that its name ends in, as far as forces have one, behind a blank; empty
/// otherwise.
std::string unit_of(const std::string& column);

/// What to look at in a history although its peaks are counted, in words: a mean below 0, no times, samples that are no
/// numbers or stand at uneven distances.
std::vector<std::string> warnings(const ForceHistory& history, const ForceFindings& found);

/// What somebody asks of peaks beyond the article's definition.
struct PeakWish {
  bool converging = false;      ///< the definition of that name (peaks/definition.hpp)
  double smoothing = 0.0;       ///< [samples]; 0: that of the definition
  double min_prominence = 0.0;  ///< share of the highest sample [1]; 0: that of the definition
  double min_distance = 0.0;    ///< [samples]
};

/// Smooths the force of the history as is asked for; what remains to be done is the selection. Throws `InputError` when
/// the converging definition is asked of a file that knows neither travel nor grains.
peaks::Selection apply(const PeakWish& wish, ForceHistory& history, const std::string& file);

}  // namespace bitrock::studies
