// Where a place is in a well: what a step asks of path and hole.
#include <algorithm>
#include <cmath>

#include "runtime/well/hole.hpp"

namespace bitrock::runtime {

WellFoot offset_from(const WellArc& arc, const Vector3& position) {
  const Vector3 d = position - arc.start;
  const double aside = dot(d, arc.binormal);
  const Vector3 in_plane = d - aside * arc.binormal;
  const Vector3 u = arc.curvature * in_plane - arc.normal;
  const double g = length(u);
  const Vector3 outwards = (1.0 / g) * u;
  const double distance = (arc.curvature * dot(in_plane, in_plane) - 2.0 * dot(d, arc.normal)) / (1.0 + g);
  return {.offset = distance * outwards + aside * arc.binormal, .tangent = cross(arc.binormal, outwards)};
}

WellFoot foot_on(const WellArc& arc, const Vector3& position) {
  WellFoot foot = offset_from(arc, position);
  const Vector3 d = position - arc.start;
  const double forward = dot(d, arc.tangent);
  const double angle = std::atan2(arc.curvature * forward, 1.0 - arc.curvature * dot(d, arc.normal));
  foot.measured_depth = arc.begin + (arc.curvature > 0.0 ? angle / arc.curvature : forward);
  return foot;
}

std::size_t piece_at(const std::vector<HolePiece>& pieces, const Vector3& position, std::size_t from) {
  std::size_t i = std::min(from, pieces.size() - 1);
  while (i > 0 && dot(position - pieces[i].arc.start, pieces[i].arc.tangent) < 0.0) --i;
  while (i + 1 < pieces.size() && dot(position, pieces[i].end_tangent) >= pieces[i].end_reach) ++i;
  return i;
}

}  // namespace bitrock::runtime
