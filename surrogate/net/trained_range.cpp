#include "surrogate/net/trained_range.hpp"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace bitrock::surrogate
