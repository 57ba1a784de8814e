#pragma once
/// A string in a well under the networks, under a sinusoid of equal mean and RMS, and without excitation: what its
/// stress points feel, by frequency, and the damage of that. The runs share the trip: off bottom the source does not
/// act.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/well/well_run.hpp"
#include "studies/well/fatigue_of_run.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::studies {

/// As files and tables have them; the networks first, to whose mean and RMS the sinusoid is matched. The last one has
/// one run for all seeds.
inline constexpr std::array<const char*, 3> well_source_names{"networks", "sinusoidal", "none"};

struct WellComparison {
  runtime::WellCase well;                 ///< whose source is the bit
  runtime::WellString string;             ///< assembled from `well`
  std::optional<surrogate::Model> model;  ///< the networks of the bit
  std::string model_fingerprint;          ///< of the model file; kept in the file of each run
  std::vector<int> seeds;                 ///< of the excitation
  std::filesystem::path folder;           ///< where the runs go
};

/// **What** How the variance of a stress after settling is spread over frequencies.
/// **Equation** sd_b = sqrt(sum_j P_j df), f_j in band b, P_j of `base::welch` in segments of 2 s.
/// **Symbols** sd [Pa]; P [Pa^2/Hz]; f [Hz]. The bands end at 3 times a turn of the drive, at 20 Hz (or there, where
/// that is higher), at the pass band along of the segments at the bit, at half the sampling rate. What is in the last
/// one the segments cannot bring from the bit: joints of their own ring there.
struct StressBands {
  double turning = 0.0;  ///< [Pa] up to 3 times a turn: the bend that the pipe turns through
  double low = 0.0;      ///< [Pa] from there to 20 Hz: the string's first modes
  double high = 0.0;     ///< [Pa] from there to the pass band
  double beyond = 0.0;   ///< [Pa] above it
};
/// Of a stress [Pa] from its sample `first` on. `sample` [s], `rotation` [rad/s] of the drive, `pass_band` [Hz].
StressBands stress_bands(const std::vector<double>& stress, std::size_t first, double sample, double rotation,
                         double pass_band);

/// One stress point of one run.
struct ComparedPoint {
  PointDamage damage;  ///< by `usual_fatigue_wish`
  StressBands bands;   ///< of its stress
};

/// One run of one source.
struct ComparedWell {
  int seed = 0;                       ///< of the excitation
  runtime::WellSummary summary;       ///< of the steps after the settling time
  std::vector<ComparedPoint> points;  ///< in the order of the case
  double mismatch = 0.0;              ///< [1] of mean and RMS against the networks' run of the same seed
};

/// For each of `well_source_names`: one run a seed, or one for all.
using ComparedWells = std::array<std::vector<ComparedWell>, well_source_names.size()>;

/// The file of a run: source (index of `well_source_names`) and seed; without a source there is one for all seeds.
std::filesystem::path run_file(const WellComparison& comparison, std::size_t source, int seed);

/// All runs, the seeds `jobs` at a time; each is written to its file when it is finished. Throws what
/// `runtime::run_well` and `damage_of` throw.
ComparedWells run_comparison(const WellComparison& comparison, int jobs, const base::ProgressCallback& progress);

/// What to look at in the runs: sinusoids that could not be matched.
std::vector<std::string> warnings(const ComparedWells& runs);

/// One row a run and point, for spreadsheets.
std::string compared_csv(const ComparedWells& runs);
/// Mean ± standard deviation over the runs, for each point, as Markdown.
std::string compared_table(const ComparedWells& runs);

}  // namespace bitrock::studies
