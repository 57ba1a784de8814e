// Report chapter about network against DEM: what to think of each output, the plots, and all the numbers.
#include <fmt/format.h>

#include <utility>

#include "views/networks/chapter.hpp"
#include "views/networks/figures.hpp"

namespace bitrock::views {

namespace {

// A network of 71 parameters cannot be judged on fewer cases than about half of that.
constexpr std::size_t enough_cases = 40;

const surrogate::ParitySummary& judged_cases(const surrogate::Parity& parity, const surrogate::OutputParity& output) {
  return parity.has_held_out ? output.held_out : output.all;
}

/// Names and verdicts in one piece, however narrow the table.
std::string unbroken(const std::string& text) {
  std::string joined;
  for (const char c : text) {
    if (c == ' ')
      joined += "\u00a0";
    else
      joined += c;
  }
  return joined;
}

report::Table verdict_table(const surrogate::Parity& parity) {
  report::Table table{
      .caption = fmt::format(
          "{} Network: how far it is off itself, the scatter of the DEM taken out, as a share of what it says, and the "
          "upper end of the 95 % interval of that; bias beside what chance makes of it. Root mean square error beside "
          "the standard error (s.e.) of the DEM means, by the law of scatter; mean deviation relative to the DEM value "
          "beside what noise alone would give a faultless network.",
          parity.has_held_out ? "The cases held out from training." : "No case was held out: all cases, learnt from."),
      .header = {"output", "verdict", "network", "at most", "bias", "chance", "unit", "DEM s.e.", "RMSE", "RMSE / s.e.",
                 "mean dev.", "noise alone"}};
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const surrogate::OutputParity& output = parity.outputs[k];
    const surrogate::ParitySummary& seen = judged_cases(parity, output);
    const auto [name, unit, factor] = shown(output, k);
    table.rows.push_back({unbroken(name), unbroken(verdict_text(output.judged)),
                          percent_of(output.error, &surrogate::NetworkError::rms),
                          percent_of(output.error, &surrogate::NetworkError::rms_high),
                          percent_of(output.error, &surrogate::NetworkError::bias),
                          percent_of(output.error, &surrogate::NetworkError::bias_chance), unit,
                          number(seen.noise, factor), number(seen.rmse, factor), number(seen.rmse_over_noise),
                          percent(seen.mean_deviation), percent_of(seen.noise_alone, &surrogate::NoiseAlone::mean)});
  }
  return table;
}

/// Calls `add(role, summary)` for each role that has cases.
template <class Add>
void for_each_role(const surrogate::OutputParity& output, const Add& add) {
  const std::pair<const char*, const surrogate::ParitySummary*> roles[] = {
      {"training", &output.train}, {"validation", &output.validation}, {"held out", &output.held_out}};
  for (const auto& [role, summary] : roles) {
    if (summary->cases > 0) add(role, *summary);
  }
}

report::Table error_table(const surrogate::Parity& parity) {
  report::Table table{
      .caption =
          "Errors by role. Standard errors of the DEM means by the law of scatter, and as the seeds of each case "
          "show them. On cases learnt from, a network can be closer to the data than their noise, for there it "
          "follows the noise.",
      .header = {"output", "cases", "number", "unit", "RMSE", "s.e. (law)", "s.e. (seen)", "RMSE / s.e.", "R2"}};
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const auto [name, unit, factor] = shown(parity.outputs[k], k);
    for_each_role(parity.outputs[k], [&, name = name, unit = unit, factor = factor](
                                         const char* role, const surrogate::ParitySummary& seen) {
      table.rows.push_back({unbroken(name), role, fmt::format("{}", seen.cases), unit, number(seen.rmse, factor),
                            number(seen.noise, factor), number(seen.dem_standard_error, factor),
                            number(seen.rmse_over_noise), number(seen.r2)});
    });
  }
  return table;
}

report::Table deviation_table(const surrogate::Parity& parity) {
  report::Table table{
      .caption =
          "Deviations from the line of equality by role, relative to the DEM value and to the range of the DEM "
          "values. \"noise\": the maximum that noise alone would give on average, and the one it stays below in "
          "95 % of all data sets.",
      .header = {"output", "cases", "bias", "mean", "max", "noise", "noise 95 %", "mean of range", "max of range",
                 "noise", "noise 95 %"}};
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const std::string name = unbroken(shown(parity.outputs[k], k).name);
    for_each_role(parity.outputs[k], [&](const char* role, const surrogate::ParitySummary& seen) {
      table.rows.push_back({name, role, percent(seen.mean_bias), percent(seen.mean_deviation),
                            percent(seen.max_deviation), percent_of(seen.noise_alone, &surrogate::NoiseAlone::max),
                            percent_of(seen.noise_alone, &surrogate::NoiseAlone::high_max), percent(seen.mean_of_range),
                            percent(seen.max_of_range), percent_of(seen.noise_of_range, &surrogate::NoiseAlone::max),
                            percent_of(seen.noise_of_range, &surrogate::NoiseAlone::high_max)});
    });
  }
  return table;
}

void add_notes(report::Page& page, const surrogate::Model& model, const surrogate::Parity& parity) {
  const surrogate::Provenance& learnt = model.provenance;
  const std::size_t cases = learnt.train_cases.size() + learnt.validation_cases.size() + learnt.test_cases.size();
  if (cases < enough_cases && learnt.taught_terms > 0) {
    page.note(fmt::format(
        "Only {} cases, through which a smooth formula of {} terms goes: the networks know its shape and no "
        "finer one. What they say between the cases is as true as the formula.",
        cases, learnt.taught_terms));
  } else if (cases < enough_cases) {
    page.note(fmt::format(
        "Only {} cases: far too few to learn from ({} parameters a network). The networks can learn the {} cases they "
        "were trained on by heart; what they say elsewhere, including the {} test cases, is a guess. Expect the parity "
        "to be poor: this page shows the path, not a result.",
        cases, surrogate::parameter_count(model.outputs[0].network.layers), learnt.train_cases.size(),
        learnt.test_cases.size()));
  }
  if (parity.law_degrees == 0) {
    page.note(
        "No case was cut more than once, so nothing is known of the scatter of the data, and nothing can be said "
        "of how much of a deviation is noise.");
  }
  if (parity.scatter_around_formula) {
    page.note(
        "No case was cut more than once: the scatter of the data is taken from single cuts around a smooth formula, "
        "and is too large where the force has a shape that the formula cannot follow.");
  }
  if (parity.outside_training_range > 0) {
    page.note(
        fmt::format("{} of the cases held out lie outside the conditions the networks were trained on; there "
                    "they extrapolate.",
                    parity.outside_training_range));
  }
}

}  // namespace

void add_parity(report::Page& page, const surrogate::Model& model, const surrogate::Parity& parity,
                const std::string& part_of) {
  add_notes(page, model, parity);
  page.table(verdict_table(parity));
  page.paragraph(
      "At the noise floor: these cases cannot tell the network from a faultless one, but would tell one twice as far "
      "off. So many times above it: RMSE / s.e. is larger than chance makes it. Above it in some cases: it is not, but "
      "single cases lie farther off than chance puts the farthest. Too noisy to tell: the cases are too few, or their "
      "scatter hides what the network should have learnt.");
  for (const report::Figure& figure : parity_figures(parity)) page.plots_in_row(figure.plots, figure.caption);
  const std::vector<report::Figure> residuals = residual_figures(parity);
  if (!residuals.empty()) {
    page.section(part_of.empty() ? "Residuals" : part_of + ": residuals",
                 "Network minus DEM, in units of the standard error that the law of scatter gives the DEM mean there.");
  }
  for (const report::Figure& figure : residuals) page.plots_in_row(figure.plots, figure.caption);
  page.section(part_of.empty() ? "Parity in numbers" : part_of + ": in numbers");
  page.table(error_table(parity));
  page.table(deviation_table(parity));
}

}  // namespace bitrock::views
