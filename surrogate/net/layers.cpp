#include "surrogate/net/layers.hpp"

#include <cmath>

#include "base/errors.hpp"

namespace bitrock::surrogate {

std::size_t layer_offset(std::span<const int> layers, int k) {
  std::size_t offset = 0;
  for (int i = 1; i < k; ++i) {
    const auto at = static_cast<std::size_t>(i);
    offset += static_cast<std::size_t>(layers[at]) * (static_cast<std::size_t>(layers[at - 1]) + 1);
  }
  return offset;
}

Layer layer(const Network& network, int k) {
  const int outputs = network.layers[static_cast<std::size_t>(k)];
  const int inputs = network.layers[static_cast<std::size_t>(k) - 1];
  const double* first = network.parameters.data() + layer_offset(network.layers, k);
  return {Eigen::Map<const RowMajorMatrix>(first, outputs, inputs),
          Eigen::Map<const Eigen::VectorXd>(first + outputs * inputs, outputs)};
}

void initialise(Network& network, base::Random& random) {
  const std::string problem = layers_problem(network.layers);
  if (!problem.empty()) throw base::InputError("the network has " + problem);
  network.parameters.clear();
  network.parameters.reserve(parameter_count(network.layers));
  for (std::size_t k = 1; k < network.layers.size(); ++k) {
    const int inputs = network.layers[k - 1], outputs = network.layers[k];
    const double deviation = std::sqrt(2.0 / inputs);
    for (int i = 0; i < outputs * inputs; ++i) network.parameters.push_back(deviation * base::normal(random));
    network.parameters.insert(network.parameters.end(), static_cast<std::size_t>(outputs), 0.0);
  }
}

double activation_slope(OutputActivation output, double activated) {
  switch (output) {
    case OutputActivation::rectified:
      return activated > 0.0 ? 1.0 : 0.0;
    case OutputActivation::softplus:
      return -std::expm1(-activated);  // 1/(1 + e^-z) = 1 - e^-f
    case OutputActivation::linear:
      break;
  }
  return 1.0;
}

}  // namespace bitrock::surrogate
