#pragma once
/// A small dense network with rectified linear units. It exists because the surrogate needs nothing more, and because
/// a real-time caller needs a forward pass that takes no memory. All parameters lie in ONE flat vector, so saving,
/// copying, exporting and optimising are each one loop. It knows nothing of units and scaling (`model.hpp`), files
/// (`model_file.hpp`) or learning (`surrogate/train/`).

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/random.hpp"
#include "surrogate/net/evaluation.hpp"

namespace bitrock::surrogate {

/// **What** Layer k = 1..K maps a[k-1] to a[k]: rectified on the hidden layers, as `output` says on the last.
/// **Equation** a[k] = max(0, W[k] a[k-1] + b[k]) for k < K, a[0] = input, a[K] = f(W[K] a[K-1] + b[K]) = output.
/// **Symbols** W[k] (n[k] x n[k-1]), b[k] (n[k]), a[k] (n[k]), f the output activation; all dimensionless.
/// **Source** [BitRock2026, sec. 3.2; its fig. 3 as told by the text]: 3 inputs, hidden layers of 4, 6 and 3 nodes, 1
/// output, rectified linear units on all layers. [NairHinton2010] for the unit.
/// **Validity** A rectified output is never negative, which fits amplitudes and counts; a network whose output unit is
/// off for every input is dead (no gradient reaches its weights) and cannot recover.
struct Network {
  std::vector<int> layers{3, 4, 6, 3, 1};  ///< n[0], n[1], ..., n[K]
  OutputActivation output = OutputActivation::rectified;
  /// For k = 1..K: W[k] row by row (n[k] x n[k-1]), then b[k] (n[k]).
  std::vector<double> parameters;
};

/// Empty when a network of these layers can be built, otherwise what is wrong with them.
std::string layers_problem(std::span<const int> layers);

/// Sum over k of n[k] (n[k-1] + 1). 71 for 3-4-6-3-1.
std::size_t parameter_count(std::span<const int> layers);

using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// One layer seen inside the flat vector.
struct Layer {
  Eigen::Map<const RowMajorMatrix> weights;  ///< W[k] (n[k] x n[k-1])
  Eigen::Map<const Eigen::VectorXd> biases;  ///< b[k] (n[k])
};

/// Layer k of K, k = 1..K. The maps live as long as the network's parameters do not move.
Layer layer(const Network& network, int k);

/// First place of layer k in the flat vector.
std::size_t layer_offset(std::span<const int> layers, int k);

/// **What** Random start for rectified units: keeps the size of signals from layer to layer.
/// **Equation** W[k] ~ N(0, 2 / n[k-1]), b[k] = 0.
/// **Source** [HeEtAl2015]. The article does not name its initialiser; Keras' default differs (uniform,
/// scaled for symmetric units).
/// Sizes `parameters` to the layers; draws in the order of the flat vector. Throws `InputError` for layers that
/// `layers_problem` refuses.
void initialise(Network& network, base::Random& random);

/// df/dz where f(z) = `activated`: the slope follows from the value. At the kink of the rectifier 0, as Keras has it.
double activation_slope(OutputActivation output, double activated);

/// "rectified", "softplus", "linear": the names in files and flags.
std::string_view name_of(OutputActivation output);

/// The activation of that name, or nothing.
std::optional<OutputActivation> output_activation(std::string_view name);

/// Forward pass of one input (n[0]) to one output (n[K]) by the `forward` of `evaluation.hpp`. Takes no memory.
/// The network must satisfy `layers_problem` and have its `parameter_count`.
void forward(const Network& network, std::span<const double> input, std::span<double> output);

}  // namespace bitrock::surrogate
