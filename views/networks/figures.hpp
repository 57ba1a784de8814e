#pragma once
/// The figures and wordings of network against DEM that terminal, page and pictures for paper share. Numbers come from
/// `surrogate::parity`, drawing is report/'s business; here is only which number goes where.

#include <optional>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "surrogate/train/parity.hpp"

namespace bitrock::views {

/// An output as people read it: "Fx A_max", forces in kN/m.
struct ShownOutput {
  std::string name, unit;
  double factor;  ///< shown = value * factor
};
ShownOutput shown(const surrogate::OutputParity& output, std::size_t index);

/// What the network says against what the DEM gave: five panels for the cutting force x, five for the axial force y.
std::vector<report::Figure> parity_figures(const surrogate::Parity& parity);

/// Residuals over the three inputs and as histograms, each for x and y. Residuals are in units of the standard error by
/// the law of scatter; outputs whose scatter is not known are left out, and a figure without panels too.
std::vector<report::Figure> residual_figures(const surrogate::Parity& parity);

/// "12.3 %" of 0.123, "-" for what cannot be said.
std::string percent(const std::optional<double>& share);
/// The same of one share of several.
template <class Shares>
std::string percent_of(const std::optional<Shares>& shares, double Shares::*member) {
  return percent(shares ? std::optional(*shares.*member) : std::nullopt);
}
/// Three digits, "-" for what cannot be said.
std::string number(const std::optional<double>& value, double factor = 1.0);

/// "at the noise floor", "2.1 times above it", ...
std::string verdict_text(const surrogate::NoiseVerdict& judged);

}  // namespace bitrock::views
