#pragma once
/// The line a hole follows: circular arcs between the stations of a survey, one after the other without a kink. It
/// reads no files and knows no string.

#include <cstddef>
#include <vector>

#include "runtime/well/vector3.hpp"

namespace bitrock::runtime {

/// One row of a survey.
struct SurveyStation {
  double measured_depth = 0.0;  ///< [m] along the hole
  double inclination = 0.0;     ///< [rad] from the vertical, 0 to pi; above pi/2 the hole rises
  double azimuth = 0.0;         ///< [rad] from north towards east; any number of turns
};

/// Direction of the hole, down the hole: (sin I cos A, sin I sin A, cos I).
Vector3 tangent_of(const SurveyStation& station);

/// Angle between two unit vectors [rad], atan2(|a x b|, a.b): right to rounding from 0 to pi.
double angle_between(const Vector3& a, const Vector3& b);

/// A piece of constant curvature. Straight where the curvature is 0.
struct WellArc {
  double begin = 0.0;      ///< [m] measured depth of its upper end
  double length = 0.0;     ///< [m]
  Vector3 start;           ///< [m] its upper end
  Vector3 tangent;         ///< down the hole, at the upper end
  Vector3 normal;          ///< from the upper end to the centre; any across the tangent where it is straight
  Vector3 binormal;        ///< tangent x normal
  double curvature = 0.0;  ///< [1/m] 0 or more
};

/// At least one arc; each begins where the one above ends.
struct WellPath {
  std::vector<WellArc> arcs;  ///< downwards
};

/// **What** Path of a survey by the method of minimum curvature.
/// **Equation** t = (sin I cos A, sin I sin A, cos I); beta = atan2(|t1 x t2|, t1.t2); the next station lies at
/// P + dM/2 (t1 + t2) tan(beta/2) / (beta/2); between the two the path is the arc of curvature beta / dM.
/// **Symbols** I, A [rad] inclination and azimuth; M [m] measured depth; beta [rad] dogleg angle.
/// **Source** [SawarynThorogood2005] for the method; beta without differences of angles, so that an azimuth through
/// north, or one of a vertical row, which means nothing, needs no care.
/// **Differences and validity** Curvature jumps at stations, tangent and position do not. `tie_in` [m] is the position
/// of the first station. Throws `InputError` for fewer than two stations, depths that do not grow, an inclination
/// outside 0 to 180 degrees, values that are not finite, and two stations that look in opposite directions.
WellPath well_path(const std::vector<SurveyStation>& stations, const Vector3& tie_in = {});

/// Measured depth of the lower end [m].
double end_depth(const WellPath& path);

/// Goes on to the measured depth `to` [m], as a straight line or along the last arc. Nothing if the path is as long.
void extend_straight(WellPath& path, double to);
/// The last arc may not become longer than half a circle: throws `InputError`.
void extend_along_last_arc(WellPath& path, double to);

/// What the path is like at one measured depth.
struct WellPoint {
  Vector3 position;   ///< [m]
  Vector3 tangent;    ///< down the hole
  Vector3 curvature;  ///< [1/m] towards the centre; at a station that of the arc below
};

/// `arc`: where the search begins, and the arc it was found on; 0 is always right. Above the first station and below
/// the last the first and the last arc go on.
WellPoint point_at(const WellPath& path, double measured_depth, std::size_t& arc);
/// The same, searched from the top.
WellPoint point_at(const WellPath& path, double measured_depth);

/// The point of the path nearest to a position.
struct WellFoot {
  Vector3 offset;               ///< [m] from the path to the position, across the path
  Vector3 tangent;              ///< down the hole
  double measured_depth = 0.0;  ///< [m]
};

/// **What** Foot of a position on one arc, or on its continuation.
/// **Equation** with d = p - P0, a = d - (d.b) b, u = k a - n, g = |u|:
///   e = ((k a.a - 2 d.n) / (1 + g)) u/g + (d.b) b,   t = b x u/g,   s = atan2(k d.t0, 1 - k d.n) / k.
/// **Symbols** P0, t0, n, b start, tangent, normal, binormal of the arc; k [1/m] curvature; e [m] offset; s [m] length
/// along the arc.
/// **Source** derived here: u/k points from the centre to p within the plane of the arc, so the distance from the
/// circle is (g - 1)/k = (g^2 - 1) / (k (1 + g)), written so that k cancels.
/// **Validity** One formula for arcs and straight lines, without loss of digits for k towards 0. Not at the centre of
/// the arc, where every point of the circle is as near (g = 0).
WellFoot foot_on(const WellArc& arc, const Vector3& position);
/// Without the measured depth, which costs an arc tangent: it is left 0.
WellFoot offset_from(const WellArc& arc, const Vector3& position);

/// Moves `arc` to the arc whose planes across the path at both its ends hold the position between them, from the arc it
/// names step by step. Right if that arc was near: a string moves little from one step to the next.
void move_to_arc(const WellPath& path, const Vector3& position, std::size_t& arc);
/// Index of the arc nearest to a position, looked for along the whole path.
std::size_t nearest_arc(const WellPath& path, const Vector3& position);

}  // namespace bitrock::runtime
