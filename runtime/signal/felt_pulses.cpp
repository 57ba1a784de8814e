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

constexpr std::size_t blocks_a_word = 16;

/// One bit for each pulse that was over at the last look, of the blocks from `first` on: at most `blocks_a_word`.
std::uint64_t over_lanes(const FeltPulses& felt, const PulseBlock* blocks, std::size_t first) {
  std::uint64_t lanes = 0;
  const std::size_t end = std::min(felt.count, first + blocks_a_word);
  for (std::size_t i = first; i < end; ++i) {
    std::uint64_t four = 0;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      four |= static_cast<std::uint64_t>(is_over(blocks[i], lane, felt.last)) << lane;
    }
    lanes |= four << (4 * (i - first));
  }
  return lanes;
}

/// The pulses of a bit, while some are added: in the places of those that were over at the last look, from the first
/// block on; then behind all others.
struct Gathering {
  FeltPulses& felt;
  PulseBlock* blocks;
  std::size_t most;
  double window_angle;
  std::size_t first = 0;   ///< block
  std::uint64_t over = 0;  ///< places that are free, four bits for each block from `first` on
};

/// False when there is no room: never, see `most_felt_blocks`.
bool find_place(Gathering& all) {
  while (all.over == 0) {
    if (all.first + blocks_a_word < all.felt.count) {
      all.first += blocks_a_word;
      all.over = over_lanes(all.felt, all.blocks, all.first);
      continue;
    }
    if (all.felt.count == all.most) return false;
    all.first = all.felt.count;
    all.blocks[all.felt.count++] = PulseBlock{};
    all.over = 0xf;
  }
  return true;
}

/// Takes a pulse over that began so many windows before `felt.window`: none or one.
void add(Gathering& all, const PulseBlock& from, std::size_t lane, double windows_before) {
  if (all.over == 0 && !find_place(all)) return;
  const auto place = static_cast<std::size_t>(__builtin_ctzll(all.over));
  all.over &= all.over - 1;
  PulseBlock& to = all.blocks[all.first + place / 4];
  const std::size_t at = place % 4;
  const double shift = windows_before * all.window_angle;
  to.climb[at] = from.climb[lane];
  to.climb_from[at] = from.climb_from[lane] + from.climb[lane] * shift;
  to.fall[at] = from.fall[lane];
  to.fall_from[at] = from.fall_from[lane] + from.fall[lane] * shift;
  to.torque[at] = from.torque[lane];
  to.force[at] = from.force[lane];
}

bool at_pulse(const SawtoothCutter& cutter) {
  return cutter.lane < 4 && cutter.four[cutter.now].begin[cutter.lane] < cutter.draw.end;
}

/// Where the next pulse is, or the end of the cell; the last cell of a window does not end.
void look(SawtoothCutter& cutter, const SawtoothLaw& law) {
  if (cutter.lane == 4 && cutter.undrawn > 0) {
    // those that come then are drawn now, so that nothing waits for them
    draw_four(law, cutter.weights, cutter.wide, cutter.draw, cutter.four[cutter.now]);
    cutter.now = 1 - cutter.now;
    cutter.lane = 0;
    cutter.undrawn -= 4;
  }
  const bool last_cell = cutter.draw.cell + 1 == law.cells;
  cutter.next = at_pulse(cutter) ? cutter.four[cutter.now].begin[cutter.lane] : last_cell ? infinity : cutter.draw.end;
}

void start_cell(SawtoothCutter& cutter, std::int64_t window, std::int64_t cell) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  cutter.draw = cell_draw(law, window_word(cutter.seed, cutter.number, window), cell);
  cutter.lane = 4;
  cutter.undrawn = law.density > 0.0 ? most_in_cell : 0;
  if (cutter.undrawn > 0) draw_four(law, cutter.weights, cutter.wide, cutter.draw, cutter.four[1 - cutter.now]);
  look(cutter, law);
}

/// Adds what begins up to `angle`.
void go_on(Gathering& all, SawtoothCutter& cutter, std::int64_t window, double angle) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  while (cutter.next <= angle) {
    if (at_pulse(cutter)) {
      add(all, cutter.four[cutter.now].pulses, cutter.lane, 0.0);
      ++cutter.lane;
      look(cutter, law);
    } else {
      start_cell(cutter, window, cutter.draw.cell + 1);
    }
  }
}

/// Adds the pulses of one whole cell that are felt at `angle` of the window `felt.window`.
void add_felt(Gathering& all, SawtoothCutter& cutter, std::int64_t window, std::int64_t cell, double angle) {
  const SawtoothLaw& law = cutter.laws[place_of(window)];
  const double before = window == all.felt.window ? 0.0 : 1.0;
  for (start_cell(cutter, window, cell); at_pulse(cutter) && cutter.next <= angle + before * all.window_angle;
       look(cutter, law)) {
    if (!is_over(cutter.four[cutter.now].pulses, cutter.lane, angle + before * all.window_angle)) {
      add(all, cutter.four[cutter.now].pulses, cutter.lane, before);
    }
    ++cutter.lane;
  }
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
  all.first = 0;
  all.over = 0;
  for (SawtoothCutter& cutter : cutters) {
    const SawtoothLaw& before = cutter.laws[place_of(window - 1)];
    add_felt(all, cutter, window - 1, before.cells - 1, angle);
    const std::int64_t cell = cell_at(cutter.laws[place_of(window)], angle);
    if (cell > 0) add_felt(all, cutter, window, cell - 1, angle);
    add_felt(all, cutter, window, cell, angle);
  }
}

/// From the window before to this one.
void next_window(Gathering& all, std::span<SawtoothCutter> cutters) {
  FeltPulses& felt = all.felt;
  for (SawtoothCutter& cutter : cutters) go_on(all, cutter, felt.window, std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < felt.count; ++i) {
    all.blocks[i].climb_from += all.blocks[i].climb * all.window_angle;
    all.blocks[i].fall_from += all.blocks[i].fall * all.window_angle;
  }
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
  while (felt.count > 0 && over_lanes(felt, blocks, felt.count - 1) == 0xf) --felt.count;
}

}  // namespace

void follow(FeltPulses& felt, PulseBlock* blocks, std::span<SawtoothCutter> cutters, double window_angle,
            std::int64_t window, double angle) {
  Gathering all{felt, blocks, most_felt_blocks(cutters.size()), window_angle, 0, over_lanes(felt, blocks, 0)};
  if (!is_near(felt, cutters, window, angle, window_angle)) {
    begin_anew(all, cutters, window, angle);
  } else {
    if (felt.window != window) next_window(all, cutters);
    felt.from = std::max(felt.from, felt.last);
  }
  felt.until = std::min(angle + felt.ahead, std::numeric_limits<double>::max());
  for (SawtoothCutter& cutter : cutters) go_on(all, cutter, window, felt.until);
  shorten(felt, blocks);
}

}  // namespace bitrock::runtime
