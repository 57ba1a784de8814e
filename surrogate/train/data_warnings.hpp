#pragma once
/// What is odd about training data although each number may be as it is: copied rows, conditions under two numbers,
/// counts that do not fit the amplitudes, inputs and outputs that teach nothing. What cannot be at all is refused by
/// the reader (`data.hpp`).

#include <span>
#include <string>
#include <vector>

#include "surrogate/train/data.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/train.hpp"

namespace bitrock::surrogate {

/// Of data for any use. One sentence a kind, with the first places.
std::vector<std::string> warnings(const TrainingData& data);

/// Of data that networks are to learn from: inputs and outputs that are the same in all rows, and fewer cases than a
/// network that begins from random numbers has parameters: it may meet each case and be anywhere between them.
std::vector<std::string> learning_warnings(const TrainingData& data, const TrainOptions& options);

/// Throws `base::InputError` when no input varies over the rows: then every network could only learn one number, and
/// most random starts give none.
void require_varied_inputs(std::span<const TrainingRow> train_rows, std::span<const LearntFurther> further,
                           const std::string& file);

}  // namespace bitrock::surrogate
