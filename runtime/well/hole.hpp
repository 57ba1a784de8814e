#pragma once
/// The hole around the path: how wide it is and how rough, by measured depth.

#include <limits>
#include <vector>

#include "runtime/well/well_path.hpp"

namespace bitrock::runtime {

/// A stretch of casing or open hole.
struct HoleSection {
  double to_depth = 0.0;          ///< [m] measured depth of its lower end
  double diameter = 0.0;          ///< [m]
  double friction = 0.0;          ///< [1] coefficient of friction, 0 or more; of fast slip where it depends on speed
  double resting_friction = 0.0;  ///< [1] at rest, no less than the other; 0: the same
  double slip_speed = 0.05;       ///< [m/s] at which half of the difference is left; above 0 [Simulator4nDOF]
};

/// A stretch of constant curvature, diameter and friction.
struct HolePiece {
  WellArc arc;                                                 ///< its part of the path
  double radius = 0.0;                                         ///< [m] of the hole
  double friction = 0.0;                                       ///< [1] of fast slip
  double more_at_rest = 0.0;                                   ///< [1] at rest it is so much more
  double slip_speed = 0.05;                                    ///< [m/s] at which half of that is left
  Vector3 end_tangent;                                         ///< down the hole, at its lower end
  double end_reach = std::numeric_limits<double>::infinity();  ///< [m] end_tangent . lower end; endless for the last
};

/// The path cut where a section begins. Below the last section the last one goes on; so does the last arc below the
/// path. Throws `InputError` when a section is not below the one before, has no width, or a friction below 0.
std::vector<HolePiece> hole_pieces(const WellPath& path, const std::vector<HoleSection>& sections);

/// The piece between whose end planes a position lies, looked for from the piece `from` on: see `move_to_arc`.
std::size_t piece_at(const std::vector<HolePiece>& pieces, const Vector3& position, std::size_t from);

}  // namespace bitrock::runtime
