#pragma once
/// A rigid convex polygon and the point of its boundary nearest to a disc's centre. Cutter, platens and packing box
/// are all such polygons, so there is one contact search and one contact law for them. A disc touches a polygon in at
/// most one point, so a corner is never counted twice.

#include <vector>

namespace bitrock::dem2d {

/// Corners in counter-clockwise order [m].
struct ConvexPolygon {
  std::vector<double> x, y;  ///< corners, counter-clockwise [m]
};

/// Where a polygon is nearest to a point.
struct NearestPoint {
  double x, y;                ///< on the boundary [m]
  double normal_x, normal_y;  ///< from the polygon towards the query point, unit length [1]
  double distance;            ///< from boundary to query point [m]; negative inside
};

/// Outside: the Euclidean nearest point. Inside: the foot on the face that is least far away.
NearestPoint nearest_point(const ConvexPolygon& polygon, double x, double y);

/// With these edges [m].
ConvexPolygon rectangle(double x_low, double y_low, double x_high, double y_high);

/// Moves all corners by so much [m].
void translate(ConvexPolygon& polygon, double dx, double dy);

}  // namespace bitrock::dem2d
