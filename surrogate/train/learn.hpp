#pragma once
/// One network learns one output: random starts, epochs of mini-batches, the best epoch, the best start. What it learns
/// from is scaled already; how rows are chosen, scaled and shared out is `train.hpp`.

#include <functional>
#include <span>
#include <vector>

#include "surrogate/net/model.hpp"
#include "surrogate/train/gradient.hpp"
#include "surrogate/train/train.hpp"

namespace bitrock::surrogate {

/// Scaled rows of one side of the split, for one output.
struct LearningRows {
  std::vector<double> inputs;   ///< (R x n[0])
  std::vector<double> targets;  ///< (R)
  std::vector<double> weights;  ///< (R), or empty: all 1

  /// Number of rows.
  int count() const { return static_cast<int>(targets.size()); }
  /// All rows as one batch.
  Batch all() const { return {count(), inputs, targets, weights}; }
};

/// Validation may be empty: then the last epoch is the best, and the error of a start is that of the training rows.
struct LearningTask {
  LearningRows train, validation, test;  ///< by what they are for
};

/// A random start is dead when the network gives the same for every training row although rows differ in input and
/// target: no gradient can bring it back. About four in ten starts of a 3-4-6-3-1 network are. Such a start
/// is drawn again from the next stream, at most this often for one training.
inline constexpr int most_draws = 1000;

/// A network can also die while learning. It is then trained anew from the next stream, at most this often in all.
inline constexpr int most_dead_trainings = 10;

/// Learning curves keep at most this many points.
inline constexpr int most_curve_points = 200;

/// Whether the network is dead, as above; one that gives zero everywhere is so too for equal targets above zero. Rows
/// as in `Batch`: `inputs` (R x n[0]) and `targets` (R), scaled. Never true when all targets are zero.
bool is_dead(const Network& network, std::span<const double> inputs, std::span<const double> targets);

/// Epochs of this output that are over, the skipped ones of an early stop among them.
using EpochsDone = std::function<void(int)>;

/// **What** The network of an epoch is the running mean of the parameters at the ends of epochs, which is less noisy
/// than where the last batch left them.
/// **Equation** q_1 = p_1,   q_e = q_(e-1) + (p_e - q_(e-1)) / min(e, N): the plain mean up to epoch N, later a mean
/// that forgets an epoch's share exponentially, over about N epochs.
/// **Symbols** p_e parameters after epoch e, q_e those kept, N `TrainOptions::smoothing`; N = 0 or 1: q_e = p_e.
/// **Source** [PolyakJuditsky1992] for averages along the path of a stochastic descent; with forgetting as commonly
/// done.
void smooth(int smoothing, int epoch, std::span<const double> parameters, std::span<double> kept);

/// `start`: the output with its scaling, the kind of its network, and in a warm start its parameters. Draws from
/// streams addressed by (options.seed, output, number of the start). Throws as `train` does.
OutputModel learn(const LearningTask& task, const TrainOptions& options, std::size_t output, const OutputModel& start,
                  const EpochsDone& done);

}  // namespace bitrock::surrogate
