#pragma once
/// One model with every kind of network that a model file may hold: three activations of the output, with and without
/// logarithm, offsets, from no hidden layer to four, one to 64 nodes wide. What is exported is compared with it.

#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "surrogate/net/layers.hpp"
#include "surrogate/net/model.hpp"

using namespace bitrock;

namespace mixed {

/// Weights as `initialise` draws them, biases between -0.2 and 0.5.
inline surrogate::Network network(base::Random& random, const std::vector<int>& layers,
                                  surrogate::OutputActivation output) {
  surrogate::Network made{.layers = layers, .output = output};
  surrogate::initialise(made, random);
  for (std::size_t k = 1; k < layers.size(); ++k) {
    const std::size_t next = surrogate::layer_offset(layers, static_cast<int>(k) + 1);
    for (std::size_t i = next - static_cast<std::size_t>(layers[k]); i < next; ++i)
      made.parameters[i] = base::uniform(random, -0.2, 0.5);
  }
  return made;
}

/// Speed 0.1 to 3 m/s, depth 0.5 to 5 mm, rake 10 to 40 degrees. Forces of some 1e5 N/m, counts of some 1e3 per metre.
/// Of the default seed, every network answers above zero for half of the conditions at least, and five of the ten are
/// cut off at zero for others.
inline surrogate::Model model(std::uint64_t seed = 365) {
  using enum surrogate::OutputActivation;
  base::Random random(seed);
  surrogate::Model made;
  constexpr std::array<double, 3> low{0.1, 0.5, 10.0}, high{3.0, 5.0, 40.0};
  for (std::size_t i = 0; i < made.inputs.size(); ++i) {
    const surrogate::VariableName& name = surrogate::input_names[i];
    made.inputs[i] = {std::string(name.name), std::string(name.unit), low[i], high[i], low[i], high[i] - low[i]};
  }
  struct Kind {
    std::vector<int> layers;
    surrogate::OutputActivation output;
    bool logarithm;
    double offset;  ///< in scales
  };
  const std::array<Kind, surrogate::article_output_count> kinds{{{{3, 4, 6, 3, 1}, rectified, false, 0.0},
                                                                 {{3, 4, 6, 3, 1}, softplus, false, 0.0},
                                                                 {{3, 4, 6, 3, 1}, linear, false, 0.0},
                                                                 {{3, 8, 8, 1}, rectified, true, 0.0},
                                                                 {{3, 8, 8, 1}, softplus, true, 0.0},
                                                                 {{3, 8, 8, 1}, linear, true, 0.0},
                                                                 {{3, 64, 1, 5, 64, 1}, linear, false, 0.7},
                                                                 {{3, 1}, linear, false, -0.1},
                                                                 {{3, 1}, softplus, true, 0.3},
                                                                 {{3, 32, 1}, rectified, true, -0.2}}};
  for (std::size_t i = 0; i < made.outputs.size(); ++i) {
    const surrogate::VariableName& name = surrogate::output_names[i];
    const double high_value = name.unit == "N/m" ? 4.3e5 : 1.7e3;
    surrogate::OutputModel& output = made.outputs[i];
    output.log_reference = kinds[i].logarithm ? high_value / 17.0 : 0.0;
    const double scale = kinds[i].logarithm ? std::log1p(17.0) : high_value;
    output.variable = {std::string(name.name), std::string(name.unit), 0.0, high_value, kinds[i].offset * scale, scale};
    output.network = network(random, kinds[i].layers, kinds[i].output);
    output.learning_curve = {{.epoch = 1, .train_mse = 0.5, .validation_mse = 0.0, .test_mse = 0.75}};
  }
  made.rock = "stone of all kinds";
  made.provenance = {.data_file = "features.csv", .data_fingerprint = "0123456789abcdef", .seed = 7};
  made.provenance.bitrock_version = "0.1.0";
  return made;
}

}  // namespace mixed
