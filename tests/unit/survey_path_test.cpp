// The hole that follows from a survey: known paths, and each trap that surveys are known for.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/survey_fixture.hpp"

using namespace bitrock;

namespace {

using base::deg;
using studies::SurveyPoint;
using survey_files::header, survey_files::read, survey_files::refusal, survey_files::warnings;

std::vector<SurveyPoint> points(const std::string& text, const studies::SurveyWish& wish = {}) {
  return survey_points(read(text, wish));
}

double per_30_m(const SurveyPoint& point) {
  return point.curvature * 30.0 / deg;
}

void expect_at(const SurveyPoint& point, double north, double east, double tvd, double tolerance) {
  EXPECT_NEAR(point.position.x, north, tolerance);
  EXPECT_NEAR(point.position.y, east, tolerance);
  EXPECT_NEAR(point.position.z, tvd, tolerance);
}

// A bend of 10 degrees per 30 m is a quarter of a circle of radius 30/(10 pi/180) = 171.887 m.
TEST(SurveyPath, TheShippedExampleIsAQuarterOfACircleAndTwoLines) {
  const studies::WellSurvey survey = studies::read_survey(BITROCK_SOURCE_DIR "/campaigns/drill/survey_example.csv");
  const std::vector<SurveyPoint> all = survey_points(survey);
  const double radius = 30.0 / (10.0 * deg);
  ASSERT_EQ(all.size(), 18u);
  expect_at(all[4], 0.0, 0.0, 1205.0, 1e-9);
  expect_at(all[13], radius, 0.0, 1205.0 + radius, 1e-9);
  expect_at(all[17], radius + 125.0, 0.0, 1205.0 + radius, 1e-9);
  EXPECT_NEAR(per_30_m(all[5]), 10.0, 1e-12);
  EXPECT_EQ(per_30_m(all[4]), 0.0);
  EXPECT_TRUE(survey.warnings.empty());
}

// Well 1 of the ISCWSA error-model examples: three straight parts, two bends. Positions by minimum curvature with the
// dogleg from atan2: the plane is vertical, so each bend of angle b and length L moves by L/b (cos - cos, sin - sin).
TEST(SurveyPath, ThePathOfIscwsaWell1) {
  const std::vector<SurveyPoint> all =
      points(header + "0,0,0\n1200,0,75\n2100,60,75\n5100,60,75\n5400,90,75\n8000,90,75\n");
  expect_at(all[2], 111.219, 415.076, 1944.294, 1e-3);
  expect_at(all[4], 857.797, 3201.342, 3521.056, 1e-3);
  expect_at(all[5], 1530.727, 5712.749, 3521.056, 1e-3);
  const double bend = 900.0 / (60.0 * deg), across = bend * 0.5;  // 1 - cos 60
  expect_at(all[2], across * std::cos(75 * deg), across * std::sin(75 * deg), 1200.0 + bend * std::sin(60 * deg), 1e-9);
}

TEST(SurveyPath, AnAzimuthThroughNorthIsASmallTurn) {
  const std::vector<SurveyPoint> all = points(header + "0,60,359.9\n30,60,0.3\n");
  EXPECT_NEAR(per_30_m(all[1]), 0.3464, 5e-5);  // 0.4 degrees of azimuth at sin 60
  const std::vector<SurveyPoint> same = points(header + "0,60,-0.1\n30,60,0.3\n");
  EXPECT_NEAR(all[1].curvature, same[1].curvature, 1e-15);
}

TEST(SurveyPath, TheAzimuthOfAVerticalRowMeansNothing) {
  const std::vector<SurveyPoint> random = points(header + "0,0,123\n500,0,311\n1000,0,4\n1030,10,90\n");
  const std::vector<SurveyPoint> still = points(header + "0,0,90\n500,0,90\n1000,0,90\n1030,10,90\n");
  for (std::size_t i = 0; i < still.size(); ++i) {
    expect_at(random[i], still[i].position.x, still[i].position.y, still[i].position.z, 1e-9);
    EXPECT_NEAR(random[i].curvature, still[i].curvature, 1e-15);
  }
}

TEST(SurveyPath, NorthIsTheCosineOfTheAzimuthInAllQuadrants) {
  const double far = 100.0 * std::sqrt(0.5);
  for (const auto& [azimuth, north, east] :
       {std::tuple{45, far, far}, {135, -far, far}, {225, -far, -far}, {315, far, -far}}) {
    const std::string angles = ",90," + std::to_string(azimuth) + "\n";
    expect_at(points(header + "0" + angles + "100" + angles)[1], north, east, 0.0, 1e-9);
  }
}

TEST(SurveyPath, DoglegsPer30MetresAndPer100Feet) {
  const SurveyPoint bend = points(header + "0,0,0\n30,10,0\n")[1];
  EXPECT_NEAR(per_30_m(bend), 10.0, 1e-12);
  EXPECT_NEAR(bend.curvature * 100.0 * base::foot / deg, 10.16, 1e-12);  // 30.48 m
}

TEST(SurveyPath, FeetAreTheSameWell) {
  const std::vector<SurveyPoint> metres = points(header + "0,0,0\n304.8,0,0\n609.6,20,30\n");
  const std::vector<SurveyPoint> feet = points("MD (ft),Inc (deg),Azi (deg)\n0,0,0\n1000,0,0\n2000,20,30\n");
  for (std::size_t i = 0; i < metres.size(); ++i)
    expect_at(feet[i], metres[i].position.x, metres[i].position.y, metres[i].position.z, 1e-9);
}

TEST(SurveyPath, AFirstStationBelowTheSurfaceOfANearlyVerticalHole) {
  const std::string text = header + "800,3,90\n830,4,90\n";
  const std::vector<SurveyPoint> all = points(text);
  ASSERT_EQ(all.size(), 3u);
  expect_at(all[1], 0.0, 800 * std::sin(3 * deg), 800 * std::cos(3 * deg), 1e-9);
  EXPECT_EQ(warnings(text),
            "s.csv: begins at MD 800 m: the hole above is taken for a straight line, 3 degrees from the vertical\n");
}

TEST(SurveyPath, AFirstStationBelowTheSurfaceOfAnInclinedHole) {
  const std::string text = header + "800,23.4,90\n830,24,90\n";
  EXPECT_EQ(refusal(text),
            "s.csv:2: begins at MD 800 m with 23.4 degrees: the hole above is not known (add the stations from the "
            "surface on, or say by --tie-in-m north,east,TVD where the first one lies)");
  const studies::SurveyWish wish{.units = {}, .tie_in = runtime::Vector3{10.0, 200.0, 750.0}, .bit_depth = 0.0};
  const std::vector<SurveyPoint> all = points(text, wish);
  ASSERT_EQ(all.size(), 2u);
  expect_at(all[0], 10.0, 200.0, 750.0, 0.0);
  EXPECT_NEAR(all[1].position.y, 200.0 + 30.0 * std::sin(23.7 * deg), 1e-3);
  EXPECT_EQ(warnings(text, wish), "s.csv: begins at MD 800 m: the hole above is not known\n");
}

TEST(SurveyPath, GoesOnStraightToTheBit) {
  const std::string text = header + "0,0,0\n270,90,0\n";
  const studies::SurveyWish wish{.units = {}, .tie_in = {}, .bit_depth = 300.0};
  const std::vector<SurveyPoint> all = points(text, wish);
  ASSERT_EQ(all.size(), 3u);
  expect_at(all[2], 270.0 / (90.0 * deg) + 30.0, 0.0, 270.0 / (90.0 * deg), 1e-9);
  EXPECT_EQ(all[2].curvature, 0.0);
  EXPECT_NE(warnings(text, wish).find("ends at MD 270 m: the hole goes on straight to 300 m"), std::string::npos);
  EXPECT_EQ(points(text, {.units = {}, .tie_in = {}, .bit_depth = 200.0}).size(), 2u) << "the survey goes deeper";
}

TEST(SurveyPath, DoubtsAreTold) {
  EXPECT_EQ(
      warnings(header + "0,0,0\n30,31,0\n60,31,0\n90,63,0\n"),
      "s.csv: a dogleg of 32 degrees per 30 m between MD 60 and 90 m (few holes turn by more than 30; 1 more such "
      "place)\n");
  EXPECT_EQ(warnings(header + "0,0,0\n30,29.9,0\n"), "");
  EXPECT_EQ(
      warnings(header + "0,0,0\n500,0,0\n551,2,0\n"),
      "s.csv: 51 m between two stations in a curve, between MD 500 and 551 m (beyond 50 m the path between them is "
      "little known)\n");
  EXPECT_EQ(warnings(header + "0,0,0\n500,0,0\n550,2,0\n1000,2.1,0\n"), "") << "50 m, and straight";
}

TEST(SurveyPath, ATvdColumnThatDisagrees) {
  const std::string names = "MD (m),Inc (deg),Azi (deg),TVD (m)\n";
  // a quarter of a circle over 270 m goes 171.887 m down
  EXPECT_NE(
      warnings(names + "0,0,0,0\n270,90,0,172.5\n")
          .find("s.csv:3: TVD 172.5 m, but 171.8873 m by minimum curvature of the stations (the latter is used)\n"),
      std::string::npos);
  for (const char* rows : {"0,0,0,0\n270,90,0,172.3\n", "0,0,0,0\n270,90,0,\n", "0,0,0,?\n270,90,0,nan\n"})
    EXPECT_EQ(warnings(names + rows).find("TVD"), std::string::npos) << rows;
  const std::string feet = "MD (ft),Inc (deg),Azi (deg),TVD\n0,0,0,0\n1000,0,0,1000\n";
  EXPECT_EQ(warnings(feet), "") << "in the unit of the depth";
  EXPECT_EQ(warnings("MD (m),Inc (deg),Azi (deg),TVD (ft)\n0,0,0,0\n304.8,0,0,1000\n"), "");
}

}  // namespace
