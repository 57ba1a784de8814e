#pragma once
/// Force and torque of the rock on a whole bit: the sum of its cutters, each rebuilt from what the network says about
/// its own speed, depth and rake. It is told how the bit moves; what moves the bit, friction on worn faces and the
/// fluid are not its business. The law is in `core/core.hpp`, and there alone force per metre becomes force; this is
/// the core with the comforts of C++: a bit and a model as read from files, memory of its own, errors in words.

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/bit/bit.hpp"
#include "runtime/signal/tallies.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::runtime {

struct Core;  // core/core.hpp

/// Motion of the bit at one instant. Rates are best smoothed over 0.1 s or so [BitRock2026, sec. 3.3].
struct BitMotion {
  double angle = 0.0;                ///< [rad] turned forward while cutting, since the beginning
  double rotation = 0.0;             ///< [rad/s] of the bit
  double rate_of_penetration = 0.0;  ///< [m/s] into the rock
};

/// Of the rock on the bit; resistance to drilling is positive.
struct BitLoad {
  double axial_force = 0.0;  ///< [N] pushes the bit off the rock
  double torque = 0.0;       ///< [N m] resists its rotation
};

/// One object per thread. A copy goes on from where the original is.
class BitForce {
 public:
  /// Takes all storage. Throws `InputError` when a cutter, a setting or the model cannot be used (made in code, not
  /// read).
  BitForce(const Bit& bit, const surrogate::Model& model);

  /// Takes no memory. What it depends on is in `core/bitrock_runtime.h`, under "What holds". Throws
  /// `SimulationError`, and has changed nothing, when the motion or a prediction is not finite, or the angle so large
  /// that windows can no longer be told apart (1e15 of them).
  BitLoad at(const BitMotion& motion);

  /// The same for many angles in a row at steady rates: sets axial_force[i] [N] and torque[i] [N m] to what `at` gives
  /// for angles[i]. All three of one length; `motion.angle` is not read.
  void along(std::span<const double> angles, const BitMotion& motion, std::span<double> axial_force,
             std::span<double> torque);

  /// Questions so far, and those outside the training range.
  ClampTally clamps() const;
  /// Sum over the cutters.
  DrawTally draws() const;

  /// The whole state as bytes; `restore` of them, here or in an object of the same bit and model, brings the same
  /// forces again to the last bit. `state` has `state_size()` bytes. `restore` throws `InputError` for other bytes.
  std::size_t state_size() const;
  /// Writes the state to `state_bytes()` bytes.
  void save(std::span<std::byte> state) const;
  /// Goes on from a state that was saved.
  void restore(std::span<const std::byte> state);

 private:
  Core& core();
  const Core& core() const;

  std::vector<double> memory_;  ///< the core's bytes; doubles, so that they begin where they must
};

}  // namespace bitrock::runtime
