#pragma once
/// Network against DEM: for each output and case the DEM's mean over seeds, its own standard error, and the prediction;
/// then the deviations in numbers. The DEM's scatter stands beside the network's error on purpose: no network can be
/// expected to come closer to the data than the data come to themselves. Draws nothing (report/) and learns nothing.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"

namespace surrogate {

/// unseen: the model's training knew no case of this number.
enum class CaseRole { train, validation, test, unseen };

/// One case of one output, in the output's unit (counts per metre of cut).
struct ParityPoint {
  int case_number = 0;
  CaseRole role = CaseRole::unseen;
  int cuts = 0;                       ///< averaged
  double dem_mean = 0.0;              ///< mean over these cuts
  double dem_standard_error = 0.0;    ///< of that mean; 0 when not known
  bool standard_error_known = false;  ///< two cuts or more
  double prediction = 0.0;
};

/// Deviation d = prediction - DEM mean, over the cases of one role. What cannot be said (no cases, a DEM mean of zero
/// everywhere, one seed, no spread) is absent, never zero or not-a-number.
struct ParitySummary {
  int cases = 0;
  int zero_cases = 0;                        ///< DEM mean 0: left out of the deviations relative to it
  std::optional<double> mean_deviation;      ///< [1] mean |d| / DEM mean
  std::optional<double> max_deviation;       ///< [1] max |d| / DEM mean
  std::optional<double> mean_bias;           ///< [1] mean d / DEM mean, with sign
  std::optional<double> mean_of_range;       ///< [1] mean |d| / (largest - smallest DEM mean of all cases)
  std::optional<double> max_of_range;        ///< [1] max |d| / the same
  std::optional<double> rmse;                ///< sqrt(mean d^2), unit of the output
  std::optional<double> r2;                  ///< [1] 1 - sum d^2 / sum (DEM mean - mean of these)^2
  std::optional<double> dem_standard_error;  ///< root mean square over the cases where it is known, unit of the output
};

struct OutputParity {
  std::string name;  ///< as in `output_names`
  std::string unit;
  std::vector<ParityPoint> points;  ///< in the order of the data
  ParitySummary all, train, test;
};

struct Parity {
  bool same_data = false;  ///< the data are, byte for byte, those of the training; otherwise roles rest on case numbers
  std::array<OutputParity, output_count> outputs;
};

Parity parity(const Model& model, const TrainingData& data);

}  // namespace surrogate
