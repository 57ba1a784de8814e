#include "surrogate/train/parity.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "surrogate/train/split.hpp"

namespace surrogate {

namespace {

CaseRole role_of(const Model& model, int case_number) {
  if (contains(model.provenance.train_cases, case_number)) return CaseRole::train;
  if (contains(model.provenance.validation_cases, case_number)) return CaseRole::validation;
  return contains(model.provenance.test_cases, case_number) ? CaseRole::test : CaseRole::unseen;
}

ParityPoint parity_point(const Model& model, const TrainingRow& mean, double prediction, std::size_t output) {
  return {.case_number = mean.case_number,
          .role = role_of(model, mean.case_number),
          .cuts = mean.cuts,
          .dem_mean = mean.outputs[output],
          .dem_standard_error = mean.standard_errors ? (*mean.standard_errors)[output] : 0.0,
          .standard_error_known = mean.standard_errors.has_value(),
          .prediction = prediction};
}

/// Running mean and largest value of numbers that may turn out to be none.
struct Collected {
  int count = 0;
  double sum = 0.0;
  double largest = 0.0;  // of values that are never negative

  void add(double value) {
    ++count;
    sum += value;
    largest = std::max(largest, value);
  }
  std::optional<double> mean() const { return count > 0 ? std::optional(sum / count) : std::nullopt; }
  std::optional<double> max() const { return count > 0 ? std::optional(largest) : std::nullopt; }
};

std::optional<double> root(std::optional<double> mean_square) {
  return mean_square ? std::optional(std::sqrt(*mean_square)) : std::nullopt;
}

ParitySummary summary_of(std::span<const ParityPoint> points, double range) {
  Collected dem, relative, bias, of_range, squares, error_squares, spread;
  for (const ParityPoint& point : points) {
    const double deviation = point.prediction - point.dem_mean;
    dem.add(point.dem_mean);
    squares.add(deviation * deviation);
    if (point.dem_mean > 0.0) {
      relative.add(std::abs(deviation) / point.dem_mean);
      bias.add(deviation / point.dem_mean);
    }
    if (range > 0.0) of_range.add(std::abs(deviation) / range);
    if (point.standard_error_known) error_squares.add(point.dem_standard_error * point.dem_standard_error);
  }
  bool all_equal = true;
  for (const ParityPoint& point : points) {
    const double from_mean = point.dem_mean - *dem.mean();
    spread.add(from_mean * from_mean);
    all_equal = all_equal && point.dem_mean == points.front().dem_mean;
  }
  ParitySummary summary{.cases = dem.count,
                        .zero_cases = dem.count - relative.count,
                        .mean_deviation = relative.mean(),
                        .max_deviation = relative.max(),
                        .mean_bias = bias.mean(),
                        .mean_of_range = of_range.mean(),
                        .max_of_range = of_range.max(),
                        .rmse = root(squares.mean()),
                        .r2 = std::nullopt,
                        .dem_standard_error = root(error_squares.mean())};
  if (!all_equal) summary.r2 = 1.0 - squares.sum / spread.sum;
  return summary;
}

ParitySummary summary_of_role(const std::vector<ParityPoint>& points, CaseRole role, double range) {
  std::vector<ParityPoint> chosen;
  std::copy_if(points.begin(), points.end(), std::back_inserter(chosen),
               [role](const ParityPoint& point) { return point.role == role; });
  return summary_of(chosen, range);
}

}  // namespace

Parity parity(const Model& model, const TrainingData& data) {
  Parity result;
  result.same_data = data.fingerprint == model.provenance.data_fingerprint;
  for (const TrainingRow& mean : averaged(data).rows) {
    const auto predictions = listed(predict(model, conditions_of(mean)));
    for (std::size_t i = 0; i < output_count; ++i) {
      result.outputs[i].points.push_back(parity_point(model, mean, predictions[i], i));
    }
  }
  for (std::size_t i = 0; i < output_count; ++i) {
    OutputParity& output = result.outputs[i];
    output.name = output_names[i].name;
    output.unit = output_names[i].unit;
    const auto by_mean = [](const ParityPoint& a, const ParityPoint& b) { return a.dem_mean < b.dem_mean; };
    const auto [low, high] = std::minmax_element(output.points.begin(), output.points.end(), by_mean);
    const double range = high->dem_mean - low->dem_mean;
    output.all = summary_of(output.points, range);
    output.train = summary_of_role(output.points, CaseRole::train, range);
    output.test = summary_of_role(output.points, CaseRole::test, range);
  }
  return result;
}

}  // namespace surrogate
