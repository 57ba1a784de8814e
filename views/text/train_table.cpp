#include "views/text/train_table.hpp"

#include <fmt/format.h>

#include <string_view>

namespace bitrock::views {

namespace {

/// "x_amax" of "x_amax_N_per_m": fits above a column.
std::string_view short_name(std::string_view name) {
  for (const std::string_view unit : {"_N_per_m", "_per_m"}) {
    if (name.ends_with(unit)) return name.substr(0, name.size() - unit.size());
  }
  return name;
}

}  // namespace

std::string search_table(const surrogate::Search& search) {
  std::string table = fmt::format(
      "{}-fold cross-validation over {} cases: root mean square errors on cases not learnt from, in standard errors of "
      "the data (1 is perfect)\n  {:<58} {:>6} {:>16}",
      search.folds, search.cases, "kind", "all", "gain");
  const std::size_t count = search.results.empty() ? 0 : search.results.front().errors.size();
  for (std::size_t i = 0; i < count; ++i) table += fmt::format(" {:>7}", short_name(surrogate::output_names[i].name));
  table += "\n";
  for (const surrogate::CandidateResult& result : search.results) {
    const std::string gain =
        &result == &search.results.front() ? "" : fmt::format("{:.3f} +- {:.3f}", result.gain, result.gain_error);
    table += fmt::format("  {:<58} {:>6.3f} {:>16}", result.candidate.name, result.error, gain);
    for (const double error : result.errors) table += fmt::format(" {:>7.3f}", error);
    table += "\n";
  }
  return table + search.choice + "\n";
}

std::string training_table(const surrogate::Model& model) {
  const std::size_t validation = model.provenance.validation_cases.size();
  std::string table = fmt::format("{} cases to learn from, {}{} to test; mean squared errors in scaled units\n",
                                  model.provenance.train_cases.size(),
                                  validation > 0 ? fmt::format("{} to say when to stop, ", validation) : "",
                                  model.provenance.test_cases.size());
  const int width = surrogate::has_moments(model) ? 21 : 16;  // of the longest name
  for (const surrogate::OutputModel& output : model.outputs) {
    const surrogate::LearningPoint& last = output.learning_curve.back();
    table += fmt::format("  {:<{}} train {:.3e}   test {:.3e}   epoch {} of {}   restarts {}\n", output.variable.name,
                         width, last.train_mse, last.test_mse, output.best_epoch, last.epoch, output.restarts);
  }
  return table;
}

}  // namespace bitrock::views
