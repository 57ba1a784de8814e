#pragma once
/// How a force history is rebuilt from its statistics: what the file of a bit says of its signal.

#include <cstdint>

namespace bitrock::runtime {

/// What overlapping pulses of a cutter become.
enum class Combine {
  sum,  ///< overlapping pulses add up: keeps the area under the force, may exceed amax; the default
  max,  ///< the highest of the overlapping pulses: never exceeds amax, loses area
};

/// Two ways of bringing the heights of a window to their mean; see `draw_amplitudes` in peak_amplitudes.hpp.
enum class AmplitudeFit {
  band_preserving,  ///< every peak stays in its band; the default
  article,          ///< the printed scaling, which may leave bands, exceed amax or turn negative
};

/// What a force is rebuilt by.
enum class SignalMode {
  automatic,        ///< sawtooth when the model can, else article
  article,          ///< peaks of five statistics; where the model knows the mean, pulses so wide that it is met
  article_literal,  ///< the same, pulses of one width factor
  sawtooth,         ///< events of mean, standard deviation and correlation lengths; see `sawtooth_law.hpp`
};

/// What a bit file says of the signal.
struct SignalSettings {
  /// `automatic` is decided once the model is known: a core takes one of the others.
  SignalMode mode = SignalMode::automatic;
  double window_angle = 0.0;        ///< [rad] theta_T, above 0
  double pulse_width_factor = 1.0;  ///< [1] f, above 0 and at most 2: pulses reach no further than one window away
  Combine combine = Combine::sum;   ///< of overlapping pulses
  AmplitudeFit amplitude_fit = AmplitudeFit::band_preserving;  ///< of the heights to their mean
  std::uint64_t seed = 0;                                      ///< of all draws
};

}  // namespace bitrock::runtime
