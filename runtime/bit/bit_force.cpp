#include "runtime/bit/bit_force.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/core/core.hpp"

namespace bitrock::runtime {

namespace {

void require_usable(const Bit& bit, const surrogate::Model& model) {
  const auto positive = [](double value) { return std::isfinite(value) && value > 0.0; };
  if (!positive(bit.signal.window_angle)) {
    throw base::InputError(
        fmt::format("bit {}: window angle {} rad (must be above 0)", bit.name, bit.signal.window_angle));
  }
  if (!positive(bit.signal.pulse_width_factor) || bit.signal.pulse_width_factor > 2.0) {
    throw base::InputError(fmt::format("bit {}: pulse width factor {} (must be above 0 and at most 2)", bit.name,
                                       bit.signal.pulse_width_factor));
  }
  if (bit.signal.mode == SignalMode::sawtooth && !surrogate::has_moments(model)) {
    throw base::InputError(fmt::format(
        "bit {}: mode 'sawtooth' needs networks of mean, sd, correlation length and correlation, which this model does "
        "not have: make one with 'bitrock train' from a features.csv that has their columns (x_mean_N_per_m, "
        "x_sd_N_per_m, ..., as 'bitrock campaign collect' writes it), or choose mode = \"article\"",
        bit.name));
  }
  if (bit.cutters.empty()) throw base::InputError(fmt::format("bit {}: no cutters (needs at least one)", bit.name));
  for (const Cutter& cutter : bit.cutters) {
    if (!positive(cutter.radius) || !positive(cutter.width)) {
      throw base::InputError(fmt::format("bit {}: cutter {} has radius {} m and width {} m (must both be above 0)",
                                         bit.name, cutter.number, cutter.radius, cutter.width));
    }
  }
}

/// What a failed `update` means here.
[[noreturn]] void fail(bitrock_status status, const Core& core, const BitMotion& motion) {
  if (status == BITROCK_BAD_PREDICTION) {
    throw base::SimulationError(fmt::format(
        "cutter {}: predicted {} is not a finite number at rotation {} rad/s and rate of penetration {} m/s; "
        "check the model file",
        core.fault_cutter, surrogate::output_names[static_cast<std::size_t>(core.fault_output)].name, motion.rotation,
        motion.rate_of_penetration));
  }
  throw base::SimulationError(fmt::format("bit at angle {} rad, rotation {} rad/s, rate of penetration {} m/s: {}",
                                          motion.angle, motion.rotation, motion.rate_of_penetration,
                                          bitrock_status_text(status)));
}

}  // namespace

BitForce::BitForce(const Bit& bit, const surrogate::Model& model) {
  require_usable(bit, model);
  const CoreDescription description = describe(bit, model);
  std::int64_t parameters = 0;
  const bitrock_status status = check(description.plain, parameters);
  if (status != BITROCK_OK) {
    throw base::InputError(fmt::format("bit {} with the model of {}: {}", bit.name,
                                       model.rock.empty() ? "unnamed rock" : model.rock, bitrock_status_text(status)));
  }
  memory_.resize((core_bytes(description.plain, parameters) + sizeof(double) - 1) / sizeof(double));
  make_core(memory_.data(), description.plain, parameters);
}

Core& BitForce::core() {
  return *reinterpret_cast<Core*>(memory_.data());
}

const Core& BitForce::core() const {
  return *reinterpret_cast<const Core*>(memory_.data());
}

BitLoad BitForce::at(const BitMotion& motion) {
  bitrock_load load{};
  const bitrock_status status = update(core(), motion.angle, motion.rotation, motion.rate_of_penetration, load);
  if (status != BITROCK_OK) fail(status, core(), motion);
  return {.axial_force = load.axial_force_N, .torque = load.torque_N_m};
}

void BitForce::along(std::span<const double> angles, const BitMotion& motion, std::span<double> axial_force,
                     std::span<double> torque) {
  BitMotion here = motion;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    here.angle = angles[i];
    const BitLoad load = at(here);
    axial_force[i] = load.axial_force;
    torque[i] = load.torque;
  }
}

ClampTally BitForce::clamps() const {
  return core().clamps;
}

DrawTally BitForce::draws() const {
  return runtime::draws(core());
}

std::size_t BitForce::state_size() const {
  return state_bytes(core());
}

void BitForce::save(std::span<std::byte> state) const {
  if (state.size() < state_size())
    throw base::InputError(fmt::format("state of a bit: {}", bitrock_status_text(BITROCK_BAD_MEMORY)));
  runtime::save(core(), state.data());
}

void BitForce::restore(std::span<const std::byte> state) {
  if (state.size() < state_size() || !runtime::restore(core(), state.data()))
    throw base::InputError(fmt::format("state of a bit: {}", bitrock_status_text(BITROCK_BAD_STATE)));
}

}  // namespace bitrock::runtime
