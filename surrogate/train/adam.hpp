#pragma once
/// One optimiser: Adam, on one flat vector of parameters. It knows neither networks nor losses.

#include <span>
#include <vector>

namespace bitrock::surrogate {

/// Constants of the optimiser.
struct AdamOptions {
  double learning_rate = 1e-3;  ///< [1] alpha; the article's value and Keras' default
  double beta1 = 0.9;           ///< [1] memory of the mean gradient: about 1/(1 - beta1) steps
  double beta2 = 0.999;         ///< [1] memory of the mean squared gradient
  double epsilon = 1e-7;        ///< [1] epsilon-hat below; Keras' default. Larger damps steps where gradients are tiny
};

/// Memory of the optimiser between steps; empty means no step was taken yet.
struct AdamState {
  std::vector<double> m;     ///< running mean of the gradient
  std::vector<double> v;     ///< running mean of its square
  double beta1_power = 1.0;  ///< beta1^t
  double beta2_power = 1.0;  ///< beta2^t
};

/// **What** One step t = 1, 2, ... against the gradient g, each parameter with its own step size.
/// **Equation** m <- m + (1 - beta1)(g - m),   v <- v + (1 - beta2)(g^2 - v),
///   alpha_t = alpha sqrt(1 - beta2^t) / (1 - beta1^t),   p <- p - alpha_t m / (sqrt(v) + epsilon_hat).
/// **Symbols** p parameter, m and v running means, alpha learning rate; all dimensionless in scaled units.
/// **Source** [KingmaBa2015], its algorithm in the other order of computation, the form Keras computes (the article
/// used Keras).
/// **Differences** The paper's first form divides by sqrt(v / (1 - beta2^t)) + epsilon. Both agree when
/// epsilon_hat = epsilon sqrt(1 - beta2^t): here epsilon stands outside the bias correction, so in the first steps it
/// weighs up to 1/sqrt(1 - beta2) = 32 times more against the gradient than there.
/// **Validity** A first step has length alpha |g| / (|g| + epsilon_hat / sqrt(1 - beta2)), whatever the scale of g.
void adam_step(const AdamOptions& options, AdamState& state, std::span<const double> gradient,
               std::span<double> parameters);

}  // namespace bitrock::surrogate
