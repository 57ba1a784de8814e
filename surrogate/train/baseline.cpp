#include "surrogate/train/baseline.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace bitrock::surrogate {

namespace {

/// The three functions of the conditions that are added up.
Eigen::Vector3d terms(std::size_t output, const TrainingRow& row) {
  const double depth = row.inputs[1], rake = row.inputs[2] * radians_per_degree;
  const double size = output_names[output].unit == "1" ? 1.0 : is_count(output) ? 1.0 / depth : depth;
  return size * Eigen::Vector3d(1.0, rake, rake * rake);
}

}  // namespace

Baseline fit_baseline(std::span<const TrainingRow> rows) {
  Baseline baseline;
  const auto count = static_cast<Eigen::Index>(rows.size());
  if (!rows.empty()) baseline.outputs = rows.front().outputs.size();
  for (std::size_t i = 0; i < baseline.outputs; ++i) {
    Eigen::MatrixXd left(count, 3);
    Eigen::VectorXd right(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      const TrainingRow& row = rows[static_cast<std::size_t>(r)];
      left.row(r) = terms(i, row);
      right(r) = row.outputs[i];
    }
    const Eigen::Vector3d solution = left.completeOrthogonalDecomposition().solve(right);
    std::copy_n(solution.data(), 3, baseline.coefficients[i].begin());
  }
  return baseline;
}

Outputs predict(const Baseline& baseline, const TrainingRow& conditions) {
  Outputs outputs{.count = baseline.outputs};
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    outputs[i] = std::max(0.0, Eigen::Vector3d(baseline.coefficients[i].data()).dot(terms(i, conditions)));
  }
  return outputs;
}

}  // namespace bitrock::surrogate
