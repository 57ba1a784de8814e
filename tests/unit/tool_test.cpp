// Geometry of cutter and walls.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/random.hpp"
#include "dem2d/tool/convex_polygon.hpp"
#include "dem2d/tool/cutter.hpp"

using namespace bitrock;

namespace {

TEST(ConvexPolygon, NearestPointOfAFaceACornerAndTheInside) {
  const auto square = dem2d::rectangle(0.0, 0.0, 2.0, 2.0);
  const auto face = dem2d::nearest_point(square, 1.0, 3.0);
  EXPECT_DOUBLE_EQ(face.distance, 1.0);
  EXPECT_DOUBLE_EQ(face.normal_y, 1.0);
  const auto corner = dem2d::nearest_point(square, 5.0, 6.0);
  EXPECT_DOUBLE_EQ(corner.distance, 5.0);
  EXPECT_DOUBLE_EQ(corner.normal_x, 0.6);
  EXPECT_DOUBLE_EQ(corner.normal_y, 0.8);
  const auto inside = dem2d::nearest_point(square, 1.0, 1.9);
  EXPECT_NEAR(inside.distance, -0.1, 1e-15);
  EXPECT_DOUBLE_EQ(inside.normal_y, 1.0);
  EXPECT_DOUBLE_EQ(inside.y, 2.0);
}

TEST(ConvexPolygon, DistanceAgreesWithABruteSearchOfTheBoundary) {
  const auto outline = dem2d::cutter_outline({13e-3, 8e-3, 0.3}, 1e-3, 2e-3);
  base::Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const double x = base::uniform(random, -20e-3, 20e-3), y = base::uniform(random, -20e-3, 25e-3);
    double brute = 1.0;
    constexpr int samples = 2000;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      for (int s = 0; s <= samples; ++s) {
        const double share = static_cast<double>(s) / samples;
        brute = std::min(brute, std::hypot(outline.x[i] + share * (outline.x[next] - outline.x[i]) - x,
                                           outline.y[i] + share * (outline.y[next] - outline.y[i]) - y));
      }
    }
    const auto point = dem2d::nearest_point(outline, x, y);
    // the sampled boundary misses the nearest point by at most half a sample (6.5e-6 m / 2)
    EXPECT_NEAR(std::fabs(point.distance), brute, 4e-6);
    EXPECT_NEAR(point.x + point.distance * point.normal_x, x, 1e-15);
    EXPECT_NEAR(point.y + point.distance * point.normal_y, y, 1e-15);
  }
}

TEST(Cutter, FaceLooksForwardAndDownByTheBackRake) {
  constexpr double rake = 15.0 * std::numbers::pi / 180.0;
  const auto outline = dem2d::cutter_outline({13e-3, 8e-3, rake}, 0.0, 0.0);
  const double edge_x = outline.x[1] - outline.x[0], edge_y = outline.y[1] - outline.y[0];
  EXPECT_NEAR(std::hypot(edge_x, edge_y), 13e-3, 1e-15);
  EXPECT_NEAR(edge_y / 13e-3, std::cos(rake), 1e-12);    // outward normal (edge_y, -edge_x): forward ...
  EXPECT_NEAR(-edge_x / 13e-3, -std::sin(rake), 1e-12);  // ... and down
  double area = 0.0;                                     // counter-clockwise: positive
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    area += 0.5 * (outline.x[i] * outline.y[next] - outline.x[next] * outline.y[i]);
    EXPECT_GE(outline.y[i], 0.0) << "nothing of the cutter is below its tip";
  }
  EXPECT_NEAR(area, 13e-3 * 8e-3, 1e-15);
}

}  // namespace
