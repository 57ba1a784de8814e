#include "dem2d/tool/cutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bitrock::dem2d {

namespace {

struct Point {
  double x, y;
};

/// Where the line from a to b has this height.
Point at_height(const Point& a, const Point& b, double y) {
  return {a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), y};
}

/// From the back end of the underside, down to the edge at (0, 0) or to its chamfer, and up the face: heights fall, and
/// then rise.
std::vector<Point> lower_side(const CutterShape& shape) {
  const double rake = shape.back_rake, clearance = shape.clearance > 0.0 ? shape.clearance : rake;
  const double underside = shape.thickness / std::cos(clearance - rake);  // the back is parallel to the face
  std::vector<Point> side{{-underside * std::cos(clearance), underside * std::sin(clearance)}};
  if (shape.chamfer > 0.0) {
    // the triangle of the edge and the two ends of the chamfer, by the law of sines
    const double at_edge = 0.5 * std::numbers::pi + rake - clearance, at_face = 0.25 * std::numbers::pi;
    const double along = shape.chamfer * std::sin(at_face) / std::sin(at_edge + at_face);
    side.push_back({-along * std::cos(clearance), along * std::sin(clearance)});
    side.push_back({shape.chamfer * std::sin(rake), shape.chamfer * std::cos(rake)});
  } else {
    side.push_back({0.0, 0.0});
  }
  side.push_back({shape.diameter * std::sin(rake), shape.diameter * std::cos(rake)});
  return side;
}

/// What is left above `y`: both ends of the cut, and the corners above it.
std::vector<Point> ground(const std::vector<Point>& side, double y) {
  std::vector<Point> left;
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (k > 0 && (side[k].y > y) != (side[k - 1].y > y)) left.push_back(at_height(side[k - 1], side[k], y));
    if (side[k].y > y) left.push_back(side[k]);
  }
  return left;
}

/// Length of the cutter at a height between its lowest point and the lower of its two ends.
double length_at(const std::vector<Point>& side, double y) {
  double back = std::numeric_limits<double>::infinity(), front = -back;
  const auto reach = [&](double x) {
    back = std::min(back, x);
    front = std::max(front, x);
  };
  for (std::size_t k = 0; k + 1 < side.size(); ++k) {
    const Point &a = side[k], &b = side[k + 1];
    if (a.y == y) reach(a.x);
    if (b.y == y) reach(b.x);
    if ((a.y < y) != (b.y < y)) reach(at_height(a, b, y).x);
  }
  return front - back;
}

/// The height at which the cutter is so long: between corners the length grows in proportion to the height.
double height_of_flat(const std::vector<Point>& side, double length) {
  std::vector<double> heights;
  for (const Point& corner : side) heights.push_back(corner.y);
  std::sort(heights.begin(), heights.end());
  double low = heights.front(), length_low = length_at(side, low);
  for (const double high : heights) {
    const double length_high = length_at(side, high);
    if (length_high >= length && high > low)
      return low + (high - low) * (length - length_low) / (length_high - length_low);
    low = high;
    length_low = length_high;
  }
  return low;
}

/// The lower side as it is worn.
std::vector<Point> worn_side(const CutterShape& shape) {
  std::vector<Point> side = lower_side(shape);
  if (shape.wear_flat <= 0.0) return side;
  return ground(side, height_of_flat(side, shape.wear_flat));
}

/// The front one of the lowest corners.
std::size_t tip_of(const std::vector<Point>& side) {
  std::size_t tip = 0;
  for (std::size_t k = 1; k < side.size(); ++k) {
    if (side[k].y <= side[tip].y) tip = k;
  }
  return tip;
}

}  // namespace

ConvexPolygon cutter_outline(const CutterShape& shape, double tip_x, double tip_y) {
  const std::vector<Point> side = worn_side(shape);
  const std::size_t tip = tip_of(side);
  ConvexPolygon outline;
  const auto add = [&](const Point& point) {
    outline.x.push_back(tip_x + (point.x - side[tip].x));
    outline.y.push_back(tip_y + (point.y - side[tip].y));
  };
  for (std::size_t k = tip; k < side.size(); ++k) add(side[k]);
  outline.x.push_back(outline.x.back() - shape.thickness * std::cos(shape.back_rake));
  outline.y.push_back(outline.y.back() + shape.thickness * std::sin(shape.back_rake));
  for (std::size_t k = 0; k < tip; ++k) add(side[k]);
  return outline;
}

double face_ahead_of_tip(const CutterShape& shape, double height) {
  if (shape.chamfer <= 0.0 && shape.wear_flat <= 0.0) return height * std::tan(shape.back_rake);
  const std::vector<Point> side = worn_side(shape);
  const std::size_t tip = tip_of(side);
  const double y = side[tip].y + height;
  std::size_t above = tip + 1;
  while (above + 1 < side.size() && side[above].y < y) ++above;
  return at_height(side[above - 1], side[above], y).x - side[tip].x;
}

double longest_wear_flat(const CutterShape& shape) {
  const std::vector<Point> side = lower_side(shape);
  const double lowest = side[tip_of(side)].y;
  return side.front().y > lowest ? length_at(side, std::min(side.front().y, side.back().y)) : 0.0;
}

}  // namespace bitrock::dem2d
