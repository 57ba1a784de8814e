#pragma once
/// The pulses that can be felt along one stretch of angle, and the force they make together. Most angles feel one
/// pulse or two, and which ones changes seldom: the train remembers the active ones and until where they stay so.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace runtime {

/// Force on one cutter per metre of its width.
struct ForcePerMetre {
  double x = 0.0;  ///< [N/m] cutting direction, resistance positive
  double y = 0.0;  ///< [N/m] axial direction, push out of the rock positive
};

enum class Combine {
  sum,  ///< overlapping pulses add up: keeps the area under the force, may exceed amax; the default
  max,  ///< the highest of the overlapping pulses: never exceeds amax, loses area
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

struct PulseTrain {
  std::vector<Pulse> pulses;  ///< ascending begin
  std::vector<Pulse> active;  ///< copies of those felt for from <= angle < until, in the order of `pulses`
  std::size_t next = 0;       ///< first pulse that has not begun
  double from = 0.0;          ///< [rad]
  double until = -std::numeric_limits<double>::infinity();  ///< [rad]
};

/// A train without pulses; takes the storage for `capacity` of them.
PulseTrain make_pulse_train(std::size_t capacity);

/// Call after `pulses` has been changed: puts them in order and forgets what was active.
void restart(PulseTrain& train);

/// **What** The force at one angle [rad] or many.
/// **Equation** F(theta) = sum_i A_i P((theta - R_i) / h_i), or the largest term and 0, in each component.
/// **Symbols** A_i [N/m] height, R_i [rad] centre, h_i [rad] half-width, P unit pulse [1].
/// **Source** [BitRock2026, sec. 3.3]; overlapping pulses are added there in a loop, the maximum is ours.
/// **Differences and validity** Terms run in the order of `pulses` whichever way an angle was reached: the force
/// depends on the angle alone, to the last bit. Cheapest when angles ascend in small steps. Takes no memory, does not
/// throw.
ForcePerMetre force_at(PulseTrain& train, Combine combine, double angle);

/// What one component adds to a load: force [N/m] times `factor`.
struct Accumulation {
  double factor = 1.0;      ///< [m] for a force, [m2] for a torque
  std::span<double> total;  ///< one entry an angle
};

/// For all i: x.total[i] += x.factor F_x(angles[i] - start), and the same for y.
void add_forces(PulseTrain& train, Combine combine, std::span<const double> angles, double start, Accumulation x,
                Accumulation y);

}  // namespace runtime
