#pragma once
/// The plainest models of the same data, as yardsticks for the networks: what a network does not do better than these,
/// it need not be a network for. Not part of any model file.
///
/// **Equation** y = h^p (c_0 + c_1 theta + c_2 theta^2), p = 1 for amplitudes, p = -1 for peaks per metre; the
/// coefficients by least squares. **Symbols** y output, h depth of cut [mm], theta back rake [rad].
/// **Source** forces of a sharp cutter grow as the area it cuts [DetournayDefourny1992]; chips of one size for each
/// depth come at a rate of one over the depth. **Validity** speed has no say.

#include <array>
#include <span>

#include "surrogate/train/data.hpp"

namespace bitrock::surrogate {

/// The formulas, fitted.
struct Baseline {
  std::array<std::array<double, 3>, most_outputs> coefficients{};  ///< c_0, c_1, c_2 of each output
  std::size_t outputs = article_output_count;  ///< those that the rows have; coefficients beyond are 0
};

/// With rows of one or two back rakes the smallest coefficients of all that fit are taken.
Baseline fit_baseline(std::span<const TrainingRow> rows);

/// Never negative.
Outputs predict(const Baseline& baseline, const TrainingRow& conditions);

}  // namespace bitrock::surrogate
