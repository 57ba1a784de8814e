#include "runtime/core/core.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::runtime {

namespace {

/// First of the ten numbers that is not finite, or -1.
int first_not_finite(const Answer& answer) {
  for (std::size_t i = 0; i < answer.size(); ++i) {
    if (!std::isfinite(answer[i])) return static_cast<int>(i);
  }
  return -1;
}

/// Asks the model about every cutter; nothing is changed when an answer is not finite, but for the fault.
bitrock_status ask_for_all(Core& core, double rotation, double rate_of_penetration) {
  ClampTally clamps = core.clamps;
  std::array<surrogate::CutConditions, asked_together> conditions;
  std::array<Answer, asked_together> answers;
  for (std::int64_t first = 0; first < core.cutter_count; first += asked_together) {
    CoreCutter* const asked = cutters(core) + first;
    const int count = static_cast<int>(std::min<std::int64_t>(asked_together, core.cutter_count - first));
    for (int q = 0; q < count; ++q) {
      conditions[q] = cut_conditions(asked[q].force.path_radius, asked[q].back_rake, rotation, rate_of_penetration);
    }
    ask(core.model, parameters(core), conditions.data(), count, answers.data(), clamps);
    for (int q = 0; q < count; ++q) {
      asked[q].answer = answers[q];
      if (const int output = first_not_finite(answers[q]); output >= 0) {
        core.fault_cutter = asked[q].force.cutter;
        core.fault_output = output;
        return BITROCK_BAD_PREDICTION;
      }
    }
  }
  core.clamps = clamps;
  return BITROCK_OK;
}

bitrock_status enter(Core& core, std::int64_t window, double rotation, double rate_of_penetration) {
  CoreCutter* const first = cutters(core);
  const bool drills = cuts(rate_of_penetration);
  // all cutters enter the same windows, so what one has drawn all have
  if (drills && !all_drawn(first->force, window)) {
    if (const bitrock_status status = ask_for_all(core, rotation, rate_of_penetration); status != BITROCK_OK) {
      return status;
    }
  }
  for (CoreCutter* cutter = first; cutter != first + core.cutter_count; ++cutter) {
    enter_window(cutter->force, window, drills ? named(cutter->answer) : CutterStatistics{});
  }
  core.window = window;
  core.window_begin = static_cast<double>(window) * core.signal.window_angle;
  forget_active(core);
  return BITROCK_OK;
}

/// Kept out of the loop below, which seldom needs them.
__attribute__((noinline)) void follow_train(Core& core, std::int64_t i, double angle) {
  follow(active_cutters(core)[i], cutters(core)[i].force.train, angle);
}
__attribute__((noinline)) BothDirections force_of_many(Core& core, std::int64_t i, double angle) {
  const ForcePerMetre force = force_at(cutters(core)[i].force.train, core.signal.combine, angle);
  return BothDirections{force.x, force.y};
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

BITROCK_INTO_BOTH void sum_as_asked(Core& core, double angle, bitrock_load& load) {
  if (core.signal.combine == Combine::sum) {
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
  if (window != core.window) {
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

void forget_active(Core& core) {
  for (std::int64_t i = 0; i < core.cutter_count; ++i) {
    ActiveCutter& cutter = active_cutters(core)[i];
    cutter.until = cutter.after;
  }
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
  DrawTally sum;
  for (std::int64_t i = 0; i < core.cutter_count; ++i) sum.add(cutters(core)[i].force.memory.tally);
  return sum;
}

}  // namespace bitrock::runtime
