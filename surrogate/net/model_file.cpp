#include "surrogate/net/model_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/json.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/json_place.hpp"
#include "surrogate/net/layers.hpp"

namespace bitrock::surrogate {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double largest_double = std::numeric_limits<double>::max();
constexpr int largest_int = std::numeric_limits<int>::max();

/// Indented like the JSON library would, but with each list of plain values on one line: a row of weights is a row.
void print(const OrderedJson& value, std::size_t depth, std::string& text) {
  const bool nested = std::any_of(value.begin(), value.end(), [](const auto& entry) { return entry.is_structured(); });
  if (!value.is_object() && !(value.is_array() && nested)) {
    // Text that is not UTF-8 (a rock name from elsewhere) must not stop the writing of a trained model.
    text += value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
    return;
  }
  const std::string indent(2 * depth, ' ');
  text += value.is_object() ? "{" : "[";
  const char* separator = "\n";
  for (const auto& [key, entry] : value.items()) {
    text += separator + indent + "  ";
    if (value.is_object()) text += OrderedJson(key).dump() + ": ";
    print(entry, depth + 1, text);
    separator = ",\n";
  }
  text += "\n" + indent + (value.is_object() ? "}" : "]");
}

OrderedJson variable_json(const Variable& variable) {
  return {{"name", variable.name}, {"unit", variable.unit},     {"low", variable.low},
          {"high", variable.high}, {"offset", variable.offset}, {"scale", variable.scale}};
}

OrderedJson output_json(const OutputModel& output) {
  OrderedJson weights = OrderedJson::array(), biases = OrderedJson::array();
  for (int k = 1; k < static_cast<int>(output.network.layers.size()); ++k) {
    const Layer seen = layer(output.network, k);
    OrderedJson rows = OrderedJson::array();
    for (Eigen::Index o = 0; o < seen.weights.rows(); ++o) {
      const double* row = seen.weights.data() + o * seen.weights.cols();
      rows.push_back(std::vector<double>(row, row + seen.weights.cols()));
    }
    weights.push_back(rows);
    biases.push_back(std::vector<double>(seen.biases.data(), seen.biases.data() + seen.biases.size()));
  }
  OrderedJson json = variable_json(output.variable);
  json["log_reference"] = output.log_reference;
  json["restarts"] = output.restarts;
  json["best_epoch"] = output.best_epoch;
  json["output_activation"] = name_of(output.network.output);
  json["layers"] = output.network.layers;
  json["weights"] = weights;
  json["biases"] = biases;
  return json;
}

OrderedJson provenance_json(const Provenance& provenance) {
  OrderedJson json{{"data_file", provenance.data_file},
                   {"data_fingerprint", provenance.data_fingerprint},
                   {"initial_fingerprint", provenance.initial_fingerprint},
                   {"seed", provenance.seed},
                   {"split_seed", provenance.split_seed},
                   {"split", provenance.split},
                   {"shuffle", provenance.shuffle},
                   {"epochs", provenance.epochs},
                   {"batch", provenance.batch},
                   {"learning_rate", provenance.learning_rate},
                   {"validation", provenance.validation},
                   {"patience", provenance.patience},
                   {"starts", provenance.starts},
                   {"smoothing", provenance.smoothing},
                   {"averaged", provenance.averaged},
                   {"weighted", provenance.weighted},
                   {"train_cases", provenance.train_cases},
                   {"validation_cases", provenance.validation_cases},
                   {"test_cases", provenance.test_cases},
                   {"choice", provenance.choice},
                   {"bitrock_version", provenance.bitrock_version}};
  if (provenance.counting) {
    const PeakCounting& counting = *provenance.counting;
    json["peak_counting"] = {{"smoothing_um", counting.smoothing_um},
                             {"min_prominence", counting.min_prominence},
                             {"min_distance_mm", counting.min_distance_mm},
                             {"sampling_um", counting.sampling_um}};
  }
  if (provenance.fluid_pressure_MPa > 0.0) json["fluid_pressure_MPa"] = provenance.fluid_pressure_MPa;
  if (provenance.taught_terms > 0) json["taught_terms"] = provenance.taught_terms;
  for (const HeldInput& held : provenance.held_inputs)
    json["held_inputs"].push_back({{"name", held.name}, {"value", held.value}});
  if (provenance.data_parts.empty()) return json;
  OrderedJson parts = OrderedJson::array();
  for (const DataPart& part : provenance.data_parts)
    parts.push_back({{"file", part.file}, {"fingerprint", part.fingerprint}, {"first_case", part.first_case}});
  json["data_parts"] = parts;
  return json;
}

OrderedJson curve_json(const std::vector<LearningPoint>& curve) {
  OrderedJson epochs = OrderedJson::array(), train = OrderedJson::array(), validation = OrderedJson::array(),
              test = OrderedJson::array();
  for (const LearningPoint& point : curve) {
    epochs.push_back(point.epoch);
    train.push_back(point.train_mse);
    validation.push_back(point.validation_mse);
    test.push_back(point.test_mse);
  }
  return {{"epoch", epochs}, {"train_mse", train}, {"validation_mse", validation}, {"test_mse", test}};
}

// Reading, in the order of writing.

const std::vector<std::string> variable_keys{"name", "unit", "low", "high", "offset", "scale"};

/// All but name and unit, which must be these.
Variable read_variable(const JsonPlace& place, std::string_view name, std::string_view unit) {
  Variable variable;
  variable.name = place.at("name").text();
  if (variable.name != name) place.at("name").refuse(fmt::format("must be {} here", name));
  variable.unit = place.at("unit").text();
  if (variable.unit != unit) place.at("unit").refuse(fmt::format("must be {}", unit));
  variable.low = place.at("low").number();
  variable.high = place.at("high").number();
  if (variable.high < variable.low) place.at("high").refuse(fmt::format("must be at least low = {}", variable.low));
  variable.offset = place.at("offset").number();
  variable.scale = place.at("scale").number();
  if (variable.scale <= 0.0) place.at("scale").refuse("must be above 0");
  return variable;
}

/// Speed, depth and rake, then further ones of names that differ.
std::vector<Variable> read_inputs(const JsonPlace& place) {
  const std::size_t count = place.list();
  if (count < input_count || count > most_inputs)
    place.refuse(fmt::format("must hold from {} to {} inputs", input_count, most_inputs));
  std::vector<Variable> inputs;
  for (std::size_t i = 0; i < count; ++i) {
    const JsonPlace one = place.at(i);
    one.only(variable_keys);
    const std::string name = i < input_count ? std::string(input_names[i].name) : one.at("name").text();
    if (i >= input_count && !is_further_input(name))
      one.at("name").refuse(fmt::format("must be {}, or begin with {}", pressure_input, rock_input_begins));
    for (const Variable& input : inputs) {
      if (input.name == name) one.at("name").refuse("comes twice");
    }
    inputs.push_back(read_variable(one, name, i < input_count ? input_names[i].unit : unit_at_end(name)));
  }
  return inputs;
}

void read_parameters(const JsonPlace& list, int count, std::vector<double>& parameters) {
  list.list_of(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    parameters.push_back(list.at(i).number_from(-largest_parameter, largest_parameter));
  }
}

Network read_network(const JsonPlace& place, std::size_t inputs) {
  Network network;
  const auto activation = output_activation(place.at("output_activation").text());
  if (!activation) place.at("output_activation").refuse("must be rectified, softplus or linear");
  network.output = *activation;
  network.layers = place.at("layers").whole_numbers();
  const std::string problem = layers_problem(network.layers);
  if (!problem.empty()) place.at("layers").refuse(problem);
  if (network.layers.front() != static_cast<int>(inputs) || network.layers.back() != 1) {
    place.at("layers").refuse(fmt::format("must begin with {} inputs and end with 1 output", inputs));
  }
  const JsonPlace weights = place.at("weights"), biases = place.at("biases");
  weights.list_of(network.layers.size() - 1);
  biases.list_of(network.layers.size() - 1);
  for (std::size_t k = 0; k + 1 < network.layers.size(); ++k) {
    const int from = network.layers[k], to = network.layers[k + 1];
    const JsonPlace rows = weights.at(k);
    rows.list_of(static_cast<std::size_t>(to));
    for (std::size_t o = 0; o < static_cast<std::size_t>(to); ++o) {
      read_parameters(rows.at(o), from, network.parameters);
    }
    read_parameters(biases.at(k), to, network.parameters);
  }
  return network;
}

OutputModel read_output(const JsonPlace& place, const VariableName& expected, std::size_t inputs) {
  std::vector<std::string> keys = variable_keys;
  keys.insert(keys.end(),
              {"log_reference", "restarts", "best_epoch", "output_activation", "layers", "weights", "biases"});
  place.only(keys);
  OutputModel output;
  output.variable = read_variable(place, expected.name, expected.unit);
  output.log_reference = place.at("log_reference").number_from(0.0, largest_double);
  output.restarts = static_cast<int>(place.at("restarts").whole_up_to(largest_int));
  output.best_epoch = static_cast<int>(place.at("best_epoch").whole_up_to(largest_int));
  output.network = read_network(place, inputs);
  return output;
}

Provenance read_provenance(const JsonPlace& place) {
  place.only({"data_file",     "data_fingerprint", "initial_fingerprint",
              "seed",          "split_seed",       "split",
              "shuffle",       "epochs",           "batch",
              "learning_rate", "validation",       "patience",
              "starts",        "smoothing",        "averaged",
              "weighted",      "train_cases",      "validation_cases",
              "test_cases",    "choice",           "bitrock_version",
              "data_parts",    "peak_counting",    "fluid_pressure_MPa",
              "held_inputs",   "taught_terms"});
  constexpr std::uint64_t any_seed = std::numeric_limits<std::uint64_t>::max();
  Provenance provenance;
  provenance.data_file = place.at("data_file").text();
  provenance.data_fingerprint = place.at("data_fingerprint").text();
  if (place.has("data_parts")) {  // models of one table are without
    const JsonPlace parts = place.at("data_parts");
    for (std::size_t k = 0; k < parts.list(); ++k) {
      const JsonPlace part = parts.at(k);
      part.only({"file", "fingerprint", "first_case"});
      provenance.data_parts.push_back({.file = part.at("file").text(),
                                       .fingerprint = part.at("fingerprint").text(),
                                       .first_case = static_cast<int>(part.at("first_case").whole_up_to(largest_int))});
    }
  }
  if (place.has("peak_counting")) {
    const JsonPlace counting = place.at("peak_counting");
    counting.only({"smoothing_um", "min_prominence", "min_distance_mm", "sampling_um"});
    const auto number = [&counting](const char* name) { return counting.at(name).number_from(0.0, largest_double); };
    provenance.counting = {.smoothing_um = number("smoothing_um"),
                           .min_prominence = number("min_prominence"),
                           .min_distance_mm = number("min_distance_mm"),
                           .sampling_um = number("sampling_um")};
  }
  if (place.has("fluid_pressure_MPa"))  // models of cuts without mud are without
    provenance.fluid_pressure_MPa = place.at("fluid_pressure_MPa").number_from(0.0, largest_double);
  if (place.has("taught_terms"))
    provenance.taught_terms = static_cast<int>(place.at("taught_terms").whole_up_to(largest_int));
  if (place.has("held_inputs")) {
    const JsonPlace held = place.at("held_inputs");
    for (std::size_t k = 0; k < held.list(); ++k) {
      held.at(k).only({"name", "value"});
      provenance.held_inputs.push_back(
          {.name = held.at(k).at("name").text(), .value = held.at(k).at("value").number()});
    }
  }
  provenance.initial_fingerprint = place.at("initial_fingerprint").text();
  provenance.seed = place.at("seed").whole_up_to(any_seed);
  provenance.split_seed = place.at("split_seed").whole_up_to(any_seed);
  provenance.split = place.at("split").number_from(0.0, 1.0);
  provenance.shuffle = place.at("shuffle").flag();
  provenance.epochs = static_cast<int>(place.at("epochs").whole_up_to(largest_int));
  provenance.batch = static_cast<int>(place.at("batch").whole_up_to(largest_int));
  provenance.learning_rate = place.at("learning_rate").number_from(0.0, largest_double);
  provenance.train_cases = place.at("train_cases").whole_numbers();
  provenance.validation = place.at("validation").number_from(0.0, 1.0);
  provenance.patience = static_cast<int>(place.at("patience").whole_up_to(largest_int));
  provenance.starts = static_cast<int>(place.at("starts").whole_up_to(largest_int));
  if (place.has("smoothing")) {  // files before 2026-11-27 have none
    provenance.smoothing = static_cast<int>(place.at("smoothing").whole_up_to(largest_int));
  }
  provenance.averaged = place.at("averaged").flag();
  provenance.weighted = place.at("weighted").flag();
  provenance.validation_cases = place.at("validation_cases").whole_numbers();
  provenance.test_cases = place.at("test_cases").whole_numbers();
  provenance.choice = place.at("choice").text();
  for (const char* key : {"train_cases", "validation_cases", "test_cases"}) {
    const std::vector<int> cases = place.at(key).whole_numbers();
    if (!std::is_sorted(cases.begin(), cases.end())) place.at(key).refuse("must be ascending");
  }
  provenance.bitrock_version = place.at("bitrock_version").text();
  return provenance;
}

std::vector<LearningPoint> read_curve(const JsonPlace& place) {
  place.only({"epoch", "train_mse", "validation_mse", "test_mse"});
  const std::vector<int> epochs = place.at("epoch").whole_numbers();
  const JsonPlace train = place.at("train_mse"), validation = place.at("validation_mse"), test = place.at("test_mse");
  train.list_of(epochs.size());
  validation.list_of(epochs.size());
  test.list_of(epochs.size());
  std::vector<LearningPoint> curve;
  for (std::size_t i = 0; i < epochs.size(); ++i) {
    curve.push_back({.epoch = epochs[i],
                     .train_mse = train.at(i).number_from(0.0, largest_double),
                     .validation_mse = validation.at(i).number_from(0.0, largest_double),
                     .test_mse = test.at(i).number_from(0.0, largest_double)});
  }
  return curve;
}

}  // namespace

std::string model_text(const Model& model) {
  OrderedJson json{{"format", model_format}, {"format_version", model_format_version}, {"rock", model.rock}};
  OrderedJson curves = OrderedJson::object();
  for (const Variable& input : model.inputs) json["inputs"].push_back(variable_json(input));
  for (const OutputModel& output : model.outputs) {
    json["outputs"].push_back(output_json(output));
    curves[output.variable.name] = curve_json(output.learning_curve);
  }
  json["provenance"] = provenance_json(model.provenance);
  json["learning_curves"] = curves;
  std::string text;
  print(json, 0, text);
  return text + "\n";
}

Model model_from_text(std::string_view text, const std::string& name) {
  const nlohmann::json json = base::json_from_text(text, name);
  const JsonPlace root(json, name);
  if (root.at("format").text() != model_format) root.at("format").refuse(fmt::format("must be {}", model_format));
  if (root.at("format_version").whole_up_to(largest_int) != model_format_version) {
    root.at("format_version").refuse(fmt::format("this bitrock reads version {}", model_format_version));
  }
  root.only({"format", "format_version", "rock", "inputs", "outputs", "provenance", "learning_curves"});

  Model model;
  model.rock = root.at("rock").text();
  model.inputs = read_inputs(root.at("inputs"));
  const JsonPlace outputs = root.at("outputs");
  // the seven behind the article's ten are there together or not at all
  const bool with_moments = outputs.list() > article_output_count;
  outputs.list_of(with_moments ? most_outputs : article_output_count);
  model.outputs.resize(outputs.list());
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    model.outputs[i] = read_output(outputs.at(i), output_names[i], model.inputs.size());
    model.outputs[i].learning_curve = read_curve(root.at("learning_curves").at(std::string(output_names[i].name)));
    names.emplace_back(output_names[i].name);
  }
  root.at("learning_curves").only(names);
  model.provenance = read_provenance(root.at("provenance"));
  return model;
}

Model read_model(const std::filesystem::path& path) {
  return model_from_text(base::read_whole(path), path.string());
}

Model read_cut_model(const std::filesystem::path& path) {
  Model model = read_model(path);
  require_no_further_inputs(model, path.string());
  return model;
}

void write_model(const std::filesystem::path& path, const Model& model) {
  base::write_whole(path, model_text(model));
}

}  // namespace bitrock::surrogate
