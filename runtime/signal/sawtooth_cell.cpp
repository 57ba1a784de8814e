#include "runtime/signal/sawtooth_cell.hpp"

namespace bitrock::runtime {

namespace {

/// (n + 1/2) / 2^24 for the 24 bits of each word that begin at `from`.
BITROCK_INTO_BOTH void uniform(const FourWords& words, int from, FourNumbers& result) {
  constexpr std::int64_t mask = 0xffffff, whole = 0x433LL << 52;
  const FourWords bits = ((words >> from) & mask) | whole;  // the last bits of a double of 2^52
  result = ((FourNumbers)bits - (0x1.0p52 - 0.5)) * 0x1.0p-24;
}

BITROCK_INTO_BOTH std::size_t draw(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell,
                                   SawtoothBlock* blocks) {
  constexpr std::int64_t low = 0xffff, whole = 0x433LL << 52;
  const double cell_begin = law.cell * static_cast<double>(cell), cell_end = law.cell * static_cast<double>(cell + 1);
  const double mean_gap = 1.0 / law.density;
  const std::uint64_t first = static_cast<std::uint64_t>(cell) * most_in_cell;
  double begin = cell_begin;
  for (std::size_t block = 0; block < most_cell_blocks; ++block) {
    FourWords words;
    for (std::size_t i = 0; i < 4; ++i)
      words[i] = static_cast<std::int64_t>(base::mix(window_word ^ (first + 4 * block + i)));
    FourNumbers u, v, gap, g;
    uniform(words, 40, u);
    uniform(words, 16, v);
    logarithm(u, gap);
    logarithm(v, g);
    gap *= -mean_gap;
    g = -g;
    g = g < law.highest ? g : law.highest + (g - g);
    const FourNumbers kind = ((FourNumbers)((words & low) | whole) - (0x1.0p52 - 0.5)) * 0x1.0p-16;
    SawtoothBlock& made = blocks[block];
    // sums one after the other: three at once and the last would have other bits
    for (std::size_t i = 0; i < 4; ++i) {
      begin += gap[i];
      made.begin[i] = begin;
    }
    const FourNumbers rise = law.rise * g;
    const FourWords in_cell = made.begin < cell_end;
    const FourWords in_x = (FourWords)(kind < law.x_below) & in_cell;
    const FourWords in_y = ((FourWords)(kind < law.both_below) | ~(FourWords)(kind < law.x_below)) & in_cell;
    made.inverse_rise = 1.0 / rise;
    made.peak = made.begin + rise;
    made.x = (FourNumbers)((FourWords)(law.x_height * g) & in_x);
    made.y = (FourNumbers)((FourWords)(law.y_height * g) & in_y);
    const FourNumbers beyond = never + (g - g);
    made.begin = (FourNumbers)(((FourWords)made.begin & in_cell) | ((FourWords)beyond & ~in_cell));
    made.peak = (FourNumbers)(((FourWords)made.peak & in_cell) | ((FourWords)beyond & ~in_cell));
    if (!(begin < cell_end)) return block + (made.begin[0] < cell_end ? 1 : 0);
  }
  return most_cell_blocks;
}

#ifdef BITROCK_WIDE
BITROCK_WIDE std::size_t draw_by_wide_vectors(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell,
                                              SawtoothBlock* blocks) {
  return draw(law, window_word, cell, blocks);
}
#endif

std::size_t draw_by_any_machine(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell,
                                SawtoothBlock* blocks) {
  return draw(law, window_word, cell, blocks);
}

}  // namespace

std::size_t draw_cell(const SawtoothLaw& law, std::uint64_t window_word, std::int64_t cell, bool wide,
                      SawtoothBlock* blocks) {
  if (!(law.density > 0.0)) return 0;
#ifdef BITROCK_WIDE
  if (wide) return draw_by_wide_vectors(law, window_word, cell, blocks);
#endif
  return draw_by_any_machine(law, window_word, cell, blocks);
}

}  // namespace bitrock::runtime
