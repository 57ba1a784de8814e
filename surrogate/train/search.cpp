#include "surrogate/train/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "surrogate/train/baseline.hpp"
#include "surrogate/train/scaling.hpp"
#include "surrogate/train/scatter.hpp"
#include "surrogate/train/smooth_formula.hpp"

namespace bitrock::surrogate {

namespace {

/// Part `fold` of the cases is left out, the others are learnt from.
std::vector<Split> fold_splits(std::vector<int> cases, int folds, const TrainOptions& options) {
  constexpr std::uint64_t folding = 0x666f6c64;  // "fold": another draw than that of the test cases
  if (options.shuffle) {
    base::Random random(base::mix(options.split_seed.value_or(options.seed) ^ folding));
    base::shuffle(random, std::span(cases));
  }
  std::vector<Split> splits(static_cast<std::size_t>(folds));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t fold = 0; fold < splits.size(); ++fold) {
      (i % splits.size() == fold ? splits[fold].test_cases : splits[fold].train_cases).push_back(cases[i]);
    }
  }
  for (Split& split : splits) {
    std::sort(split.train_cases.begin(), split.train_cases.end());
    std::sort(split.test_cases.begin(), split.test_cases.end());
  }
  return splits;
}

/// Deviations from the means of the left-out cases.
std::vector<Outputs> deviations(const TrainingData& data, const TrainingData& means, const Split& split,
                                const Candidate& candidate, TrainOptions options,
                                const base::ProgressCallback& progress) {
  const std::vector<TrainingRow> left_out = rows_of(means.rows, split.test_cases);
  std::vector<Outputs> predicted;
  const std::vector<LearntFurther> further = learnt_further(data);
  if (candidate.layers.empty() && candidate.degree > 0) {
    const SmoothFormula formula = fit_formula(rows_of(means.rows, split.train_cases), further, candidate.degree);
    for (const TrainingRow& row : left_out) predicted.push_back(predict(formula, row));
  } else if (candidate.layers.empty()) {
    const Baseline baseline = fit_baseline(rows_of(means.rows, split.train_cases));
    for (const TrainingRow& row : left_out) predicted.push_back(predict(baseline, row));
  } else {
    take_kind(candidate, options);
    const Model model = train_on(data, split, options, progress);
    for (const TrainingRow& row : left_out)
      predicted.push_back(listed(predict(model, conditions_of(row), further_values(row, further))));
  }
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    for (std::size_t o = 0; o < predicted[i].size(); ++o) predicted[i][o] -= left_out[i].outputs[o];
  }
  return predicted;
}

/// s_o over all cases; 1 for an output that does not scatter at all.
Outputs scatter_of(const TrainingData& means) {
  const ScatterLaw law = scatter_law(means.rows);
  Outputs squares{.count = output_count(means)};
  for (const TrainingRow& row : means.rows) {
    for (std::size_t o = 0; o < squares.size(); ++o) {
      const double error = standard_error(law, o, row.outputs[o], row.cut_length, row.cuts);
      squares[o] += error * error / static_cast<double>(means.rows.size());
    }
  }
  for (double& square : squares) square = square > 0.0 ? std::sqrt(square) : 1.0;
  return squares;
}

/// q_i of every case, and the errors of the candidate.
std::vector<double> judge(const std::vector<Outputs>& deviations, const Outputs& scatter, CandidateResult& result) {
  std::vector<double> per_case;
  const auto count = static_cast<double>(deviations.size());
  const auto outputs = static_cast<double>(scatter.size());
  Outputs sums{.count = scatter.count};
  for (const Outputs& deviation : deviations) {
    double sum = 0.0;
    for (std::size_t o = 0; o < sums.size(); ++o) {
      const double error = deviation[o] / scatter[o];
      sums[o] += error * error / count;
      sum += error * error / outputs;
    }
    per_case.push_back(sum);
  }
  double mean = 0.0;
  result.errors.count = sums.count;
  for (std::size_t o = 0; o < sums.size(); ++o) {
    result.errors[o] = std::sqrt(sums[o]);
    mean += sums[o] / outputs;
  }
  result.error = std::sqrt(mean);
  return per_case;
}

void compare(const std::vector<double>& first, const std::vector<double>& other, CandidateResult& result) {
  const auto count = static_cast<double>(first.size());
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) sum += first[i] - other[i];
  result.gain = sum / count;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double from_mean = first[i] - other[i] - result.gain;
    squares += from_mean * from_mean;
  }
  result.gain_error = std::sqrt(squares / (count * (count - 1.0)));
}

void choose(Search& search) {
  const auto better = [&](const CandidateResult& result) {
    return !result.candidate.layers.empty() && result.gain > gain_asked_for * result.gain_error && result.gain > 0.0;
  };
  for (std::size_t i = 1; i < search.results.size(); ++i) {
    if (better(search.results[i]) && search.results[i].error < search.results[search.chosen].error) search.chosen = i;
  }
  const CandidateResult& taken = search.results[search.chosen];
  search.choice = fmt::format(
      "of {} kinds in {}-fold cross-validation over {} cases: {}, held-out error {:.3f} standard "
      "errors of the data",
      search.results.size(), search.folds, search.cases, taken.candidate.name, taken.error);
  if (search.chosen > 0) {
    search.choice +=
        fmt::format("; {} has {:.3f}, more by {:.1f} standard errors of the difference",
                    search.results[0].candidate.name, search.results[0].error, taken.gain / taken.gain_error);
  } else {
    search.choice += "; no other network is better beyond the scatter";
  }
}

}  // namespace

void take_kind(const Candidate& candidate, TrainOptions& options) {
  options.layers = candidate.layers;
  options.output = candidate.output;
  options.log_targets = candidate.log_targets;
  options.taught = candidate.taught;
}

std::vector<Candidate> usual_candidates() {
  const std::vector<int> article{3, 4, 6, 3, 1}, wide{3, 8, 12, 6, 1}, wider{3, 16, 16, 1};
  return {{.name = "3-4-6-3-1, taught by a formula", .layers = article, .taught = true},
          {.name = "3-4-6-3-1", .layers = article},
          {.name = "3-8-12-6-1", .layers = wide},
          {.name = "3-16-16-1", .layers = wider},
          {.name = "3-4-6-3-1, softplus output", .layers = article, .output = OutputActivation::softplus},
          {.name = "3-4-6-3-1, linear output", .layers = article, .output = OutputActivation::linear},
          {.name = "3-4-6-3-1, log targets", .layers = article, .log_targets = true},
          {.name = "3-8-12-6-1, log targets", .layers = wide, .log_targets = true},
          {.name = "3-16-16-1, linear output, log targets",
           .layers = wider,
           .output = OutputActivation::linear,
           .log_targets = true},
          {.name = "3-8-12-6-1, taught by a formula", .layers = wide, .taught = true},
          {.name = "3-16-16-1, taught by a formula", .layers = wider, .taught = true},
          {.name = "smooth formula of degree 3", .layers = {}, .degree = 3},
          {.name = "smooth formula of degree 2", .layers = {}, .degree = 2},
          {.name = "formula: depth or 1/depth times a parabola of the rake", .layers = {}}};
}

Search search(const TrainingData& data, const TrainOptions& options, const std::vector<Candidate>& candidates,
              int folds, const base::ProgressCallback& progress) {
  const TrainingData means = averaged(data);
  const Split outer =
      split_cases(case_numbers(data), options.split, options.shuffle, options.split_seed.value_or(options.seed));
  const auto cases = static_cast<int>(outer.train_cases.size());
  if (folds < 2 || folds > cases) {
    throw base::InputError(
        fmt::format("folds = {} (must be from 2 to the number of training cases, {})", folds, cases));
  }
  if (options.init_from != nullptr) throw base::InputError("a search cannot begin from trained networks");
  const TrainingData known{.file = data.file, .rows = rows_of(means.rows, outer.train_cases)};
  if (scatter_law(known.rows).degrees_of_freedom == 0) {
    throw base::InputError(fmt::format(
        "{}: no case was cut more than once, so nothing is known of the scatter that errors are measured in",
        data.file));
  }
  const std::vector<Split> splits = fold_splits(outer.train_cases, folds, options);
  const Outputs scatter = scatter_of(known);

  Search result{.folds = folds, .cases = cases};
  std::vector<double> first;
  const double all = static_cast<double>(candidates.size()) * folds;
  double over = 0.0;
  for (const Candidate& candidate : candidates) {
    std::vector<Outputs> all_deviations;
    for (const Split& split : splits) {
      const auto tell = [&](double part, double whole) {
        if (progress) progress(over + part / whole, all);
      };
      const std::vector<Outputs> some = deviations(data, means, split, candidate, options, tell);
      all_deviations.insert(all_deviations.end(), some.begin(), some.end());
      over += 1.0;
    }
    CandidateResult judged{.candidate = candidate};
    const std::vector<double> per_case = judge(all_deviations, scatter, judged);
    if (result.results.empty()) first = per_case;
    compare(first, per_case, judged);
    result.results.push_back(judged);
  }
  choose(result);
  return result;
}

}  // namespace bitrock::surrogate
