#include "runtime/signal/felt_pulses.hpp"

#include <algorithm>

namespace bitrock::runtime {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The cell that this angle lies in; below the first edge in the first, above the last in the last.
std::int64_t cell_at(const SawtoothLaw& law, double angle) {
  auto cell = static_cast<std::int64_t>(std::clamp(angle / law.cell, 0.0, static_cast<double>(law.cells - 1)));
  // the quotient is rounded, and the edges are products
  if (cell > 0 && angle < law.cell * static_cast<double>(cell)) --cell;
  if (cell + 1 < law.cells && angle >= law.cell * static_cast<double>(cell + 1)) ++cell;
  return cell;
}

bool is_over(const PulseBlock& block, std::size_t lane, double angle) {
  return !(block.fall[lane] * angle + block.fall_from[lane] > 0.0);
}

/// One bit for each of the four that are over.
BITROCK_INTO_BOTH std::uint64_t over_lanes(const PulseBlock& block, double angle) {
  constexpr FourNumbers zero{};
  constexpr FourWords bits{1, 2, 4, 8};
  const FourWords over = (FourWords)(block.fall * angle + block.fall_from <= zero) & bits;
  return static_cast<std::uint64_t>((over[0] | over[1]) | (over[2] | over[3]));
}

constexpr std::size_t blocks_a_word = 16;

/// One bit for each pulse that was over at the last look, of the blocks from `first` on: at most `blocks_a_word`.
BITROCK_INTO_BOTH std::uint64_t over_word(const FeltPulses& felt, const PulseBlock* blocks, std::size_t first) {
  std::uint64_t lanes = 0;
  const std::size_t end = std::min(felt.count, first + blocks_a_word);
  for (std::size_t i = first; i < end; ++i) lanes |= over_lanes(blocks[i], felt.last) << (4 * (i - first));
  return lanes;
}

#ifdef BITROCK_WIDE
BITROCK_WIDE std::uint64_t over_by_wide_vectors(const FeltPulses& felt, const PulseBlock* blocks, std::size_t first) {
  return over_word(felt, blocks, first);
}
#endif

std::uint64_t over_word(const FeltPulses& felt, const PulseBlock* blocks, std::size_t first,
                        [[maybe_unused]] bool wide) {
#ifdef BITROCK_WIDE
  if (wide) return over_by_wide_vectors(felt, blocks, first);
#endif
  return over_word(felt, blocks, first);
}

/// The pulses of a bit, while some are added: in the places of those that were over at the last look, from the first
/// block on; then behind all others.
struct Gathering {
  FeltPulses& felt;
  PulseBlock* blocks;
  std::size_t most;
  double window_angle;
  bool wide;
  std::size_t first = 0;   ///< block
  std::uint64_t over = 0;  ///< places that are free, four bits for each block from `first` on
};

/// False when there is no room: never, see `most_felt_blocks`.
bool find_place(Gathering& all) {
  while (all.over == 0) {
    if (all.first + blocks_a_word < all.felt.count) {
      all.first += blocks_a_word;
      all.over = over_word(all.felt, all.blocks, all.first, all.wide);
      continue;
    }
    if (all.felt.count == all.most) return false;
    all.first = all.felt.count;
    all.blocks[all.felt.count++] = PulseBlock{};
    all.over = 0xf;
  }
  return true;
}

/// Takes a pulse over.
void add(Gathering& all, const PulseBlock& from, std::size_t lane) {
  if (all.over == 0 && !find_place(all)) return;
  const auto place = static_cast<std::size_t>(__builtin_ctzll(all.over));
  all.over &= all.over - 1;
  PulseBlock& to = all.blocks[all.first + place / 4];
  const std::size_t at = place % 4;
  to.climb[at] = from.climb[lane];
  to.climb_from[at] = from.climb_from[lane];
  to.fall[at] = from.fall[lane];
  to.fall_from[at] = from.fall_from[lane];
  to.torque[at] = from.torque[lane];
  to.force[at] = from.force[lane];
}

/// Angles of these pulses count from the beginning of the next window.
BITROCK_INTO_BOTH void move_to_next_window(PulseBlock& block, double window_angle) {
  block.climb_from += block.climb * window_angle;
  block.fall_from += block.fall * window_angle;
}

/// Where the next pulse of the cell begins; infinite when there is none.
double next_begin(const SawtoothCutter& cutter) {
  const DrawnPulses& four = cutter.four[cutter.now];
  return cutter.lane < 4 && four.begin[cutter.lane] < cutter.draw.end ? four.begin[cutter.lane] : infinity;
}

/// The next pulse is the first of the other four; those that come then are drawn now, so that nothing waits for them.
void take_next_four(SawtoothCutter& cutter, const SawtoothLaw& law) {
  draw_four(law, cutter.weights, cutter.wide, cutter.draw, cutter.four[cutter.now]);
  cutter.now = 1 - cutter.now;
  cutter.lane = 0;
}

/// Goes on to the next pulse.
void step(SawtoothCutter& cutter, const SawtoothLaw& law) {
  ++cutter.lane;
  if (cutter.lane == 4 && cutter.draw.drawn < most_in_cell + 4) take_next_four(cutter, law);
}

/// Where the next pulse is, or the end of the cell; the last cell of a window does not end.
void look(SawtoothCutter& cutter, const SawtoothLaw& law) {
  const bool last_cell = cutter.draw.cell + 1 == law.cells;
  const double begin = next_begin(cutter);
  cutter.next = begin < infinity || last_cell ? begin : cutter.draw.end;
}

void start_cell(SawtoothCutter& cutter, std::int64_t window, std::int64_t cell) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  cutter.draw = cell_draw(law, window_word(cutter.seed, cutter.number, window), cell);
  cutter.lane = 4;
  if (law.density > 0.0) {
    draw_four(law, cutter.weights, cutter.wide, cutter.draw, cutter.four[1 - cutter.now]);
    take_next_four(cutter, law);
  }
  look(cutter, law);
}

/// Adds what begins up to `angle`.
void go_on(Gathering& all, SawtoothCutter& cutter, std::int64_t window, double angle) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  while (cutter.next <= angle) {
    for (; next_begin(cutter) <= angle; step(cutter, law)) add(all, cutter.four[cutter.now].pulses, cutter.lane);
    look(cutter, law);
    if (cutter.next <= angle) start_cell(cutter, window, cutter.draw.cell + 1);
  }
}

/// Adds the pulses of one whole cell that are felt at `angle`, both from the beginning of `window`.
void add_felt(Gathering& all, SawtoothCutter& cutter, std::int64_t window, std::int64_t cell, double angle) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  start_cell(cutter, window, cell);
  for (; next_begin(cutter) <= angle; step(cutter, law)) {
    if (!is_over(cutter.four[cutter.now].pulses, cutter.lane, angle))
      add(all, cutter.four[cutter.now].pulses, cutter.lane);
  }
  look(cutter, law);
}

/// So far ahead that `added_together` pulses of the bit begin, in the mean.
double ahead(std::span<const SawtoothCutter> cutters, std::int64_t window) {
  double density = 0.0;
  for (const SawtoothCutter& cutter : cutters) density += cutter.laws[place_of(window)].density;
  return std::min(added_together / density, std::numeric_limits<double>::max());  // where nothing comes
}

/// All pulses felt at an angle, from nothing.
void begin_anew(Gathering& all, std::span<SawtoothCutter> cutters, std::int64_t window, double angle) {
  all.felt = {.window = window, .from = angle, .last = angle, .ahead = ahead(cutters, window)};
  for (SawtoothCutter& cutter : cutters) {
    const SawtoothLaw& before = cutter.laws[place_of(window - 1)];
    add_felt(all, cutter, window - 1, before.cells - 1, angle + all.window_angle);
  }
  for (std::size_t i = 0; i < all.felt.count; ++i) move_to_next_window(all.blocks[i], all.window_angle);
  for (SawtoothCutter& cutter : cutters) {
    const std::int64_t cell = cell_at(cutter.laws[place_of(window)], angle);
    if (cell > 0) add_felt(all, cutter, window, cell - 1, angle);
    add_felt(all, cutter, window, cell, angle);
  }
}

/// From the window before to this one.
void next_window(Gathering& all, std::span<SawtoothCutter> cutters) {
  FeltPulses& felt = all.felt;
  for (SawtoothCutter& cutter : cutters) go_on(all, cutter, felt.window, std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < felt.count; ++i) move_to_next_window(all.blocks[i], all.window_angle);
  felt.from -= all.window_angle;
  felt.last -= all.window_angle;
  ++felt.window;
  felt.ahead = ahead(cutters, felt.window);
  for (SawtoothCutter& cutter : cutters) start_cell(cutter, felt.window, 0);
}

/// Whether the angle is so near that the cutters can be taken there cell by cell.
bool is_near(const FeltPulses& felt, std::span<const SawtoothCutter> cutters, std::int64_t window, double angle,
             double window_angle) {
  const bool next = window - 1 == felt.window;
  if (felt.window == no_window || (window != felt.window && !next)) return false;
  const double from_begin = next ? angle + window_angle : angle;  // of `felt.window`
  if (!(from_begin >= felt.from)) return false;
  for (const SawtoothCutter& cutter : cutters) {
    const double cell = cutter.laws[place_of(felt.window)].cell;
    if (from_begin >= cell * static_cast<double>(cutter.draw.cell + 2)) return false;
  }
  return true;
}

/// What is behind all that is felt need not be looked at.
void shorten(FeltPulses& felt, const PulseBlock* blocks) {
  while (felt.count > 0 && over_lanes(blocks[felt.count - 1], felt.last) == 0xf) --felt.count;
}

}  // namespace

void follow(FeltPulses& felt, PulseBlock* blocks, std::span<SawtoothCutter> cutters, double window_angle,
            std::int64_t window, double angle) {
  Gathering all{.felt = felt,
                .blocks = blocks,
                .most = most_felt_blocks(cutters.size()),
                .window_angle = window_angle,
                .wide = cutters.front().wide};
  if (!is_near(felt, cutters, window, angle, window_angle)) {
    begin_anew(all, cutters, window, angle);
  } else {
    all.over = over_word(felt, blocks, 0, all.wide);
    if (felt.window != window) next_window(all, cutters);
    felt.from = std::max(felt.from, felt.last);
  }
  felt.until = angle + felt.ahead;
  for (SawtoothCutter& cutter : cutters) go_on(all, cutter, window, felt.until);
  shorten(felt, blocks);
}

}  // namespace bitrock::runtime
