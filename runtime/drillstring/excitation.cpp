#include "runtime/drillstring/excitation.hpp"

#include <cmath>

#include "base/random.hpp"

namespace bitrock::runtime {

BitRockSource no_excitation() {
  return [](const BitMotion&) { return BitLoad{}; };
}

BitRockSource sinusoidal_excitation(const Excitation& force, const Excitation& torque, double waves_per_turn) {
  return [=](const BitMotion& motion) {
    const double wave = std::sqrt(2.0) * std::sin(waves_per_turn * motion.angle);
    return BitLoad{.axial_force = force.mean + force.deviation * wave, .torque = torque.mean + torque.deviation * wave};
  };
}

BitRockSource noise_excitation(const Excitation& force, const Excitation& torque, double piece_angle,
                               std::uint64_t seed) {
  return [=](const BitMotion& motion) {
    const auto piece = static_cast<std::int64_t>(std::floor(motion.angle / piece_angle));
    const auto draw = [&](const Excitation& component, int number) {
      return component.mean + std::sqrt(12.0) * component.deviation * (base::keyed_uniform(seed, piece, number) - 0.5);
    };
    return BitLoad{.axial_force = draw(force, 0), .torque = draw(torque, 1)};
  };
}

BitRockSource simple_excitation(const SourceCase& source, std::uint64_t seed) {
  switch (source.kind) {
    case SourceKind::sinusoidal:
      return sinusoidal_excitation(source.force, source.torque, source.waves_per_turn);
    case SourceKind::noise:
      return noise_excitation(source.force, source.torque, source.piece_angle, seed);
    case SourceKind::none:
    case SourceKind::bit:
      break;
  }
  return no_excitation();
}

}  // namespace bitrock::runtime
