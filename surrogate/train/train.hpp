#pragma once
/// From peak statistics to a `Model`: ten small networks, five for each force component, each learnt on its own
/// [BitRock2026, sec. 3.2]. It follows the article's procedure (scaled data, random 80/20 split, Adam, batches of 4, 50
/// epochs, mean squared error) and keeps the last epoch; it neither searches for better settings nor stops early.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"

namespace surrogate {

struct TrainOptions {
  std::vector<int> layers{3, 4, 6, 3, 1};     ///< of every network; first 3, last 1
  int epochs = 50;                            ///< passes through the training rows
  int batch = 4;                              ///< rows a step; the last batch of an epoch may be smaller
  double learning_rate = 1e-3;                ///< [1] of Adam
  std::uint64_t seed = 1;                     ///< of initial weights and batch order
  std::optional<std::uint64_t> split_seed{};  ///< of the choice of test cases; unset: `seed`
  double split = 0.8;                         ///< fraction of the cases to learn from
  bool shuffle = true;  ///< false: file order in split and batches, the last cases are the test set
  int threads = 1;      ///< 0: one a core. The bits do not depend on it
  std::string rock{};   ///< which rock, for people; empty with `init_from`: as there
  /// Warm start: begin from these networks and keep their scaling; layers must be the same. Not owned.
  const Model* init_from = nullptr;
};

/// A random start is dead when the network gives zero for every training row, or one value for rows that differ in
/// input and target: no gradient can bring it back. About four in ten starts of a 3-4-6-3-1 network are. Such a start
/// is drawn again from the next stream, at most this often for one training.
inline constexpr int most_draws = 1000;

/// A network can also die while learning. It is then trained anew from the next stream, at most this often in all.
inline constexpr int most_trainings = 10;

/// Learning curves keep at most this many points.
inline constexpr int most_curve_points = 200;

/// The same data, options and seed give the same bits of the model for any number of threads: every output draws from
/// streams of its own, addressed by (seed, output, restart). `progress` counts epochs over all outputs and is called
/// by one thread at a time. Looks at `base::stop_requested` after each epoch.
/// Throws `base::InputError` for options out of range and for a warm start that does not fit, `base::SimulationError`
/// when a training diverges (parameters beyond `largest_parameter`) or stays dead.
Model train(const TrainingData& data, const TrainOptions& options, const base::ProgressCallback& progress = {});

/// Whether the network is dead, as above. Rows as in `Batch`: `inputs` (R x 3) and `targets` (R), scaled. Never true
/// when all targets are zero, for then zero is the right answer.
bool is_dead(const Network& network, std::span<const double> inputs, std::span<const double> targets);

}  // namespace surrogate
