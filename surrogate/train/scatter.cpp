#include "surrogate/train/scatter.hpp"

#include <cmath>

namespace bitrock::surrogate {

namespace {

/// var(y) / phi.
double shape(std::size_t output, double value, double cut_length) {
  return is_count(output) ? value / cut_length : value * value;
}

}  // namespace

ScatterLaw scatter_law(std::span<const TrainingRow> means) {
  ScatterLaw law;
  for (const TrainingRow& row : means) {
    if (row.standard_errors) law.degrees_of_freedom += row.cuts - 1;
  }
  if (!means.empty()) law.phi.count = means.front().outputs.count;
  for (std::size_t i = 0; i < law.phi.size(); ++i) {
    double seen = 0.0, of_shape = 0.0;
    for (const TrainingRow& row : means) {
      if (!row.standard_errors) continue;
      const double error = (*row.standard_errors)[i];
      seen += (row.cuts - 1) * row.cuts * error * error;
      of_shape += (row.cuts - 1) * shape(i, row.outputs[i], row.cut_length);
    }
    law.phi[i] = of_shape > 0.0 ? seen / of_shape : 0.0;
  }
  return law;
}

double standard_error(const ScatterLaw& law, std::size_t output, double value, double cut_length, int cuts) {
  return std::sqrt(law.phi[output] * shape(output, value, cut_length) / cuts);
}

}  // namespace bitrock::surrogate
