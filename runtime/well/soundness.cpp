#include "runtime/well/soundness.hpp"

#include <cmath>
#include <numbers>

namespace bitrock::runtime {

namespace {

constexpr double most_turned = 0.95 * std::numbers::pi;  // [rad] between neighbours

}  // namespace

std::optional<Unsound> unsound(const WellString& string, const WellStringState& state) {
  const Columns& columns = state.columns;
  for (std::size_t i = 0; i < state.count; ++i) {
    if (!is_finite(vector_at(columns, position, i)) || !is_finite(vector_at(columns, rate, i)))
      return Unsound{.finite = false, .segment = i};
    if (i + 1 == state.count && string.upper_end != UpperEnd::clamped) break;
    Rotation a, b;
    take(columns, frame, columns.place_of(i + 1), a);
    take(columns, frame, columns.place_of(i), b);
    const double cosine = std::abs((conjugate(a) * b).w);
    if (cosine < std::cos(0.5 * most_turned)) return Unsound{.segment = i};
  }
  return std::nullopt;
}

}  // namespace bitrock::runtime
