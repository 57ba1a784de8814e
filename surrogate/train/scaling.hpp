#pragma once
/// Names, training range and scaling of inputs and outputs, taken from the training rows alone: the test rows must not
/// lend the networks anything, not even their range.
///
/// **Equation** inputs: scaled = (value - low) / (high - low), in [0, 1] on the training rows;
/// outputs: scaled = value / high, so that zero stays zero and the scaled output, never negative, fits a rectified
/// unit; with a log reference y_0 the same of ln(1 + value / y_0). A column that does not vary (inputs) or is all
/// zero (outputs) gets scale 1.
/// **Source** [BitRock2026, sec. 3.2] says only that the data were scaled.

#include <span>
#include <string>
#include <vector>

#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"

namespace bitrock::surrogate {

/// Whether its range is wider than the rounding of its numbers.
bool varies(const Variable& input);

/// A further input that is learnt from.
struct LearntFurther {
  std::string name;       ///< of its column
  std::size_t place = 0;  ///< in `TrainingRow::further`
};

/// Those of the data that vary, in the order of the data.
std::vector<LearntFurther> learnt_further(const TrainingData& data);

/// Those that the model has. Throws `base::InputError` when the data lack one (a pressure they never lack).
std::vector<LearntFurther> learnt_further(const Model& model, const TrainingData& data);

/// Speed, depth and rake, then these; with `output_scaling` it needs at least one row.
std::vector<Variable> input_variables(std::span<const TrainingRow> train_rows,
                                      std::span<const LearntFurther> further = {});

/// The values of a row for these, as `predict` wants them.
std::vector<double> further_values(const TrainingRow& row, std::span<const LearntFurther> further);

/// Output number `output` without its network; `log_targets` chooses y_0, the smallest positive value.
OutputModel output_scaling(std::span<const TrainingRow> train_rows, std::size_t output, bool log_targets);

/// For a warm start: names and scaling of `kept`, range widened to hold `seen` too.
Variable with_wider_range(Variable kept, const Variable& seen);

/// Of a value in the unit of the variable.
inline double scaled(const Variable& variable, double value) {
  return (value - variable.offset) / variable.scale;
}

}  // namespace bitrock::surrogate
