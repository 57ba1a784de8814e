#pragma once
/// From peak statistics to a `Model`: ten small networks, five for each force component, each learnt on its own
/// [BitRock2026, sec. 3.2]. `as_in_the_article` is its procedure: averages over the cuts of a case, scaled data, random
/// 80/20 split, Adam, batches of 4, 50 epochs, mean squared error, the last epoch kept. Beyond it (`recommended`): the
/// parameters may be averaged over epochs; cases kept for validation say which epoch was best and when to stop; several
/// starts make a poor minimum unlikely. Comparing kinds of networks is `search.hpp`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"
#include "surrogate/train/split.hpp"

namespace bitrock::surrogate {

/// How the networks are built and trained.
struct TrainOptions {
  std::vector<int> layers{3, 4, 6, 3, 1};  ///< of every network; first 3 (further inputs are added to it), last 1
  OutputActivation output = OutputActivation::rectified;  ///< of the last layer
  bool log_targets = false;                   ///< the networks learn ln(1 + y / y_0), y_0 the smallest positive y seen
  int epochs = 50;                            ///< passes through the training rows, at most
  int batch = 4;                              ///< rows a step; the last batch of an epoch may be smaller
  double learning_rate = 1e-3;                ///< [1] of Adam
  std::uint64_t seed = 1;                     ///< of initial weights and batch order
  std::optional<std::uint64_t> split_seed{};  ///< of the choice of test cases; unset: `seed`
  double split = 0.8;                         ///< fraction of the cases to learn from
  double validation = 0.0;  ///< fraction of the cases to learn from that only say which epoch is best; 0: the last is
  int patience = 0;         ///< stop after so many epochs without a better validation error; 0: go on to the end
  int starts = 1;           ///< random starts, of which the one with the least error is kept (validation, or training)
  int smoothing = 0;        ///< epochs over which parameters are averaged (learn.hpp); 0: those of the last step
  bool averaged = true;     ///< learn from the mean over the cuts of a case; false: from the single cuts
  bool weighted = false;    ///< weigh errors by the inverse variance of the data (`scatter.hpp`)
  bool taught = false;      ///< learn from a smooth formula through the cases (`taught_rows.hpp`); not in a warm start
  bool shuffle = true;      ///< false: file order in splits and batches, the last cases are the test set
  int threads = 1;          ///< 0: one a core. The bits do not depend on it
  std::string rock{};       ///< which rock, for people; empty with `init_from`: as there
  /// Warm start: begin from these networks and keep their scaling; layers must be the same. Not owned.
  const Model* init_from = nullptr;
};

/// The article's procedure [BitRock2026, sec. 3.2]: 50 epochs, a single start, the last epoch kept.
TrainOptions as_in_the_article();

/// The layers of networks with so many further inputs: these, the first one wider.
std::vector<int> with_further(std::vector<int> layers, std::size_t further);

/// What `bitrock train` does unless it is told otherwise: a smooth formula teaches the networks (docs/decisions/0021);
/// 600 epochs at a rate of 0.003, three starts, parameters averaged over 50 epochs. The article's 50 epochs end before
/// the networks have learnt what the data hold, and of the small networks many a start ends in a poor minimum; found by
/// cross-validation (docs/decisions/0013).
TrainOptions recommended();

/// Patience that goes with `validation`, found with the above.
inline constexpr int recommended_patience = 200;

/// Throws `base::InputError` for options out of range and for a warm start that does not fit; the split is judged with
/// the data.
void check_options(const TrainOptions& options);

/// The same data, options and seed give the same bits of the model for any number of threads: every output draws from
/// streams of its own, addressed by (seed, output, restart). `progress` counts epochs over all outputs and is called
/// by one thread at a time. Looks at `base::stop_requested` after each epoch.
/// Throws `base::InputError` for options out of range and for a warm start that does not fit, `base::SimulationError`
/// when a training diverges (parameters beyond `largest_parameter`) or stays dead.
Model train(const TrainingData& data, const TrainOptions& options, const base::ProgressCallback& progress = {});

/// The same on a given split; `options.split` and the drawing of test cases are not looked at.
Model train_on(const TrainingData& data, const Split& split, const TrainOptions& options,
               const base::ProgressCallback& progress = {});

}  // namespace bitrock::surrogate
