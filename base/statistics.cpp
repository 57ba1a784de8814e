#include "base/statistics.hpp"

#include <cmath>

namespace bitrock::base {

Summary summarise(std::span<const double> values) {
  Summary summary;
  summary.count = static_cast<int>(values.size());
  if (values.empty()) return summary;
  double sum = 0.0;
  for (const double value : values) sum += value;
  summary.mean = sum / summary.count;
  if (summary.count < 2) return summary;
  double squares = 0.0;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.standard_deviation = std::sqrt(squares / (summary.count - 1));
  summary.standard_error = summary.standard_deviation / std::sqrt(static_cast<double>(summary.count));
  return summary;
}

}  // namespace bitrock::base
