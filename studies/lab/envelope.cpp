#include "studies/lab/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace bitrock::studies {

Envelope fit_envelope(const std::vector<const dem2d::LabRun*>& runs) {
  const auto count = static_cast<double>(runs.size());
  double pressure = 0.0, strength = 0.0;  // means
  for (const dem2d::LabRun* run : runs) {
    pressure += run->confining_pressure / count;
    strength += (run->confining_pressure + run->peak_stress) / count;
  }
  double squares = 0.0, products = 0.0;
  for (const dem2d::LabRun* run : runs) {
    const double dp = run->confining_pressure - pressure;
    squares += dp * dp;
    products += dp * (run->confining_pressure + run->peak_stress - strength);
  }
  const double k = products / squares, at_zero = strength - k * pressure;
  return {.strength_at_zero = at_zero,
          .slope = k,
          .friction_angle = k > 1.0 ? std::asin((k - 1.0) / (k + 1.0)) : std::nan(""),
          .cohesion = k > 1.0 ? at_zero / (2.0 * std::sqrt(k)) : std::nan("")};
}

base::Summary EnvelopeOfSeeds::of(double Envelope::*member) const {
  std::vector<double> values;
  values.reserve(lines.size());
  for (const Envelope& line : lines) values.push_back(line.*member);
  return base::summarise(values);
}

EnvelopeOfSeeds envelope_of(const std::vector<dem2d::LabRun>& runs) {
  std::map<std::uint64_t, std::vector<const dem2d::LabRun*>> by_seed;
  for (const dem2d::LabRun& run : runs) by_seed[run.seed].push_back(&run);
  EnvelopeOfSeeds envelope;
  for (const auto& [seed, tests] : by_seed) {
    const auto other_pressure = [first = tests.front()->confining_pressure](const dem2d::LabRun* run) {
      return run->confining_pressure != first;
    };
    if (std::none_of(tests.begin(), tests.end(), other_pressure)) continue;
    envelope.seeds.push_back(seed);
    envelope.lines.push_back(fit_envelope(tests));
  }
  return envelope;
}

}  // namespace bitrock::studies
