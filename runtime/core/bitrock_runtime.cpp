#include "runtime/core/bitrock_runtime.h"

#include <cmath>

#include "runtime/core/core.hpp"

using namespace bitrock;

// The C interface: looks at pointers and sizes, then calls the core. A `bitrock_core` is a `runtime::Core`.

namespace {

runtime::Core* core_at(bitrock_core* core) {
  return reinterpret_cast<runtime::Core*>(core);
}

const runtime::Core* core_at(const bitrock_core* core) {
  return reinterpret_cast<const runtime::Core*>(core);
}

/// The core is one, and the pointers point somewhere.
template <class... Pointers>
bitrock_status look_at(const bitrock_core* core, Pointers... pointers) {
  if (core == nullptr || ((pointers == nullptr) || ...)) return BITROCK_NULL_POINTER;
  return core_at(core)->magic == runtime::core_magic ? BITROCK_OK : BITROCK_NOT_A_CORE;
}

}  // namespace

int32_t bitrock_runtime_version(void) {
  return BITROCK_RUNTIME_VERSION;
}

const char* bitrock_status_text(bitrock_status status) {
  switch (status) {
    case BITROCK_OK:
      return "done";
    case BITROCK_NULL_POINTER:
      return "an argument is a null pointer";
    case BITROCK_BAD_MEMORY:
      return "the memory is too small or its address is not divisible by 16";
    case BITROCK_NOT_A_CORE:
      return "the memory holds no core (was it created?)";
    case BITROCK_BAD_SIGNAL:
      return "signal: window angle, averaging time and drop length must be above 0, the pulse width factor above 0 and "
             "at most 2, combine, amplitude fit and mode one of their words";
    case BITROCK_BAD_CUTTER:
      return "cutters: 1 to 1000 of them, radius and width above 0, back rake finite, number within 32 bits";
    case BITROCK_BAD_MODEL:
      return "model: ten or seventeen outputs, layers from 3 to 1 node, each of at most 64, all numbers finite, scales "
             "of inputs above 0, low "
             "not "
             "above high";
    case BITROCK_NOT_FINITE:
      return "angle, rotation, rate of penetration and time must be finite";
    case BITROCK_ANGLE_TOO_LARGE:
      return "the angle must be below 1e15 windows";
    case BITROCK_BAD_PREDICTION:
      return "the model answered with a number that is not finite";
    case BITROCK_TIME_NOT_LATER:
      return "an accepted step must end later than the one before";
    case BITROCK_NOTHING_ACCEPTED:
      return "no step has been accepted yet";
    case BITROCK_BAD_STATE:
      return "the bytes are not a state of a core of the same description";
    case BITROCK_NO_MOMENTS:
      return "the mode sawtooth needs a model of seventeen outputs: with mean, standard deviation, correlation "
             "lengths and correlation of the force";
  }
  return "unknown status";
}

bitrock_status bitrock_core_size(const bitrock_description* description, size_t* bytes) {
  if (description == nullptr || bytes == nullptr) return BITROCK_NULL_POINTER;
  std::int64_t parameters = 0;
  const bitrock_status status = runtime::check(*description, parameters);
  if (status == BITROCK_OK) *bytes = runtime::core_bytes(*description, parameters);
  return status;
}

bitrock_status bitrock_core_create(void* memory, size_t bytes, const bitrock_description* description,
                                   bitrock_core** core) {
  if (memory == nullptr || description == nullptr || core == nullptr) return BITROCK_NULL_POINTER;
  std::int64_t parameters = 0;
  if (const bitrock_status status = runtime::check(*description, parameters); status != BITROCK_OK) return status;
  if (bytes < runtime::core_bytes(*description, parameters) ||
      reinterpret_cast<std::uintptr_t>(memory) % runtime::core_alignment != 0) {
    return BITROCK_BAD_MEMORY;
  }
  *core = reinterpret_cast<bitrock_core*>(runtime::make_core(memory, *description, parameters));
  return BITROCK_OK;
}

bitrock_status bitrock_core_reset(bitrock_core* core) {
  const bitrock_status status = look_at(core);
  if (status == BITROCK_OK) runtime::reset(*core_at(core));
  return status;
}

bitrock_status bitrock_core_update(bitrock_core* core, double angle_rad, double rotation_rad_per_s,
                                   double rate_of_penetration_m_per_s, bitrock_load* load) {
  if (const bitrock_status status = look_at(core, load); status != BITROCK_OK) return status;
  return runtime::update(*core_at(core), angle_rad, rotation_rad_per_s, rate_of_penetration_m_per_s, *load);
}

bitrock_status bitrock_core_accept(bitrock_core* core, double time_s, double rotation_rad_per_s,
                                   double rate_of_penetration_m_per_s) {
  if (const bitrock_status status = look_at(core); status != BITROCK_OK) return status;
  if (!std::isfinite(time_s) || !std::isfinite(rotation_rad_per_s) || !std::isfinite(rate_of_penetration_m_per_s)) {
    return BITROCK_NOT_FINITE;
  }
  runtime::Core& it = *core_at(core);
  // both hold the same times, so the second is accepted when the first is
  const bool later = accept(it.rotation, time_s, rotation_rad_per_s) &&
                     accept(it.rate_of_penetration, time_s, rate_of_penetration_m_per_s);
  return later ? BITROCK_OK : BITROCK_TIME_NOT_LATER;
}

bitrock_status bitrock_core_averages(const bitrock_core* core, double* rotation_rad_per_s,
                                     double* rate_of_penetration_m_per_s) {
  const bitrock_status status = look_at(core, rotation_rad_per_s, rate_of_penetration_m_per_s);
  if (status != BITROCK_OK) return status;
  const runtime::Core& it = *core_at(core);
  if (it.rotation.count == 0) return BITROCK_NOTHING_ACCEPTED;
  *rotation_rad_per_s = mean(it.rotation);
  *rate_of_penetration_m_per_s = mean(it.rate_of_penetration);
  return BITROCK_OK;
}

bitrock_status bitrock_core_tally(const bitrock_core* core, bitrock_tally* tally) {
  if (const bitrock_status status = look_at(core, tally); status != BITROCK_OK) return status;
  const runtime::ClampTally& clamps = core_at(core)->clamps;
  const runtime::DrawTally draws = runtime::draws(*core_at(core));
  *tally = {.asked = clamps.asked,
            .speed_below = clamps.speed_below,
            .speed_above = clamps.speed_above,
            .depth_below = clamps.depth_below,
            .depth_above = clamps.depth_above,
            .rake_below = clamps.rake_below,
            .rake_above = clamps.rake_above,
            .drawn = draws.drawn,
            .mean_missed = draws.mean_missed,
            .band_left = draws.band_left,
            .narrowed = draws.narrowed,
            .capped = draws.capped,
            .length_clamped = draws.length_clamped,
            .correlation_clamped = draws.correlation_clamped};
  return BITROCK_OK;
}

bitrock_status bitrock_core_fault(const bitrock_core* core, int64_t* cutter_number, int32_t* output) {
  if (const bitrock_status status = look_at(core, cutter_number, output); status != BITROCK_OK) return status;
  *cutter_number = core_at(core)->fault_cutter;
  *output = core_at(core)->fault_output;
  return BITROCK_OK;
}

bitrock_status bitrock_core_state_size(const bitrock_core* core, size_t* bytes) {
  if (const bitrock_status status = look_at(core, bytes); status != BITROCK_OK) return status;
  *bytes = runtime::state_bytes(*core_at(core));
  return BITROCK_OK;
}

bitrock_status bitrock_core_save(const bitrock_core* core, void* state, size_t bytes) {
  if (const bitrock_status status = look_at(core, state); status != BITROCK_OK) return status;
  if (bytes < runtime::state_bytes(*core_at(core))) return BITROCK_BAD_MEMORY;
  runtime::save(*core_at(core), state);
  return BITROCK_OK;
}

bitrock_status bitrock_core_restore(bitrock_core* core, const void* state, size_t bytes) {
  if (const bitrock_status status = look_at(core, state); status != BITROCK_OK) return status;
  if (bytes < runtime::state_bytes(*core_at(core))) return BITROCK_BAD_STATE;
  return runtime::restore(*core_at(core), state) ? BITROCK_OK : BITROCK_BAD_STATE;
}
