#include "runtime/signal/sawtooth_force.hpp"

#include <algorithm>
#include <limits>

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

/// The number of events that are still felt behind `from`, moved by -`shift`, one after the other from place `kept` on.
std::size_t keep(SawtoothForce& force, const SawtoothBlock* blocks, std::size_t count, double shift, double from,
                 std::size_t kept) {
  for (std::size_t i = 0; i < count; ++i) {
    const SawtoothBlock block = blocks[i];  // what is kept may be written into it
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double peak = block.peak[lane] - shift;
      if (!(block.begin[lane] < never) || !(peak + force.drop > from)) continue;
      SawtoothBlock& to = force.stream.blocks[kept / 4];
      to.begin[kept % 4] = block.begin[lane] - shift;
      to.peak[kept % 4] = peak;
      to.inverse_rise[kept % 4] = block.inverse_rise[lane];
      to.x[kept % 4] = block.x[lane];
      to.y[kept % 4] = block.y[lane];
      ++kept;
    }
  }
  return kept;
}

/// Fills the block of the last event kept; the number of blocks.
std::size_t filled(SawtoothStream& stream, std::size_t kept) {
  for (; kept % 4 != 0; ++kept) {
    SawtoothBlock& block = stream.blocks[kept / 4];
    block.begin[kept % 4] = block.peak[kept % 4] = never;
    block.inverse_rise[kept % 4] = 1.0;
    block.x[kept % 4] = block.y[kept % 4] = 0.0;
  }
  return kept / 4;
}

const SawtoothLaw& law_of(const SawtoothForce& force, std::int64_t window) {
  return force.laws[place_of(window)];
}

/// The events of one cell behind the first `at` blocks; the number of its blocks.
std::size_t draw_behind(SawtoothForce& force, std::int64_t window, std::int64_t cell, std::size_t at) {
  return draw_cell(law_of(force, window), window_word(force.seed, force.cutter, window), cell, force.wide,
                   force.stream.blocks.data() + at);
}

/// Events of before that reach into the cell, from nothing.
std::size_t survivors_anew(SawtoothForce& force, std::int64_t window, std::int64_t cell, double cell_begin) {
  SawtoothBlock* const blocks = force.stream.blocks.data();
  const std::size_t last = draw_behind(force, window - 1, law_of(force, window - 1).cells - 1, 0);
  std::size_t kept = keep(force, blocks, last, force.window_angle, cell_begin, 0);
  if (cell > 0) {
    const std::size_t at = (kept + 3) / 4;
    kept = keep(force, blocks + at, draw_behind(force, window, cell - 1, at), 0.0, cell_begin, kept);
  }
  return kept;
}

void enter_cell(SawtoothForce& force, std::int64_t window, std::int64_t cell) {
  SawtoothStream& stream = force.stream;
  const SawtoothLaw& law = law_of(force, window);
  const double cell_begin = law.cell * static_cast<double>(cell);
  const bool next_cell = stream.window == window && stream.cell == cell - 1;
  const bool next_window = stream.window == window - 1 && cell == 0 && stream.window != no_window &&
                           stream.cell == law_of(force, window - 1).cells - 1;
  const std::size_t kept = next_cell || next_window ? keep(force, stream.blocks.data(), stream.count,
                                                           next_window ? force.window_angle : 0.0, cell_begin, 0)
                                                    : survivors_anew(force, window, cell, cell_begin);
  stream.window = window;
  stream.cell = cell;
  stream.count = filled(stream, kept);
  stream.count += draw_behind(force, window, cell, stream.count);
  double last_end = -infinity;
  for (std::size_t i = 0; i < stream.count; ++i) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (stream.blocks[i].begin[lane] < never) last_end = std::max(last_end, stream.blocks[i].peak[lane] + force.drop);
    }
    stream.last_end[i] = last_end;
  }
}

}  // namespace

void set_up(SawtoothForce& force, const SignalSettings& settings, int cutter, double path_radius, bool wide) {
  force.seed = settings.seed;
  force.cutter = cutter;
  force.wide = wide;
  force.window_angle = settings.window_angle;
  force.drop = drop_angle(settings, path_radius);
  force.laws.fill({.cell = settings.window_angle});
  forget(force);
}

void forget(SawtoothForce& force) {
  force.stream.window = no_window;
  force.stream.count = 0;
}

void follow(SawtoothForce& force, std::int64_t window, double angle, SawtoothReach& reach) {
  const SawtoothStream& stream = force.stream;
  const SawtoothLaw& law = law_of(force, window);
  const std::int64_t cell = cell_at(law, angle);
  if (stream.window != window || stream.cell != cell) {
    enter_cell(force, window, cell);
    reach.first = reach.next = 0;
  } else if (!(reach.after < reach.until) || angle <= reach.after) {
    reach.first = reach.next = 0;
  }
  while (reach.first < stream.count && stream.last_end[reach.first] <= angle) ++reach.first;
  reach.next = std::max(reach.next, reach.first);
  while (reach.next < stream.count && stream.blocks[reach.next].begin[0] < angle) ++reach.next;
  const double edge = cell + 1 < law.cells ? law.cell * static_cast<double>(cell + 1) : infinity;
  reach.until = reach.next < stream.count ? std::min(stream.blocks[reach.next].begin[0], edge) : edge;
  const double begin = cell > 0 ? law.cell * static_cast<double>(cell) : -infinity;
  reach.after = reach.first > 0 ? std::max(stream.last_end[reach.first - 1], begin) : begin;
}

}  // namespace bitrock::runtime
