#pragma once
/// How far questions lie outside what the networks have learnt, in words for people.

#include <array>
#include <string>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// How far the farther of two values in the unit of the input lies outside its training range, over the width of that
/// range [1]; 0 inside. Infinite for a range without width.
double beyond_range(const Variable& input, double low, double high);

/// "depth_of_cut_mm 0.1 (trained 0.5 to 4: 11 % of that range below it)" for the values from `low` to `high` that were
/// asked; empty inside.
std::string beyond_range_in_words(const Variable& input, double low, double high);

/// What was asked of one input, in its unit.
struct AskedRange {
  double low = 0.0, high = 0.0;  ///< least and greatest value that was asked
};
using AskedRanges = std::array<AskedRange, input_count>;  ///< in the order of the inputs

/// The same of all inputs of a model, one behind the other; empty when all are inside.
std::string beyond_ranges_in_words(const Model& model, const AskedRanges& asked);

/// Throws `base::InputError` beginning with `source` when an answer, or its numbers of peaks in a cut of this length
/// [m], are not finite.
void require_finite(const Prediction& prediction, double cut_length, const std::string& source);

}  // namespace bitrock::surrogate
