#include "surrogate/train/adam.hpp"

#include <cmath>

namespace bitrock::surrogate {

void adam_step(const AdamOptions& options, AdamState& state, std::span<const double> gradient,
               std::span<double> parameters) {
  state.m.resize(parameters.size(), 0.0);
  state.v.resize(parameters.size(), 0.0);
  state.beta1_power *= options.beta1;
  state.beta2_power *= options.beta2;
  const double step = options.learning_rate * std::sqrt(1.0 - state.beta2_power) / (1.0 - state.beta1_power);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double g = gradient[i];
    state.m[i] += (1.0 - options.beta1) * (g - state.m[i]);
    state.v[i] += (1.0 - options.beta2) * (g * g - state.v[i]);
    parameters[i] -= step * state.m[i] / (std::sqrt(state.v[i]) + options.epsilon);
  }
}

}  // namespace bitrock::surrogate
