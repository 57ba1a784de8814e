#include "surrogate/export/c_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "surrogate/export/columns.hpp"
#include "surrogate/export/source_text.hpp"
#include "surrogate/net/layers.hpp"

namespace bitrock::surrogate {

namespace {

/// With "_predict" 31 characters, of which C99 promises to tell names apart that other files see.
constexpr std::size_t longest_prefix = 23;

constexpr std::string_view what_it_does = R"c( *
 * One condition a call: 3 numbers in, OUTPUTS out, whatever else the arrays hold. For many, call it once for each, with
 * conditions + 3 i and statistics + OUTPUTS i.
 *
 * It answers 1 inside the training range of the conditions, and 0 outside, where it extrapolates. Not-a-number in
 * gives not-a-number out. x is the cutting direction, along the rock surface; y is the axial direction, out of the
 * rock. Forces are those of the rock on the cutter for each metre of thickness out of the plane of cutting; peaks are
 * counted per metre of cut.
 *
 * C99, and C++ as well; link the mathematics library (-lm). No memory is taken and no state kept: it may be called
 * from a real-time loop and from several threads. Compiled without fused multiply-add (gcc and clang:
 * -ffp-contract=off, which gcc's -std=c99 implies) and with the same mathematics library, the bits are those of
 * `bitrock predict`. Not for -ffast-math. A program to try it:
 *
 *   cc -std=c99 -DBITROCK_MAIN FILE.c -lm && echo "1 0.002 0.26" | ./a.out
 *
)c";

constexpr std::string_view declarations = R"c( */
#include <math.h>

#ifdef __cplusplus
extern "C" {
#endif
int PREFIX_predict(const double conditions[3], double statistics[OUTPUTS]);
#ifdef __cplusplus
}
#endif

)c";

constexpr std::string_view types = R"c(
enum { PREFIX_rectified, PREFIX_softplus, PREFIX_linear }; /* what the last layer does */

/* Layer k = 1..K maps n[k-1] numbers to n[k]: each starts at its bias and adds its row of weights in order; negative
 * sums become 0, except on the last layer. value = offset + scale * (what the network gives), and with a
 * log_reference y0 above 0 the statistic is y0 (exp(value) - 1). */
typedef struct {
  const int* layers; /* n[0], ..., n[K] */
  int layer_count;   /* K + 1 */
  int activation;
  double log_reference;
  double offset;
  double scale;
  const double* parameters; /* for k = 1..K: weights row by row, then biases */
} PREFIX_network;

typedef struct {
  double si_per_unit; /* the networks have learnt in m/s, mm and degrees */
  double low, high;   /* training range, 1e-9 wider for the rounding of units */
  double offset, scale;
} PREFIX_input;

)c";

constexpr std::string_view functions = R"c(
static double PREFIX_not_negative(double z) {
  return z < 0.0 ? 0.0 : z; /* not-a-number stays what it is */
}

static double PREFIX_activated(int activation, double z) {
  if (activation == PREFIX_rectified) return PREFIX_not_negative(z);
  if (activation == PREFIX_softplus) return PREFIX_not_negative(z) + log1p(exp(-fabs(z)));
  return z;
}

static double PREFIX_forward(const PREFIX_network* network, const double scaled[3]) {
  double buffers[2][PREFIX_widest_layer] = {{0.0}, {0.0}};
  double* from = buffers[0];
  double* to = buffers[1];
  const double* weight = network->parameters;
  for (int i = 0; i < 3; ++i) from[i] = scaled[i];
  for (int k = 1; k < network->layer_count; ++k) {
    const int inputs = network->layers[k - 1];
    const int outputs = network->layers[k];
    const int last = k + 1 == network->layer_count;
    const double* bias = weight + outputs * inputs;
    double* const filled = to;
    for (int o = 0; o < outputs; ++o) {
      double z = bias[o];
      for (int i = 0; i < inputs; ++i) z += *weight++ * from[i];
      to[o] = PREFIX_activated(last ? network->activation : PREFIX_rectified, z);
    }
    weight = bias + outputs;
    to = from;
    from = filled;
  }
  return from[0];
}

int PREFIX_predict(const double conditions[3], double statistics[OUTPUTS]) {
  double scaled[3];
  int inside = 1;
  for (int i = 0; i < 3; ++i) {
    const PREFIX_input* input = &PREFIX_inputs[i];
    const double value = conditions[i] / input->si_per_unit;
    scaled[i] = (value - input->offset) / input->scale;
    if (!(value >= input->low && value <= input->high)) inside = 0;
  }
  for (int i = 0; i < OUTPUTS; ++i) {
    const PREFIX_network* network = &PREFIX_networks[i];
    double value = network->offset + network->scale * PREFIX_forward(network, scaled);
    if (network->log_reference > 0.0) value = network->log_reference * expm1(value);
    statistics[i] = PREFIX_not_negative(value);
  }
  return inside;
}

#ifdef BITROCK_MAIN
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The three numbers of a line, with nothing behind them; 0 when there is anything else. */
static int PREFIX_read(const char* line, double conditions[3]) {
  if (strchr(line, 'x') != NULL || strchr(line, 'X') != NULL) return 0; /* hexadecimal numbers */
  for (int i = 0; i < 3; ++i) {
    char* end = NULL;
    conditions[i] = strtod(line, &end);
    if (end == line || strchr(" \t\r\n", *end) == NULL) return 0;
    line = end;
  }
  return line[strspn(line, " \t\r\n")] == '\0';
}

/* Three conditions a line in; WORDS statistics, and 1 inside the training range or 0 outside, a line out. */
int main(void) {
  char line[512];
  double conditions[3], statistics[OUTPUTS];
  for (int number = 1; fgets(line, sizeof line, stdin) != NULL; ++number) {
    if (!PREFIX_read(line, conditions)) {
      fprintf(stderr, "line %d of the input: must be three numbers with blanks between them\n", number);
      return 2;
    }
    const int inside = PREFIX_predict(conditions, statistics);
    for (int i = 0; i < OUTPUTS; ++i) printf("%.17g ", statistics[i]);
    printf("%d\n", inside);
  }
  return 0;
}
#endif
)c";

std::string table(const char* name, std::span<const Column> columns) {
  std::string text;
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += fmt::format(" *   {}[{}]  {}\n", name, i, described(columns[i]));
  return text;
}

std::string head(const Model& model, std::string_view prefix) {
  return fmt::format(
             "/* Peak statistics of the force on one cutter in one rock: {}\n"
             " *\n"
             " *   int {}_predict(const double conditions[3], double statistics[OUTPUTS]);\n"
             " *\n",
             comment_text(model.rock), prefix) +
         table("conditions", condition_columns(model)) + table("statistics", statistic_columns(model)) +
         std::string(what_it_does) + origin(model, " * ");
}

/// Names for the places in the two arrays.
std::string places(const Model& model) {
  std::string text = "/* Places in conditions and in statistics; SI units. */\nenum {";
  const char* separator = "\n";
  const auto add = [&](const std::string& name) {
    text += fmt::format("{}  PREFIX_{}", separator, name);
    separator = ",\n";
  };
  for (const Column& column : condition_columns(model)) add(column.name);
  text += "\n};\nenum {";
  separator = "\n";
  for (const Column& column : statistic_columns(model)) add(column.name);
  return text + "\n};\n";
}

std::string row(std::span<const double> values) {
  std::string numbers;
  for (const double value : values) numbers += fmt::format(" {},", number_text(value));
  return fmt::format(" {}\n", numbers);
}

std::string network_arrays(const OutputModel& output) {
  const std::string& name = output.variable.name;
  std::string text =
      fmt::format("\nstatic const int PREFIX_{}_layers[] = {{{}}};\n", name, fmt::join(output.network.layers, ", "));
  text += fmt::format("static const double PREFIX_{}_parameters[] = {{\n", name);
  for (int k = 1; k < static_cast<int>(output.network.layers.size()); ++k) {
    const Layer seen = layer(output.network, k);
    const auto inputs = static_cast<std::size_t>(seen.weights.cols());
    const std::span weights(seen.weights.data(), static_cast<std::size_t>(seen.weights.size()));
    text += fmt::format("  /* layer {}: a row of weights for each of {} nodes, then the biases */\n", k,
                        seen.weights.rows());
    for (std::size_t first = 0; first < weights.size(); first += inputs) text += row(weights.subspan(first, inputs));
    text += row({seen.biases.data(), static_cast<std::size_t>(seen.biases.size())});
  }
  return text + "};\n";
}

std::string tables(const Model& model) {
  int widest = input_count;
  std::string text, rows;
  for (const OutputModel& output : model.outputs) {
    const Network& network = output.network;
    widest = std::max(widest, *std::max_element(network.layers.begin(), network.layers.end()));
    text += network_arrays(output);
    rows += fmt::format("  {{PREFIX_{0}_layers, {1}, PREFIX_{2}, {3}, {4}, {5}, PREFIX_{0}_parameters}},\n",
                        output.variable.name, network.layers.size(), name_of(network.output),
                        number_text(output.log_reference), number_text(output.variable.offset),
                        number_text(output.variable.scale));
  }
  text += "\nstatic const PREFIX_network PREFIX_networks[OUTPUTS] = {\n" + rows + "};\n";
  text += "\nstatic const PREFIX_input PREFIX_inputs[3] = {\n";
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Variable& input = model.inputs[i];
    const Bounds bounds = widened_range(input);
    text += fmt::format("  {{{}, {}, {}, {}, {}}},\n", number_text(input_names[i].si_per_unit), number_text(bounds.low),
                        number_text(bounds.high), number_text(input.offset), number_text(input.scale));
  }
  return fmt::format("enum {{ PREFIX_widest_layer = {} }};\n", widest) + text + "};\n";
}

}  // namespace

std::string c_source(const Model& model, std::string_view prefix) {
  require_identifier(prefix, "prefix", longest_prefix);
  const std::string code =
      std::string(declarations) + places(model) + std::string(types) + tables(model) + std::string(functions);
  const std::size_t outputs = model.outputs.size();
  std::string text = head(model, prefix) + replaced(code, "PREFIX", prefix);
  text = replaced(std::move(text), "OUTPUTS", fmt::format("{}", outputs));
  return replaced(std::move(text), "WORDS", outputs == most_outputs ? "seventeen" : "ten");
}

}  // namespace bitrock::surrogate
