// Files for ParaView, read back: each array is found at its offset, is as long as it says, and holds what was put in.
#include <gtest/gtest.h>

#include "tests/unit/output_fixtures.hpp"
#include "tests/unit/vtp_reader.hpp"
#include "views/cut/vtk_export.hpp"

using namespace bitrock;

namespace {

using vtp_reader::between, vtp_reader::integers, vtp_reader::reals;

const dem2d::Frame frame = output_fixtures::frame_at(2e-3, 2e-3);

TEST(Vtk, Discs) {
  const std::string vtp = views::vtp_text(views::vtk_discs(frame));
  EXPECT_NE(vtp.find("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"),
            std::string::npos);
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"4\" NumberOfVerts=\"4\">"), std::string::npos);
  EXPECT_EQ(reals(vtp, "position_m"),
            (std::vector<double>{6e-3, 1e-3, 0, 7e-3, 1e-3, 0, 8e-3, 3e-3, 0, 9e-3, 3e-3, 0}));
  EXPECT_EQ(reals(vtp, "radius_m"), frame.radius);
  EXPECT_EQ(reals(vtp, "velocity_m_per_s"), (std::vector<double>{0, 0, 0, 0.25, 0, 0, 0.5, 1, 0, -0.5, 2, 0}));
  EXPECT_NE(vtp.find("Name=\"velocity_m_per_s\" NumberOfComponents=\"3\""), std::string::npos);
  EXPECT_EQ(integers(vtp, "id"), frame.id);
  EXPECT_EQ(integers(vtp, "fragment"), frame.fragment);
  EXPECT_EQ(integers(vtp, "connectivity"), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(integers(vtp, "offsets"), (std::vector<int>{1, 2, 3, 4}));
}

TEST(Vtk, JointsFindTheirDiscsById) {
  const std::string vtp = views::vtp_text(views::vtk_joints(frame));
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"4\" NumberOfLines=\"2\">"), std::string::npos);
  EXPECT_EQ(integers(vtp, "connectivity"), (std::vector<int>{0, 1, 2, 3})) << "disc 4 stands in place 3";
  EXPECT_EQ(integers(vtp, "offsets"), (std::vector<int>{2, 4}));
}

TEST(Vtk, CracksUpToTheInstant) {
  const std::string vtp = views::vtp_text(views::vtk_cracks(output_fixtures::run(), frame));
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"4\" NumberOfLines=\"2\">"), std::string::npos) << "the third comes later";
  EXPECT_EQ(reals(vtp, "time_s"), (std::vector<double>{1e-3, 1.5e-3}));
  EXPECT_EQ(reals(vtp, "length_m"), (std::vector<double>{0.5e-3, 0.5e-3}));
  EXPECT_EQ(integers(vtp, "mode"), (std::vector<int>{1, 1}));
  EXPECT_EQ(integers(vtp, "parted"), (std::vector<int>{0, 1}));
  // two elements of 0.5 mm: a face of 1 mm upright at (6.5, 1), and one that stays at (6.6, 1.5)
  const std::vector<double> expected{6.5e-3, 0.5e-3, 0, 6.5e-3, 1.5e-3, 0, 6.6e-3, 1e-3, 0, 6.6e-3, 2e-3, 0};
  const std::vector<double> points = reals(vtp, "position_m");
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_NEAR(points[k], expected[k], 1e-15) << k;
}

TEST(Vtk, CracksSayTheirMode) {
  const std::string vtp =
      views::vtp_text(views::vtk_cracks(output_fixtures::run(), output_fixtures::frame_at(4e-3, 0)));
  EXPECT_EQ(integers(vtp, "mode"), (std::vector<int>{1, 1, 2}));
  EXPECT_EQ(integers(vtp, "parted"), (std::vector<int>{0, 1, 0}));
}

TEST(Vtk, CutterWithTheForceOfItsInstant) {
  const std::string vtp = views::vtp_text(views::vtk_cutter(output_fixtures::run(), frame));
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"4\" NumberOfPolys=\"1\">"), std::string::npos);
  EXPECT_EQ(reals(vtp, "force_x_N_per_m"), (std::vector<double>{2000.0}));
  EXPECT_EQ(reals(vtp, "force_y_N_per_m"), (std::vector<double>{-200.0}));
  const std::vector<double> points = reals(vtp, "position_m");
  EXPECT_DOUBLE_EQ(points[0], 2e-3);
  EXPECT_DOUBLE_EQ(points[1], 3e-3) << "the tip is one depth of cut below the surface at 4 mm";
}

TEST(Vtk, NothingIsAnEmptyFileThatStillNamesItsArrays) {
  const std::string vtp = views::vtp_text(views::vtk_cracks(output_fixtures::run(), output_fixtures::frame_at(0, 0)));
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"0\" NumberOfLines=\"0\">"), std::string::npos);
  EXPECT_TRUE(integers(vtp, "mode").empty());
}

TEST(Vtk, ListOfInstants) {
  const views::VtkInstant instants[] = {{0.0025, "frames/discs_0000.vtp"}, {1.0 / 3.0, "frames/discs_0001.vtp"}};
  const std::string pvd = views::pvd_text(instants);
  EXPECT_NE(pvd.find("<DataSet timestep=\"0.0025\" part=\"0\" file=\"frames/discs_0000.vtp\"/>"), std::string::npos);
  EXPECT_EQ(std::stod(between(pvd, "timestep=\"", "\"", pvd.find("0001") - 60)), 1.0 / 3.0);
}

}  // namespace
