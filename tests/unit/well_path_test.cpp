// The path of a well against surveys whose positions are known, and against geometry.
#include "runtime/well/well_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/errors.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

SurveyStation station(double depth, double inclination_deg, double azimuth_deg) {
  return {depth, inclination_deg * degree, azimuth_deg * degree};
}

void expect_near(const Vector3& a, const Vector3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

/// Test well No. 1 of the ISCWSA, in metres.
std::vector<SurveyStation> iscwsa_1() {
  return {station(0, 0, 0),      station(1200, 0, 0),   station(2100, 60, 75),
          station(5100, 60, 75), station(5400, 90, 75), station(8000, 90, 75)};
}

/// Vertical to 1205 m, then 10 degrees per 30 m to the horizontal: radius 171.887 m.
std::vector<SurveyStation> quarter_turn(double azimuth_deg) {
  return {station(0, 0, azimuth_deg), station(1205, 0, azimuth_deg), station(1475, 90, azimuth_deg),
          station(1600, 90, azimuth_deg)};
}

TEST(WellPath, IscwsaTestWellOne) {
  WellPath path = well_path(iscwsa_1());
  // by hand: R = 900/(60 deg) = 859.437; at 2100 TVD = 1200 + R sin 60, departure R (1 - cos 60)
  expect_near(point_at(path, 2100).position, {111.219, 415.076, 1944.294}, 6e-4);
  expect_near(point_at(path, 5400).position, {857.797, 3201.342, 3521.056}, 6e-4);
  expect_near(point_at(path, 8000).position, {1530.727, 5712.749, 3521.056}, 6e-4);
  const double radius = 900.0 / (60.0 * degree);
  EXPECT_NEAR(point_at(path, 2100).position.z, 1200.0 + radius * std::sin(60.0 * degree), 1e-9);
}

TEST(WellPath, QuarterTurnIsACircle) {
  const double radius = 270.0 / (90.0 * degree);
  for (const double azimuth : {0.0, 75.0, 200.0}) {
    const WellPath path = well_path(quarter_turn(azimuth));
    const Vector3 north{std::cos(azimuth * degree), std::sin(azimuth * degree), 0.0};
    const Vector3 centre = radius * north + Vector3{0.0, 0.0, 1205.0};
    for (double depth = 1205.0; depth <= 1475.0; depth += 15.0) {
      const WellPoint point = point_at(path, depth);
      EXPECT_NEAR(length(point.position - centre), radius, 1e-10);
      EXPECT_NEAR(length(point.tangent), 1.0, 1e-14);
      if (depth < 1475.0) expect_near(point.curvature, (1.0 / (radius * radius)) * (centre - point.position), 1e-14);
    }
    EXPECT_NEAR(point_at(path, 1475.0).position.z, 1205.0 + radius, 1e-10);  // 1376.887 m
    EXPECT_NEAR(point_at(path, 1600.0).position.z, 1205.0 + radius, 1e-10);
  }
}

TEST(WellPath, AzimuthThroughNorthIsASmallTurn) {
  // spherical law of cosines; a difference of azimuths of 359.6 degrees would give 119.6
  const double beta = std::acos(1.0 - std::pow(std::sin(60 * degree), 2) * (1.0 - std::cos(0.4 * degree)));
  EXPECT_NEAR(beta / degree, 0.3464, 5e-5);
  const WellPath path = well_path({station(1000, 60, 359.9), station(1030, 60, 0.3)});
  EXPECT_NEAR(path.arcs[0].curvature, beta / 30.0, 1e-11);
  const WellPath turned = well_path({station(1000, 60, -0.1), station(1030, 60, 360.3)});
  expect_near(point_at(path, 1020).position, point_at(turned, 1020).position, 1e-10);
}

TEST(WellPath, AzimuthOfAVerticalRowMeansNothing) {
  const WellPath plain = well_path(quarter_turn(30));
  const WellPath scattered = well_path(
      {station(0, 0, 313), station(400, 0, 12), station(1205, 0, 171), station(1475, 90, 30), station(1600, 90, 30)});
  for (const double depth : {300.0, 1000.0, 1300.0, 1590.0})
    expect_near(point_at(plain, depth).position, point_at(scattered, depth).position, 1e-9);
}

TEST(WellPath, NorthIsTheCosineOfTheAzimuth) {
  const struct { double azimuth, north, east; } quadrants[] = {{45, 1, 1}, {135, -1, 1}, {225, -1, -1}, {315, 1, -1}};
  for (const auto& q : quadrants) {
    const WellPath path = well_path({station(0, 90, q.azimuth), station(std::numbers::sqrt2, 90, q.azimuth)});
    expect_near(point_at(path, std::numbers::sqrt2).position, {q.north, q.east, 0.0}, 1e-15);
  }
}

TEST(WellPath, PositionAndTangentDoNotJumpAtStations) {
  const WellPath path = well_path({station(0, 0, 0), station(30, 3, 20), station(60, 8, 350), station(90, 8, 350),
                                   station(120, 40, 100), station(150, 120, 170)});
  for (double depth = 30.0; depth < 150.0; depth += 30.0) {
    const WellPoint above = point_at(path, depth - 1e-9), below = point_at(path, depth + 1e-9);
    expect_near(above.position, below.position, 3e-9);
    expect_near(above.tangent, below.tangent, 1e-9);
    // the tangent is the derivative of the position; curvatures here are below 0.05 1/m, so the secant over a jump of
    // them misses by less than 0.05 x 1e-5 / 2
    const Vector3 secant = 5e4 * (point_at(path, depth + 1e-5).position - point_at(path, depth - 1e-5).position);
    expect_near(secant, below.tangent, 2.5e-7);
    // and offset and tangent of a foot do not jump either where a point goes from one arc to the next
    const Vector3 aside = 0.03 * any_across(below.tangent);
    std::size_t up = nearest_arc(path, above.position + aside - 1e-7 * above.tangent);
    std::size_t down = nearest_arc(path, below.position + aside + 1e-7 * below.tangent);
    EXPECT_EQ(up + 1, down);
    const WellFoot foot_up = foot_on(path.arcs[up], below.position + aside);
    const WellFoot foot_down = foot_on(path.arcs[down], below.position + aside);
    expect_near(foot_up.offset, foot_down.offset, 1e-9);
    expect_near(foot_up.tangent, foot_down.tangent, 1e-9);
    EXPECT_NEAR(foot_up.measured_depth, depth, 1e-8);
    EXPECT_NEAR(foot_down.measured_depth, depth, 1e-8);
  }
}

TEST(WellPath, TheFootOfAPointIsWhereItWasPutUp) {
  const WellPath path = well_path(iscwsa_1());
  std::size_t arc = 0;
  for (double depth = 10.0; depth < 8000.0; depth += 97.0) {
    const WellPoint point = point_at(path, depth);
    const Vector3 one = any_across(point.tangent);
    const Vector3 offset = 0.02 * one - 0.015 * cross(point.tangent, one);
    move_to_arc(path, point.position + offset, arc);
    const WellFoot foot = foot_on(path.arcs[arc], point.position + offset);
    expect_near(foot.offset, offset, 2e-12);
    expect_near(foot.tangent, point.tangent, 1e-13);
    EXPECT_NEAR(foot.measured_depth, depth, 2e-9);
    EXPECT_EQ(arc, nearest_arc(path, point.position + offset));
  }
}

TEST(WellPath, AWeakCurvatureKeepsItsDigits) {
  // the offset from a circle of radius 6e9 m, which |p - c| - R would know to a micrometre only
  const WellPath path = well_path({station(0, 30, 0), {30.0, 30 * degree + 5e-9, 0.0}});
  const WellPoint point = point_at(path, 10.0);
  const Vector3 up = cross(point.tangent, Vector3{0.0, 1.0, 0.0});
  expect_near(foot_on(path.arcs[0], point.position + 0.025 * up).offset, 0.025 * up, 1e-14);
}

TEST(WellPath, GoesOnStraightOrAlongItsLastArc) {
  const std::vector<SurveyStation> stations{station(0, 0, 0), station(100, 0, 0), station(190, 30, 0)};
  WellPath straight = well_path(stations), arc = well_path(stations);
  extend_straight(straight, 220.0);
  extend_along_last_arc(arc, 280.0);
  EXPECT_EQ(end_depth(straight), 220.0);
  EXPECT_EQ(end_depth(arc), 280.0);
  const WellPoint end = point_at(well_path(stations), 190.0);
  expect_near(point_at(straight, 220.0).position, end.position + 30.0 * end.tangent, 1e-11);
  expect_near(point_at(arc, 280.0).tangent, tangent_of(station(0, 60, 0)), 1e-14);
  extend_straight(straight, 200.0);
  EXPECT_EQ(end_depth(straight), 220.0);
  EXPECT_THROW(extend_along_last_arc(arc, 700.0), base::InputError);
}

TEST(WellPath, RefusesWhatIsNoPath) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(well_path({station(0, 0, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(0, 1, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(10, 0, 0), station(9, 1, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(10, -1, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(10, 181, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(10, 180, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(nan, 1, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, nan, 0), station(10, 1, 0)}), base::InputError);
  EXPECT_THROW(well_path({station(0, 0, 0), station(10, 1, nan)}), base::InputError);
}

}  // namespace
