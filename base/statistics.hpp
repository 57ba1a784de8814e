#pragma once
/// Mean, scatter and standard error of a small sample. Sums run in the order given.

#include <span>

namespace bitrock::base {

struct Summary {
  int count = 0;                    ///< of the values
  double mean = 0.0;                ///< in the unit of the values
  double standard_deviation = 0.0;  ///< with n - 1; 0 when fewer than two values
  double standard_error = 0.0;      ///< standard deviation of the mean, sd / sqrt(n)
};

/// Of these values; all 0 without any.
Summary summarise(std::span<const double> values);

}  // namespace bitrock::base
