#pragma once
/// The force model of one cutter in one rock: small networks with the names, units, training range and scaling of
/// what goes in and comes out. `predict` answers, for one set of cutting conditions, the five peak statistics of the
/// force in the cutting direction x and in the axial direction y [BitRock2026, sec. 3.2]; a model of seventeen networks
/// also means, standard deviations, correlation length and correlation of the two, which are ours. It does not rebuild
/// force histories (runtime/), does not learn (surrogate/train/), and reading and writing are in `model_file.hpp`.

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "peaks/rates.hpp"
#include "surrogate/net/network.hpp"

namespace bitrock::surrogate {

/// One input or output. In the unit of the file, because a model file is a door: scaled = (value - offset) / scale.
struct Variable {
  std::string name;     ///< of `input_names` or `output_names`, ends in its unit
  std::string unit;     ///< as in the name
  double low = 0.0;     ///< smallest value seen in training, in `unit`
  double high = 0.0;    ///< largest value seen in training, in `unit`
  double offset = 0.0;  ///< in `unit`
  double scale = 1.0;   ///< in `unit`, above 0
};

/// The errors of one output after an epoch.
struct LearningPoint {
  int epoch = 0;                ///< 1 is after the first pass through the training rows
  double train_mse = 0.0;       ///< mean squared error over all training rows, scaled units, weighted as in training
  double validation_mse = 0.0;  ///< the same over the validation rows; 0 when there are none
  double test_mse = 0.0;        ///< the same over the test rows
};

/// One output: its scaling, its network, how it was learnt.
///
/// **Equation** the network gives (t(y) - offset) / scale, where t(y) = y, or t(y) = ln(1 + y / y_0) when log_reference
/// y_0 is above 0. **Symbols** y the output in its unit, y_0 in that unit. The logarithm makes equal errors of the
/// network equal shares of the output.
struct OutputModel {
  Variable variable;           ///< offset and scale are in its unit, or dimensionless with a log_reference
  double log_reference = 0.0;  ///< y_0, in the unit of the variable; 0: the network gives the value itself
  Network network;             ///< in scaled units
  int restarts = 0;            ///< dead networks drawn or trained before this one
  int best_epoch = 0;          ///< the epoch whose parameters were kept
  std::vector<LearningPoint> learning_curve;  ///< at most 200 points, the last epoch among them
};

/// What the network should give for a value of the output.
double to_network(const OutputModel& output, double value);

/// The output for what the network gives; never negative, because amplitudes and counts are not.
double from_network(const OutputModel& output, double given);

/// A further input (further_inputs.hpp) and the value it is held at.
struct HeldInput {
  std::string name;    ///< ends in its unit
  double value = 0.0;  ///< in the unit of the name
};

/// One of several tables that networks learnt from together.
struct DataPart {
  std::string file;         ///< name without folder
  std::string fingerprint;  ///< of the file
  int first_case = 0;       ///< added to the case numbers of the file, so that those of all parts differ
};

/// How the peaks of a table were counted, where it says so (peaks/definition.hpp). Counts of two ways do not mix.
struct PeakCounting {
  double smoothing_um = 0.0;     ///< length of the moving mean, applied twice
  double min_prominence = 0.0;   ///< share of the highest sample [1]
  double min_distance_mm = 0.0;  ///< from a higher peak
  double sampling_um = 0.0;      ///< without smoothing, where counts depend on it; 0 otherwise
};

/// Where a model comes from: enough to train it again to the same bits.
struct Provenance {
  std::string data_file;                 ///< file name without folder
  std::string data_fingerprint;          ///< `base::fingerprint_text` of the file
  std::vector<DataPart> data_parts;      ///< when it was several files; then the two above speak of all together
  std::optional<PeakCounting> counting;  ///< of the peaks; empty where the tables did not say
  double fluid_pressure_MPa = 0.0;       ///< of the mud under which all cuts were made; 0: without, or an input
  std::vector<HeldInput> held_inputs;    ///< further inputs of the model it was made from, and their values
  std::string initial_fingerprint;       ///< of the model file a warm start began from; empty: a random start
  std::uint64_t seed = 0;                ///< of initial weights and batch order
  std::uint64_t split_seed = 0;          ///< of the choice of test cases
  double split = 0.0;                    ///< fraction of the cases used for training
  bool shuffle = true;                   ///< false: file order, the last cases are the test set
  int epochs = 0;                        ///< that were allowed
  int batch = 0;                         ///< rows a step
  double learning_rate = 0.0;            ///< [1]
  double validation = 0.0;               ///< fraction of the training cases that say when to stop; 0: none
  int patience = 0;                      ///< epochs without a better validation error before the stop; 0: no stop
  int starts = 1;                        ///< trainings from different random starts, of which the best was kept
  int smoothing = 0;                     ///< epochs over which the parameters were averaged; 0: not at all
  bool averaged = true;                  ///< learnt from the mean over the cuts of a case, not from the single cuts
  bool weighted = false;                 ///< errors weighted by the scatter of the data
  int taught_terms = 0;                  ///< of the smooth formula that the networks learnt from; 0: from the cases
  std::vector<int> train_cases;          ///< ascending case numbers
  std::vector<int> validation_cases;     ///< ascending case numbers
  std::vector<int> test_cases;           ///< ascending case numbers
  std::string choice;                    ///< which kinds of network were compared and why this one; empty: not compared
  std::string bitrock_version;           ///< that trained it
};

/// Name and unit every model has at each place; `si_per_unit` turns file units into SI.
struct VariableName {
  std::string_view name;  ///< as in files
  std::string_view unit;  ///< of its values
  double si_per_unit;     ///< SI value = value * si_per_unit
};

/// Of the first three inputs of all networks, in order.
inline constexpr std::array<VariableName, input_count> input_names{{
    {"cutter_speed_m_per_s", "m/s", si_per_input_unit[0]},
    {"depth_of_cut_mm", "mm", si_per_input_unit[1]},
    {"back_rake_deg", "deg", si_per_input_unit[2]},
}};

/// x first, then y. Peak counts are per metre of cut, so that they do not depend on how long a cut was simulated.
/// Then, in models that have them: mean and standard deviation of each component over the travel; the lags at which
/// the autocorrelation over travel has fallen to 1/e and to 3/4, the means of both components; Pearson's correlation of
/// the two.
inline constexpr std::array<VariableName, most_outputs> output_names{{
    {"x_amax_N_per_m", "N/m", 1.0},
    {"x_amean_N_per_m", "N/m", 1.0},
    {"x_np1_per_m", "1/m", 1.0},
    {"x_np23_per_m", "1/m", 1.0},
    {"x_np4_per_m", "1/m", 1.0},
    {"y_amax_N_per_m", "N/m", 1.0},
    {"y_amean_N_per_m", "N/m", 1.0},
    {"y_np1_per_m", "1/m", 1.0},
    {"y_np23_per_m", "1/m", 1.0},
    {"y_np4_per_m", "1/m", 1.0},
    {"x_mean_N_per_m", "N/m", 1.0},
    {"x_sd_N_per_m", "N/m", 1.0},
    {"y_mean_N_per_m", "N/m", 1.0},
    {"y_sd_N_per_m", "N/m", 1.0},
    {"correlation_length_m", "m", 1.0},
    {"short_correlation_length_m", "m", 1.0},
    {"xy_correlation", "1", 1.0},
}};

/// Of peaks per metre; false: an amplitude.
inline bool is_count(std::size_t output) {
  return output_names[output].unit == "1/m";
}

/// The networks of one rock, and all that is needed to ask them.
struct Model {
  /// In the order of `input_names`, then further ones (further_inputs.hpp); 3 to `most_inputs`.
  std::vector<Variable> inputs{std::vector<Variable>(input_count)};
  /// Ten or seventeen, in the order of `output_names`.
  std::vector<OutputModel> outputs{std::vector<OutputModel>(article_output_count)};
  std::string rock;       ///< which rock, for people
  Provenance provenance;  ///< where it comes from
};

/// It has the seven outputs behind the article's ten.
inline bool has_moments(const Model& model) {
  return model.outputs.size() == most_outputs;
}

/// One number for each output of a model, in the order of `output_names`. Takes no memory.
struct OutputValues {
  std::array<double, most_outputs> items{};  ///< those beyond `count` are 0
  std::size_t count = article_output_count;  ///< or `most_outputs`

  std::size_t size() const { return count; }                                 ///< as a container has it
  double* begin() { return items.data(); }                                   ///< first output
  double* end() { return items.data() + count; }                             ///< behind the last output that counts
  const double* begin() const { return items.data(); }                       ///< first output
  const double* end() const { return items.data() + count; }                 ///< behind the last output that counts
  double& operator[](std::size_t i) { return items.data()[i]; }              ///< not checked
  const double& operator[](std::size_t i) const { return items.data()[i]; }  ///< not checked
  void fill(double value) { std::fill(begin(), end(), value); }              ///< those that count
  bool operator==(const OutputValues&) const = default;                      ///< all of `items` too
  /// Any order will do: for what is kept sorted.
  bool operator<(const OutputValues& other) const { return items < other.items; }
};

/// Forces are per metre of thickness out of the plane of cutting.
struct Prediction {
  peaks::PeakRates x;                          ///< cutting direction
  peaks::PeakRates y;                          ///< axial direction, out of the rock
  std::array<double, moment_count> moments{};  ///< the seven outputs behind the ten, where the model has them
  bool has_moments = false;                    ///< whether the model has them
  bool inside_training_range = false;          ///< for these conditions
};

/// The ten or seventeen numbers in the order of `output_names`.
OutputValues listed(const Prediction& prediction);

/// `further`: values of the inputs behind the first three, in their units and in the order of the model, one each.
/// Takes no memory, does not throw, does not clamp: outside the training range it extrapolates and says so.
/// Not-a-number in gives not-a-number out, flagged as outside. The model must come from `read_model` or `train`: its
/// shapes are not checked again.
Prediction predict(const Model& model, const CutConditions& conditions, std::span<const double> further = {});

/// Of `evaluation.hpp`, for one input.
Bounds widened_range(const Variable& input);

/// The nearest conditions inside the training box. What lies inside, or outside by no more than the rounding of a unit
/// conversion (1e-9 of the bound), comes back unchanged.
CutConditions clamped_to_training_range(const Model& model, CutConditions conditions);

}  // namespace bitrock::surrogate
