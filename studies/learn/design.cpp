#include "studies/learn/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/errors.hpp"
#include "base/even_points.hpp"
#include "base/number.hpp"
#include "base/units.hpp"
#include "studies/campaign/plan.hpp"
#include "surrogate/train/smooth_formula.hpp"

namespace bitrock::studies {

namespace {

constexpr int digits = 4;

/// In so many digits, in the unit of the tables, that people can read and repeat the conditions; the ends as they are.
double between(double low, double high, double share, double unit) {
  if (share <= 0.0 || low == high) return low;
  return share >= 1.0 ? high : base::rounded_to_digits((low + share * (high - low)) / unit, digits) * unit;
}

double depth_at(const LearnRange& range, double share) {
  const double step = std::round(share * (depth_steps - 1)) / (depth_steps - 1);
  if (step <= 0.0) return range.low_depth;
  if (step >= 1.0) return range.high_depth;
  const double depth = range.low_depth * std::pow(range.high_depth / range.low_depth, step);
  return base::rounded_to_digits(depth / base::mm, digits) * base::mm;
}

double pressure_at(const LearnRange& range, double share) {
  const double pressure = surrogate::pressure_between(range.low_pressure, range.high_pressure, share);
  if (share <= 0.0 || share >= 1.0) return pressure;  // the ends as they are
  const double rounded = base::rounded_to_digits(pressure / base::MPa, digits);
  // between none and the least that a cut may have there is nothing: none
  return dem2d::fluid_pressure_MPa.contains(rounded) ? rounded * base::MPa : range.low_pressure;
}

}  // namespace

LearnRange range_of(const Study& study) {
  LearnRange range;
  bool first = true;
  for_each_job(study, [&](const Job& job) {
    const dem2d::CutCase& cut = job.cut;
    const auto widen = [first](double value, double& low, double& high) {
      low = first ? value : std::min(low, value);
      high = first ? value : std::max(high, value);
    };
    widen(cut.cutter_speed, range.low_speed, range.high_speed);
    widen(cut.depth_of_cut, range.low_depth, range.high_depth);
    widen(cut.back_rake, range.low_rake, range.high_rake);
    widen(cut.mud_pressure, range.low_pressure, range.high_pressure);
    first = false;
  });
  return range;
}

LearnDesign::LearnDesign(const Study& like, const LearnRange& range, std::uint64_t seed)
    : like_(like), range_(range), seed_(seed), each_has_pressure_(has_pressures(like)) {
  like_.grid = {};
  like_.table = {};
  like_.table_file.clear();
  least_time_ = time_of(range.high_speed, range.low_depth);
  for (int step = 0; step < depth_steps; ++step)
    least_time_ = std::min(least_time_, time_of(range.high_speed, depth_at(range, step / (depth_steps - 1.0))));
}

double LearnDesign::time_of(double speed, double depth) const {
  Study one = like_;
  one.seeds = {1};
  one.table = {.cutter_speed = {speed}, .depth_of_cut = {depth}, .back_rake = {range_.low_rake}, .mud_pressure = {}};
  return work(jobs(one).front());
}

Study LearnDesign::next(int cuts, int batch) {
  const bool pressures = range_.low_pressure < range_.high_pressure;
  const base::EvenPoints points(pressures ? 5 : 4, seed_);
  Study study = like_;
  study.seeds = {static_cast<int>(seed_) + batch};
  std::vector<std::tuple<double, double, double, double>> taken;
  constexpr int most_refused = 10000;  // one after the other: of a wide range some 20 are
  int refused = 0;
  while (static_cast<int>(taken.size()) < cuts) {
    const std::vector<double> at = points.point(++point_);
    const double speed = between(range_.low_speed, range_.high_speed, base::with_ends(at[0]), 1.0);
    const double depth = depth_at(range_, base::with_ends(at[1]));
    const double rake = between(range_.low_rake, range_.high_rake, base::with_ends(at[2]), base::deg);
    const double pressure = pressures ? pressure_at(range_, base::with_ends(at[4])) : range_.low_pressure;
    const std::tuple one(speed, depth, rake, pressure);
    if (at[3] > std::sqrt(least_time_ / time_of(speed, depth)) || std::ranges::find(taken, one) != taken.end()) {
      if (++refused < most_refused) continue;
      throw base::InputError(fmt::format(
          "a batch of {} cuts has only {} different conditions (widen the range of the study)", cuts, taken.size()));
    }
    refused = 0;
    taken.push_back(one);
    study.table.cutter_speed.push_back(speed);
    study.table.depth_of_cut.push_back(depth);
    study.table.back_rake.push_back(rake);
    if (each_has_pressure_) study.table.mud_pressure.push_back(pressure);
  }
  return study;
}

}  // namespace bitrock::studies
