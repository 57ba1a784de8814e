#pragma once
/// A small dense network with rectified linear units. It exists because the surrogate needs nothing more, and because
/// a real-time caller needs a forward pass that takes no memory. All parameters lie in ONE flat vector, so saving,
/// copying, exporting and optimising are each one loop. It knows nothing of units and scaling (`model.hpp`), files
/// (`model_file.hpp`), layers as matrices (`layers.hpp`) or learning (`surrogate/train/`).

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
  std::vector<int> layers{3, 4, 6, 3, 1};                 ///< n[0], n[1], ..., n[K]
  OutputActivation output = OutputActivation::rectified;  ///< of the last layer
  /// For k = 1..K: W[k] row by row (n[k] x n[k-1]), then b[k] (n[k]).
  std::vector<double> parameters;
};

/// Empty when a network of these layers can be built, otherwise what is wrong with them.
std::string layers_problem(std::span<const int> layers);

/// Sum over k of n[k] (n[k-1] + 1). 71 for 3-4-6-3-1.
std::size_t parameter_count(std::span<const int> layers);

/// "rectified", "softplus", "linear": the names in files and flags.
std::string_view name_of(OutputActivation output);

/// The activation of that name, or nothing.
std::optional<OutputActivation> output_activation(std::string_view name);

/// Forward pass of one input (n[0]) to one output (n[K]) by the `forward` of `evaluation.hpp`. Takes no memory.
/// The network must satisfy `layers_problem` and have its `parameter_count`.
void forward(const Network& network, std::span<const double> input, std::span<double> output);

}  // namespace bitrock::surrogate
