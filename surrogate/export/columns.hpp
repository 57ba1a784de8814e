#pragma once
/// The columns of an exported model, in SI: bitrock's own files carry the units of the field (mm, degrees), but a model
/// that lives in somebody's simulation is fed by that simulation. Three conditions in, ten or seventeen statistics out,
/// in the order of `input_names` and `output_names`. Forces are per metre of thickness out of the plane of cutting,
/// peaks per metre of cut.

#include <array>
#include <string>
#include <vector>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// One input or output, in SI.
struct Column {
  std::string name;     ///< ends in its unit
  std::string unit;     ///< "m/s", "m", "rad", "N/m", "1/m"
  std::string meaning;  ///< a few words
  double low = 0.0;     ///< smallest value seen in training, in `unit`
  double high = 0.0;    ///< largest value seen in training, in `unit`
};

/// In SI, in the order of the arguments.
std::array<Column, input_count> condition_columns(const Model& model);
/// In SI, in the order of the results.
std::vector<Column> statistic_columns(const Model& model);

}  // namespace bitrock::surrogate
