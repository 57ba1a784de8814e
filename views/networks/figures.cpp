#include "views/networks/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "surrogate/net/further_inputs.hpp"
#include "views/networks/parity_plot.hpp"
#include "views/networks/residual_plot.hpp"

namespace bitrock::views {

namespace {

// Residual plots reach at least this far up and down, so that a good network does not look like a bad one.
constexpr double least_residual_axis = 4.0;

/// How an input is called in the title of a plot and at its axis.
struct InputWords {
  std::string title, axis;
};

InputWords words_of(const surrogate::Variable& input) {
  constexpr std::array<const char*, surrogate::input_count> titles{"speed", "depth", "rake"};
  constexpr std::array<const char*, surrogate::input_count> axes{"speed [m/s]", "depth of cut [mm]", "back rake [deg]"};
  for (std::size_t i = 0; i < titles.size(); ++i) {
    if (input.name == surrogate::input_names[i].name) return {titles[i], axes[i]};
  }
  if (input.name == surrogate::pressure_input) return {"pressure", "pressure of the mud [MPa]"};
  return {input.name, fmt::format("{} [{}]", input.name, input.unit)};
}

double input_of(const surrogate::ParityPoint& point, std::size_t input) {
  return input < point.inputs.size() ? point.inputs[input] : point.further[input - point.inputs.size()];
}

views::CaseKind kind_of(surrogate::CaseRole role) {
  if (surrogate::is_held_out(role)) return views::CaseKind::held_out;
  return role == surrogate::CaseRole::validation ? views::CaseKind::validation : views::CaseKind::training;
}

std::string label_of(const surrogate::ParityPoint& point) {
  std::string label = fmt::format("case {}: {:g} m/s, {:g} mm, {:g}\u00b0", point.case_number, point.inputs[0],
                                  point.inputs[1], point.inputs[2]);
  for (const double value : point.further) label += fmt::format(", {:g}", value);
  return label;
}

report::Plot parity_plot(const surrogate::OutputParity& output, const ShownOutput& as) {
  std::vector<views::ParityPoint> points;
  for (const surrogate::ParityPoint& point : output.points) {
    points.push_back({.dem = point.dem_mean * as.factor,
                      .network = point.prediction * as.factor,
                      .dem_standard_error = point.dem_standard_error * as.factor,
                      .kind = kind_of(point.role),
                      .label = label_of(point)});
  }
  return views::parity_plot(as.name, as.unit, points);
}

/// Residuals of the cases where there are any, over input number `input`.
std::vector<views::Residual> residuals(const surrogate::OutputParity& output, std::size_t input) {
  std::vector<views::Residual> found;
  for (const surrogate::ParityPoint& point : output.points) {
    if (!point.residual) continue;
    found.push_back({.input = input_of(point, input),
                     .residual = *point.residual,
                     .kind = kind_of(point.role),
                     .label = label_of(point)});
  }
  return found;
}

double residual_axis(const std::vector<views::Residual>& residuals) {
  double largest = least_residual_axis;
  for (const views::Residual& residual : residuals) largest = std::max(largest, 1.05 * std::abs(residual.residual));
  return largest;
}

struct Direction {
  const char *file_ending, *words;
  std::size_t first, last;  ///< outputs from the first to before the last
};
constexpr std::size_t ten = surrogate::article_output_count;
constexpr std::array<Direction, 3> directions{{{"x", "Cutting force x", 0, surrogate::statistics_count},
                                               {"y", "Axial force y", surrogate::statistics_count, ten},
                                               {"moments", "What rebuilds the force", ten, surrogate::most_outputs}}};

/// Those whose outputs are there.
std::span<const Direction> shown_directions(const surrogate::Parity& parity) {
  return std::span(directions).first(parity.outputs.size() > ten ? 3 : 2);
}

report::Figure parity_figure(const surrogate::Parity& parity, const Direction& direction) {
  report::Figure figure{.name = fmt::format("parity_{}", direction.file_ending),
                        .caption = fmt::format(
                            "{}: what the network says against what the DEM gave. On the line both are equal; the band "
                            "is 15 % to either side. Error bars: standard error of the DEM mean, from the seeds of "
                            "that case alone.",
                            direction.words)};
  for (std::size_t k = direction.first; k < direction.last; ++k) {
    figure.plots.push_back(parity_plot(parity.outputs[k], shown(parity.outputs[k], k)));
  }
  return figure;
}

report::Figure residual_figure(const surrogate::Parity& parity, const Direction& direction) {
  report::Figure figure{
      .name = fmt::format("residuals_{}", direction.file_ending),
      .caption = fmt::format("{}: network minus DEM in units of the standard error of the DEM mean (by the law of "
                             "scatter). A trend is the network's fault; a cloud within 2 is noise.",
                             direction.words)};
  for (std::size_t k = direction.first; k < direction.last; ++k) {
    const surrogate::OutputParity& output = parity.outputs[k];
    for (std::size_t input = 0; input < parity.inputs.size(); ++input) {
      const std::vector<views::Residual> seen = residuals(output, input);
      if (seen.empty()) break;
      const InputWords words = words_of(parity.inputs[input]);
      figure.plots.push_back(views::residual_plot(fmt::format("{} over {}", shown(output, k).name, words.title),
                                                  words.axis, seen, residual_axis(seen)));
    }
  }
  return figure;
}

report::Figure histogram_figure(const surrogate::Parity& parity, const Direction& direction) {
  report::Figure figure{
      .name = fmt::format("histogram_{}", direction.file_ending),
      .caption = fmt::format("{}: the same residuals counted. Were noise all that is left, those held out would follow "
                             "the standard normal. The last columns hold all that lies beyond.",
                             direction.words)};
  for (std::size_t k = direction.first; k < direction.last; ++k) {
    const std::vector<views::Residual> seen = residuals(parity.outputs[k], 0);
    if (!seen.empty()) figure.plots.push_back(views::residual_histogram(shown(parity.outputs[k], k).name, seen));
  }
  return figure;
}

}  // namespace

ShownOutput shown(const surrogate::OutputParity& output, std::size_t index) {
  constexpr const char* statistics[] = {"A_max", "A_mean", "NP1", "NP23", "NP4"};
  constexpr std::array<const char*, surrogate::moment_count> moments{
      "Fx mean", "Fx sd", "Fy mean", "Fy sd", "correlation length", "short correlation length", "correlation xy"};
  if (index >= ten) {
    const std::string moment = moments[index - ten];
    if (output.unit == "N/m") return {moment, "kN/m", 1e-3};
    return output.unit == "m" ? ShownOutput{moment, "mm", 1e3} : ShownOutput{moment, output.unit, 1.0};
  }
  const std::string force = index < surrogate::statistics_count ? "Fx " : "Fy ";
  const std::string name = force + statistics[index % surrogate::statistics_count];
  if (output.unit == "N/m") return {name, "kN/m", 1e-3};
  return {name, output.unit, 1.0};
}

std::vector<report::Figure> parity_figures(const surrogate::Parity& parity) {
  std::vector<report::Figure> figures;
  for (const Direction& direction : shown_directions(parity)) figures.push_back(parity_figure(parity, direction));
  return figures;
}

std::vector<report::Figure> residual_figures(const surrogate::Parity& parity) {
  std::vector<report::Figure> figures;
  for (const auto& make : {residual_figure, histogram_figure}) {
    for (const Direction& direction : shown_directions(parity)) {
      report::Figure figure = make(parity, direction);
      if (!figure.plots.empty()) figures.push_back(std::move(figure));
    }
  }
  return figures;
}

std::string percent(const std::optional<double>& share) {
  if (!share) return "-";
  constexpr double no_minus = 0.0;  // -0.04 % is 0.0 %, not -0.0 %
  return fmt::format("{:.1f} %", std::round(1000.0 * *share) / 10.0 + no_minus);
}

std::string number(const std::optional<double>& value, double factor) {
  return value ? fmt::format("{:.3g}", *value * factor) : "-";
}

std::string verdict_text(const surrogate::NoiseVerdict& judged) {
  switch (judged.verdict) {
    case surrogate::Verdict::at_noise_floor:
      return "at the noise floor";
    case surrogate::Verdict::above_noise_floor:
      return fmt::format("{:.2g} times above it", *judged.ratio);
    case surrogate::Verdict::above_in_places:
      return fmt::format("above it in {} case{}", judged.cases_above, judged.cases_above == 1 ? "" : "s");
    case surrogate::Verdict::too_noisy:
      return "data too noisy to tell";
    case surrogate::Verdict::no_scatter_known:
      break;
  }
  return "no scatter known";
}

}  // namespace bitrock::views
