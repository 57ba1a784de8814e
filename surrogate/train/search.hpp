#pragma once
/// Which kind of network to take, decided by the data: each kind is trained on all but one part of the training cases
/// and asked for the part it has not seen, part after part (k-fold cross-validation). The test cases of the final
/// training have no say, so its errors on them stay honest. Two plain formulas are measured beside the networks.
///
/// **Equation** For case i and output o, d_io = prediction - mean over the cuts of the case. Errors are in units of the
/// data's own standard error s_o = sqrt(mean_i s_io^2), s_io by the law of scatter (`scatter.hpp`):
///
///     error_o = sqrt(mean_i d_io^2) / s_o,   error = sqrt(mean_o error_o^2)
///
/// A perfect model has 1, because the means it is measured against are off by s themselves. Against the first kind, q_i
/// = mean_o (d_io / s_o)^2: gain = mean_i (q_i of the first - q_i), its standard error from the scatter of the
/// differences over the cases.
/// **Validity** the cases of two folds share training cases, so the standard error of the gain is somewhat too small;
/// hence three of them are asked for, not two.

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "surrogate/train/train.hpp"

namespace bitrock::surrogate {

/// One kind of network, or a formula.
struct Candidate {
  std::string name;                                       ///< for people
  std::vector<int> layers;                                ///< empty: a formula
  OutputActivation output = OutputActivation::rectified;  ///< of the last layer
  bool log_targets = false;                               ///< learns logarithms
  bool taught = false;                                    ///< learns from a smooth formula (`taught_rows.hpp`)
  int degree = 0;  ///< without layers: of the smooth formula (`smooth_formula.hpp`); 0: that of `baseline.hpp`
};

/// Networks of this kind are trained with the options.
void take_kind(const Candidate& candidate, TrainOptions& options);

/// The article's network taught by a smooth formula first; by itself, wider, with other outputs, logarithms, both;
/// wider ones that are taught; and formulas by themselves.
std::vector<Candidate> usual_candidates();

/// What the measuring of a candidate gave.
struct CandidateResult {
  Candidate candidate;      ///< that was measured
  OutputValues errors{};    ///< error_o [1]
  double error = 0.0;       ///< [1]
  double gain = 0.0;        ///< against the first candidate [1]; positive is better
  double gain_error = 0.0;  ///< its standard error [1]
};

/// What a search has found.
struct Search {
  int folds = 0;                         ///< parts of the data
  int cases = 0;                         ///< that were predicted unseen
  std::vector<CandidateResult> results;  ///< in the order of the candidates
  std::size_t chosen = 0;                ///< its place in the results
  std::string choice;                    ///< one sentence: what was compared, what was taken and why
};

/// Gains of so many standard errors and more count as better. With eight candidates, chance alone gives the best of
/// them 2.7 in one of twenty searches.
inline constexpr double gain_asked_for = 3.0;

/// Compares the candidates on the training cases of the split that `train` would draw with the same options; layers,
/// output, log_targets and taught of the options are not looked at, everything else is. The first candidate is kept
/// unless another network is better beyond the scatter; of several, the one with the least error. Formulas are never
/// chosen. The same bits for any number of threads. Throws `base::InputError` for fewer cases than folds, fewer than
/// two folds, data without known scatter, and as `train` does.
Search search(const TrainingData& data, const TrainOptions& options, const std::vector<Candidate>& candidates,
              int folds, const base::ProgressCallback& progress = {});

}  // namespace bitrock::surrogate
