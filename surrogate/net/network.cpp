#include "surrogate/net/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/errors.hpp"

namespace bitrock::surrogate {

namespace {

constexpr std::array<std::string_view, 3> output_names_in_files{"rectified", "softplus", "linear"};  // as in the enum

}  // namespace

std::string layers_problem(std::span<const int> layers) {
  if (layers.size() < 2 || layers.size() > most_layers) {
    return fmt::format("{} layers (2 to {} are allowed)", layers.size(), most_layers);
  }
  for (const int width : layers) {
    if (width < 1 || width > widest_layer) {
      return fmt::format("a layer of {} nodes (1 to {} are allowed)", width, widest_layer);
    }
  }
  return {};
}

std::size_t layer_offset(std::span<const int> layers, int k) {
  std::size_t offset = 0;
  for (int i = 1; i < k; ++i) {
    const auto at = static_cast<std::size_t>(i);
    offset += static_cast<std::size_t>(layers[at]) * (static_cast<std::size_t>(layers[at - 1]) + 1);
  }
  return offset;
}

std::size_t parameter_count(std::span<const int> layers) {
  return layer_offset(layers, static_cast<int>(layers.size()));
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

std::string_view name_of(OutputActivation output) {
  return output_names_in_files[static_cast<std::size_t>(output)];
}

std::optional<OutputActivation> output_activation(std::string_view name) {
  for (std::size_t i = 0; i < output_names_in_files.size(); ++i) {
    if (output_names_in_files[i] == name) return static_cast<OutputActivation>(i);
  }
  return std::nullopt;
}

void forward(const Network& network, std::span<const double> input, std::span<double> output) {
  forward({.layers = network.layers.data(),
           .layer_count = static_cast<int>(network.layers.size()),
           .output = network.output,
           .parameters = network.parameters.data()},
          input.data(), output.data());
}

}  // namespace bitrock::surrogate
