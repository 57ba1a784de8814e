#include "surrogate/export/matlab_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "surrogate/export/columns.hpp"
#include "surrogate/export/source_text.hpp"
#include "surrogate/net/layers.hpp"

namespace bitrock::surrogate {

namespace {

constexpr std::size_t longest_name = 63;  // namelengthmax of MATLAB

constexpr std::string_view what_it_does = R"m(%
%   One condition or many: conditions is N x 3, statistics is N x OUTPUTS and inside N x 1, a row for each row. A single
%   condition may also be a column of 3, as Simulink gives signals. Anything else is an error.
%
%   inside is true inside the training range of the conditions; outside, the statistics are extrapolated. Not-a-number
%   in gives not-a-number out. x is the cutting direction, along the rock surface; y is the axial direction, out of the
%   rock. Forces are those of the rock on the cutter for each metre of thickness out of the plane of cutting; peaks are
%   counted per metre of cut.
%
)m";

constexpr std::string_view calculation = R"m(
if ~isnumeric(conditions) || ~isreal(conditions) || ~ismatrix(conditions)
  error('NAME:conditions', 'NAME: conditions must be a matrix of real numbers');
end
rows = double(conditions);
if size(rows, 1) == 3 && size(rows, 2) == 1
  rows = rows.';
end
if size(rows, 2) ~= 3
  error('NAME:conditions', 'NAME: conditions are %d x %d (must be N x 3, a row for each condition)', ...
        size(rows, 1), size(rows, 2));
end
count = size(rows, 1);
statistics = zeros(count, OUTPUTS);
inside = true(count, 1);

% Layer k maps some numbers to others: each starts at its bias and adds its row of weights in order; negative sums
% become 0, except on the last layer.
scaled = zeros(1, 3);
from = zeros(1, widest_layer);
to = zeros(1, widest_layer);
for row = 1:count
  for i = 1:3
    value = rows(row, i) / si_per_unit(i);
    scaled(i) = (value - input_offset(i)) / input_scale(i);
    if ~(value >= lowest(i) && value <= highest(i))
      inside(row) = false;
    end
  end
  place = 1;   % in layers
  weight = 1;  % in parameters
  for n = 1:OUTPUTS
    for i = 1:3
      from(i) = scaled(i);
    end
    last = layer_counts(n) - 1;
    for k = 1:last
      inputs = layers(place);
      outputs = layers(place + 1);
      place = place + 1;
      bias = weight + outputs * inputs;
      for o = 1:outputs
        z = parameters(bias);
        for i = 1:inputs
          z = z + parameters(weight) * from(i);
          weight = weight + 1;
        end
        bias = bias + 1;
        if k < last || activations(n) == 0
          if z < 0
            z = 0;
          end
        elseif activations(n) == 1
          softened = log1p(exp(-abs(z)));
          if z < 0
            z = 0;
          end
          z = z + softened;
        end
        to(o) = z;
      end
      weight = bias;
      for o = 1:outputs
        from(o) = to(o);
      end
    end
    place = place + 1;
    value = offsets(n) + scales(n) * from(1);
    if log_references(n) > 0
      value = log_references(n) * expm1(value);
    end
    if value < 0
      value = 0;
    end
    statistics(row, n) = value;
  end
end
end
)m";

std::string table(const char* name, std::span<const Column> columns) {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    text += fmt::format("%   {}(:, {})  {}\n", name, i + 1, described(columns[i]));
  }
  return text;
}

/// `name = [..., ..., ...];` in one line.
template <class Values, class TextOf>
std::string row(const char* name, const Values& values, const TextOf& text_of) {
  std::string text = fmt::format("{} = [", name);
  const char* comma = "";
  for (const auto& value : values) {
    text += fmt::format("{}{}", comma, text_of(value));
    comma = ", ";
  }
  return text + "];\n";
}

std::string inputs(const Model& model) {
  const auto of_input = [](double Variable::*member) {
    return [member](const Variable& input) { return number_text(input.*member); };
  };
  return "% The networks have learnt in m/s, mm and degrees; the training range is 1e-9 wider for the rounding of "
         "units.\n" +
         row("si_per_unit", input_names, [](const VariableName& name) { return number_text(name.si_per_unit); }) +
         row("lowest", model.inputs, [](const Variable& input) { return number_text(widened_range(input).low); }) +
         row("highest", model.inputs, [](const Variable& input) { return number_text(widened_range(input).high); }) +
         row("input_offset", model.inputs, of_input(&Variable::offset)) +
         row("input_scale", model.inputs, of_input(&Variable::scale));
}

std::string outputs(const Model& model) {
  using Output = const OutputModel&;
  return "\n% value = offset + scale * (what the network gives); with a log_reference y0 above 0 the statistic is\n"
         "% y0 (exp(value) - 1). Activation of the last layer: 0 rectified, 1 softplus, 2 linear.\n" +
         row("offsets", model.outputs, [](Output output) { return number_text(output.variable.offset); }) +
         row("scales", model.outputs, [](Output output) { return number_text(output.variable.scale); }) +
         row("log_references", model.outputs, [](Output output) { return number_text(output.log_reference); }) +
         row("activations", model.outputs, [](Output output) { return static_cast<int>(output.network.output); }) +
         row("layer_counts", model.outputs, [](Output output) { return output.network.layers.size(); });
}

std::string parameter_rows(const OutputModel& output) {
  std::string text;
  for (int k = 1; k < static_cast<int>(output.network.layers.size()); ++k) {
    const Layer seen = layer(output.network, k);
    text +=
        fmt::format("  ... {}, layer {}: a row of weights for each node, then the biases\n", output.variable.name, k);
    const auto add_row = [&](std::span<const double> values) {
      text += " ";
      for (const double value : values) text += fmt::format(" {},", number_text(value));
      text += " ...\n";
    };
    const auto columns = static_cast<std::size_t>(seen.weights.cols());
    for (Eigen::Index o = 0; o < seen.weights.rows(); ++o)
      add_row({seen.weights.data() + o * seen.weights.cols(), columns});
    add_row({seen.biases.data(), static_cast<std::size_t>(seen.biases.size())});
  }
  return text;
}

std::string networks(const Model& model) {
  int widest = input_count;
  std::string layers = "layers = [ ...\n", parameters = "parameters = [ ...\n";
  for (const OutputModel& output : model.outputs) {
    const std::vector<int>& widths = output.network.layers;
    widest = std::max(widest, *std::max_element(widths.begin(), widths.end()));
    layers += fmt::format("  {}, ... {}\n", fmt::join(widths, ", "), output.variable.name);
    parameters += parameter_rows(output);
  }
  return fmt::format("widest_layer = {};\n", widest) + layers + "];\n" + parameters + "];\n";
}

}  // namespace

std::string matlab_source(const Model& model, std::string_view name) {
  require_identifier(name, "function name", longest_name);
  std::string text = fmt::format(
                         "function [statistics, inside] = {}(conditions)\n"
                         "% Peak statistics of the force on one cutter in one rock: {}\n%\n",
                         name, comment_text(model.rock)) +
                     table("conditions", condition_columns(model)) + table("statistics", statistic_columns(model)) +
                     std::string(what_it_does) + origin(model, "% ") + "\n" + inputs(model) + outputs(model) +
                     networks(model) + replaced(std::string(calculation), "NAME", name);
  return replaced(std::move(text), "OUTPUTS", fmt::format("{}", model.outputs.size()));
}

}  // namespace bitrock::surrogate
