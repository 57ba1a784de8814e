#pragma once
/// An autodriller: the feed of the string from its weight on the bit, as the rig knows it.

#include <algorithm>

namespace bitrock::runtime {

/// Gains of the control, and what the brake can do.
struct Autodriller {
  double proportional = 0.0;  ///< K_p [m/s/N]
  double integral = 0.0;      ///< K_i [m/s/N/s]
  double fastest = 0.0;       ///< [m/s] feed; it never lifts
};

/// **What** Gains for a string of this stiffness that answers within this time.
/// **Equation** K_p = 2 / (k t), K_i = 1 / (k t^2).
/// **Symbols** k [N/m] of the whole string along its axis; t [s].
/// **Source** derived here: at rest on a face that goes away with V the weight grows with k (v - V). With the PI
/// control v = K_p (W* - W) + K_i integral of (W* - W) the error obeys e'' + 2 e' / t + e / t^2 = 0: it is gone after
/// some t without swinging, whatever V is.
/// **Validity** t well above the slowest axial period of the string, and above the second over which the load is
/// smoothed.
inline Autodriller autodriller_for(double stiffness, double time, double fastest) {
  return {.proportional = 2.0 / (stiffness * time), .integral = 1.0 / (stiffness * time * time), .fastest = fastest};
}

inline constexpr double load_smoothing = 1.0;  ///< [s] of loads, some periods of the first axial mode

/// **What** A load as the rig tells it: smoothed.
/// **Equation** L += h / min(t_s, t) (load - L): the mean at first, then a lag of the first order.
/// **Symbols** t_s [s] `load_smoothing`; t [s] since the rig began to measure; h [s] step.
inline double smoothed_load(double before, double load, double time, double h) {
  return before + std::min(1.0, h / std::min(load_smoothing, std::max(time, h))) * (load - before);
}

/// Feed [m/s] for a weight [N] that is missing, over a step of h [s]. `drift` [m/s] is the integral so far; it stands
/// still while the feed is at a limit and would go beyond.
inline double feed_of(const Autodriller& control, double missing, double h, double& drift) {
  const double wish = control.proportional * missing + drift;
  const double feed = std::clamp(wish, 0.0, control.fastest);
  if (wish == feed || (wish - feed) * missing < 0.0) drift += h * control.integral * missing;
  return feed;
}

}  // namespace bitrock::runtime
