#pragma once
/// How far a network itself is off, as a share of what it says, with the scatter of the data taken out.

#include <optional>
#include <span>

namespace bitrock::surrogate {

/// One case that the network has not learnt from.
struct JudgedCase {
  double prediction = 0.0;      ///< p of the network, above 0
  double dem_mean = 0.0;        ///< y, in the same unit
  double standard_error = 0.0;  ///< s of that mean, 0 or more
};

/// Shares of what the network says [1].
struct NetworkError {
  double rms = 0.0;          ///< e: expected error at such a case
  double rms_high = 0.0;     ///< upper end of the 95 % interval of e: below it in 97.5 % of all data sets, or more
  double bias = 0.0;         ///< b: above 0 where the network says too much
  double bias_chance = 0.0;  ///< of b by scatter alone: within so much of either side in 95 % of all data sets
};

/// **What** Error and bias of a network over n cases.
/// **Equation** e^2 = max(0, mean of ((p - y) / p)^2 - q), q = mean of (s / p)^2; b = mean of (p - y) / p; chance
/// 1.96 sqrt(q / n). Upper end: e_h^2 = q (k_h^2 - 1), k_h that of k = sqrt(mean of ((p - y) / p)^2 / q) as in
/// `noise_floor.hpp`. Where k is below 1 by chance, the upper end is that of k = 1: fewer cases cannot show more.
/// **Symbols** p, y, s: `JudgedCase`; `law_degrees` [1] of the law that gave s.
/// **Source** y = true value + noise of variance s^2, independent of p; derived here.
/// **Differences and validity** Shares of p, not of y as the deviations of `parity.hpp`: y scatters itself, and where s
/// is a third of it (counts of few peaks) (p - y) / y is 10 % too high on the average. Only for cases not learnt from.
/// Absent for fewer than two cases with p above 0, and where no scatter is known.
std::optional<NetworkError> network_error(std::span<const JudgedCase> cases, double law_degrees);

}  // namespace bitrock::surrogate
