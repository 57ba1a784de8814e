#include "surrogate/net/trained_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace bitrock::surrogate {

namespace {

/// Distance of what is asked from each end of the range, 0 inside.
struct Beyond {
  double below, above;
};

Beyond beyond(const Variable& input, double low, double high) {
  const Bounds bounds = widened_range(input);
  return {low < bounds.low ? input.low - low : 0.0, high > bounds.high ? high - input.high : 0.0};
}

}  // namespace

double beyond_range(const Variable& input, double low, double high) {
  const auto [below, above] = beyond(input, low, high);
  const double farthest = std::max(below, above);
  return farthest == 0.0 ? 0.0 : farthest / (input.high - input.low);
}

std::string beyond_range_in_words(const Variable& input, double low, double high) {
  const double share = beyond_range(input, low, high);
  if (share == 0.0) return "";
  const auto [below, above] = beyond(input, low, high);
  const std::string asked = low == high ? fmt::format("{:.4g}", low) : fmt::format("{:.4g} to {:.4g}", low, high);
  if (!(input.high > input.low)) return fmt::format("{} {} (trained at {:.4g} alone)", input.name, asked, input.low);
  return fmt::format("{} {} (trained {:.4g} to {:.4g}: {:.3g} % of that range {} it)", input.name, asked, input.low,
                     input.high, 100.0 * share, below > above ? "below" : "above");
}

std::string beyond_ranges_in_words(const Model& model, const AskedRanges& asked) {
  std::string text;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::string one = beyond_range_in_words(model.inputs[i], asked[i].low, asked[i].high);
    if (!one.empty()) text += (text.empty() ? "" : "; ") + one;
  }
  return text;
}

void require_finite(const Prediction& prediction, double cut_length, const std::string& source) {
  bool finite = true;
  for (const auto& p : {prediction.x, prediction.y})
    finite = finite && std::isfinite(p.amax + p.amean + (p.np1 + p.np23 + p.np4) * (1.0 + cut_length));
  for (const double moment : prediction.moments) finite = finite && std::isfinite(moment);
  if (finite) return;
  throw base::InputError(
      fmt::format("{}: no finite answer for these conditions (they are too far outside its training range)", source));
}

}  // namespace bitrock::surrogate
