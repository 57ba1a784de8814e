#include "surrogate/net/network.hpp"

#include <fmt/format.h>

#include <array>

#include "surrogate/net/layers.hpp"

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

std::size_t parameter_count(std::span<const int> layers) {
  return layer_offset(layers, static_cast<int>(layers.size()));
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
