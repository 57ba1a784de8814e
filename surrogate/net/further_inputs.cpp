#include "surrogate/net/further_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/errors.hpp"
#include "base/number.hpp"

namespace bitrock::surrogate {

namespace {

constexpr std::array<std::string_view, 8> units{"MPa_sqrt_m", "kg_per_m3", "MPa", "GPa", "mm", "um", "m", "deg"};

/// The output with the first layer of its network narrowed to speed, depth and rake.
void hold(OutputModel& output, std::span<const double> scaled) {
  Network& network = output.network;
  const auto inputs = static_cast<std::size_t>(network.layers[0]), nodes = static_cast<std::size_t>(network.layers[1]);
  std::vector<double> parameters;
  parameters.reserve(network.parameters.size());
  for (std::size_t node = 0; node < nodes; ++node) {
    const auto row = network.parameters.begin() + static_cast<std::ptrdiff_t>(node * inputs);
    parameters.insert(parameters.end(), row, row + input_count);
  }
  for (std::size_t node = 0; node < nodes; ++node) {
    double bias = network.parameters[nodes * inputs + node];
    for (std::size_t i = 0; i < scaled.size(); ++i)
      bias += network.parameters[node * inputs + input_count + i] * scaled[i];
    parameters.push_back(bias);
  }
  parameters.insert(parameters.end(), network.parameters.begin() + static_cast<std::ptrdiff_t>(nodes * (inputs + 1)),
                    network.parameters.end());
  network.parameters = std::move(parameters);
  network.layers[0] = input_count;
}

HeldInput held_input(const std::string& text) {
  const std::size_t sign = text.find('=');
  const std::string number = sign == std::string::npos ? "" : text.substr(sign + 1);
  const std::optional<double> value = base::number_in(number);
  if (sign == 0 || !value) {
    throw base::InputError(fmt::format("'{}' is no value of an input{} (must be NAME=VALUE, such as {}=20)", text,
                                       number.empty() ? "" : ": " + base::why_no_number(number), pressure_input));
  }
  return {.name = text.substr(0, sign), .value = *value};
}

}  // namespace

bool is_further_input(std::string_view name) {
  return name == pressure_input || name.starts_with(rock_input_begins);
}

std::string_view unit_at_end(std::string_view name) {
  for (const std::string_view unit : units) {
    if (name.size() > unit.size() && name.ends_with(unit) && name[name.size() - unit.size() - 1] == '_') return unit;
  }
  return "1";
}

std::span<const Variable> further_inputs(const Model& model) {
  return std::span(model.inputs).subspan(input_count);
}

std::string further_names(const Model& model) {
  std::string names;
  for (const Variable& input : further_inputs(model)) names += (names.empty() ? "" : ", ") + input.name;
  return names;
}

std::vector<HeldInput> held_inputs(std::span<const std::string> texts) {
  std::vector<HeldInput> held;
  held.reserve(texts.size());
  for (const std::string& text : texts) held.push_back(held_input(text));
  return held;
}

std::vector<double> further_values(const Model& model, std::span<const HeldInput> given) {
  std::vector<double> values;
  for (const Variable& input : further_inputs(model)) {
    const auto is_it = [&input](const HeldInput& one) { return one.name == input.name; };
    if (std::count_if(given.begin(), given.end(), is_it) > 1)
      throw base::InputError(fmt::format("{} is given twice", input.name));
    const auto found = std::find_if(given.begin(), given.end(), is_it);
    if (found == given.end()) {
      throw base::InputError(fmt::format("{} is missing (the networks ask for it too: {:g} to {:g} were learnt)",
                                         input.name, input.low, input.high));
    }
    values.push_back(found->value);
  }
  for (const HeldInput& one : given) {
    const auto is_it = [&one](const Variable& input) { return one.name == input.name; };
    if (std::ranges::any_of(further_inputs(model), is_it)) continue;
    const std::string names = further_names(model);
    throw base::InputError(fmt::format("{}: the networks have no such further input ({})", one.name,
                                       names.empty() ? "they have none" : "they have " + names));
  }
  return values;
}

Model held(const Model& model, std::span<const HeldInput> given) {
  std::vector<double> scaled = further_values(model, given);
  Model narrow = model;
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const Variable& input = model.inputs[input_count + i];
    const Bounds bounds = widened_range(input);
    if (!(scaled[i] >= bounds.low && scaled[i] <= bounds.high)) {
      throw base::InputError(fmt::format("{} = {:g} (must be from {:g} to {:g}, what the networks have learnt)",
                                         input.name, scaled[i], input.low, input.high));
    }
    if (input.name == pressure_input) narrow.provenance.fluid_pressure_MPa = scaled[i];
    narrow.provenance.held_inputs.push_back({input.name, scaled[i]});
    scaled[i] = (scaled[i] - input.offset) / input.scale;
  }
  narrow.inputs.resize(input_count);
  for (OutputModel& output : narrow.outputs) hold(output, scaled);
  return narrow;
}

void require_no_further_inputs(const Model& model, const std::string& source) {
  if (further_inputs(model).empty()) return;
  std::string flags;
  for (const Variable& input : further_inputs(model)) flags += fmt::format(" {}={:g}", input.name, input.high);
  throw base::InputError(
      fmt::format("{}: the networks ask for more than speed, depth and rake: {} (hold them, for instance by: bitrock "
                  "hold {}{} -o held.json)",
                  source, further_names(model), source, flags));
}

}  // namespace bitrock::surrogate
