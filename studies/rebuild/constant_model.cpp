#include "studies/rebuild/constant_model.hpp"

namespace bitrock::studies {

surrogate::Model constant_model(const surrogate::OutputValues& values) {
  constexpr double anything = 1e9;  // the range it says it was trained on
  surrogate::Model model;
  for (surrogate::Variable& input : model.inputs)
    input = {.low = -anything, .high = anything, .offset = 0.0, .scale = 1.0};
  model.outputs.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    surrogate::OutputModel& output = model.outputs[i];
    output.network.layers = {surrogate::input_count, 1};
    output.network.parameters = {0.0, 0.0, 0.0, 1.0};  // no weights, a bias of 1
    output.variable.offset = 0.0;
    output.variable.scale = values[i];
  }
  return model;
}

}  // namespace bitrock::studies
