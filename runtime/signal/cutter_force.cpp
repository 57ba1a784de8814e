#include "runtime/signal/cutter_force.hpp"

namespace bitrock::runtime {

namespace {

static_assert(most_pulses <= std::numeric_limits<std::uint16_t>::max(), "places of active pulses");

void count(DrawTally& tally, const ComponentDraw& drawn) {
  tally.drawn += drawn.counts.total() > 0 ? 1 : 0;
  tally.mean_missed += drawn.fit.mean_missed ? 1 : 0;
  tally.band_left += drawn.fit.band_left ? 1 : 0;
  tally.narrowed += drawn.narrowed ? 1 : 0;
  tally.capped += drawn.counts.capped ? 1 : 0;
}

/// What the memory says of this place, drawn.
void draw_place(CutterForce& cutter, std::size_t place) {
  draw_window(cutter.windows[place], cutter.memory.statistics[place], cutter.path_radius, cutter.settings,
              {.seed = cutter.settings.seed, .cutter = cutter.cutter, .window = cutter.memory.kept[place]});
}

/// The pulses that can be felt in the window entered last.
void gather(CutterForce& cutter) {
  cutter.train.pulses.clear();
  const double window_angle = cutter.settings.window_angle;
  for (const int step : {-1, 0, 1}) {
    put_pulses(cutter.windows[place_of(cutter.memory.entered + step)], step * window_angle, window_angle, cutter.train);
  }
  restart(cutter.train);
}

}  // namespace

void DrawTally::add(const DrawTally& other) {
  drawn += other.drawn;
  mean_missed += other.mean_missed;
  band_left += other.band_left;
  narrowed += other.narrowed;
  capped += other.capped;
  length_clamped += other.length_clamped;
  correlation_clamped += other.correlation_clamped;
}

void set_up(CutterForce& force, const SignalSettings& settings, int cutter, double path_radius) {
  force.settings = settings;
  force.cutter = cutter;
  force.path_radius = path_radius;
  force.memory = {};
  force.memory.kept.fill(no_window);
  for (PeakWindow& window : force.windows) window.peaks.clear();
  force.train.pulses.clear();
  restart(force.train);
}

CutterStatistics latched(const CutterStatistics& statistics) {
  return {.x = usable(statistics.x),
          .y = usable(statistics.y),
          .x_width = statistics.x_width,
          .y_width = statistics.y_width};
}

void enter_window(CutterForce& cutter, std::int64_t window, const CutterStatistics& statistics) {
  for (std::int64_t k = window - 1; k <= window + 1; ++k) {
    const std::size_t place = place_of(k);
    if (cutter.memory.kept[place] == k) continue;
    cutter.memory.kept[place] = k;
    cutter.memory.statistics[place] = latched(statistics);
    draw_place(cutter, place);
    count(cutter.memory.tally, cutter.windows[place].x);
    count(cutter.memory.tally, cutter.windows[place].y);
  }
  cutter.memory.entered = window;
  gather(cutter);
}

void restore(CutterForce& cutter, const CutterMemory& memory) {
  const CutterMemory before = cutter.memory;
  cutter.memory = memory;
  bool changed = memory.entered != before.entered;
  for (std::size_t place = 0; place < windows_kept; ++place) {
    const bool same = memory.kept[place] == before.kept[place] && memory.statistics[place] == before.statistics[place];
    if (same) continue;
    changed = true;
    if (memory.kept[place] != no_window) draw_place(cutter, place);
  }
  if (changed && memory.entered != no_window) gather(cutter);
}

}  // namespace bitrock::runtime
