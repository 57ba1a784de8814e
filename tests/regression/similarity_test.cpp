// Exact similarity: there is no length in the model but those of the input. All lengths doubled (grains and
// installation gap, bed, cutter, depth, travel, window, margin), stresses, densities and speed kept: forces per metre
// and times double, because k = E* d per metre and m = rho d^2 give a step of d sqrt(rho / E*). Two being the base of
// floating point numbers, the doubling is exact bit for bit as long as no constant carries a length, time or force.
//
// One does: the cutter starts a micrometre before the rock, whatever the grains (run_cut.cpp, start_gap). Here that gap
// is doubled by hand; the last test has what it does when it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dem2d/cut/run_cut.hpp"
#include "dem2d/cut/window.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/small_cuts.hpp"

using namespace bitrock;

namespace {

constexpr double start_gap = 1e-6;  ///< as in run_cut.cpp [m]

/// 8 mm, 1.2 mm deep in a bed of 24 x 7 mm with grains of 0.8 mm, some 250 discs, of which a window moves.
dem2d::CutCase small_cut() {
  dem2d::CutCase cut = small_cuts::fine_grained();
  cut.depth_of_cut = 1.2e-3;
  cut.cut_length = 8e-3;
  cut.bed_length = 24e-3;
  cut.bed_height = 7e-3;
  cut.moving_ahead = 6e-3;
  cut.moving_behind = 2.5e-3;
  dem2d::check_cut_case(cut, "small cut");
  return cut;
}

dem2d::CutCase doubled(dem2d::CutCase cut) {
  for (double* length : {&cut.rock.radius_min, &cut.rock.radius_max, &cut.rock.installation_gap, &cut.rock.initial_gap,
                         &cut.rock.specimen_width, &cut.rock.specimen_height, &cut.depth_of_cut, &cut.cut_length,
                         &cut.cutter_diameter, &cut.cutter_thickness, &cut.bed_length, &cut.bed_height,
                         &cut.moving_ahead, &cut.moving_behind, &cut.sampling_distance, &cut.domain_margin}) {
    *length *= 2.0;
  }
  return cut;
}

std::vector<double> doubled(std::vector<double> values) {
  for (double& value : values) value *= 2.0;
  return values;
}

const dem2d::Specimen& small_bed() {
  static const dem2d::CutCase cut = small_cut();
  static const dem2d::Specimen made = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  return made;
}

const dem2d::Specimen& large_bed() {
  static const dem2d::CutCase cut = doubled(small_cut());
  static const dem2d::Specimen made = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  return made;
}

/// What the cutter feels step by step, and what breaks.
struct Course {
  double step = 0.0;                                  ///< [s]
  std::vector<double> force_x, force_y, cutter_work;  ///< after each step [N/m], [J/m]
  std::vector<dem2d::Crack> cracks;
};

/// The loop of `run_cut` without its samples, the cutter starting at `outline`.
Course drive(const dem2d::CutCase& cut, const dem2d::Specimen& bed, const dem2d::ConvexPolygon& outline, double tip_x) {
  dem2d::World world = dem2d::make_cut_world(cut, bed);
  dem2d::Boundary& cutter = world.boundaries[0];
  cutter.shape = outline;
  dem2d::forgive_overlaps(cutter, world.discs);
  const dem2d::CutSchedule schedule = dem2d::plan_steps(cut, world.step);
  world.step = schedule.step;
  if (cut.mud_pressure > 0.0) dem2d::settle_under_mud(world, cut);
  dem2d::Window window = dem2d::open_window(world, cut, tip_x);
  Course course{.step = schedule.step};
  for (long long sample = 1; sample <= schedule.samples; ++sample) {
    for (int step = 0; step < schedule.steps_per_sample; ++step) {
      dem2d::advance(world);
      course.force_x.push_back(world.boundaries[0].force_x);
      course.force_y.push_back(world.boundaries[0].force_y);
      course.cutter_work.push_back(world.boundaries[0].work);
    }
    dem2d::advance_window(window, world, tip_x + cut.sampling_distance * static_cast<double>(sample));
  }
  course.cracks = world.cracks;
  return course;
}

TEST(Similarity, ARockOfDoubledGrainsIsPackedFromTheSameSeedDoubled) {
  const dem2d::Specimen &small = small_bed(), &large = large_bed();
  EXPECT_EQ(large.x, doubled(small.x));
  EXPECT_EQ(large.y, doubled(small.y));
  EXPECT_EQ(large.radius, doubled(small.radius));
  EXPECT_EQ(large.disc1, small.disc1);
  EXPECT_EQ(large.disc2, small.disc2);
  EXPECT_EQ(large.pressure, small.pressure);
}

void expect_doubled(const dem2d::CutCase& cut) {
  const dem2d::CutCase large_cut = doubled(cut);
  dem2d::Specimen bed = small_bed(), large_one = large_bed();
  bed.rock.tension_softening = large_one.rock.tension_softening = cut.rock.tension_softening;
  const dem2d::World start = dem2d::make_cut_world(cut, bed);
  const dem2d::ConvexPolygon outline = start.boundaries[0].shape;
  const double tip_x = -cut.depth_of_cut * std::tan(cut.back_rake) - start_gap;
  const Course small = drive(cut, bed, outline, tip_x);
  const Course large = drive(large_cut, large_one, {doubled(outline.x), doubled(outline.y)}, 2.0 * tip_x);

  EXPECT_EQ(large.step, 2.0 * small.step);
  EXPECT_EQ(large.force_x, doubled(small.force_x));
  EXPECT_EQ(large.force_y, doubled(small.force_y));
  EXPECT_EQ(large.cutter_work, doubled(doubled(small.cutter_work)));  // force times length
  ASSERT_GT(small.cracks.size(), 50u) << "a cut in which nothing happens shows nothing";
  ASSERT_EQ(large.cracks.size(), small.cracks.size());
  for (std::size_t k = 0; k < small.cracks.size(); ++k) {
    ASSERT_EQ(large.cracks[k].time, 2.0 * small.cracks[k].time);
    ASSERT_EQ(large.cracks[k].x, 2.0 * small.cracks[k].x);
    ASSERT_EQ(large.cracks[k].disc1, small.cracks[k].disc1);
    ASSERT_EQ(large.cracks[k].mode, small.cracks[k].mode);
  }
}

TEST(Similarity, DoubledLengthsDoubleForcesAndTimesBitForBit) {
  expect_doubled(small_cut());
}

TEST(Similarity, AlsoUnderMudOfTheSamePressure) {
  dem2d::CutCase cut = small_cut();
  cut.mud_pressure = 15e6;
  expect_doubled(cut);
}

TEST(Similarity, AlsoInRockThatSoftens) {
  dem2d::CutCase cut = small_cut();
  cut.rock.tension_softening = 3.0;
  expect_doubled(cut);
}

// In the doubled cut the start gap is not doubled, so in its own measure the cutter is half of it ahead. Until the
// first crack that is what the forces differ by: half a micrometre's worth of the climb, twice that allowed because the
// rock rings. Afterwards the two are different runs of a chaotic process.
TEST(Similarity, AWholeCutIsDoubledButForTheGapBeforeTheRock) {
  const dem2d::CutCase cut = small_cut();
  const dem2d::CutRun small = dem2d::run_cut(cut, small_bed()), large = dem2d::run_cut(doubled(cut), large_bed());
  EXPECT_EQ(large.step, 2.0 * small.step);
  EXPECT_EQ(large.duration, 2.0 * small.duration);
  EXPECT_EQ(large.time, doubled(small.time));

  ASSERT_FALSE(small.cracks.empty());
  const double whole_until = std::min(small.cracks.front().time, 0.5 * large.cracks.front().time);
  std::size_t whole = 0;
  double steepest = 0.0;  // climb from one sample to the next [N/m]
  for (; whole + 1 < small.time.size() && small.time[whole + 1] < whole_until; ++whole) {
    steepest = std::max(steepest, std::fabs(small.force_x[whole + 1] - small.force_x[whole]));
  }
  ASSERT_GT(whole, 3u);
  const double allowed = 2.0 * (0.5 * start_gap / cut.sampling_distance) * steepest;
  for (std::size_t k = 0; k < whole; ++k) EXPECT_NEAR(0.5 * large.force_x[k], small.force_x[k], allowed) << k;
}

}  // namespace
