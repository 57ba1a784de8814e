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

/// Twice the area is the sum of the cross products: positive where the corners run counter-clockwise.
double area_of(const dem2d::ConvexPolygon& outline) {
  double area = 0.0;
  for (std::size_t i = 0; i < outline.x.size(); ++i) {
    const std::size_t next = (i + 1) % outline.x.size();
    area += 0.5 * (outline.x[i] * outline.y[next] - outline.x[next] * outline.y[i]);
  }
  return area;
}

/// Every turn is to the left, and nothing is below the tip, which is the first corner.
void expect_convex_above_its_tip(const dem2d::ConvexPolygon& outline) {
  const std::size_t n = outline.x.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n, k = (i + 2) % n;
    const double turn = (outline.x[j] - outline.x[i]) * (outline.y[k] - outline.y[j]) -
                        (outline.y[j] - outline.y[i]) * (outline.x[k] - outline.x[j]);
    EXPECT_GT(turn, 0.0) << i;
    EXPECT_GE(outline.y[i], outline.y[0]);
  }
}

constexpr double degree = std::numbers::pi / 180.0;

TEST(Cutter, AClearanceOfItsOwnTurnsTheUndersideOnly) {
  const auto outline = dem2d::cutter_outline(
      {.diameter = 13e-3, .thickness = 8e-3, .back_rake = 20 * degree, .clearance = 7 * degree}, 1e-3, 2e-3);
  ASSERT_EQ(outline.x.size(), 4u);
  expect_convex_above_its_tip(outline);
  EXPECT_NEAR(std::atan2(outline.y[3] - outline.y[0], outline.x[0] - outline.x[3]), 7 * degree, 1e-12);
  EXPECT_NEAR(std::atan2(outline.x[1] - outline.x[0], outline.y[1] - outline.y[0]), 20 * degree, 1e-12);
  // the back is parallel to the face
  EXPECT_NEAR(std::atan2(outline.x[2] - outline.x[3], outline.y[2] - outline.y[3]), 20 * degree, 1e-12);
}

TEST(Cutter, AChamferTakesATriangleOffTheEdge) {
  const dem2d::CutterShape sharp{.diameter = 13e-3, .thickness = 8e-3, .back_rake = 15 * degree};
  dem2d::CutterShape chamfered = sharp;
  chamfered.chamfer = 0.4e-3;
  const auto outline = dem2d::cutter_outline(chamfered, 0.0, 0.0);
  ASSERT_EQ(outline.x.size(), 5u);
  expect_convex_above_its_tip(outline);
  EXPECT_NEAR(area_of(outline), 13e-3 * 8e-3 - 0.5 * 0.4e-3 * 0.4e-3, 1e-15);
  // 45 degrees to the face, which leans by 15: the bevel rises by 30 degrees from its lower end, the tip
  EXPECT_NEAR(std::atan2(outline.y[1] - outline.y[0], outline.x[1] - outline.x[0]), 30 * degree, 1e-12);
  EXPECT_NEAR(std::hypot(outline.x[1], outline.y[1]), 0.4e-3 * std::numbers::sqrt2, 1e-15);
  // 2 mm above the tip the face is where the sharp one is whose edge is 0.4 mm sin 15 lower
  const double edge = 0.4e-3 * std::sin(15 * degree), back = 0.4e-3 * std::cos(15 * degree);
  EXPECT_NEAR(dem2d::face_ahead_of_tip(chamfered, 2e-3), back + (2e-3 + edge) * std::tan(15 * degree), 1e-15);
  EXPECT_NEAR(dem2d::face_ahead_of_tip(chamfered, 0.1e-3), 0.1e-3 / std::tan(30 * degree), 1e-15) << "on the bevel";
}

TEST(Cutter, AWearFlatIsGroundParallelToTheCut) {
  const double rake = 20 * degree;
  dem2d::CutterShape worn{.diameter = 13e-3, .thickness = 8e-3, .back_rake = rake, .wear_flat = 1e-3};
  const auto outline = dem2d::cutter_outline(worn, 0.0, 0.0);
  ASSERT_EQ(outline.x.size(), 5u);
  expect_convex_above_its_tip(outline);
  EXPECT_NEAR(outline.x[0] - outline.x[4], 1e-3, 1e-15);
  EXPECT_NEAR(outline.y[4], 0.0, 1e-18);
  // the corner that is gone is a right triangle over the flat
  EXPECT_NEAR(area_of(outline), 13e-3 * 8e-3 - 0.5 * 1e-6 * std::sin(rake) * std::cos(rake), 1e-15);
  EXPECT_NEAR(dem2d::face_ahead_of_tip(worn, 2e-3), 2e-3 * std::tan(rake), 1e-15);
  EXPECT_NEAR(dem2d::longest_wear_flat(worn), 8e-3 / std::cos(rake), 1e-12) << "from the back end of the underside";
  worn.chamfer = 0.4e-3;  // first the bevel is worn, then the face
  const auto both = dem2d::cutter_outline(worn, 0.0, 0.0);
  expect_convex_above_its_tip(both);
  EXPECT_NEAR(both.x[0] - both.x.back(), 1e-3, 1e-15);
}

TEST(Cutter, WithoutChamferAndFlatNoBitChanges) {
  for (const double rake : {0.0, 10 * degree, 20 * degree, 30 * degree}) {
    const double tip_x = -0.3e-3, tip_y = 4.1e-3;
    const auto outline = dem2d::cutter_outline({13e-3, 8e-3, rake}, tip_x, tip_y);
    const double up_x = 13e-3 * std::sin(rake), up_y = 13e-3 * std::cos(rake);
    const double back_x = -8e-3 * std::cos(rake), back_y = 8e-3 * std::sin(rake);
    EXPECT_EQ(outline.x, (std::vector<double>{tip_x, tip_x + up_x, tip_x + up_x + back_x, tip_x + back_x}));
    EXPECT_EQ(outline.y, (std::vector<double>{tip_y, tip_y + up_y, tip_y + up_y + back_y, tip_y + back_y}));
  }
}

}  // namespace
