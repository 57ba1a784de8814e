#pragma once
/// Mean squared error of a network over one mini-batch, and its gradient by back-propagation. Nothing else: no batches
/// are chosen here (`train.hpp`) and no step is taken (`adam.hpp`).

#include <span>
#include <vector>

#include "surrogate/net/network.hpp"

namespace bitrock::surrogate {

/// B rows of input and target, row by row.
struct Batch {
  int rows = 0;                     ///< B
  std::span<const double> inputs;   ///< (B x n[0]), scaled
  std::span<const double> targets;  ///< (B x n[K]), scaled
  std::span<const double> weights;  ///< (B), of the rows in the error; empty: all 1
};

/// Memory that is reused from batch to batch.
struct GradientBuffers {
  std::vector<std::vector<double>> activations;  ///< k = 0..K: a[k] (B x n[k])
  std::vector<double> delta;                     ///< dL/dz[k] (B x n[k]) of the layer in work
  std::vector<double> delta_below;               ///< dL/dz[k-1] (B x n[k-1])
};

/// **What** Loss and its derivative with respect to every parameter.
/// **Equation** L = 1/(B n[K]) sum_b w_b sum_j (a[K]_bj - t_bj)^2. With z[k] = W[k] a[k-1] + b[k], d[k] = dL/dz[k]:
///   d[K]_bj = 2/(B n[K]) w_b (a[K]_bj - t_bj) f'(z[K]_bj),   d[k-1]_bi = r(z[k-1]_bi) sum_j W[k]_ji d[k]_bj,
///   dL/dW[k]_ji = sum_b d[k]_bj a[k-1]_bi,   dL/db[k]_j = sum_b d[k]_bj,   r(z) = 1 for z > 0, else 0.
/// **Symbols** B rows of the batch; n[k], W[k], b[k], a[k], f as in `Network`; t target; w weight of a row; all
/// dimensionless.
/// **Source** [RumelhartEtAl1986].
/// **Validity** Exact except at a kink z = 0, where the derivative does not exist and 0 is taken, as Keras does.
/// Sums run in index order: the bits depend neither on vector width nor on thread count.
///
/// `gradient` has the layout and size of `network.parameters` and is overwritten. Returns L.
double loss_and_gradient(const Network& network, const Batch& batch, GradientBuffers& buffers,
                         std::span<double> gradient);

/// L alone, over any number of rows; 0 for none.
double mean_squared_error(const Network& network, const Batch& batch);

}  // namespace bitrock::surrogate
