#include "runtime/bit/bit_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/errors.hpp"

namespace runtime {

namespace {

constexpr double most_windows = 1e15;  // every window number below it is an exact double

void require_usable(const Bit& bit) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(bit.signal.window_angle)) {
    throw base::InputError(
        fmt::format("bit {}: window angle {} rad (must be above 0)", bit.name, bit.signal.window_angle));
  }
  if (!positive(bit.signal.pulse_width_factor) || bit.signal.pulse_width_factor > 2.0) {
    throw base::InputError(fmt::format("bit {}: pulse width factor {} (must be above 0 and at most 2)", bit.name,
                                       bit.signal.pulse_width_factor));
  }
  if (bit.cutters.empty()) throw base::InputError(fmt::format("bit {}: no cutters (needs at least one)", bit.name));
  for (const Cutter& cutter : bit.cutters) {
    if (!positive(cutter.radius) || !positive(cutter.width)) {
      throw base::InputError(fmt::format("bit {}: cutter {} has radius {} m and width {} m (must both be above 0)",
                                         bit.name, cutter.number, cutter.radius, cutter.width));
    }
  }
}

void count(std::int64_t& below, std::int64_t& above, double asked, double answered) {
  below += answered > asked ? 1 : 0;
  above += answered < asked ? 1 : 0;
}

PeakStatistics plain(const surrogate::PeakStatisticsPrediction& prediction) {
  return {.amax = prediction.amax,
          .amean = prediction.amean,
          .np1 = prediction.np1,
          .np23 = prediction.np23,
          .np4 = prediction.np4};
}

}  // namespace

surrogate::CutConditions cut_conditions(const Cutter& cutter, const BitMotion& motion) {
  const double rotation = std::max(motion.rotation, slowest_rotation);
  return {.cutter_speed = rotation * cutter.radius,
          .depth_of_cut = 2.0 * std::numbers::pi * motion.rate_of_penetration / rotation,
          .back_rake = cutter.back_rake};
}

BitForce::BitForce(const Bit& bit, surrogate::Model model)
    : bit_(bit), model_(std::move(model)), window_(std::numeric_limits<double>::quiet_NaN()) {
  require_usable(bit_);
  for (const Cutter& cutter : bit_.cutters) {
    forces_.push_back(make_cutter_force(bit_.signal, cutter.number, cutter.radius));
  }
}

CutterStatistics BitForce::statistics(const Cutter& cutter, const BitMotion& motion) {
  if (motion.rate_of_penetration <= 0.0) return {};
  const surrogate::CutConditions asked = cut_conditions(cutter, motion);
  const surrogate::CutConditions answered = clamped_to_training_range(model_, asked);
  ++clamps_.asked;
  count(clamps_.speed_below, clamps_.speed_above, asked.cutter_speed, answered.cutter_speed);
  count(clamps_.depth_below, clamps_.depth_above, asked.depth_of_cut, answered.depth_of_cut);
  count(clamps_.rake_below, clamps_.rake_above, asked.back_rake, answered.back_rake);
  const surrogate::Prediction prediction = predict(model_, answered);
  return {.x = plain(prediction.x), .y = plain(prediction.y)};
}

double BitForce::window_of(double angle) const {
  const double window = std::floor(angle / bit_.signal.window_angle);
  if (!(std::abs(window) < most_windows)) {
    throw base::SimulationError(
        fmt::format("bit angle {} rad (must be finite and below {:.0e} windows)", angle, most_windows));
  }
  return window;
}

void BitForce::enter(double window, const BitMotion& motion) {
  if (!std::isfinite(motion.rotation) || !std::isfinite(motion.rate_of_penetration)) {
    throw base::SimulationError(
        fmt::format("bit at window {:.0f}: rotation {} rad/s, rate of penetration {} m/s (must be finite)", window,
                    motion.rotation, motion.rate_of_penetration));
  }
  for (std::size_t i = 0; i < forces_.size(); ++i) {
    enter_window(forces_[i], static_cast<std::int64_t>(window), statistics(bit_.cutters[i], motion));
  }
  window_ = window;
}

BitLoad BitForce::at(const BitMotion& motion) {
  BitLoad load;
  along({&motion.angle, 1}, motion, {&load.axial_force, 1}, {&load.torque, 1});
  return load;
}

void BitForce::along(std::span<const double> angles, const BitMotion& motion, std::span<double> axial_force,
                     std::span<double> torque) {
  for (std::size_t begin = 0, end = 0; begin < angles.size(); begin = end) {
    const double window = window_of(angles[begin]);
    while (end < angles.size() && window_of(angles[end]) == window) ++end;
    if (window != window_) enter(window, motion);

    const double start = window * bit_.signal.window_angle;
    std::ranges::fill(axial_force.subspan(begin, end - begin), 0.0);
    std::ranges::fill(torque.subspan(begin, end - begin), 0.0);
    for (std::size_t i = 0; i < forces_.size(); ++i) {
      const Cutter& cutter = bit_.cutters[i];
      add_forces(forces_[i].train, bit_.signal.combine, angles.subspan(begin, end - begin), start,
                 {.factor = cutter.width * cutter.radius, .total = torque.subspan(begin, end - begin)},
                 {.factor = cutter.width, .total = axial_force.subspan(begin, end - begin)});
    }
  }
}

DrawTally BitForce::draws() const {
  DrawTally sum;
  for (const CutterForce& force : forces_) sum.add(force.tally);
  return sum;
}

}  // namespace runtime
