#include "runtime/signal/sawtooth_cell.hpp"

#include "runtime/signal/rise_lengths.hpp"

namespace bitrock::runtime {

namespace {

/// (n + 1/2) / 2^bits for that many bits of each word, from `from` on.
template <int bits>
BITROCK_INTO_BOTH void uniform(const FourWords& words, int from, FourNumbers& result) {
  constexpr std::int64_t mask = (1LL << bits) - 1, whole = 0x433LL << 52;
  constexpr double step = 1.0 / static_cast<double>(1LL << bits);
  const FourWords last = ((words >> from) & mask) | whole;  // the last bits of a double of 2^52
  result = ((FourNumbers)last - (0x1.0p52 - 0.5)) * step;
}

BITROCK_INTO_BOTH void draw(const SawtoothLaw& law, const LoadWeights& weights, CellDraw& drawn, DrawnPulses& four) {
  const std::uint64_t first = static_cast<std::uint64_t>(drawn.cell * most_in_cell + drawn.drawn);
  FourWords words;
  for (std::size_t i = 0; i < 4; ++i) {
    words[i] = static_cast<std::int64_t>(base::mix(drawn.window_word ^ (first + i)));
  }
  FourNumbers u, v, t, kind, gap, g, w, begin;
  uniform<20>(words, 44, u);
  uniform<16>(words, 28, v);
  uniform<16>(words, 12, t);
  uniform<12>(words, 0, kind);
  logarithm(u, gap);
  logarithm(v, g);
  const FourNumbers cut = least_unit + (1.0 - least_unit) * t;
  logarithm(cut, w);
  gap *= -law.mean_gap;
  g = -g;
  w = -w;
  // sums one after the other: three at once and the last would have other bits
  for (std::size_t i = 0; i < 4; ++i) {
    drawn.last += gap[i];
    begin[i] = drawn.last;
  }
  four.begin = begin;
  drawn.drawn += 4;

  FourNumbers unit = 1.0 - law.part + law.part * w;
  for (int n = 0; n < law.power; ++n) unit *= w;
  const FourNumbers rise = law.least_rise + law.rise * unit;
  const FourNumbers nothing{}, highest = highest_pulse + nothing;
  const FourNumbers torque = (law.x_height * weights.torque) * g, force = (law.y_height * weights.force) * g;
  const FourWords in_both = kind < law.both_below, in_x = kind < law.x_below;
  PulseBlock& block = four.pulses;
  block.climb = 1.0 / rise;
  block.climb_from = -begin * block.climb;
  block.fall = nothing - law.inverse_drop;
  block.fall_from = 1.0 + (begin + rise) * law.inverse_drop;
  block.torque = (FourNumbers)((FourWords)(torque < highest ? torque : highest) & in_x);
  block.force = (FourNumbers)((FourWords)(force < highest ? force : highest) & (in_both | ~in_x));
}

#ifdef BITROCK_WIDE
BITROCK_WIDE void draw_by_wide_vectors(const SawtoothLaw& law, const LoadWeights& weights, CellDraw& drawn,
                                       DrawnPulses& four) {
  draw(law, weights, drawn, four);
}
#endif

void draw_by_any_machine(const SawtoothLaw& law, const LoadWeights& weights, CellDraw& drawn, DrawnPulses& four) {
  draw(law, weights, drawn, four);
}

}  // namespace

void draw_four(const SawtoothLaw& law, const LoadWeights& weights, [[maybe_unused]] bool wide, CellDraw& drawn,
               DrawnPulses& four) {
#ifdef BITROCK_WIDE
  if (wide) return draw_by_wide_vectors(law, weights, drawn, four);
#endif
  draw_by_any_machine(law, weights, drawn, four);
}

}  // namespace bitrock::runtime
