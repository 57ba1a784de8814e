#include "runtime/bit/constant_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "base/units.hpp"

namespace bitrock::runtime {

namespace {

using base::m_per_h, base::rpm;

constexpr double rounding = 1.0 + 1e-12;                   // of a unit conversion there and back
constexpr std::size_t samples_between_reports = 1u << 16;  // some milliseconds of work

void require_above_zero(double value, const char* name, const char* unit) {
  if (!(std::isfinite(value) && value > 0.0)) {
    throw base::InputError(fmt::format("{} = {:.6g} {} (must be finite and above 0)", name, value, unit));
  }
}

std::size_t checked_samples(const ConstantSpeed& run) {
  if (!(run.rotation * rounding >= slowest_rpm * rpm && run.rotation <= fastest_rpm * rpm * rounding)) {
    throw base::InputError(fmt::format("rotation = {:.6g} rpm (must be at least {} and at most {})", run.rotation / rpm,
                                       slowest_rpm, fastest_rpm));
  }
  require_above_zero(run.duration, "duration", "s");
  require_above_zero(run.rate, "rate", "Hz");
  if (!(run.rate_of_penetration >= 0.0 && run.rate_of_penetration <= fastest_m_per_h * m_per_h * rounding)) {
    throw base::InputError(fmt::format("rate of penetration = {:.6g} m/h (must be at least 0 and at most {})",
                                       run.rate_of_penetration / m_per_h, fastest_m_per_h));
  }
  // 0.1 s at 30 Hz is a hair above 3 in binary and yet 3 samples
  const double samples = std::max(1.0, std::ceil(run.duration * run.rate * (1.0 - 1e-15)));
  if (samples > most_samples) {
    throw base::InputError(
        fmt::format("duration {:.6g} s at {:.6g} Hz = {:.6g} samples (must be at most {:.0f}); shorten "
                    "the duration or lower the rate",
                    run.duration, run.rate, samples, most_samples));
  }
  return static_cast<std::size_t>(samples);
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

Signal constant_speed_signal(const Bit& bit, const surrogate::Model& model, const ConstantSpeed& run,
                             const base::ProgressCallback& progress) {
  const std::size_t samples = checked_samples(run);
  BitForce bit_force(bit, model);
  Signal signal;
  for (std::vector<double>* column : {&signal.time_s, &signal.angle_rad, &signal.axial_force_N, &signal.torque_N_m}) {
    column->resize(samples);
  }

  for (std::size_t i = 0; i < samples; ++i) {
    signal.time_s[i] = static_cast<double>(i) / run.rate;
    signal.angle_rad[i] = run.rotation * signal.time_s[i];
  }
  const BitMotion motion{.rotation = run.rotation, .rate_of_penetration = run.rate_of_penetration};
  for (std::size_t done = 0; done < samples;) {
    base::throw_if_stopped();
    if (progress) progress(static_cast<double>(done), static_cast<double>(samples));
    const std::size_t count = std::min(samples_between_reports, samples - done);
    bit_force.along(std::span(signal.angle_rad).subspan(done, count), motion,
                    std::span(signal.axial_force_N).subspan(done, count),
                    std::span(signal.torque_N_m).subspan(done, count));
    done += count;
  }
  if (progress) progress(static_cast<double>(samples), static_cast<double>(samples));

  signal.summary = {.mean_force_N = mean(signal.axial_force_N),
                    .max_force_N = *std::max_element(signal.axial_force_N.begin(), signal.axial_force_N.end()),
                    .mean_torque_N_m = mean(signal.torque_N_m),
                    .max_torque_N_m = *std::max_element(signal.torque_N_m.begin(), signal.torque_N_m.end()),
                    .depth_of_cut_m = 2.0 * std::numbers::pi * run.rate_of_penetration / run.rotation,
                    .clamps = bit_force.clamps(),
                    .draws = bit_force.draws()};
  return signal;
}

}  // namespace bitrock::runtime
