// Trajectories of WITSML.
#include <gtest/gtest.h>

#include "tests/unit/survey_fixture.hpp"

using namespace bitrock;

namespace {

using base::deg, base::foot;
using survey_files::read, survey_files::refusal, survey_files::warnings;

std::string station(const std::string& inside) {
  return "    <trajectoryStation uid=\"s\">\n" + inside + "    </trajectoryStation>\n";
}

std::string row(const std::string& md, const std::string& incl, const std::string& azi) {
  return station("<typeTrajStation>magnetic MWD</typeTrajStation>\n<md uom=\"ft\">" + md +
                 "</md>\n<incl uom=\"dega\">" + incl + "</incl>\n<azi uom=\"dega\">" + azi +
                 "</azi>\n<dls uom=\"dega/30m\">99</dls>\n");
}

std::string document(const std::string& stations) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<trajectorys xmlns=\"http://www.witsml.org/schemas/1series\" version=\"1.4.1.1\">\n"
         "  <trajectory uidWell=\"W\" uidWellbore=\"B\" uid=\"T\">\n"
         "    <nameWell>A-1</nameWell><mdMx uom=\"m\">4000</mdMx><aziRef>grid north</aziRef>\n" +
         stations + "  </trajectory>\n</trajectorys>\n";
}

TEST(SurveyWitsml, ATrajectoryIsTheSameWellAsItsTable) {
  const studies::WellSurvey survey =
      read(document(row("0", "0", "47.3") + row(" 1000\n", "3.5", "20") + row("2e3", "6", "30")));
  ASSERT_EQ(survey.stations.size(), 3u);
  EXPECT_DOUBLE_EQ(survey.stations[1].measured_depth, 1000 * foot);
  EXPECT_DOUBLE_EQ(survey.stations[1].inclination, 3.5 * deg);
  EXPECT_DOUBLE_EQ(survey.stations[2].azimuth, 30 * deg);
  EXPECT_EQ(survey.format, "WITSML trajectory");
  EXPECT_EQ(survey.md_unit.name, "ft");
  const studies::WellSurvey table = read("MD (ft),Inc (deg),Azi (deg)\n0,0,47.3\n1000,3.5,20\n2000,6,30\n");
  EXPECT_EQ(survey_points(survey)[2].position.z, survey_points(table)[2].position.z);
}

TEST(SurveyWitsml, NamespacesAndASingleTrajectory) {
  const std::string prefixed =
      "\xef\xbb\xbf<w:trajectory xmlns:w=\"x\"><w:trajectoryStation><w:md uom=\"m\">0</w:md><w:incl "
      "uom=\"rad\">0</w:incl>"
      "<w:azi uom=\"rad\">0</w:azi></w:trajectoryStation><w:trajectoryStation><w:md uom=\"m\">10</w:md>"
      "<w:incl uom=\"rad\">0.1</w:incl><w:azi uom=\"rad\">1</w:azi></w:trajectoryStation></w:trajectory>";
  EXPECT_EQ(read(prefixed).stations[1].inclination, 0.1);
}

TEST(SurveyWitsml, ATvdThatDisagreesIsTold) {
  const auto with_tvd = [](const char* tvd) {
    return document(station("<md uom=\"m\">0</md><incl uom=\"dega\">0</incl><azi uom=\"dega\">0</azi>") +
                    station(std::string("<md uom=\"m\">100</md><tvd uom=\"m\">") + tvd +
                            "</tvd><incl uom=\"dega\">0</incl><azi uom=\"dega\">0</azi>"));
  };
  EXPECT_EQ(warnings(with_tvd("100.4")), "");
  EXPECT_NE(warnings(with_tvd("100.6")).find("TVD 100.6 m, but 100 m by minimum curvature"), std::string::npos);
}

TEST(SurveyWitsml, EachFaultIsNamedWithItsLine) {
  const std::string good = row("0", "0", "0");
  EXPECT_EQ(refusal(document(good + station("<md uom=\"ft\">10</md>\n<azi uom=\"dega\">0</azi>\n"))),
            "s.csv:12: a station without <incl>");
  EXPECT_EQ(refusal(document(good + station("<md>10</md>\n"))), "s.csv:13: <md> without its unit (uom)");
  EXPECT_EQ(refusal(document(good + station("<md uom=\"furlong\">10</md>\n"))),
            "s.csv:13: <md>: the unit uom='furlong' is not known here");
  EXPECT_EQ(refusal(document(good + station("<md uom=\"m\">10</md>\n"))), "s.csv:13: <md> in m, above in ft");
  EXPECT_EQ(refusal(document(row("0", "0", "0") + row("100", "zero", "0"))),
            "s.csv:15: <incl>: 'zero' is not a number");
  EXPECT_EQ(refusal(document(row("100", "0", "0") + row("90", "0", "0"))),
            "s.csv:12: measured depth 90 ft below 100 ft (must grow from row to row)");
  EXPECT_EQ(refusal(document("")), "s.csv: a trajectory without stations (trajectoryStation)");
  EXPECT_EQ(refusal("<logs>\n<log/></logs>"),
            "s.csv:1: <logs> holds no trajectory (a WITSML 1.4.1.1 trajectory is needed, or a table)");
  EXPECT_EQ(refusal("<trajectorys><trajectory/>\n<trajectory/></trajectorys>"),
            "s.csv:2: a second trajectory (a file holds one survey)");
  EXPECT_EQ(refusal("<trajectorys>\n<trajectory>\n"), "s.csv:2: no XML: Start-end tags mismatch");
  EXPECT_EQ(refusal(document(good), {.units = {.md = "ft", .angle = {}}}),
            "s.csv: WITSML names its units (leave --md-unit and --angle-unit out)");
}

}  // namespace
