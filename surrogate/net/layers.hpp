#pragma once
/// The layers of a network seen as matrices inside its flat vector, their random start and the slope of the last one:
/// what training and the writers of files need beyond `network.hpp`.

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "base/random.hpp"
#include "surrogate/net/network.hpp"

namespace bitrock::surrogate {

/// Weights as they lie in the flat vector: row after row, one row a node of the layer.
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

}  // namespace bitrock::surrogate
