#include "surrogate/train/taught_rows.hpp"

#include <algorithm>
#include <cmath>

#include "base/even_points.hpp"
#include "surrogate/net/further_inputs.hpp"

namespace bitrock::surrogate {

namespace {

double between(double low, double high, double share) {
  return share == 1.0 ? high : low + (high - low) * share;
}

}  // namespace

std::vector<TrainingRow> taught_rows(const SmoothFormula& formula, std::span<const TrainingRow> rows, int count) {
  const std::vector<Variable> range = input_variables(rows, formula.further);
  const base::EvenPoints points(static_cast<int>(range.size()));
  std::vector<TrainingRow> taught;
  for (int i = 1; i <= count; ++i) {
    std::vector<double> at = points.point(i);
    std::transform(at.begin(), at.end(), at.begin(), base::with_ends);
    TrainingRow row = rows.front();
    row.case_number = i;
    row.cuts = 1;
    row.standard_errors.reset();
    row.inputs = {between(range[0].low, range[0].high, at[0]),
                  std::exp(between(std::log(range[1].low), std::log(range[1].high), at[1])),
                  between(range[2].low, range[2].high, at[2])};
    for (std::size_t k = 0; k < formula.further.size(); ++k) {
      const auto& spread = formula.further[k].name == pressure_input ? pressure_between : between;
      row.further[formula.further[k].place] = spread(range[3 + k].low, range[3 + k].high, at[3 + k]);
    }
    row.outputs = predict(formula, row);
    taught.push_back(row);
  }
  return taught;
}

}  // namespace bitrock::surrogate
