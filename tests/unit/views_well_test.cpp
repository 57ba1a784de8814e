// A run in a well as one looks at it afterwards: the file with the whole string comes back, the view in space, the
// files for ParaView, how a joint whirls.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "runtime/well/well_file.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/vtp_reader.hpp"
#include "tests/unit/well_texts.hpp"
#include "views/well/chapter.hpp"
#include "views/well/string_space.hpp"
#include "views/well/vtk_string.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

const std::string bent = R"(name = "bent"
[well]
)" + well_texts::bent_path +
                         R"(frames = 20
)" + well_texts::hole_and_pipe +
                         well_texts::slow_drive + R"([run]
duration_s = 3
step_ms = 0.5
sample_ms = 10
settling_s = 1
[[stress_point]]
name = "middle"
above_bit_m = 50
[[stress_point]]
name = "low"
above_bit_m = 12
)";

class WellViews : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "case.toml") << bent;
    well_ = read_well_case(folder_ / "case.toml");
    string_ = assemble(well_);
    run_ = run_well(well_, string_, make_source(well_.drill, std::nullopt));
    write_well_run(run_, well_, "", folder_ / "run.h5");
    file_ = read_well_run(folder_ / "run.h5");
  }

  scratch::Folder folder_{"well_views"};
  WellCase well_;
  WellString string_;
  WellRun run_;
  WellFile file_;
};

TEST_F(WellViews, TheFileComesBack) {
  EXPECT_EQ(resolved_toml(file_.well), resolved_toml(well_));
  EXPECT_EQ(file_.well.stations.size(), 3u);
  EXPECT_EQ(file_.well.stations[2].inclination, well_.stations[2].inclination);
  EXPECT_EQ(file_.series.hook_load_N, run_.series.hook_load_N);
  EXPECT_EQ(file_.stress.points[1].stress, run_.series.stress_Pa[1]);
  EXPECT_EQ(file_.frames.time_s, run_.frames.time_s);
  EXPECT_EQ(file_.frames.nodes, run_.frames.nodes);
  EXPECT_EQ(file_.frames.von_mises_Pa, run_.frames.von_mises_Pa);
  EXPECT_EQ(file_.frames.offset_down_m, run_.frames.offset_down_m);
  ASSERT_EQ(file_.orbits.size(), 2u);
  EXPECT_EQ(file_.orbits[1].right_m, run_.orbits[1].right_m);
  EXPECT_EQ(file_.orbits[1].clearance, run_.orbits[1].clearance);
  EXPECT_EQ(run_.orbits[0].up_m.size(), 200u);  // of 300 samples, 100 settle
}

TEST_F(WellViews, TheWholeCaseIsInTheFile) {
  std::ofstream(folder_ / "again.toml") << resolved_toml(well_);
  const WellCase again = read_well_case(folder_ / "again.toml");
  const WellRun second = run_well(again, assemble(again), make_source(again.drill, std::nullopt));
  EXPECT_EQ(second.series.hook_load_N, run_.series.hook_load_N);
  EXPECT_EQ(second.series.stress_Pa, run_.series.stress_Pa);
}

TEST_F(WellViews, AWishForFramesChangesNoBitOfTheRun) {
  WellCase none = well_;
  none.frames = 0;
  const WellRun run = run_well(none, string_, make_source(none.drill, std::nullopt));
  EXPECT_TRUE(run.frames.nodes.empty());
  EXPECT_EQ(run.series.hook_load_N, run_.series.hook_load_N);
  write_well_run(run, none, "", folder_ / "none.h5");
  EXPECT_TRUE(read_well_run(folder_ / "none.h5").frames.nodes.empty());
}

TEST_F(WellViews, AFileOfTheVersionBeforeIsRead) {
  base::Hdf5Writer old;
  old.head(well_format, well_format_version);
  std::string text = bent;  // as the user wrote it, its survey in a file that is not here
  const std::size_t begin = text.find("measured_depth_m"), end = text.find("frames");
  old.attribute("config_toml", text.replace(begin, end - begin, "survey = \"gone.csv\"\n"));
  old.attribute("model_fingerprint", "");
  for (const char* name : {"step_s", "wall_s", "axial_pass_band_Hz", "torsional_pass_band_Hz", "settling_s"})
    old.attribute(name, 0.5);
  for (const char* name : {"time_s", "hook_load_N", "drive_torque_N_m", "drive_rotation_rad_per_s",
                           "bit_rotation_rad_per_s", "weight_on_bit_N", "source_force_N", "torque_on_bit_N_m",
                           "rop_m_per_s", "bit_depth_m", "fed_m", "bit_side_force_N"})
    old.array(std::string("/series/") + name, std::vector{0.25, 0.75, 1.25, 1.5, 1.75}, "1", "");
  for (const char* point : {"1", "2"})
    old.array(fmt::format("/stress/point_{}_Pa", point), std::vector{1.0, 2.0, 1.0, 3.0, 2.0}, "Pa", "");
  old.array("/stress/measured_depth_m", std::vector{45.0, 83.0}, "m", "");
  old.attribute("stress_points", "middle\nlow\n");
  old.save(folder_ / "old.h5");
  const WellFile file = read_well_run(folder_ / "old.h5");
  EXPECT_TRUE(file.frames.nodes.empty());
  EXPECT_TRUE(file.orbits.empty());
  EXPECT_TRUE(file.well.stations.empty());
  EXPECT_EQ(file.series.rop_m_per_s[2], 1.25);
  EXPECT_EQ(file.stress.points[1].stress[3], 3.0);
}

TEST_F(WellViews, TheNodesLieWhereTheStringDoes) {
  const StringFrames& frames = run_.frames;
  ASSERT_EQ(frames.time_s.size(), 21u);  // the beginning, and 20
  EXPECT_EQ(frames.time_s.front(), 0.0);
  EXPECT_NEAR(frames.time_s.back(), 3.0, 1e-9);
  ASSERT_EQ(frames.nodes.back(), 11);  // ten segments
  const std::size_t bit = frames.north_m.size() - 11, table = frames.north_m.size() - 1;
  EXPECT_NEAR(frames.measured_depth_m[bit], run_.series.bit_depth_m.back(), 1e-4);
  EXPECT_NEAR(frames.down_m[table], 0.0, 0.05);  // it hangs at the table
  EXPECT_NEAR(frames.tension_N[table], run_.series.hook_load_N.back(), 0.1);
  EXPECT_NEAR(frames.torque_N_m[table], run_.series.drive_torque_N_m.back(), 0.1);
  EXPECT_EQ(frames.tension_N[bit], 0.0f);  // off bottom
  const WellPath path = well_path(well_.stations);
  for (std::size_t k = bit; k <= table; ++k) {
    const Vector3 middle = point_at(path, frames.measured_depth_m[k]).position;
    EXPECT_NEAR(frames.north_m[k] - frames.offset_north_m[k], middle.x, 1e-3);
    EXPECT_NEAR(frames.east_m[k] - frames.offset_east_m[k], middle.y, 1e-3);
    EXPECT_NEAR(frames.down_m[k] - frames.offset_down_m[k], middle.z, 1e-3);
  }
  // what presses sums up to what is seen of it; a joint that presses lies at the wall, as far as its spring gives way
  const double clearance = 0.5 * (0.2159 - 0.127);
  double pressed = 0.0;
  for (std::size_t k = bit + 1; k < table; ++k) {
    const double offset = std::hypot(frames.offset_north_m[k], frames.offset_east_m[k], frames.offset_down_m[k]);
    pressed += frames.side_force_N[k];
    if (frames.side_force_N[k] > 100.0f) {
      EXPECT_GT(offset, clearance);
      EXPECT_LT(offset, 1.1 * clearance);
    } else if (frames.side_force_N[k] == 0.0f) {
      EXPECT_LT(offset, clearance + 1e-6);
    }
  }
  EXPECT_GT(pressed, 1e3);
}

TEST(WellFrames, TheWorstFibreIsWorstOfAll) {
  const PipeSection pipe{.outer_diameter = 0.127, .inner_diameter = 0.10861};
  for (const double tension : {2e5, -2e5}) {
    const SectionLoad load{.tension = tension, .moment = {-3e3, 4e3, -5e3}};
    const double worst = stress_of(pipe, load, worst_angle(pipe, load, 1e7), 1e7).von_mises;
    double seen = 0.0;
    for (int k = 0; k < 3600; ++k)
      seen = std::max(seen, stress_of(pipe, load, k * std::numbers::pi / 1800.0, 1e7).von_mises);
    EXPECT_NEAR(worst, seen, 1e-5 * seen);
    EXPECT_GE(worst, seen);
  }
}

TEST(WellFrames, TensionAndBendingOnPaper) {
  // A = pi/4 (D^2 - d^2) = 3.4032e-3 m^2, I = pi/64 (D^4 - d^4) = 5.9390e-6 m^4: the build of 172 m radius
  const PipeSection pipe{.outer_diameter = 0.127, .inner_diameter = 0.10861};
  const SectionLoad load{.tension = 134e3, .moment = {0.0, 6.911e3, 0.0}};
  const Stress stress = stress_of(pipe, load, worst_angle(pipe, load, 0.0), 0.0);
  EXPECT_NEAR(stress.axial, 39.37e6, 0.01e6);
  EXPECT_NEAR(stress.normal - stress.axial, 73.89e6, 0.01e6);  // E r / R
}

TEST(WellFrames, InstantsLieEvenlyAndTheLastIsOne) {
  for (const auto& [samples, wished] : {std::pair{1000LL, 7}, {10LL, 40}, {9LL, 9}}) {
    int kept = 0;
    long long before = 0, longest = 0;
    for (long long k = 1; k <= samples; ++k) {
      if (!is_kept(k, samples, wished)) continue;
      ++kept;
      longest = std::max(longest, k - before);
      before = k;
    }
    EXPECT_EQ(kept, std::min<long long>(samples, wished));
    EXPECT_EQ(before, samples);
    EXPECT_LE(longest, samples / std::min<long long>(samples, wished) + 1);
  }
  EXPECT_FALSE(is_kept(5, 5, 0));
}

TEST(WellFrames, UpIsTheHighSideAndRightIsRight) {
  const HoleAxes level = hole_axes({1.0, 0.0, 0.0});  // towards north
  EXPECT_NEAR(level.up.z, -1.0, 1e-15);
  EXPECT_NEAR(level.right.y, 1.0, 1e-15);  // east
  const HoleAxes upright = hole_axes({0.0, 0.0, 1.0});
  EXPECT_NEAR(upright.up.x, 1.0, 1e-15);
  EXPECT_NEAR(upright.right.y, 1.0, 1e-15);
}

TEST(WellFrames, AJointThatGoesRoundBackwards) {
  Orbit orbit;  // 3 turns a second against the drive, sampled every millisecond for 2 s
  for (int k = 0; k <= 2000; ++k) {
    const double angle = 2.0 * std::numbers::pi * 3.0 * 1e-3 * k;  // counter-clockwise, seen down the hole
    orbit.right_m.push_back(static_cast<float>(0.02 * std::cos(angle)));
    orbit.up_m.push_back(static_cast<float>(0.02 * std::sin(angle)));
  }
  EXPECT_NEAR(views::whirl_rate(orbit, 1e-3), -2.0 * std::numbers::pi * 3.0, 1e-4);
  for (float& up : orbit.up_m) up = -up;
  EXPECT_NEAR(views::whirl_rate(orbit, 1e-3), 2.0 * std::numbers::pi * 3.0, 1e-4);
}

TEST_F(WellViews, TheViewInSpaceHoldsTheString) {
  const report::SpaceView view = views::string_space(file_, 5);
  ASSERT_EQ(view.frames.size(), 5u);
  const report::SpaceFrame& last = view.frames.back();
  ASSERT_EQ(last.line.x.size(), 11u);
  EXPECT_EQ(last.label, "3.0 s, bit at 95.0 m");
  EXPECT_EQ(last.line.z.front(), static_cast<double>(run_.frames.down_m[run_.frames.down_m.size() - 11]));
  EXPECT_NEAR(last.values[1].front(), 1e-3 * run_.frames.side_force_N[run_.frames.down_m.size() - 11], 1e-9);
  const std::vector<float>& depths = run_.frames.measured_depth_m;
  EXPECT_NEAR(view.guide_marks.back(), 1.03 * *std::max_element(depths.begin(), depths.end()), 1e-4);
  EXPECT_NO_THROW(report::check(view));
}

TEST_F(WellViews, ParaViewGetsTheNumbersOfTheFile) {
  const auto series = views::write_well_vtk(file_, folder_ / "vtk", "run.h5", {});
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].cells.size(), 21u);
  const std::string list = base::read_whole(folder_ / "vtk/string.pvd");
  EXPECT_NE(list.find(fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"frames/string_0020.vtp\"/>",
                                  run_.frames.time_s.back())),
            std::string::npos)
      << list;
  const std::string vtp = base::read_whole(folder_ / "vtk/frames/string_0020.vtp");
  EXPECT_NE(vtp.find("<Piece NumberOfPoints=\"11\" NumberOfLines=\"1\">"), std::string::npos);
  const std::vector<double> places = vtp_reader::reals(vtp, "position_m"), offsets = vtp_reader::reals(vtp, "offset_m"),
                            forces = vtp_reader::reals(vtp, "side_force_N");
  ASSERT_EQ(places.size(), 33u);
  ASSERT_EQ(forces.size(), 11u);
  const StringFrames& frames = run_.frames;
  const std::size_t first = frames.north_m.size() - 11;
  for (std::size_t k = 0; k < 11; ++k) {
    EXPECT_EQ(places[3 * k], static_cast<double>(frames.north_m[first + k]));
    EXPECT_EQ(places[3 * k + 1], static_cast<double>(frames.east_m[first + k]));
    EXPECT_EQ(places[3 * k + 2], static_cast<double>(frames.down_m[first + k]));
    EXPECT_EQ(offsets[3 * k + 1], static_cast<double>(frames.offset_east_m[first + k]));
    EXPECT_EQ(forces[k], static_cast<double>(frames.side_force_N[first + k]));
  }
  const std::vector<int> line{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  EXPECT_EQ(vtp_reader::integers(vtp, "connectivity"), line);
  const std::string hole = base::read_whole(folder_ / "vtk/frames/hole_0000.vtp");
  EXPECT_NEAR(vtp_reader::reals(hole, "radius_m").back(), 0.5 * 0.2159, 1e-15);
  // a shorter run leaves no frames of the longer one
  WellFile shorter = file_;
  shorter.frames.nodes.resize(3);
  shorter.frames.time_s.resize(3);
  views::write_well_vtk(shorter, folder_ / "vtk", "run.h5", {});
  EXPECT_FALSE(base::is_there(folder_ / "vtk/frames/string_0003.vtp"));
  shorter.frames = {};
  EXPECT_THROW(views::write_well_vtk(shorter, folder_ / "vtk", "run.h5", {}), base::InputError);
}

TEST_F(WellViews, APageHasItsChapters) {
  const std::vector<views::ShownWell> runs = views::shown_wells({"run.h5"}, {file_});
  report::Page page("title");
  views::add_well_chapters(page, runs, views::well_figures(runs));
  const std::string html = page.html_with("", "");
  for (const char* heading : {"Summary", "The string in its well", "Over time", "A closer look", "Along the string",
                              "Stresses", "Spectra", "Orbits", "Damage"})
    EXPECT_NE(html.find(std::string("\">") + heading + "</h2>"), std::string::npos) << heading;
  EXPECT_NE(html.find("space-1-data"), std::string::npos);
}

TEST_F(WellViews, AFileWithoutTheWholeStringHasAPage) {
  WellFile old = file_;  // as the version before wrote it
  old.frames = {};
  old.orbits.clear();
  old.well.stations.clear();
  const std::vector<views::ShownWell> runs = views::shown_wells({"run.h5"}, {old});
  report::Page page("title");
  views::add_well_chapters(page, runs, views::well_figures(runs));
  const std::string html = page.html_with("", "");
  EXPECT_EQ(html.find("space-1-data"), std::string::npos);
  EXPECT_NE(html.find("\">Stresses</h2>"), std::string::npos);
  EXPECT_FALSE(views::well_profile(runs.front()).has_value());
}

}  // namespace
