// What a table of a survey may look like, its units, and each message for what is none.
#include <gtest/gtest.h>

#include "studies/well/survey_units.hpp"
#include "tests/unit/survey_fixture.hpp"

using namespace bitrock;

namespace {

using base::deg, base::foot;
using survey_files::header, survey_files::read, survey_files::refusal;

/// 0, 100 and 200 m; 0, 3 and 6 degrees; 10, 20 and 30 degrees.
void expect_the_three(const studies::WellSurvey& survey, double length = 1.0) {
  ASSERT_EQ(survey.stations.size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(survey.stations[i].measured_depth, 100.0 * i * length);
    EXPECT_DOUBLE_EQ(survey.stations[i].inclination, 3.0 * i * deg);
    EXPECT_DOUBLE_EQ(survey.stations[i].azimuth, (10.0 + 10.0 * i) * deg);
  }
}

TEST(SurveyTable, CommasTabsAndBlanksAreTheSameTable) {
  for (const char* text : {"MD (m),Inc (deg),Azi (deg)\n0,0,10\n100,3,20\n200,6,30\n",
                           "MD (m)\tInc (deg)\tAzi (deg)\n0\t0\t10\n100\t3\t20\n200\t6\t30\n",
                           "MD (m)  Inc (deg) Azi (deg)\n 0 0 10\n 100  3 20\n 200   6 30\n",
                           "md_m,inc_deg,azi_deg\n0,0,10\n100,3,20\n200,6,30\n",
                           "\"Measured depth, m\",Incl [°],Azimuth (°)\n0,0,10\n100,3,20\n200,6,30",
                           "Name,AZI (deg),INC (deg),DEPT (m)\ntop,10,0,0\n,20,3,100\n,30,6,200\n",
                           "MD,Inc,Azi\nm,deg,deg\n0,0,10\n100,3,20\n200,6,30\n",
                           "# a comment\nMD\tINCL\tHAZI\n(m)\t(deg)\t(deg)\n0\t0\t10\n100\t3\t20\n200\t6\t30\n"}) {
    SCOPED_TRACE(text);
    expect_the_three(read(text));
  }
}

TEST(SurveyTable, ByteOrderMarkAndLineEndsOfAllSystems) {
  expect_the_three(read("\xef\xbb\xbf" + header + "0,0,10\n100,3,20\n200,6,30\n"));
  expect_the_three(read("MD (m),Inc (deg),Azi (deg)\r\n0,0,10\r\n\r\n100,3,20\r\n200,6,30\r\n"));
  expect_the_three(read("MD (m)\tInc (deg)\tAzi (deg)\r0\t0\t10\r100\t3\t20\r200\t6\t30\r"));
}

TEST(SurveyTable, UnitsStandInTheHeaderOrAreSaid) {
  const std::string rows = "0,0,10\n100,3,20\n200,6,30\n";
  expect_the_three(read("MD (ft),Inc (deg),Azi (deg)\n" + rows), foot);
  expect_the_three(read("MD (usft),Inc (deg),Azi (deg)\n" + rows), 1200.0 / 3937.0);
  expect_the_three(read("MD,Inc,Azi\n" + rows, {.units = {.md = "ft", .angle = "deg"}}), foot);
  const studies::WellSurvey radians = read("MD (m),Inc (rad),Azi (deg)\n0,0,10\n100,0.05,20\n");
  EXPECT_EQ(radians.stations[1].inclination, 0.05);
  EXPECT_EQ(radians.inclination_unit.name, "rad");
  EXPECT_EQ(radians.azimuth_unit.name, "deg");
}

TEST(SurveyTable, NoUnitIsNeverGuessed) {
  EXPECT_EQ(refusal("MD,Inc (deg),Azi (deg)\n0,0,0\n100,0,0\n"),
            "s.csv:1: 'MD': no unit (write it into the header, such as 'MD (ft)', or say --md-unit; known are m, ft, "
            "ftUS)");
  EXPECT_EQ(refusal("MD (m),Inc (deg),Azi\n0,0,0\n100,0,0\n"),
            "s.csv:1: 'Azi': no unit (write it into the header, such as 'Azi (deg)', or say --angle-unit; known are "
            "deg, rad)");
  EXPECT_EQ(refusal("MD (km),Inc (deg),Azi (deg)\n0,0,0\n1,0,0\n"),
            "s.csv:1: 'MD (km)': the unit 'km' is not known (m, ft, ftUS)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,0,0\n", {.units = {.md = "ft", .angle = {}}}),
            "s.csv:1: 'MD (m)': measured depth is said to be in ft, but also in m");
}

TEST(SurveyTable, AWellTraceOfPetrel) {
  const std::string comments =
      "# WELL TRACE FROM PETREL\n# WELL NAME: A-1\n# WELL HEAD X-COORDINATE: 1000.0 (m)\n"
      "# MD AND TVD ARE REFERENCED (=0) AT WELL DATUM AND INCREASE DOWNWARDS\n# ANGLES ARE GIVEN IN DEGREES\n";
  const std::string table =
      "#======\n      MD      X      Y      Z     TVD    DX     DY   AZIM_TN   INCL    DLS   AZIM_GN\n#======\n"
      " 0.0 1000 2000 0 0 0 0 11 0.0 0.0 10\n 100.0 1000 2000 -99.95 99.95 0 0 21 3.0 0.9 20\n"
      " 200.0 1000 2000 -199.6 199.6 0 0 31 6.0 0.9 30\n";
  expect_the_three(read(comments + "# DEPTH (Z, TVD) GIVEN IN m-UNITS\n" + table));
  expect_the_three(read(comments + "# DEPTH (Z, TVD) GIVEN IN ft-UNITS\n" + table), foot);
  expect_the_three(read(comments + table, {.units = {.md = "m", .angle = {}}}));
  EXPECT_NE(refusal(comments + table).find("'MD': no unit"), std::string::npos);
}

TEST(SurveyTable, EachFaultIsNamedWithItsLine) {
  EXPECT_EQ(refusal(""), "s.csv: empty (a header with names, and a row a station, are needed)");
  EXPECT_EQ(refusal(header), "s.csv: only a header (a row a station is needed)");
  EXPECT_EQ(refusal("MD,Inc,Azi\nm,deg,deg\n"), "s.csv: only a header (a row a station is needed)");
  EXPECT_EQ(refusal("0,0,0\n100,0,0\n"),
            "s.csv:1: '0' in the header (the first line gives the columns' names and units)");
  EXPECT_EQ(refusal("MD (m),Inc (deg)\n0,0\n"),
            "s.csv:1: no column of azimuth (named azi, azim, azimuth, hazi, azim gn, azim tn); the header has: MD (m), "
            "Inc (deg)");
  EXPECT_EQ(refusal("MD (m),Depth (m),Inc (deg),Azi (deg)\n0,0,0,0\n"),
            "s.csv:1: 'MD (m)' and 'Depth (m)' both name the measured depth (one column is needed)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,NaN,0\n"), "s.csv:3: Inc (deg): NaN (only finite numbers are allowed)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,,0\n"), "s.csv:3: Inc (deg): an empty text is not a number");
  EXPECT_EQ(refusal(header + "0,0,0\nMD (m),Inc (deg),Azi (deg)\n100,0,0\n"),
            "s.csv:3: MD (m): 'MD (m)' is not a number (a second header; a file holds one survey)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,5,2,5,0\n"),
            "s.csv:3: 5 values (the header has 3 columns; numbers have a point, not a comma)");
  EXPECT_EQ(refusal("MD (m)\tInc (deg)\tAzi (deg)\n0\t0\t0\n100,5\t0\t0\n"),
            "s.csv:3: MD (m): '100,5' is not a number (decimal comma: write 100.5)");
  EXPECT_EQ(refusal("MD (m);Inc (deg);Azi (deg)\n0;0;0\n"),
            "s.csv:1: semicolons between the columns (put commas or tabs between them, and points into the numbers)");
  EXPECT_EQ(refusal("Measured Depth (m) Inc (deg) Azi (deg)\n0 0 0\n"),
            "s.csv:2: 3 values (the header has 4 columns; where names have blanks, put commas between the columns)");
  EXPECT_NE(refusal(std::string("M\0D\0", 4)).find("UTF-16"), std::string::npos);
  EXPECT_NE(refusal("MD (m),Inc (\xb0),Azi (\xb0)\n0,0,0\n").find("UTF-8"), std::string::npos) << "Latin-1";
}

TEST(SurveyTable, StationsThatCannotBe) {
  EXPECT_EQ(refusal(header + "0,0,0\n100,0,0\n90,0,0\n"),
            "s.csv:4: measured depth 90 m below 100 m (must grow from row to row)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,0,0\n100,0,0\n"),
            "s.csv:4: measured depth 100 m below 100 m (must grow from row to row)");
  EXPECT_EQ(refusal(header + "-5,0,0\n100,0,0\n"),
            "s.csv:2: measured depth -5 m (from 0 to 20000 m; is it in another unit?)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,190,0\n"),
            "s.csv:3: inclination 190 deg (from 0, straight down, to 180 deg; are the angles in another unit?)");
  EXPECT_EQ(refusal("MD (m),Inc (rad),Azi (rad)\n0,0,0\n100,12,0\n"),
            "s.csv:3: inclination 12 rad (from 0, straight down, to 3.1415927 rad; are the angles in another unit?)");
  EXPECT_EQ(refusal(header + "0,0,0\n100,10,1205\n"),
            "s.csv:3: azimuth 1205 deg (from 0, north, over 90 deg, east, to 360 deg)");
  EXPECT_EQ(refusal(header + "0,0,0\n"), "s.csv: one station (a path needs two)");
  EXPECT_EQ(refusal(header + "0,90,0\n100,90,180\n"),
            "s.csv:3: the hole turns by 180 degrees to its opposite direction within 100 m (no path follows from that; "
            "look at inclination and azimuth)");
  EXPECT_EQ(read(header + "0,0,0\n100,90,0\n200,180,0\n").stations.size(), 3u) << "90 and 90 degrees are no 180";
}

TEST(SurveyTable, ADipIsNoInclination) {
  EXPECT_EQ(refusal("MD (m),Dip (deg),Azi (deg)\n0,-90,0\n100,-85,0\n"),
            "s.csv:1: a column of dip, which is measured from the horizontal (give the inclination, from the vertical: "
            "90 degrees - dip where down is positive, 90 degrees + dip where down is negative)");
  EXPECT_EQ(
      refusal(header + "0,-90,0\n100,-85,0\n"),
      "s.csv:2: inclination -90 deg (from 0, straight down, to 180 deg; is it a dip, from the horizontal, or does "
      "it stand for a missing value?)");
  EXPECT_EQ(read("MD (m),Inc (deg),Azi (deg),Dip (deg)\n0,0,0,71\n100,0,0,71\n").stations.size(), 2u)
      << "of the magnetic field";
}

TEST(SurveyUnits, NameAndUnitOfAHeader) {
  const auto parts = [](const char* cell) {
    const studies::HeaderName name = studies::header_name(cell);
    return name.words + "|" + name.unit;
  };
  EXPECT_EQ(parts("MD (ft)"), "md|ft");
  EXPECT_EQ(parts("MD[ft]"), "md|ft");
  EXPECT_EQ(parts("md_ft"), "md|ft");
  EXPECT_EQ(parts("Measured Depth, ft"), "measured depth|ft");
  EXPECT_EQ(parts("DEPT.M"), "dept|m");
  EXPECT_EQ(parts("AZIM_TN"), "azim tn|");
  EXPECT_EQ(parts("Inc (\xc2\xb0)"), "inc|\xc2\xb0");
  EXPECT_EQ(parts("m"), "m|");
  EXPECT_EQ(parts(")"), ")|");
  EXPECT_EQ(parts(""), "|");
}

}  // namespace
