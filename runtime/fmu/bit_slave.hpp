#pragma once
/// A bit between communication points: what the FMU's inputs, steps and parameters do to the core. Its functions are
/// those of `slave.hpp`.

#include "runtime/fmu/bit_block.hpp"
#include "runtime/fmu/slave.hpp"

namespace bitrock::fmu {

/// What the host may set before the first step.
struct Settings {
  bitrock_signal signal{};        ///< parameters of the FMU
  double threshold_weight = 0.0;  ///< [N]
};

/// What the host sets.
struct Inputs {
  double rotation = 0.0;             ///< [rad/s]
  double rate_of_penetration = 0.0;  ///< [m/s]
  double weight = 0.0;               ///< [N]
};

/// Everything that changes but the core. All members have eight bytes: copies of it are compared and saved as bytes.
struct Moment : Clock {
  Inputs inputs;              ///< of this step
  double speed = 0.0;         ///< [rad/s] of the angle
  double speed_since = 0.0;   ///< [s]
  double angle_since = 0.0;   ///< [rad] at that time, with what the step before it missed
  double last_step = 0.0;     ///< [s] length of the step that ended at `time`
  double angle = 0.0;         ///< [rad] turned forward while cutting
  std::int64_t begun = 0;     ///< 1: it has cut
  double torque = 0.0;        ///< [N m]
  double axial_force = 0.0;   ///< [N]
  double depth_of_cut = 0.0;  ///< [m]
};

/// One instance.
struct BitSlave : Slave {
  char* bytes = nullptr;         ///< of the block
  BitBlock block;                ///< bit and model
  bitrock_core* core = nullptr;  ///< its force
  bitrock_signal core_signal{};  ///< the core was made with it
  Settings settings;             ///< parameters
  Moment moment;                 ///< all that changes
};

/// As the bit file has them.
Settings start_settings(const BitSlave& slave);

/// Whether a core can be made with these.
bitrock_status check(const BitSlave& slave, const Settings& settings);

/// **What** One communication step, to the time `end` [s].
/// **Equation** omega_c = progression(omega, W, W_TS); theta(t) = theta_0 + omega_c (t - t_0), where
/// theta_0 = theta(t_0) + missing_angle(omega_c before t_0, omega_c, last step); torque and force =
/// `bitrock_core_update` of theta, mean omega, mean V for W > 0, otherwise 0.
/// **Symbols** omega [rad/s], V [m/s], W [N] inputs: samples, at the beginning of the step, of signals that change
/// steadily or jump there; W_TS [N] threshold; theta [rad], never less than it was; t_0 [s] when omega_c last changed;
/// means over the averaging time up to the beginning of the step.
/// **Source** `laws/progression_angle.hpp`, `laws/moving_average.hpp`, `core/core.hpp`; as in the drill string, the
/// means go into the load before the end of the step comes into them.
/// **Differences and validity** While inputs do not change, the angle, and as the means are then exact (see
/// `moving_average.hpp`) the load too, depend on time alone, to the last bit, whatever the steps. While the rotation
/// changes, the angle is right to second order in the step: with each rotation held for its step it would lag by half a
/// step of what the rotation gained, and at 1 ms that is a peak's width. Nothing is drawn or averaged before the bit
/// first cuts (omega_c > 0 and V above `slowest_advance`): averages begin with the inputs of that step. A bit off the
/// rock (W <= 0) feels nothing; one that stands on it feels what it felt when it stopped. When it fails, nothing has
/// changed.
bitrock_status step(BitSlave& slave, double end);

}  // namespace bitrock::fmu
