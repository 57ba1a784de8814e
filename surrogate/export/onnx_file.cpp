#include "surrogate/export/onnx_file.hpp"

#include <fmt/format.h>
#include <onnx/checker.h>
#include <onnx/onnx_pb.h>

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "base/version.hpp"
#include "surrogate/export/columns.hpp"
#include "surrogate/net/layers.hpp"

namespace bitrock::surrogate {

namespace {

constexpr int operator_set = 13;  // the oldest with all forms used here; old programs read it
constexpr int file_version = 7;   // of the time of that operator set

/// Writes one graph from its beginning to its end. A name stands for what a node gives, or for a constant.
class Graph {
 public:
  explicit Graph(onnx::GraphProto& graph) : graph_(graph) {}

  /// A node that gives `name`.
  std::string node(const char* operation, const std::vector<std::string>& inputs, const std::string& name) {
    onnx::NodeProto& node = *graph_.add_node();
    node.set_op_type(operation);
    node.set_name(name);
    for (const std::string& input : inputs) node.add_input(input);
    node.add_output(name);
    return name;
  }

  /// Sets a whole number of the node written last.
  void attribute(const char* name, int value) {
    onnx::AttributeProto& attribute = *graph_.mutable_node(graph_.node_size() - 1)->add_attribute();
    attribute.set_name(name);
    attribute.set_type(onnx::AttributeProto::INT);
    attribute.set_i(value);
  }

  std::string constant(const std::string& name, std::span<const double> values, const std::vector<int>& shape) {
    onnx::TensorProto& tensor = *graph_.add_initializer();
    tensor.set_name(name);
    tensor.set_data_type(onnx::TensorProto::FLOAT);
    for (const int length : shape) tensor.add_dims(length);
    for (const double value : values) tensor.add_float_data(in_32_bits(value, name));
    return name;
  }

  std::string constant(const std::string& name, double value) { return constant(name, {&value, 1}, {1}); }

  /// A factor must not become 0, as a weight may.
  std::string factor(const std::string& name, std::span<const double> values) {
    for (const double value : values) {
      if (static_cast<float>(value) == 0.0F) refuse(value, name);
    }
    return constant(name, values, {static_cast<int>(values.size())});
  }

  std::string factor(const std::string& name, double value) { return factor(name, {&value, 1}); }

 private:
  static float in_32_bits(double value, const std::string& name) {
    const auto single = static_cast<float>(value);
    if (!std::isfinite(single)) refuse(value, name);
    return single;
  }

  [[noreturn]] static void refuse(double value, const std::string& name) {
    throw base::InputError(
        fmt::format("{} = {:g} does not fit into the 32-bit numbers of ONNX (1e-45 to 3e38)", name, value));
  }

  onnx::GraphProto& graph_;
};

std::string scaled_conditions(Graph& graph, const Model& model) {
  std::array<double, input_count> offsets{}, factors{};
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    offsets[i] = model.inputs[i].offset * input_names[i].si_per_unit;
    factors[i] = 1.0 / (model.inputs[i].scale * input_names[i].si_per_unit);
  }
  const std::string above = graph.node(
      "Sub", {"conditions", graph.constant("conditions/offset", offsets, {input_count})}, "conditions/above_offset");
  return graph.node("Mul", {above, graph.factor("conditions/per_scale", factors)}, "conditions/scaled");
}

/// What network `name` gives for the scaled conditions.
std::string network_nodes(Graph& graph, const Network& network, const std::string& name, std::string value) {
  const int last = static_cast<int>(network.layers.size()) - 1;
  for (int k = 1; k <= last; ++k) {
    const Layer seen = layer(network, k);
    const auto outputs = static_cast<int>(seen.weights.rows()), inputs = static_cast<int>(seen.weights.cols());
    const std::span weights(seen.weights.data(), static_cast<std::size_t>(seen.weights.size()));
    const std::span biases(seen.biases.data(), static_cast<std::size_t>(seen.biases.size()));
    const std::string place = fmt::format("{}/layer_{}", name, k);
    value = graph.node("Gemm",
                       {value, graph.constant(place + "/weights", weights, {outputs, inputs}),
                        graph.constant(place + "/biases", biases, {outputs})},
                       place + "/sum");
    graph.attribute("transB", 1);  // rows of weights belong to outputs
    const bool rectifies = k < last || network.output == OutputActivation::rectified;
    if (rectifies) value = graph.node("Relu", {value}, place);
    if (k == last && network.output == OutputActivation::softplus) value = graph.node("Softplus", {value}, place);
  }
  return value;
}

/// From what a network gives to the statistic, as `from_network`, but for the last step: all ten are rectified at once.
std::string unscaled(Graph& graph, const OutputModel& output, std::string value) {
  const std::string& name = output.variable.name;
  value = graph.node("Mul", {value, graph.factor(name + "/scale", output.variable.scale)}, name + "/times_scale");
  value = graph.node("Add", {value, graph.constant(name + "/offset", output.variable.offset)}, name + "/plus_offset");
  if (output.log_reference > 0.0) {
    value = graph.node("Exp", {value}, name + "/exponential");
    value = graph.node("Sub", {value, graph.constant(name + "/one", 1.0)}, name + "/exponential_minus_one");
    value = graph.node("Mul", {value, graph.factor(name + "/log_reference", output.log_reference)},
                       name + "/times_log_reference");
  }
  return value;
}

/// N rows of `columns` 32-bit numbers.
void describe(onnx::ValueInfoProto& value, const char* name, int columns, const char* meaning) {
  value.set_name(name);
  value.set_doc_string(meaning);
  onnx::TypeProto_Tensor& tensor = *value.mutable_type()->mutable_tensor_type();
  tensor.set_elem_type(onnx::TensorProto::FLOAT);
  tensor.mutable_shape()->add_dim()->set_dim_param("N");
  tensor.mutable_shape()->add_dim()->set_dim_value(columns);
}

/// Lists of one entry a column, separated by commas: any language splits them.
void add_metadata(onnx::ModelProto& file, const std::string& prefix, std::span<const Column> columns) {
  std::string names, units, lows, highs;
  const char* comma = "";
  for (const Column& column : columns) {
    names += comma + column.name;
    units += comma + column.unit;
    lows += fmt::format("{}{}", comma, column.low);
    highs += fmt::format("{}{}", comma, column.high);
    comma = ",";
  }
  for (const auto& [key, value] :
       {std::pair{"names", names}, std::pair{"units", units}, std::pair{"low", lows}, std::pair{"high", highs}}) {
    onnx::StringStringEntryProto& entry = *file.add_metadata_props();
    entry.set_key(prefix + "_" + key);
    entry.set_value(value);
  }
}

void add_metadata(onnx::ModelProto& file, const Model& model) {
  add_metadata(file, "conditions", condition_columns(model));
  add_metadata(file, "statistics", statistic_columns(model));
  for (const auto& [key, value] : {std::pair{"rock", model.rock}, std::pair{"data_file", model.provenance.data_file},
                                   std::pair{"data_fingerprint", model.provenance.data_fingerprint},
                                   std::pair{"trained_by", "bitrock " + model.provenance.bitrock_version}}) {
    onnx::StringStringEntryProto& entry = *file.add_metadata_props();
    entry.set_key(key);
    entry.set_value(value);
  }
}

}  // namespace

std::string onnx_file(const Model& model) {
  onnx::ModelProto file;
  file.set_ir_version(file_version);
  file.set_producer_name("bitrock");
  file.set_producer_version(base::version);
  file.set_doc_string(
      "peak statistics of the force on one cutter in one rock; forces per metre of thickness out of "
      "the plane of cutting, peaks per metre of cut; names, units and training range in the metadata");
  onnx::OperatorSetIdProto& operators = *file.add_opset_import();
  operators.set_domain("");
  operators.set_version(operator_set);
  add_metadata(file, model);

  onnx::GraphProto& described = *file.mutable_graph();
  described.set_name("bitrock");
  describe(*described.add_input(), "conditions", input_count, "cutter speed [m/s], depth of cut [m], back rake [rad]");
  describe(
      *described.add_output(), "statistics", static_cast<int>(model.outputs.size()),
      has_moments(model)
          ? "amax, amean [N/m], np1, np23, np4 [1/m] in the cutting direction x, then the same in the axial direction "
            "y; then mean and standard deviation of x and of y [N/m], correlation length [m], correlation [1]"
          : "amax, amean [N/m], np1, np23, np4 [1/m] in the cutting direction x, then the same in the axial direction "
            "y");
  Graph graph(described);
  const std::string scaled = scaled_conditions(graph, model);
  std::vector<std::string> columns;
  for (const OutputModel& output : model.outputs) {
    const std::string given = network_nodes(graph, output.network, output.variable.name, scaled);
    columns.push_back(unscaled(graph, output, given));
  }
  const std::string together = graph.node("Concat", columns, "together");
  graph.attribute("axis", 1);
  graph.node("Relu", {together}, "statistics");

  onnx::checker::check_model(file);
  return file.SerializeAsString();
}

}  // namespace bitrock::surrogate
