#include "studies/well/fatigue_of_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/units.hpp"
#include "peaks/rainflow.hpp"
#include "studies/well/fatigue.hpp"

namespace bitrock::studies {

namespace {

constexpr double seconds_per_hour = 3600.0;
constexpr double counted_range = 0.01;  // of the largest: smaller cycles are noise, and do no damage

struct Cycle {
  double range, mean, number;
};

std::vector<Cycle> cycles_in(std::span<const double> stress) {
  std::vector<Cycle> cycles;
  peaks::Rainflow rainflow([&cycles](double range, double mean, double number) {
    cycles.push_back({range, mean, number});
  });
  for (const double value : stress) rainflow.add(value);
  rainflow.finish();
  return cycles;
}

}  // namespace

PointDamage damage_of_history(const std::string& name, double measured_depth, std::span<const double> stress,
                              double hours, const FatigueWish& wish) {
  PointDamage result{.name = name, .measured_depth = measured_depth};
  for (const double value : stress) result.mean += value / static_cast<double>(stress.size());
  const std::vector<Cycle> cycles = cycles_in(stress);
  for (const Cycle& cycle : cycles) result.largest_range = std::max(result.largest_range, cycle.range);
  for (const Cycle& cycle : cycles) {
    const double range = goodman_range(cycle.range, cycle.mean, wish.tensile_strength);
    if (!std::isfinite(range)) {
      throw base::SimulationError(
          fmt::format("{} at {:.1f} m: a cycle about {:.0f} MPa (the mean stress alone reaches the tensile strength of "
                      "{:.0f} MPa)",
                      name, measured_depth, cycle.mean / base::MPa, wish.tensile_strength / base::MPa));
    }
    result.damage_per_hour += cycle.number / cycles_to_failure(wish.curve, range) / hours;
    if (cycle.range > counted_range * result.largest_range) result.cycles_per_hour += cycle.number / hours;
  }
  result.hours_to_failure = 1.0 / result.damage_per_hour;
  return result;
}

CountedTime counted_time(const runtime::StressHistories& run, const FatigueWish& wish, const std::string& file) {
  const double from = wish.from < 0.0 ? run.settling : wish.from;
  const auto first = std::lower_bound(run.time.begin(), run.time.end(), from);
  const auto last = std::upper_bound(first, run.time.end(), wish.to);
  const auto count = static_cast<std::size_t>(last - first);
  if (count < 3) {
    throw base::InputError(fmt::format("{}: {} samples from {:g} s to {:g} s (a cycle needs 3; the run ends at {:g} s)",
                                       file, count, from, std::min(wish.to, run.time.back()), run.time.back()));
  }
  const auto begin = static_cast<std::size_t>(first - run.time.begin());
  return {.begin = begin, .count = count, .hours = (run.time[begin + count - 1] - run.time[begin]) / seconds_per_hour};
}

std::vector<PointDamage> damage_of(const runtime::StressHistories& run, const FatigueWish& wish,
                                   const std::string& file) {
  if (run.points.empty())
    throw base::InputError(file + ": the run has no stress points (give the case some: [[stress_point]])");
  const CountedTime time = counted_time(run, wish, file);
  std::vector<PointDamage> damages;
  damages.reserve(run.points.size());
  for (const runtime::StressHistory& point : run.points)
    damages.push_back(damage_of_history(point.name, point.measured_depth,
                                        std::span(point.stress).subspan(time.begin, time.count), time.hours, wish));
  return damages;
}

FatigueWish usual_fatigue_wish() {
  return {.curve = *find_sn_curve(usual_sn_curve), .tensile_strength = usual_tensile_strength};
}

SnCurve read_sn_curve(const std::string& file) {
  const base::CsvTable table = base::read_csv(file);
  table.require({"stress_range_MPa", "cycles"});
  return sn_curve_through(table.column("stress_range_MPa"), table.column("cycles"), file, file);
}

}  // namespace bitrock::studies
