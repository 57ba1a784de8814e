#include "surrogate/train/data_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/errors.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/unit_slips.hpp"

namespace bitrock::surrogate {

namespace {

/// Places of one kind: all are counted, the first ones are named.
class Places {
 public:
  void add(const std::string& place) {
    constexpr int most_named = 3;
    if (++count_ <= most_named) named_ += (named_.empty() ? "" : ", ") + place;
    if (count_ == most_named + 1) named_ += ", ...";
  }
  int count() const { return count_; }
  const std::string& named() const { return named_; }

 private:
  int count_ = 0;
  std::string named_;
};

void add_if_any(const Places& places, const std::string& what, std::vector<std::string>& all) {
  if (places.count() > 0) all.push_back(fmt::format("{} ({}: {})", what, places.count(), places.named()));
}

Places repeated_conditions(const TrainingData& data) {
  Places places;
  std::map<std::pair<std::array<double, input_count>, std::vector<double>>, int> case_of;
  for (const TrainingRow& row : data.rows) {
    const auto [known, is_new] = case_of.emplace(std::pair(row.inputs, row.further), row.case_number);
    if (is_new || known->second == row.case_number) continue;
    places.add(fmt::format("case {} as case {}", row.case_number, known->second));
  }
  return places;
}

Places copied_statistics(const TrainingData& data) {
  Places places;
  std::map<std::pair<double, Outputs>, int> line_of;  // with the length: counts here are divided by it
  for (const TrainingRow& row : data.rows) {
    const bool nothing = std::all_of(row.outputs.begin(), row.outputs.end(), [](double v) { return v == 0.0; });
    const auto [known, is_new] = line_of.emplace(std::pair(row.cut_length, row.outputs), row.line);
    if (!is_new && !nothing) places.add(fmt::format("line {} as line {}", row.line, known->second));
  }
  return places;
}

/// A force has peaks and a highest one, or neither.
Places peaks_without_height(const TrainingData& data) {
  Places places;
  for (const TrainingRow& row : data.rows) {
    for (std::size_t k = 0; k < article_output_count; k += statistics_count) {
      const bool peaks = row.outputs[k + 2] + row.outputs[k + 3] + row.outputs[k + 4] > 0.0;
      if (peaks == (row.outputs[k] > 0.0)) continue;
      places.add(fmt::format("line {}, {}", row.line, k == 0 ? "x" : "y"));
    }
  }
  return places;
}

/// In a single cut peaks are counted: 1, 2, 3.
Places broken_counts(const TrainingData& data) {
  constexpr double rounding = 1e-6;  // of a count that was divided by the length of cut and multiplied again
  Places places;
  if (!data.has_seeds) return places;
  for (const TrainingRow& row : data.rows) {
    for (std::size_t i = 0; i < row.outputs.size(); ++i) {
      const double count = row.outputs[i] * row.cut_length;
      if (!is_count(i) || std::abs(count - std::round(count)) <= rounding * std::max(1.0, count)) continue;
      places.add(fmt::format("line {}, {:.6g} of {}", row.line, count, output_names[i].name));
    }
  }
  return places;
}

}  // namespace

std::vector<std::string> warnings(const TrainingData& data) {
  std::vector<std::string> all;
  add_if_any(repeated_conditions(data),
             fmt::format("{}: cases with the speed, depth and rake of another case; what one teaches, the other may "
                         "test: give repeats one case number and seeds of their own",
                         data.file),
             all);
  add_if_any(copied_statistics(data),
             fmt::format("{}: rows with the same ten statistics as another row: copied?", data.file), all);
  add_if_any(peaks_without_height(data),
             fmt::format("{}: peaks without an amplitude, or an amplitude without peaks", data.file), all);
  add_if_any(
      broken_counts(data),
      fmt::format("{}: peak counts of single cuts that are no whole numbers: are they counts of one cut?", data.file),
      all);
  if (data.moments_left_out) {
    all.push_back(fmt::format(
        "{}: not all of these tables have the columns of mean, sd, correlation length and correlation: only "
        "the article's ten outputs are learnt (make the tables anew with bitrock campaign features)",
        data.file));
  }
  for (std::string& slip : unit_slips(data)) all.push_back(std::move(slip));
  return all;
}

std::vector<std::string> learning_warnings(const TrainingData& data, const TrainOptions& options) {
  std::vector<std::string> all;
  const std::size_t cases = case_numbers(data).size();
  const std::vector<LearntFurther> further = learnt_further(data);
  const std::size_t parameters = parameter_count(with_further(options.layers, further.size()));
  if (options.init_from == nullptr && !options.taught && cases < parameters) {
    all.push_back(
        fmt::format("{}: {} cases for networks of {} parameters each: they may meet every case and be far off between "
                    "them (cut more conditions, or start from the networks of a like rock with --init-from)",
                    data.file, cases, parameters));
  }
  for (const Variable& input : input_variables(data.rows)) {
    if (varies(input)) continue;
    all.push_back(
        fmt::format("{}: {} is {:.6g} in all rows: the networks learn nothing of it, and any other value is "
                    "outside their training range",
                    data.file, input.name, input.low));
  }
  const std::vector<TrainingRow> rows = averaged(data).rows;
  for (std::size_t i = 0; i < output_count(data); ++i) {
    const Variable output = output_scaling(rows, i, false).variable;
    if (output.high > output.low) continue;
    all.push_back(fmt::format("{}: {} is {:.6g} in all cases: there is nothing to learn for its network", data.file,
                              output.name, output.low));
  }
  return all;
}

void require_varied_inputs(std::span<const TrainingRow> train_rows, std::span<const LearntFurther> further,
                           const std::string& file) {
  const std::vector<Variable> inputs = input_variables(train_rows, further);
  if (std::any_of(inputs.begin(), inputs.end(), varies)) return;
  std::string seen;
  for (const Variable& input : inputs)
    seen += fmt::format("{}{} = {:.6g}", seen.empty() ? "" : ", ", input.name, input.low);
  throw base::InputError(
      fmt::format("{}: speed, depth and rake are the same in all {} rows to learn from: {} (at least one of them must "
                  "vary: networks learn how the force depends on them)",
                  file, train_rows.size(), seen));
}

}  // namespace bitrock::surrogate
