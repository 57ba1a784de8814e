#pragma once
/// The pulses that can be felt along one stretch of angle, and the force they make together. Most angles feel one
/// pulse or two, and which ones changes seldom: the train remembers the active ones and between which angles they stay
/// so.

#include <cstddef>
#include <cstdint>
#include <limits>

#include "runtime/signal/fixed_list.hpp"
#include "runtime/signal/peak_counts.hpp"
#include "runtime/signal/settings.hpp"

namespace bitrock::runtime {

/// Force on one cutter per metre of its width.
struct ForcePerMetre {
  double x = 0.0;  ///< [N/m] cutting direction, resistance positive
  double y = 0.0;  ///< [N/m] axial direction, push out of the rock positive
};

/// A peak with its shape (`unit_pulse` of step5.hpp) in both components, felt for begin < angle < end.
struct Pulse {
  double begin = 0.0;                 ///< [rad]
  double end = 0.0;                   ///< [rad]
  double centre = 0.0;                ///< [rad] R
  double x = 0.0;                     ///< [N/m] height
  double y = 0.0;                     ///< [N/m] height
  double inverse_half_width_x = 0.0;  ///< [1/rad] 1 / h of the x component
  double inverse_half_width_y = 0.0;  ///< [1/rad] 1 / h of the y component
};

/// Those of three windows: the one that is cut, the one before and the one after it.
inline constexpr std::size_t most_pulses = std::size_t{3} * largest_peak_count;

/// Pulses of three windows, and which of them are felt now.
struct PulseTrain {
  FixedList<Pulse, most_pulses> pulses;  ///< ascending begin
  FixedList<std::uint16_t, most_pulses>
      active;            ///< places in `pulses`, ascending, of those felt for after < angle < until
  std::size_t next = 0;  ///< first pulse that has not begun
  double after = 0.0;    ///< [rad]
  double until = -std::numeric_limits<double>::infinity();  ///< [rad]
};

/// Call after `pulses` has been changed: puts them in order and forgets what was active.
void restart(PulseTrain& train);

/// `active` is right for this angle [rad].
inline bool remembered(const PulseTrain& train, double angle) {
  return angle > train.after && angle < train.until;
}

/// Makes `active` right for the angle [rad]: cheap forward, anew from the first pulse backward.
void follow(PulseTrain& train, double angle);

/// **What** The force at one angle [rad].
/// **Equation** F(theta) = sum_i A_i P((theta - R_i) / h_i), or the largest term and 0, in each component.
/// **Symbols** A_i [N/m] height, R_i [rad] centre, h_i [rad] half-width, P unit pulse [1].
/// **Source** [BitRock2026, sec. 3.3]; overlapping pulses are added there in a loop, the maximum is ours.
/// **Differences and validity** Terms run in the order of `pulses` whichever way an angle was reached: the force
/// depends on the angle alone, to the last bit. Takes no memory, does not throw. The bit evaluates the active pulses of
/// all its cutters together (`active_pulses.hpp`), to the same bits.
ForcePerMetre force_at(PulseTrain& train, Combine combine, double angle);

}  // namespace bitrock::runtime
