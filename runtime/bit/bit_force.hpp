#pragma once
/// Force and torque of the rock on a whole bit: the sum of its cutters, each rebuilt from what the network says about
/// its own speed, depth and rake. Here, and only here, force per metre becomes force. It is told how the bit moves;
/// what moves the bit, friction on worn faces and the fluid are not its business.

#include <cstdint>
#include <span>
#include <vector>

#include "runtime/bit/bit.hpp"
#include "runtime/signal/cutter_force.hpp"
#include "surrogate/net/model.hpp"

namespace runtime {

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

/// How often the network was asked outside its training range and answered for the nearest edge instead. One count a
/// question and reason; a question is asked per cutter and window.
struct ClampTally {
  std::int64_t asked = 0;
  std::int64_t speed_below = 0, speed_above = 0;
  std::int64_t depth_below = 0, depth_above = 0;
  std::int64_t rake_below = 0, rake_above = 0;

  std::int64_t clamped() const {
    return speed_below + speed_above + depth_below + depth_above + rake_below + rake_above;
  }
};

/// A bit turning slower than this is taken to turn at it when depth of cut and cutter speed are asked for: 0.6 rpm. It
/// keeps ROP / N finite while a bit sticks, when its angle, and so its force, stands still anyway. Larger values would
/// make the cuts of a bit that barely turns too shallow; smaller ones change nothing, as the depth is clamped.
inline constexpr double slowest_rotation = 0.0628;  ///< [rad/s]

/// **What** Conditions of one cutter when the bit turns steadily.
/// **Equation** d = 2 pi V / omega; v = omega r.
/// **Symbols** d [m] depth of cut; V [m/s] rate of penetration; omega [rad/s] rotation, at least `slowest_rotation`;
/// v [m/s] cutter speed; r [m] radius of its path.
/// **Source** [BitRock2026, sec. 3.1].
/// **Differences and validity** Holds for one cutter a track. V small against v: the path is taken as a circle.
surrogate::CutConditions cut_conditions(const Cutter& cutter, const BitMotion& motion);

/// **What** Load on the bit.
/// **Equation** W(theta) = sum_i F_y,i(theta) w_i; T(theta) = sum_i F_x,i(theta) w_i r_i, i in the order of the bit.
/// **Symbols** F_x,i, F_y,i [N/m] force on cutter i per metre of width (`cutter_force.hpp`); w_i [m]; r_i [m].
/// **Source** [BitRock2026, sec. 3.3]: superposition and arm. The width is ours: the article does not say how
/// the force of a two-dimensional simulation, which is per metre of thickness, becomes a force.
/// **Differences and validity** Cutters do not feel each other. Without friction under worn cutters the mean torque of
/// a bit whose rings cover the face, each resisted by eps w d, is eps a^2 d / 2 [DetournayDefourny1992]. Conditions are
/// asked for when the angle enters a window and hold for the window after it (see `enter_window`). ROP not above 0
/// means nothing is cut: windows drawn then are empty. Any other ROP, however small, is clamped to the shallowest cut
/// the network knows, so the force does not vanish with the depth.
class BitForce {
 public:
  /// Takes all storage. Throws `InputError` when a cutter or a setting cannot be used (a bit made in code, not read).
  BitForce(const Bit& bit, surrogate::Model model);

  /// Takes no memory. One object per thread. Throws `SimulationError` when the motion or a prediction is not finite, or
  /// the angle so large that windows can no longer be told apart (1e15 of them).
  BitLoad at(const BitMotion& motion);

  /// The same for many angles in a row at steady rates: sets axial_force[i] [N] and torque[i] [N m] to what `at` gives
  /// for angles[i], to the last bit, but some times faster as it follows one cutter through a window before it turns to
  /// the next. All three of one length; `motion.angle` is not read.
  void along(std::span<const double> angles, const BitMotion& motion, std::span<double> axial_force,
             std::span<double> torque);

  const ClampTally& clamps() const { return clamps_; }
  /// Sum over the cutters.
  DrawTally draws() const;

 private:
  double window_of(double angle) const;
  void enter(double window, const BitMotion& motion);
  CutterStatistics statistics(const Cutter& cutter, const BitMotion& motion);

  Bit bit_;
  surrogate::Model model_;
  std::vector<CutterForce> forces_;  ///< in the order of bit_.cutters
  double window_;                    ///< the one entered last, a whole number; NaN before the first
  ClampTally clamps_;
};

}  // namespace runtime
