#pragma once
/// What acts between the bit and the rock, in the order of one step: how the face moves, what the source adds, and what
/// the breaking rock holds. Shared by the string in two dimensions and the string in a well; it knows neither.

#include "runtime/drillstring/excitation.hpp"
#include "runtime/laws/fracture_spring.hpp"
#include "runtime/laws/friction.hpp"
#include "runtime/laws/moving_average.hpp"
#include "runtime/laws/rate_of_penetration.hpp"
#include "runtime/laws/rock_contact.hpp"

namespace bitrock::runtime {

/// How friction depends on speed.
enum class FrictionLaw {
  none,     ///< no friction
  smooth,   ///< `SmoothFriction`, which never sticks
  stribeck  ///< `StribeckFriction`, which sticks
};

/// Friction at the bit or at the wall; both constants are there, `law` says which count.
struct Friction {
  FrictionLaw law = FrictionLaw::none;  ///< which one is used
  SmoothFriction smooth;                ///< used for `smooth`
  StribeckFriction stribeck;            ///< used for `stribeck`
};

/// How the bit advances under its weight.
enum class AdvanceLaw {
  none,         ///< the rock face stands still
  root,         ///< `RootAdvance`, that of the article
  regularized,  ///< `RegularizedAdvance`
  imposed       ///< a given speed of a bit that turns, at any weight
};

/// What of the source's axial force acts on the bit, beside the rock spring.
enum class AxialSource {
  full,         ///< all of it: the spring carries less than the weight on bit by its mean
  fluctuation,  ///< less its running mean over a turn of cut
  none          ///< nothing of it
};

/// Everything at the bit.
struct BitRock {
  Friction friction;                             ///< of the bit on the rock
  double friction_radius = 0.0;                  ///< [m] arm of the friction: torque = W r mu
  AdvanceLaw advance_law = AdvanceLaw::root;     ///< which one is used
  RootAdvance root_advance;                      ///< used for `root`
  RegularizedAdvance regularized_advance;        ///< used for `regularized`
  double imposed_advance = 0.0;                  ///< [m/s] used for `imposed`: of a bit that turns, at any weight
  double threshold_weight = 0.0;                 ///< [N] W_TS
  RockContact contact;                           ///< spring and damper
  double hydraulic_force = 0.0;                  ///< [N] upwards on the bit
  double fracture_stiffness = 2e4;               ///< [N m/rad]
  Unloading unloading = Unloading::free;         ///< when the bit turns back
  AxialSource axial_source = AxialSource::full;  ///< which part of the force of the source acts
  double engagement_depth = 0.4e-3;              ///< [m] lift of the bit at which the cutters have left the rock
  double averaging_time = 0.1;                   ///< [s] of rotation and ROP before they reach the source
  double imposed_weight = 0.0;                   ///< [N] weight on bit when there is no axial chain
};

/// All that changes at the bit; of one instant.
struct BitRockState {
  double face = 0.0;                              ///< [m] position of the rock face below the bit
  double progression = 0.0;                       ///< [rad] theta_bp
  double twist = 0.0;                             ///< [rad] stored in the rock
  double weight_on_bit = 0.0;                     ///< [N] of the rock spring and damper, or imposed
  double rate_of_penetration = 0.0;               ///< [m/s] of this instant
  double friction_torque = 0.0;                   ///< [N m] of the rock on the bit, against forward turning positive
  double fracture_torque = 0.0;                   ///< [N m] resists, 0 or more
  double source_force = 0.0;                      ///< [N] axial force of the source that acts, upwards
  double source_torque = 0.0;                     ///< [N m] most that the rock before the cutters bears, 0 or more
  double source_mean = 0.0;                       ///< [N] running mean of the source's force (fluctuation only)
  bool source_known = false;                      ///< whether `source_mean` has begun
  MovingAverage smooth_rotation, smooth_advance;  ///< of the bit, for the cutting conditions
};

/// Of the rock on the bit, against forward turning: friction and fracture [N m].
inline double torque_on_bit(const BitRockState& bit) {
  return bit.friction_torque + bit.fracture_torque;
}

/// The law of advance at a rotation of the bit [rad/s]. `none`: no advance.
AdvanceLine advance_at(const BitRock& bit, double rotation);

/// **What** Weight on bit, and how the face moves below it in a step of `h` seconds. Returns how deep the bit stands
/// below the face [m].
/// **Symbols** `rotation` [rad/s] of the bit; `position` [m] and `speed` [m/s] of the bit along the hole, at the end of
/// the step.
double push_on_face(const BitRock& bit, BitRockState& state, double rotation, double position, double speed, double h);

/// Load of the source and the torque of breaking rock, after the bit has turned by `turned` [rad]; `depth` [m] of the
/// bit below the face, with its weight of this instant known. The source's force fades as the bit is lifted.
void drive_source(const BitRock& bit, BitRockState& state, const BitRockSource& source, double turned, double depth);

}  // namespace bitrock::runtime
