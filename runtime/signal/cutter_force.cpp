#include "runtime/signal/cutter_force.hpp"

#include <limits>

namespace runtime {

namespace {

constexpr std::int64_t nothing_kept = std::numeric_limits<std::int64_t>::min();

static_assert((windows_kept & (windows_kept - 1)) == 0, "place_of masks");

std::size_t place_of(std::int64_t window) {
  return static_cast<std::size_t>(window & (windows_kept - 1));
}

void count(DrawTally& tally, const ComponentDraw& drawn) {
  tally.drawn += drawn.counts.total() > 0 ? 1 : 0;
  tally.mean_missed += drawn.fit.mean_missed ? 1 : 0;
  tally.band_left += drawn.fit.band_left ? 1 : 0;
  tally.narrowed += drawn.narrowed ? 1 : 0;
  tally.capped += drawn.counts.capped ? 1 : 0;
}

}  // namespace

void DrawTally::add(const DrawTally& other) {
  drawn += other.drawn;
  mean_missed += other.mean_missed;
  band_left += other.band_left;
  narrowed += other.narrowed;
  capped += other.capped;
}

CutterForce make_cutter_force(const SignalSettings& settings, int cutter, double path_radius) {
  CutterForce force;
  force.settings = settings;
  force.cutter = cutter;
  force.path_radius = path_radius;
  force.train = make_pulse_train(3 * largest_peak_count);
  for (PeakWindow& window : force.windows) window = empty_window();
  force.kept.fill(nothing_kept);
  return force;
}

void enter_window(CutterForce& cutter, std::int64_t window, const CutterStatistics& statistics) {
  const CutterStatistics latched{.x = usable(statistics.x, cutter.cutter), .y = usable(statistics.y, cutter.cutter)};
  for (std::int64_t k = window - 1; k <= window + 1; ++k) {
    const std::size_t place = place_of(k);
    if (cutter.kept[place] == k) continue;
    draw_window(cutter.windows[place], latched, cutter.path_radius, cutter.settings,
                {.seed = cutter.settings.seed, .cutter = cutter.cutter, .window = k});
    cutter.kept[place] = k;
    count(cutter.tally, cutter.windows[place].x);
    count(cutter.tally, cutter.windows[place].y);
  }
  cutter.train.pulses.clear();
  const double window_angle = cutter.settings.window_angle;
  for (int step : {-1, 0, 1}) {
    put_pulses(cutter.windows[place_of(window + step)], step * window_angle, window_angle, cutter.train);
  }
  restart(cutter.train);
}

}  // namespace runtime
