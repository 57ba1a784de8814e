#pragma once
/// Mean, scatter and standard error of a small sample. Sums run in the order given.

#include <span>

namespace bitrock::base {

struct Summary {
  int count = 0;
  double mean = 0.0;
  double standard_deviation = 0.0;  ///< with n - 1; 0 when fewer than two values
  double standard_error = 0.0;      ///< standard deviation of the mean, sd / sqrt(n)
};

Summary summarise(std::span<const double> values);

}  // namespace bitrock::base
