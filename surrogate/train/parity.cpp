#include "surrogate/train/parity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "base/errors.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/scatter.hpp"
#include "surrogate/train/smooth_formula.hpp"
#include "surrogate/train/split.hpp"

namespace bitrock::surrogate {

namespace {

/// The part of what the model learnt from that these data are, byte for byte.
const DataPart* part_of(const Model& model, const TrainingData& data) {
  const std::vector<DataPart>& parts = model.provenance.data_parts;
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const DataPart& part) { return part.fingerprint == data.fingerprint; });
  return found == parts.end() ? nullptr : &*found;
}

/// `number` is that of the training, which may be no int: a model file can add any `first_case` to it.
CaseRole role_of(const Model& model, std::int64_t number, CaseNumbers numbers) {
  if (numbers == CaseNumbers::of_another_study || number > std::numeric_limits<int>::max()) return CaseRole::unseen;
  const int case_number = static_cast<int>(number);
  if (contains(model.provenance.train_cases, case_number)) return CaseRole::train;
  if (contains(model.provenance.validation_cases, case_number)) return CaseRole::validation;
  return contains(model.provenance.test_cases, case_number) ? CaseRole::test : CaseRole::unseen;
}

ParityPoint parity_point(const TrainingRow& mean, CaseRole role, const ScatterLaw& law, std::vector<double> further,
                         double prediction, std::size_t output) {
  const double value = mean.outputs[output];
  ParityPoint point{.case_number = mean.case_number,
                    .role = role,
                    .inputs = mean.inputs,
                    .further = std::move(further),
                    .cuts = mean.cuts,
                    .dem_mean = value,
                    .dem_standard_error = mean.standard_errors ? (*mean.standard_errors)[output] : 0.0,
                    .standard_error_known = mean.standard_errors.has_value(),
                    .noise = standard_error(law, output, value, mean.cut_length, mean.cuts),
                    .prediction = prediction};
  point.noise_half_way = standard_error(law, output, 0.5 * (value + prediction), mean.cut_length, mean.cuts);
  if (point.noise_half_way > 0.0) point.residual = (prediction - value) / point.noise_half_way;
  return point;
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

/// Sum of squares around the mean; exactly 0 when all are equal, which rounding of the mean would hide.
double squares_around_mean(std::span<const ParityPoint> points) {
  Collected means;
  bool all_equal = true;
  for (const ParityPoint& point : points) {
    means.add(point.dem_mean);
    all_equal = all_equal && point.dem_mean == points.front().dem_mean;
  }
  if (all_equal) return 0.0;
  double squares = 0.0;
  for (const ParityPoint& point : points) {
    squares += (point.dem_mean - *means.mean()) * (point.dem_mean - *means.mean());
  }
  return squares;
}

NoiseAlone noise_alone(std::span<const double> standard_errors) {
  constexpr double high = 0.95;
  return {.mean = expected_mean(standard_errors),
          .max = expected_largest(standard_errors),
          .high_max = largest_quantile(standard_errors, high)};
}

/// Root mean square of s_i; absent when no scatter is known.
std::optional<double> noise_of(std::span<const ParityPoint> points) {
  Collected squares;
  for (const ParityPoint& point : points) squares.add(point.noise * point.noise);
  return squares.sum > 0.0 ? root(squares.mean()) : std::nullopt;
}

void add_noise(std::span<const ParityPoint> points, double range, ParitySummary& summary) {
  summary.noise = noise_of(points);
  if (!summary.noise) return;
  summary.rmse_over_noise = *summary.rmse / *summary.noise;
  std::vector<double> of_value, of_range;
  for (const ParityPoint& point : points) {
    if (point.dem_mean > 0.0) of_value.push_back(point.noise / point.dem_mean);
    if (range > 0.0) of_range.push_back(point.noise / range);
  }
  if (!of_value.empty()) summary.noise_alone = noise_alone(of_value);
  if (!of_range.empty()) summary.noise_of_range = noise_alone(of_range);
}

ParitySummary summary_of(std::span<const ParityPoint> points, double range) {
  Collected relative, bias, of_range, squares, error_squares;
  for (const ParityPoint& point : points) {
    const double deviation = point.prediction - point.dem_mean;
    squares.add(deviation * deviation);
    if (point.dem_mean > 0.0) {
      relative.add(std::abs(deviation) / point.dem_mean);
      bias.add(deviation / point.dem_mean);
    }
    if (range > 0.0) of_range.add(std::abs(deviation) / range);
    if (point.standard_error_known) error_squares.add(point.dem_standard_error * point.dem_standard_error);
  }
  ParitySummary summary{.cases = squares.count,
                        .zero_cases = squares.count - relative.count,
                        .mean_deviation = relative.mean(),
                        .max_deviation = relative.max(),
                        .mean_bias = bias.mean(),
                        .mean_of_range = of_range.mean(),
                        .max_of_range = of_range.max(),
                        .rmse = root(squares.mean()),
                        .dem_standard_error = root(error_squares.mean())};
  const double spread = squares_around_mean(points);
  if (spread > 0.0) summary.r2 = 1.0 - squares.sum / spread;
  add_noise(points, range, summary);
  return summary;
}

template <class Chosen>
std::vector<ParityPoint> points_where(const std::vector<ParityPoint>& points, const Chosen& chosen) {
  std::vector<ParityPoint> found;
  std::copy_if(points.begin(), points.end(), std::back_inserter(found),
               [&](const ParityPoint& point) { return chosen(point.role); });
  return found;
}

/// nu_1 of `noise_floor.hpp`.
double compared_degrees(std::span<const ParityPoint> points) {
  std::vector<double> variances;
  for (const ParityPoint& point : points) variances.push_back(point.noise * point.noise);
  return effective_degrees(variances, std::vector<double>(variances.size(), 1.0));
}

/// nu_2 of `noise_floor.hpp`; the degrees that a formula leaves belong to all cases alike.
double law_degrees(std::span<const ParityPoint> points, const ScatterLaw& law) {
  std::vector<double> variances, degrees;
  for (const ParityPoint& point : points) {
    if (!point.standard_error_known && !law.around_formula) continue;
    variances.push_back(point.cuts * point.noise * point.noise);
    degrees.push_back(law.around_formula ? law.degrees_of_freedom / static_cast<double>(points.size())
                                         : point.cuts - 1);
  }
  return effective_degrees(variances, degrees);
}

NoiseVerdict judged(const OutputParity& output, std::span<const ParityPoint> compared, const ParitySummary& summary,
                    const ScatterLaw& law) {
  if (!summary.noise || !output.all.noise) return {};
  const int cases = output.all.cases;
  std::vector<double> residuals;
  for (const ParityPoint& point : compared) {
    if (point.residual) residuals.push_back(*point.residual);
  }
  return judge({.rmse = *summary.rmse,
                .noise = *summary.noise,
                .compared_degrees = compared_degrees(compared),
                .law_degrees = law_degrees(output.points, law),
                .all_cases = cases,
                .variance_of_means = cases > 1 ? squares_around_mean(output.points) / (cases - 1) : 0.0,
                .noise_of_all_squared = *output.all.noise * *output.all.noise,
                .residuals = residuals});
}

void compare(OutputParity& output, const ScatterLaw& law) {
  const auto by_mean = [](const ParityPoint& a, const ParityPoint& b) { return a.dem_mean < b.dem_mean; };
  const auto [low, high] = std::minmax_element(output.points.begin(), output.points.end(), by_mean);
  const double range = high->dem_mean - low->dem_mean;
  const auto is = [](CaseRole role) { return [role](CaseRole seen) { return seen == role; }; };
  const std::vector<ParityPoint> held_out = points_where(output.points, is_held_out);
  output.all = summary_of(output.points, range);
  output.train = summary_of(points_where(output.points, is(CaseRole::train)), range);
  output.validation = summary_of(points_where(output.points, is(CaseRole::validation)), range);
  output.held_out = summary_of(held_out, range);
  output.judged = held_out.empty() ? judged(output, output.points, output.all, law)
                                   : judged(output, held_out, output.held_out, law);
  std::vector<JudgedCase> cases;
  cases.reserve(held_out.size());
  for (const ParityPoint& point : held_out)
    cases.push_back(
        {.prediction = point.prediction, .dem_mean = point.dem_mean, .standard_error = point.noise_half_way});
  output.error = network_error(cases, law_degrees(output.points, law));
}

/// From cases that were cut more than once; where there are none, around a formula.
ScatterLaw known_scatter(std::span<const TrainingRow> means, std::span<const LearntFurther> further) {
  const ScatterLaw repeated = scatter_law(means);
  if (repeated.degrees_of_freedom > 0 || means.size() < least_scatter_degrees) return repeated;
  return scatter_around(fit_formula(means, further), means);
}

/// Networks that do not ask for the pressure know one alone.
void require_pressure(const Model& model, const TrainingData& data) {
  for (const Variable& input : further_inputs(model)) {
    if (input.name == pressure_input) return;
  }
  for (const TrainingRow& row : data.rows) {
    const double pressure = row.further.empty() ? 0.0 : row.further.front();
    if (pressure == model.provenance.fluid_pressure_MPa) continue;
    throw base::InputError(fmt::format(
        "{}:{}: cut under {} = {:g}, and the networks have learnt from cuts under {:g} (the pressure is no input of "
        "theirs)",
        data.file, row.line, pressure_input, pressure, model.provenance.fluid_pressure_MPa));
  }
}

}  // namespace

Parity parity(const Model& model, const TrainingData& data, CaseNumbers numbers) {
  if (!mix(model.provenance.counting, data.counting)) {
    throw base::InputError(
        fmt::format("{}: peaks are counted {}, and the networks have learnt from peaks counted {} (their numbers "
                    "cannot be compared: "
                    "make the table by the same definition with bitrock campaign features, or train anew)",
                    data.file, in_words(data.counting), in_words(model.provenance.counting)));
  }
  const std::vector<LearntFurther> further = learnt_further(model, data);
  require_pressure(model, data);
  Parity result{.inputs = model.inputs};
  const DataPart* part = part_of(model, data);
  const std::int64_t first_case = part == nullptr ? 0 : part->first_case;
  result.same_data = part != nullptr || data.fingerprint == model.provenance.data_fingerprint;
  const TrainingData means = averaged(data);
  const ScatterLaw law = known_scatter(means.rows, learnt_further(data));
  result.outputs.resize(std::min(model.outputs.size(), output_count(data)));
  result.law_degrees = law.degrees_of_freedom;
  result.scatter_around_formula = law.around_formula;
  for (const TrainingRow& mean : means.rows) {
    const CaseRole role = role_of(model, mean.case_number + first_case, numbers);
    const std::vector<double> values = further_values(mean, further);
    const Prediction prediction = predict(model, conditions_of(mean), values);
    if (is_held_out(role)) {
      result.has_held_out = true;
      if (!prediction.inside_training_range) ++result.outside_training_range;
    }
    const auto predictions = listed(prediction);
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
      if (std::isfinite(predictions[i])) continue;
      throw base::InputError(
          fmt::format("the model has no finite answer for {} of case {}", output_names[i].name, mean.case_number));
    }
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
      result.outputs[i].points.push_back(parity_point(mean, role, law, values, predictions[i], i));
    }
  }
  for (std::size_t i = 0; i < result.outputs.size(); ++i) {
    result.outputs[i].name = output_names[i].name;
    result.outputs[i].unit = output_names[i].unit;
    compare(result.outputs[i], law);
  }
  return result;
}

std::vector<std::string> warnings(const Parity& parity, const TrainingData& data, CaseNumbers numbers) {
  std::vector<std::string> all;
  if (!parity.same_data && numbers == CaseNumbers::as_in_training) {
    all.push_back(
        fmt::format("{} is not the file the model learnt from; cases of the same number are taken for the same cases "
                    "(--unseen if they are not)",
                    data.file));
  }
  if (parity.outside_training_range > 0) {
    all.push_back(fmt::format("{} cases held out lie outside the training range: the networks extrapolate there",
                              parity.outside_training_range));
  }
  if (parity.law_degrees == 0)
    all.emplace_back("no case was cut more than once: nothing is known of the scatter of the data");
  if (parity.scatter_around_formula)
    all.emplace_back(
        "no case was cut more than once: the scatter of the data is taken from single cuts around a smooth formula");
  return all;
}

}  // namespace bitrock::surrogate
