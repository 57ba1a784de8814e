#pragma once
/// What the rock does to the bit beyond its mean push: the interface through which a drill string is excited, and the
/// sources that come with it. A source knows how far the bit has cut and how fast it turns and drills; it knows neither
/// time nor the string, so its force does not depend on the solver's step.

#include <cstdint>
#include <functional>
#include <string>

#include "runtime/bit/bit_force.hpp"

namespace bitrock::runtime {

/// Load of the rock on the bit at a motion whose rates are means over 0.1 s or so. A torque below 0 counts as 0: the
/// rock does not drive the bit.
using BitRockSource = std::function<BitLoad(const BitMotion&)>;

/// Nothing.
BitRockSource no_excitation();

/// One component of the simple sources: [N] or [N m].
struct Excitation {
  double mean = 0.0;       ///< in the unit of the signal
  double deviation = 0.0;  ///< standard deviation, 0 or more; RMS^2 = mean^2 + deviation^2
};

/// What shakes the bit.
enum class SourceKind {
  none,        ///< nothing: no force and no torque of cutting
  sinusoidal,  ///< waves over the angle of the bit
  noise,       ///< a random number for each piece of the angle
  bit          ///< the cutters of a bit, by the networks
};

/// What shakes the bit, and how much.
struct SourceCase {
  SourceKind kind = SourceKind::none;  ///< which one
  Excitation force;                    ///< [N] of the simple kinds
  Excitation torque;                   ///< [N m]
  double waves_per_turn = 1.0;         ///< sinusoidal
  double piece_angle = 0.01;           ///< [rad] noise
  int seed = -1;                       ///< of noise or bit; -1: 1, or what the bit file says
  std::string model_file;              ///< of the networks; empty: to be given at the command line
};

/// **What** The customary excitation: harmonic in the angle of the bit.
/// **Equation** F = mean + sqrt(2) deviation sin(n theta_bp).
/// **Symbols** n [1] waves a turn, above 0 (3 for roller cones [YigitChristoforou2006]); theta_bp [rad].
/// **Validity** Force and torque are in phase.
BitRockSource sinusoidal_excitation(const Excitation& force, const Excitation& torque, double waves_per_turn);

/// **What** White noise over the angle of the bit: constant in pieces of equal angle, independent from piece to piece.
/// **Equation** F = mean + sqrt(12) deviation (u - 1/2), u uniform in [0, 1), drawn for each piece and component.
/// **Symbols** piece_angle [rad] above 0.
/// **Differences and validity** Draws are addressed by (seed, piece, component): the same angle always gives the same
/// force. Flat spectrum up to 1 / (2 piece_angle). Uniform, not normal: bounded within 1.73 deviations.
BitRockSource noise_excitation(const Excitation& force, const Excitation& torque, double piece_angle,
                               std::uint64_t seed);

/// The source of that kind, which is none of a bit; `seed` of noise.
BitRockSource simple_excitation(const SourceCase& source, std::uint64_t seed);

/// The networks: the load of a whole bit. `bit` must outlive the source, and remembers its windows.
inline BitRockSource bit_excitation(BitForce& bit) {
  return [&bit](const BitMotion& motion) { return bit.at(motion); };
}

}  // namespace bitrock::runtime
