#include "dem2d/tool/convex_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bitrock::dem2d {

NearestPoint nearest_point(const ConvexPolygon& polygon, double x, double y) {
  const std::size_t corners = polygon.x.size();
  NearestPoint inside{0.0, 0.0, 0.0, 0.0, -std::numeric_limits<double>::infinity()};
  NearestPoint outside{0.0, 0.0, 0.0, 0.0, std::numeric_limits<double>::infinity()};
  bool is_inside = true;
  for (std::size_t i = 0; i < corners; ++i) {
    const std::size_t next = i + 1 < corners ? i + 1 : 0;
    const double edge_x = polygon.x[next] - polygon.x[i], edge_y = polygon.y[next] - polygon.y[i];
    const double length = std::sqrt(edge_x * edge_x + edge_y * edge_y);
    const double normal_x = edge_y / length, normal_y = -edge_x / length;  // outward for counter-clockwise corners
    const double to_x = x - polygon.x[i], to_y = y - polygon.y[i];
    const double height = to_x * normal_x + to_y * normal_y;
    const double along = std::clamp((to_x * edge_x + to_y * edge_y) / (length * length), 0.0, 1.0);
    const double foot_x = polygon.x[i] + along * edge_x, foot_y = polygon.y[i] + along * edge_y;
    if (height > 0.0) is_inside = false;
    if (height > inside.distance) inside = {x - height * normal_x, y - height * normal_y, normal_x, normal_y, height};
    const double gap_x = x - foot_x, gap_y = y - foot_y;
    const double distance = std::sqrt(gap_x * gap_x + gap_y * gap_y);
    if (distance > 0.0 && distance < outside.distance) {
      outside = {foot_x, foot_y, gap_x / distance, gap_y / distance, distance};
    }
  }
  return is_inside ? inside : outside;
}

ConvexPolygon rectangle(double x_low, double y_low, double x_high, double y_high) {
  return {{x_low, x_high, x_high, x_low}, {y_low, y_low, y_high, y_high}};
}

void translate(ConvexPolygon& polygon, double dx, double dy) {
  for (double& x : polygon.x) x += dx;
  for (double& y : polygon.y) y += dy;
}

}  // namespace bitrock::dem2d
