#pragma once
/// A rock's networks in a time that somebody has: cut a batch of conditions (design.hpp), see how well the force is
/// known by now, cut the next one, until the time is over or the force is known well enough; then train. It may be
/// stopped at any moment and goes on where it was.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "studies/campaign/runner.hpp"
#include "studies/learn/design.hpp"
#include "surrogate/train/data.hpp"
#include "surrogate/train/smooth_formula.hpp"

namespace bitrock::studies {

/// What is asked for.
struct LearnRequest {
  Study like;                    ///< rock, cutter, sizes; the range of its cases is what is learnt
  std::filesystem::path folder;  ///< of cuts, tables and notebook
  double budget = 3600.0;        ///< time on the clock, over all calls on this folder [s]
  double spent = 0.0;            ///< of the budget, before cutting begins, by this call [s]
  std::optional<double> error;   ///< stop when the force is known this well [1]
  int workers = 1;               ///< cuts side by side
  int batch = 24;                ///< cuts between two looks at the error
  std::uint64_t seed = 1;        ///< of design and rocks
};

/// How well each output is known: the standard error that a smooth formula through the cuts has, over the mean of the
/// output over the cuts.
///
/// **Equation** e = s sqrt(p / n) / m, s^2 that of `surrogate::scatter_left`.
/// **Symbols** n cuts, p terms; m = 1 for amplitudes, whose errors are shares already; for peaks, root of the mean
/// number in a cut.
/// **Source** of n observations with independent errors of variance s^2, p coefficients leave s^2 p / n on the average.
/// **Validity** the force has the shape of the formula: what its terms cannot follow is in s, but only partly in e.
struct Knowledge {
  int cuts = 0, terms = 0;      ///< n and p
  std::vector<double> errors;   ///< one an output [1]
  std::vector<double> scatter;  ///< of a single cut, one an output: s / m [1]
  double force_error = 0.0;     ///< root mean square over A_max, A_mean, and where known mean, of x and y [1]
};
/// Of a table with at least two cases.
Knowledge knowledge_of(const surrogate::TrainingData& data);

/// With so many times the cuts: as one over the root.
double expected_error(const Knowledge& knowledge, double times_cuts);

/// How many times the cuts there are after an hour more at the pace of the time `elapsed` [s].
double times_cuts_an_hour_later(double elapsed);

/// How far it is, after a batch.
struct LearnProgress {
  int batch = 0;                       ///< number of the last one
  Knowledge knowledge;                 ///< by now
  double elapsed = 0.0, budget = 0.0;  ///< on the clock, over all calls [s]
};

/// Who is told; any of them may be empty.
struct LearnListeners {
  std::function<void(const JobReport&)> on_job;        ///< after each cut
  std::function<void(const std::string&)> on_stage;    ///< "making the rock of seed 1, ..."
  std::function<void(const LearnProgress&)> on_batch;  ///< after each batch
};

/// Why it ended.
enum class LearnEnd {
  time_over,     ///< no batch fits into what is left
  error_reached  ///< the force is known as well as was asked for
};

/// What it leaves: features.csv, features_mean.csv and forces.h5 of all cuts in the folder, which hold what is known at
/// any moment after the first batch.
struct Learnt {
  LearnEnd end = LearnEnd::time_over;  ///< why
  LearnProgress last;                  ///< after the last batch
  double core_time = 0.0;              ///< of all cuts [s]
};

/// The first batch is cut whatever the budget. Throws `base::InputError` for a folder of another request (rock, range,
/// seed, batch) and for a range with too few different conditions; `SimulationError` when a cut fails; `Interrupted`
/// when the user stops it.
Learnt learn(const LearnRequest& request, const LearnListeners& listeners = {});

}  // namespace bitrock::studies
