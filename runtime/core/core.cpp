#include "runtime/core/core.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace bitrock::runtime {

namespace {

/// First of the numbers that is not finite, or -1.
int first_not_finite(const Answer& answer) {
  for (std::size_t i = 0; i < answer.size(); ++i) {
    if (!std::isfinite(answer[i])) return static_cast<int>(i);
  }
  return -1;
}

/// Asks the model about every cutter; nothing is changed when an answer is not finite, but for the fault.
bitrock_status ask_for_all(Core& core, double rotation, double rate_of_penetration, ClampTally& clamps) {
  ClampTally counted = clamps;
  std::array<surrogate::CutConditions, asked_together> conditions;
  std::array<Answer, asked_together> answers;
  for (std::int64_t first = 0; first < core.cutter_count; first += asked_together) {
    CoreCutter* const asked = cutters(core) + first;
    const int count = static_cast<int>(std::min<std::int64_t>(asked_together, core.cutter_count - first));
    for (int q = 0; q < count; ++q) {
      conditions[q] = cut_conditions(asked[q].path_radius, asked[q].back_rake, rotation, rate_of_penetration);
    }
    ask(core.model, parameters(core), core.signal.mode, conditions.data(), count, answers.data(), counted);
    for (int q = 0; q < count; ++q) {
      asked[q].answer = answers[q];
      if (const int output = first_not_finite(answers[q]); output >= 0) {
        core.fault_cutter = asked[q].number;
        core.fault_output = output;
        return BITROCK_BAD_PREDICTION;
      }
    }
  }
  clamps = counted;
  return BITROCK_OK;
}

/// What the cutter's peaks are drawn with.
CutterStatistics statistics_of(const Core& core, const CoreCutter& cutter) {
  const bool with_means = core.signal.mode == SignalMode::article && has_moments(core.model);
  return with_means ? named_with_means(cutter.answer) : named(cutter.answer);
}

bool all_kept(const Core& core, std::int64_t window) {
  for (std::int64_t k = window - 1; k <= window + windows_ahead(core); ++k) {
    if (core.windows.kept[place_of(k)] != k) return false;
  }
  return true;
}

void draw_laws(Core& core, std::size_t place, bool drills, DrawTally& tally) {
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    const CoreCutter& cutter = cutters(core)[i];
    const ForceMoments wanted = drills ? moments(cutter.answer) : ForceMoments{};
    sawtooth_cutters(core)[i].laws[place] = sawtooth_law(wanted, core.signal, cutter.path_radius, tally);
  }
}

bitrock_status enter(Core& core, std::int64_t window, double rotation, double rate_of_penetration) {
  const bool drills = cuts(rate_of_penetration);
  if (drills && !all_kept(core, window)) {
    if (const bitrock_status status = ask_for_all(core, rotation, rate_of_penetration, core.clamps);
        status != BITROCK_OK) {
      return status;
    }
  }
  for (std::int64_t k = window - 1; k <= window + windows_ahead(core); ++k) {
    const std::size_t place = place_of(k);
    if (core.windows.kept[place] == k) continue;
    core.windows.kept[place] = k;
    core.windows.rotation[place] = rotation;
    core.windows.rate_of_penetration[place] = rate_of_penetration;
    if (is_sawtooth(core)) draw_laws(core, place, drills, core.draws);
  }
  for (std::int64_t i = 0; i < core.cutter_count && !is_sawtooth(core); ++i) {
    enter_window(cutter_forces(core)[i], window, drills ? statistics_of(core, cutters(core)[i]) : CutterStatistics{});
  }
  set_window(core, window);
  return BITROCK_OK;
}

/// Kept out of the loops below, which seldom need them.
__attribute__((noinline)) void follow_train(Core& core, std::int64_t i, double angle) {
  follow(active_cutters(core)[i], cutter_forces(core)[i].train, angle);
}
__attribute__((noinline)) BothDirections force_of_many(Core& core, std::int64_t i, double angle) {
  const ForcePerMetre force = force_at(cutter_forces(core)[i].train, core.signal.combine, angle);
  return BothDirections{force.x, force.y};
}
__attribute__((noinline)) void follow_pulses(Core& core, double angle) {
  const std::span list(sawtooth_cutters(core), static_cast<std::size_t>(core.cutter_count));
  follow(core.felt, pulse_blocks(core), list, core.signal.window_angle, core.windows.entered, angle);
}

template <Combine combine>
BITROCK_INTO_BOTH void sum_of_cutters(Core& core, double angle, bitrock_load& load) {
  BothDirections sum{};
  ActiveCutter* const active = active_cutters(core);
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    ActiveCutter& cutter = active[i];
    if (!(angle > cutter.after && angle < cutter.until)) follow_train(core, i, angle);
    BothDirections force{};
    take<combine>(force, cutter.pairs[0], angle);
    if (cutter.count > 2) {
      for (std::size_t pair = 1; 2 * pair < cutter.count && pair < cutter.pairs.size(); ++pair) {
        take<combine>(force, cutter.pairs[pair], angle);
      }
      if (cutter.count > most_active) force = force_of_many(core, i, angle);
    }
    sum += cutter.weight * force;
  }
  load = {.axial_force_N = sum[1], .torque_N_m = sum[0]};
}

BITROCK_INTO_BOTH void sum_of_pulses(Core& core, double angle, bitrock_load& load) {
  if (!(angle >= core.felt.from && angle < core.felt.until)) follow_pulses(core, angle);
  core.felt.last = angle;
  add_up(pulse_blocks(core), core.felt.count, angle, load.torque_N_m, load.axial_force_N);
}

BITROCK_INTO_BOTH void sum_as_asked(Core& core, double angle, bitrock_load& load) {
  if (is_sawtooth(core)) {
    sum_of_pulses(core, angle, load);
  } else if (core.signal.combine == Combine::sum) {
    sum_of_cutters<Combine::sum>(core, angle, load);
  } else {
    sum_of_cutters<Combine::max>(core, angle, load);
  }
}

#ifdef BITROCK_WIDE
BITROCK_WIDE void sum_by_wide_vectors(Core& core, double angle, bitrock_load& load) {
  sum_as_asked(core, angle, load);
}
#endif

void sum_by_any_machine(Core& core, double angle, bitrock_load& load) {
  sum_as_asked(core, angle, load);
}

}  // namespace

bitrock_status update(Core& core, double angle, double rotation, double rate_of_penetration, bitrock_load& load) {
  if (!std::isfinite(angle) || !std::isfinite(rotation) || !std::isfinite(rate_of_penetration)) {
    return BITROCK_NOT_FINITE;
  }
  const double place = angle / core.signal.window_angle;
  if (!(std::fabs(place) < most_windows)) return BITROCK_ANGLE_TOO_LARGE;
  std::int64_t window = static_cast<std::int64_t>(place);  // towards 0; the next line makes it the floor
  if (static_cast<double>(window) > place) --window;
  if (window != core.windows.entered) {
    if (const bitrock_status status = enter(core, window, rotation, rate_of_penetration); status != BITROCK_OK) {
      return status;
    }
  }

  const double from_begin = angle - core.window_begin;
#ifdef BITROCK_WIDE
  if (core.wide) {
    sum_by_wide_vectors(core, from_begin, load);
    return BITROCK_OK;
  }
#endif
  sum_by_any_machine(core, from_begin, load);
  return BITROCK_OK;
}

void set_window(Core& core, std::int64_t window) {
  core.windows.entered = window;
  core.window_begin = window == no_window ? 0.0 : static_cast<double>(window) * core.signal.window_angle;
  core.felt.until = core.felt.from;
  for (std::int64_t i = 0; i < core.cutter_count && !is_sawtooth(core); ++i) {
    ActiveCutter& cutter = active_cutters(core)[i];
    cutter.until = cutter.after;
  }
}

bool go_to(Core& core, const WindowMemory& windows) {
  const WindowMemory before = core.windows;
  std::array<std::size_t, windows_kept> changed{};
  std::size_t count = 0;
  for (std::size_t place = 0; place < windows_kept; ++place) {
    const bool same = windows.kept[place] == before.kept[place] && windows.rotation[place] == before.rotation[place] &&
                      windows.rate_of_penetration[place] == before.rate_of_penetration[place];
    if (!same) changed[count++] = place;
  }
  if (count == 0 && windows.entered == before.entered) return true;  // what is felt is right, too
  ClampTally none;
  const auto asked = [&](std::size_t place) {
    return !cuts(windows.rate_of_penetration[place]) ||
           ask_for_all(core, windows.rotation[place], windows.rate_of_penetration[place], none) == BITROCK_OK;
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!asked(changed[i])) return false;
  }
  core.windows = windows;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = changed[i];
    if (count > 1 && !asked(place)) return false;  // it answered above
    const bool drills = cuts(windows.rate_of_penetration[place]);
    DrawTally counted_before;
    if (is_sawtooth(core)) draw_laws(core, place, drills, counted_before);
    for (std::int64_t k = 0; k < core.cutter_count && !is_sawtooth(core); ++k) {
      CutterMemory memory = cutter_forces(core)[k].memory;
      memory.kept[place] = windows.kept[place];
      memory.statistics[place] = latched(drills ? statistics_of(core, cutters(core)[k]) : CutterStatistics{});
      restore(cutter_forces(core)[k], memory);
    }
  }
  if (count > 0) forget(core.felt);
  for (std::int64_t k = 0; k < core.cutter_count && !is_sawtooth(core); ++k) {
    CutterMemory memory = cutter_forces(core)[k].memory;
    memory.entered = windows.entered;
    restore(cutter_forces(core)[k], memory);
  }
  set_window(core, windows.entered);
  return true;
}

bool has_wide_vectors() {
#ifdef BITROCK_WIDE
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

DrawTally draws(const Core& core) {
  DrawTally sum = core.draws;
  for (std::int64_t i = 0; i < core.cutter_count && !is_sawtooth(core); ++i)
    sum.add(cutter_forces(core)[i].memory.tally);
  return sum;
}

void set_draws(Core& core, const DrawTally& draws) {
  core.draws = draws;
  for (std::int64_t i = 0; i < core.cutter_count && !is_sawtooth(core); ++i) cutter_forces(core)[i].memory.tally = {};
}

}  // namespace bitrock::runtime
