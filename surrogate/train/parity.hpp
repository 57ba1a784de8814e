#pragma once
/// Network against DEM: for each output and case the DEM's mean over seeds, its own standard error, and the prediction;
/// then the deviations in numbers, beside what the scatter of the DEM alone would make of them. No network can be
/// expected to come closer to the data than the data come to themselves; `noise_floor.hpp` has the statistics and the
/// meaning of a verdict. Draws nothing (report/) and learns nothing.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "surrogate/net/model.hpp"
#include "surrogate/train/data.hpp"
#include "surrogate/train/network_error.hpp"
#include "surrogate/train/noise_floor.hpp"

namespace bitrock::surrogate {

/// What a case was to the training of the model.
enum class CaseRole {
  train,       ///< the networks learnt from it
  validation,  ///< it said when to stop
  test,        ///< held out, to judge the networks
  unseen       ///< the training knew no such case
};

/// Test and unseen cases: only they show what the network can do.
inline bool is_held_out(CaseRole role) {
  return role == CaseRole::test || role == CaseRole::unseen;
}

/// One case of one output, in the output's unit (counts per metre of cut).
struct ParityPoint {
  int case_number = 0;                       ///< one speed, depth and rake
  CaseRole role = CaseRole::unseen;          ///< what it was to the training
  std::array<double, input_count> inputs{};  ///< in the units of `input_names`
  std::vector<double> further{};             ///< of the model's inputs behind these, in their units
  int cuts = 0;                              ///< averaged
  double dem_mean = 0.0;                     ///< mean over these cuts
  double dem_standard_error = 0.0;           ///< of that mean, as seen; 0 when not known
  bool standard_error_known = false;         ///< two cuts or more
  double noise = 0.0;              ///< s_i, its standard error by the law of scatter, at the DEM mean; 0 when not known
  double prediction = 0.0;         ///< of the network
  double noise_half_way = 0.0;     ///< the same half-way between DEM mean and prediction
  std::optional<double> residual;  ///< r_i of `noise_floor.hpp` [1]
};

/// |d| that the scatter of the data alone would give.
struct NoiseAlone {
  double mean = 0.0;      ///< expected mean
  double max = 0.0;       ///< expected maximum
  double high_max = 0.0;  ///< 95 % of all maxima are below
};

/// Deviation d = prediction - DEM mean, over the cases of one role. What cannot be said (no cases, a DEM mean of zero
/// everywhere, one seed, no spread) is absent, never zero or not-a-number.
struct ParitySummary {
  int cases = 0;                             ///< in all
  int zero_cases = 0;                        ///< DEM mean 0: left out of the deviations relative to it
  std::optional<double> mean_deviation;      ///< [1] mean |d| / DEM mean
  std::optional<double> max_deviation;       ///< [1] max |d| / DEM mean
  std::optional<NoiseAlone> noise_alone;     ///< [1] |d| / DEM mean
  std::optional<double> mean_bias;           ///< [1] mean d / DEM mean, with sign
  std::optional<double> mean_of_range;       ///< [1] mean |d| / (largest - smallest DEM mean of all cases)
  std::optional<double> max_of_range;        ///< [1] max |d| / the same
  std::optional<NoiseAlone> noise_of_range;  ///< [1] |d| / the same
  std::optional<double> rmse;                ///< sqrt(mean d^2), unit of the output
  std::optional<double> r2;                  ///< [1] 1 - sum d^2 / sum (DEM mean - mean of these)^2
  std::optional<double> dem_standard_error;  ///< root mean square over the cases where it is known, unit of the output
  std::optional<double> noise;               ///< root mean square of s_i, unit of the output
  std::optional<double> rmse_over_noise;     ///< [1]
};

/// One network against the data.
struct OutputParity {
  std::string name;                                ///< as in `output_names`
  std::string unit;                                ///< of the output
  std::vector<ParityPoint> points;                 ///< in the order of the data
  ParitySummary all, train, validation, held_out;  ///< over the cases of each role
  NoiseVerdict judged;                             ///< on held-out cases, or on all when there are none
  std::optional<NetworkError> error;               ///< on held-out cases; absent when there are none
};

/// A comparison of a model with data.
struct Parity {
  /// The data are, byte for byte, those of the training, or one of its tables; otherwise roles rest on case numbers.
  bool same_data = false;
  bool has_held_out = false;            ///< verdicts rest on held-out cases
  int law_degrees = 0;                  ///< degrees of freedom of the law of scatter
  bool scatter_around_formula = false;  ///< no case was cut twice: the law is that of single cuts around a formula
  int outside_training_range = 0;       ///< held-out cases where the networks extrapolate
  std::vector<Variable> inputs;         ///< of the model: speed, depth, rake, further ones
  std::vector<OutputParity> outputs;    ///< what both model and data have: ten or seventeen
};

/// How the cases of the data are told from those of the training.
enum class CaseNumbers {
  as_in_training,   ///< the same number is the same case
  of_another_study  ///< they have nothing to do with each other: all cases are unseen
};

/// Throws `base::InputError` when the model has no finite answer for a case.
Parity parity(const Model& model, const TrainingData& data, CaseNumbers numbers = CaseNumbers::as_in_training);

/// What to think of when reading the comparison with these data: cases that may be others, cases outside the training
/// range, no scatter.
std::vector<std::string> warnings(const Parity& parity, const TrainingData& data, CaseNumbers numbers);

}  // namespace bitrock::surrogate
