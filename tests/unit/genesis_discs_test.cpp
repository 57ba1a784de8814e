// Discs packed elsewhere: what the table may hold, what becomes of it, and the words for what it may not hold.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "dem2d/files/discs_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

/// Four columns and three rows of discs of radius 0.5 mm, 1 mm apart: 17 touching pairs (9 along rows, 8 along
/// columns).
std::string square_lattice(double x0 = 0.5e-3, double y0 = 0.5e-3) {
  std::string text = "radius_m,y_m,colour,x_m\n";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += fmt::format("0.0005,{},7,{}\n", y0 + 1e-3 * row, x0 + 1e-3 * column);
    }
  }
  return text;
}

class DiscsFile : public testing::Test {
 protected:
  const scratch::Folder folder{"discs_file"};
  dem2d::Rock rock;

  dem2d::Specimen read(const std::string& text, const std::optional<dem2d::BoxSize>& box = {}) {
    base::write_whole(folder / "discs.csv", text);
    return dem2d::specimen_from_discs(folder / "discs.csv", rock, 5, box);
  }
  void expect_refused(const std::string& text, const std::string& words,
                      const std::optional<dem2d::BoxSize>& box = {}) {
    try {
      read(text, box);
      ADD_FAILURE() << "accepted; wanted: " << words;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what() << "\nlacks: " << words;
    }
  }
};

TEST_F(DiscsFile, IsJoinedByTheGapRuleInABoxOfItsOwn) {
  const dem2d::Specimen specimen = read(square_lattice(-3e-3, 7e-3));
  EXPECT_EQ(specimen.disc1.size(), 17u);
  EXPECT_NEAR(specimen.width, 4e-3, 1e-15);
  EXPECT_NEAR(specimen.height, 3e-3, 1e-15);
  EXPECT_NEAR(specimen.x[0], 0.5e-3, 1e-15) << "shifted so that the lower left corner of the box is at the origin";
  EXPECT_NEAR(specimen.y[11], 2.5e-3, 1e-15);
  EXPECT_TRUE(specimen.packed_elsewhere());
  EXPECT_EQ(specimen.origin.substr(0, 17), "discs discs.csv (");
  rock.installation_gap = 0.45e-3;  // a diagonal of the square leaves a gap of 0.414 mm
  EXPECT_EQ(read(square_lattice()).disc1.size(), 17u + 12u);
}

TEST_F(DiscsFile, StaysWhereItIsInAGivenBox) {
  const dem2d::Specimen specimen = read(square_lattice(2e-3, 1e-3), dem2d::BoxSize{60e-3, 20e-3});
  EXPECT_EQ(specimen.width, 60e-3);
  EXPECT_EQ(specimen.x[0], 2e-3);
  EXPECT_EQ(specimen.y[0], 1e-3);
}

TEST_F(DiscsFile, OfAPackingGivesTheSamePackingBack) {
  const dem2d::Specimen made = dem2d::make_specimen(rock, 12e-3, 12e-3, 3, 1);
  const dem2d::Specimen read_back =
      read(base::csv_text({"x_m", "y_m", "radius_m"}, {made.x, made.y, made.radius}), dem2d::BoxSize{12e-3, 12e-3});
  EXPECT_EQ(read_back.x, made.x);
  EXPECT_EQ(read_back.radius, made.radius);
  EXPECT_EQ(read_back.disc1, made.disc1);
  EXPECT_EQ(read_back.disc2, made.disc2);
}

TEST_F(DiscsFile, SeedIsNotComparedButBoxAndRockAre) {
  const dem2d::Specimen specimen = read(square_lattice(), dem2d::BoxSize{4e-3, 3e-3});
  EXPECT_EQ(dem2d::mismatch(specimen, rock, 4e-3, 3e-3, 99), "");
  EXPECT_EQ(dem2d::mismatch(specimen, rock, std::nextafter(4e-3, 1.0), 3e-3, 99), "") << "4 mm, computed otherwise";
  EXPECT_NE(dem2d::mismatch(specimen, rock, 5e-3, 3e-3, 99).find("wanted is a bed of 5 x 3 mm"), std::string::npos);
  dem2d::Rock other = rock;
  other.installation_gap *= 2.0;
  EXPECT_NE(dem2d::mismatch(specimen, other, 4e-3, 3e-3, 99).find("another rock"), std::string::npos);
}

TEST(Specimen, DiscsThatHangTogetherInPiecesAreWarnedOf) {
  dem2d::Specimen specimen;
  specimen.x.resize(20);
  for (int disc = 0; disc + 1 < 20; ++disc) {  // a chain of twenty
    specimen.disc1.push_back(disc);
    specimen.disc2.push_back(disc + 1);
  }
  EXPECT_TRUE(dem2d::warnings(specimen).empty());
  specimen.disc1.erase(specimen.disc1.begin() + 11);
  specimen.disc2.erase(specimen.disc2.begin() + 11);
  ASSERT_EQ(dem2d::warnings(specimen).size(), 1u);
  EXPECT_EQ(dem2d::warnings(specimen)[0].find("the 20 discs hang together in 2 pieces, the largest has 60 % of them"),
            0u)
      << dem2d::warnings(specimen)[0];
}

TEST_F(DiscsFile, OriginSurvivesTheSpecimenFile) {
  const dem2d::Specimen specimen = read(square_lattice());
  dem2d::write_specimen(specimen, folder / "s.h5");
  const dem2d::Specimen again = dem2d::read_specimen(folder / "s.h5");
  EXPECT_EQ(again.origin, specimen.origin);
  EXPECT_EQ(again.disc2, specimen.disc2);
  EXPECT_EQ(again.seed, 5u);

  const dem2d::Specimen packed = dem2d::make_specimen(rock, 12e-3, 12e-3, 3, 1);
  dem2d::write_specimen(packed, folder / "p.h5");
  const dem2d::Specimen packed_again = dem2d::read_specimen(folder / "p.h5");
  EXPECT_FALSE(packed_again.packed_elsewhere());
  EXPECT_EQ(packed_again.pressure, packed.pressure);
  EXPECT_EQ(packed_again.radius_factor, packed.radius_factor);
}

TEST_F(DiscsFile, RefusesWhatIsNoRock) {
  const std::string good = square_lattice();
  expect_refused("x_m,y_m,radius_mm\n0,0,1\n", "a column is missing: radius_m");
  expect_refused("x_m,y_m,radius_m\n0,0,0.001\n0.002,0,0.001\n", "2 discs (at least 10 are needed)");
  expect_refused(good + "-0.0005,0.1,7,0.1\n",
                 "discs.csv:14: radius_m = -0.0005 (must be at least 1e-06 and at most 1)");
  expect_refused(good + "0,0.1,7,0.1\n", "discs.csv:14: radius_m = 0 (must be");
  expect_refused(good + "0.0005,1e300,7,0.1\n", "discs.csv:14: y_m = 1e+300 (must be");
  expect_refused(good + "0.0005,nan,7,0.1\n", "discs.csv:14: column y_m: nan");
  expect_refused(good + "0.0005,0.0005,7,0.0005\n", "the discs of lines 2 and 14 have the same centre");
  // 0.26 mm above the last disc: overlap 1 - 0.26 = 0.74 mm, 1.48 of the radius
  expect_refused(good + "0.0005,0.00276,7,0.0035\n", "the discs of lines 13 and 14 overlap by 1.48 of the smaller");
  expect_refused(good, "discs.csv:5: the disc at (0.0035, 0.0005) m lies outside the box of 3 x 3 mm",
                 dem2d::BoxSize{3e-3, 3e-3});
  expect_refused(good + "0.00004,0.1,7,0.1\n", "the smallest radius is 0.04 mm, less than");
  std::string apart = "x_m,y_m,radius_m\n";
  for (int i = 0; i < 10; ++i) apart += fmt::format("{},0,0.001\n", 0.01 * i);
  expect_refused(apart, "nothing would be joined");
}

TEST_F(DiscsFile, RadiiInAnotherUnitAreRefusedByItsName) {
  const auto lattice_of = [](double radius) {
    std::string text = "x_m,y_m,radius_m\n";
    for (int i = 0; i < 12; ++i) text += fmt::format("{},{},{}\n", 2 * radius * (i % 4), 2 * radius * (i / 4), radius);
    return text;
  };
  expect_refused(lattice_of(0.6),
                 "radius_m from 0.6 to 0.6 m, 800 times the radii of the rock ([discs] 0.5 to 0.75 mm): "
                 "are they in millimetres? (x_m, y_m and radius_m are in metres");
  expect_refused(lattice_of(1.6), "are they in millimetres?");  // beyond what is a radius at all
  expect_refused(lattice_of(0.06), "are they in centimetres?");
  expect_refused(lattice_of(0.0225), "are they in inches?");
  expect_refused(lattice_of(6e-7), "are they in kilometres?");
  expect_refused(lattice_of(2e-5), "0.04 times the radii of the rock ([discs] 0.5 to 0.75 mm) (x_m");

  rock.installation_gap = 0.01e-3;
  EXPECT_TRUE(dem2d::discs_warnings(read(lattice_of(0.6e-3))).empty());
  EXPECT_TRUE(dem2d::discs_warnings(read(lattice_of(0.2e-3))).empty()) << "a finer packing";
  const auto warnings = dem2d::discs_warnings(read(lattice_of(0.1e-3)));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("is 0.2 times the nearest radius of the rock file"), std::string::npos) << warnings[0];
}

TEST_F(DiscsFile, CountsThePiecesThatJointsMake) {
  const dem2d::Specimen whole = read(square_lattice());
  EXPECT_EQ(dem2d::pieces(whole).count, 1);
  EXPECT_EQ(dem2d::pieces(whole).largest, 12u);
  EXPECT_EQ(dem2d::pieces(whole).unjoined, 0);
  EXPECT_TRUE(dem2d::warnings(whole).empty());

  // a second block 1 mm to the right of the first, a pair above, and a disc alone
  const std::string block = square_lattice(5.5e-3);
  const dem2d::Specimen apart = read(square_lattice() + block.substr(block.find('\n') + 1) +
                                     "0.0005,0.0095,7,0.0005\n0.0005,0.0095,7,0.0015\n0.0005,0.0195,7,0.0005\n");
  const dem2d::Pieces pieces = dem2d::pieces(apart);
  EXPECT_EQ(pieces.count, 3);
  EXPECT_EQ(pieces.largest, 12u);
  EXPECT_EQ(pieces.unjoined, 1);
  ASSERT_EQ(dem2d::warnings(apart).size(), 1u);
  EXPECT_NE(dem2d::warnings(apart)[0].find("in 3 pieces, the largest has 44.4 % of them, and 1 discs have no joint"),
            std::string::npos)
      << dem2d::warnings(apart)[0];
}

TEST_F(DiscsFile, APackingOfOursIsOnePiece) {
  EXPECT_TRUE(dem2d::warnings(dem2d::make_specimen(rock, 12e-3, 12e-3, 3, 1)).empty());
}

}  // namespace
