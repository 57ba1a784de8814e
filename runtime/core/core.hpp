#pragma once
/// A whole bit in one block of memory: what the C interface (runtime/core/bitrock_runtime.h) makes and calls, and
/// what `BitForce` wraps. No pointers inside, so its bytes can be copied; no heap, no exceptions, no C++ library beyond
/// its headers. The file with the law of the bit is core.cpp.

#include <cstddef>
#include <cstdint>

#include "runtime/core/active_pulses.hpp"
#include "runtime/core/bitrock_runtime.h"
#include "runtime/core/conditions.hpp"
#include "runtime/laws/moving_average.hpp"
#include "runtime/signal/cutter_force.hpp"
#include "runtime/signal/felt_pulses.hpp"

namespace bitrock::runtime {

inline constexpr double most_windows = 1e15;  ///< every window number below it is an exact double
inline constexpr std::uint64_t core_magic = 0x62697472'6f636b31ULL;  ///< "bitrock1"

/// What a core knows of one cutter.
struct alignas(16) CoreCutter {
  int number = 0;            ///< on the bit
  double path_radius = 0.0;  ///< [m]
  double back_rake = 0.0;    ///< [rad]
  Answer answer{};           ///< of the model, while a window is entered
};

/// What a core is, then what it knows, then how far it is. Behind it in memory: `cutter_count` cutters; as many of what
/// their mode looks at each time, `ActiveCutter` or `SawtoothCutter`; what that is taken from, `cutter_count`
/// `CutterForce` or `most_felt_blocks` `PulseBlock`; then the parameters of the networks.
struct alignas(16) Core {
  std::uint64_t magic = 0;           ///< `core_magic`
  std::uint64_t fingerprint = 0;     ///< of the description: states belong to it
  std::int64_t cutter_count = 0;     ///< of the bit
  std::int64_t parameter_count = 0;  ///< of all networks together
  bool wide = false;                 ///< `has_wide_vectors` of the machine it was made on

  SignalSettings signal;        ///< how peaks are drawn
  ModelNumbers model;           ///< the networks
  double average_window = 0.0;  ///< [s]

  WindowMemory windows;               ///< drawn so far
  double window_begin = 0.0;          ///< [rad] of the window entered last
  FeltPulses felt;                    ///< of the mode "sawtooth"
  DrawTally draws;                    ///< besides what the cutters of the modes of peaks have counted
  ClampTally clamps;                  ///< questions so far
  MovingAverage rotation;             ///< [rad/s]
  MovingAverage rate_of_penetration;  ///< [m/s]

  std::int64_t fault_cutter = 0;  ///< number of the cutter whose prediction was not finite
  std::int32_t fault_output = 0;  ///< output of the first fault, where there was one
};

/// Whether the mode is "sawtooth". Otherwise it is one of peaks.
inline bool is_sawtooth(const Core& core) {
  return core.signal.mode == SignalMode::sawtooth;
}

/// First of `cutter_count`, in the order of the bit; likewise below.
inline CoreCutter* cutters(Core& core) {
  return reinterpret_cast<CoreCutter*>(&core + 1);
}
/// Of the modes of peaks alone.
inline ActiveCutter* active_cutters(Core& core) {
  return reinterpret_cast<ActiveCutter*>(cutters(core) + core.cutter_count);
}
/// Of the modes of peaks alone.
inline CutterForce* cutter_forces(Core& core) {
  return reinterpret_cast<CutterForce*>(active_cutters(core) + core.cutter_count);
}
/// The same of a core that stays as it is.
inline const CutterForce* cutter_forces(const Core& core) {
  return cutter_forces(const_cast<Core&>(core));
}
/// Of the mode "sawtooth" alone.
inline SawtoothCutter* sawtooth_cutters(Core& core) {
  return reinterpret_cast<SawtoothCutter*>(cutters(core) + core.cutter_count);
}
/// Of the mode "sawtooth" alone: room for `most_felt_blocks`.
inline PulseBlock* pulse_blocks(Core& core) {
  return reinterpret_cast<PulseBlock*>(sawtooth_cutters(core) + core.cutter_count);
}
/// Behind the cutters in memory.
inline double* parameters(Core& core) {
  return is_sawtooth(core) ? reinterpret_cast<double*>(pulse_blocks(core) +
                                                       most_felt_blocks(static_cast<std::size_t>(core.cutter_count)))
                           : reinterpret_cast<double*>(cutter_forces(core) + core.cutter_count);
}

/// Everything that can be wrong with a description. Sets the parameters its networks have.
bitrock_status check(const bitrock_description& description, std::int64_t& parameter_count);

/// Of the address of a core: both directions of a pulse are read at once.
inline constexpr std::size_t core_alignment = 16;

/// That a core of this bit needs.
std::size_t core_bytes(const bitrock_description& description, std::int64_t parameter_count);

/// `memory` holds `core_bytes` and the description has passed `check`.
Core* make_core(void* memory, const bitrock_description& description, std::int64_t parameter_count);

/// The angles that follow lie in this window, and nothing that was felt is right any more.
void set_window(Core& core, std::int64_t window);

/// Back to the beginning: nothing drawn, nothing counted, nothing averaged.
void reset(Core& core);

/// **What** Load on the bit.
/// **Equation** W(theta) = sum_i F_y,i(theta) w_i; T(theta) = sum_i F_x,i(theta) w_i r_i, i in the order of the bit.
/// **Symbols** F_x,i, F_y,i [N/m] force on cutter i per metre of width (`cutter_force.hpp`, `felt_pulses.hpp`); w_i
/// [m]; r_i [m].
/// **Source** [BitRock2026, sec. 3.3]: superposition and arm. The width is ours: the article does not say how
/// the force of a two-dimensional simulation, which is per metre of thickness, becomes a force.
/// **Differences and validity** Cutters do not feel each other. Without friction under worn cutters the mean torque of
/// a bit whose rings cover the face, each resisted by eps w d, is eps a^2 d / 2 [DetournayDefourny1992]. Conditions are
/// asked for when the angle enters a window and hold for the window after it (peaks, see `enter_window`) or for this
/// one (sawteeth). ROP not above `slowest_advance` means nothing is cut: windows drawn then are empty. Any other ROP,
/// however small, is clamped to the shallowest cut the network knows, so the force does not vanish with the depth.
bitrock_status update(Core& core, double angle, double rotation, double rate_of_penetration, bitrock_load& load);

/// Vectors of four numbers; with two the bits are the same.
bool has_wide_vectors();

/// Comes back to these windows: what is kept otherwise is drawn again, as at the motion when it was drawn first. False,
/// and nothing changed, when the model has no finite answer for one.
bool go_to(Core& core, const WindowMemory& windows);

/// Sum over the cutters.
DrawTally draws(const Core& core);
/// Sets that sum; the cutters count from 0 again.
void set_draws(Core& core, const DrawTally& draws);

/// Windows that can be felt in window k: from k - 1 to k + this.
inline std::int64_t windows_ahead(const Core& core) {
  return is_sawtooth(core) ? 0 : 1;  // sawteeth do not reach back
}

/// That its state needs.
std::size_t state_bytes(const Core& core);

/// `state` holds `state_bytes`.
void save(const Core& core, void* state);

/// False, and nothing changed, when the bytes are not of `save` of a core of the same description: every index, count
/// and number is looked at, also when the checksum fits.
bool restore(Core& core, const void* state);

}  // namespace bitrock::runtime
