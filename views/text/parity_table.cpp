#include "views/text/parity_table.hpp"

#include <fmt/format.h>

#include "views/networks/figures.hpp"

namespace bitrock::views {

std::string parity_table(const surrogate::Parity& parity) {
  const surrogate::OutputParity& first = parity.outputs.front();
  std::string table =
      parity.has_held_out
          ? fmt::format(
                "{} cases held out of {}: deviations of the network from the DEM, beside what noise alone gives\n",
                first.held_out.cases, first.all.cases)
          : fmt::format("no case was held out: all {} cases, learnt from, so the network may follow their noise\n",
                        first.all.cases);
  constexpr const char* line =
      "{:<{}} {:<5} {:>8} {:>8} {:>7}  {:>7} {:>7}  {:>7} {:>6}  {:>8} {:>7}  {:>8} {:>8}   {}\n";
  const int width = parity.outputs.size() > surrogate::article_output_count ? 18 : 9;
  table += fmt::format(line, "output", width, "unit", "DEM s.e.", "RMSE", "x s.e.", "network", "(most)", "bias", "(+-)",
                       "mean dev", "(noise)", "max dev", "(noise)", "verdict");
  for (std::size_t k = 0; k < parity.outputs.size(); ++k) {
    const surrogate::OutputParity& output = parity.outputs[k];
    const surrogate::ParitySummary& seen = parity.has_held_out ? output.held_out : output.all;
    const auto [name, unit, factor] = shown(output, k);
    table += fmt::format(line, name, width, unit, number(seen.noise, factor), number(seen.rmse, factor),
                         number(seen.rmse_over_noise), percent_of(output.error, &surrogate::NetworkError::rms),
                         percent_of(output.error, &surrogate::NetworkError::rms_high),
                         percent_of(output.error, &surrogate::NetworkError::bias),
                         percent_of(output.error, &surrogate::NetworkError::bias_chance), percent(seen.mean_deviation),
                         percent_of(seen.noise_alone, &surrogate::NoiseAlone::mean), percent(seen.max_deviation),
                         percent_of(seen.noise_alone, &surrogate::NoiseAlone::max), verdict_text(output.judged));
  }
  return table;
}

}  // namespace bitrock::views
