// Small whole cuts: the same bits for any number of threads and any repeat, and forces of the right kind.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.hpp"
#include "dem2d/files/run_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/step/step.hpp"
#include "tests/scratch.hpp"
#include "views/cut/snapshot.hpp"

using namespace bitrock;

namespace {

/// A shallow, short, fast cut in a small bed: about 200 discs, under a second.
dem2d::CutCase small_cut() {
  dem2d::CutCase cut = dem2d::read_cut_case(std::string(BITROCK_SOURCE_DIR) + "/campaigns/cuts/example.toml");
  cut.cutter_speed = 2.0;
  cut.cut_length = 8e-3;
  cut.bed_length = 24e-3;
  cut.bed_height = 12e-3;
  dem2d::check_cut_case(cut, "small cut");
  return cut;
}

dem2d::Specimen small_bed(int threads = 1) {
  const dem2d::CutCase cut = small_cut();
  return dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, threads);
}

TEST(Genesis, PacksDenseAndConnected) {
  dem2d::CutCase cut = small_cut();
  cut.rock.packing_pressure = 30e6;
  const dem2d::Specimen bed = dem2d::make_specimen(cut.rock, cut.bed_length, cut.bed_height, 3, 1);
  EXPECT_LE(bed.equilibrium_ratio, 1e-4);
  EXPECT_GT(dem2d::coordination_number(bed), 4.0);
  EXPECT_LT(dem2d::coordination_number(bed), 6.0);
  EXPECT_NEAR(bed.pressure / bed.rock.packing_pressure, 1.0, 0.01);
  // 0.113 in a core of 3600 discs. Along the walls of this small box, a strip of a tenth of a millimetre stays open:
  // 72 mm of wall make that two hundredths of the area. Discs there have fewer neighbours, too.
  EXPECT_GT(dem2d::porosity(bed), 0.11);
  EXPECT_LT(dem2d::porosity(bed), 0.15);
  EXPECT_LE(dem2d::floaters(bed), static_cast<int>(bed.x.size()) / 15);
}

TEST(Genesis, SameSeedSameBytesForAnyThreads) {
  const scratch::Folder folder("genesis");
  dem2d::write_specimen(small_bed(1), folder / "one.h5");
  dem2d::write_specimen(small_bed(2), folder / "two.h5");
  EXPECT_EQ(base::read_whole(folder / "one.h5"), base::read_whole(folder / "two.h5"));
  const dem2d::Specimen read = dem2d::read_specimen(folder / "one.h5");
  EXPECT_EQ(read.x, small_bed().x);
  EXPECT_EQ(read.disc2, small_bed().disc2);
}

TEST(Genesis, AKeptSpecimenIsKnownByItsBoxRockAndSeed) {
  const dem2d::Specimen bed = small_bed();
  dem2d::Rock rock = bed.rock;
  EXPECT_EQ(dem2d::mismatch(bed, rock, bed.width, bed.height, 3), "");
  EXPECT_NE(dem2d::mismatch(bed, rock, bed.width, bed.height, 4).find("made with seed 3"), std::string::npos);
  EXPECT_NE(dem2d::mismatch(bed, rock, 2.0 * bed.width, bed.height, 3).find("24 x 12 mm"), std::string::npos);
  rock.cohesion *= 2.0;
  EXPECT_NE(dem2d::mismatch(bed, rock, bed.width, bed.height, 3).find("another rock"), std::string::npos);
}

TEST(Cut, SameBitsForOneAndTwoThreads) {
  const auto cut = small_cut();
  const auto bed = small_bed();
  const auto one = dem2d::run_cut(cut, bed), two = dem2d::run_cut(cut, bed, {.threads = 2});
  EXPECT_EQ(one.force_x, two.force_x);
  EXPECT_EQ(one.force_y, two.force_y);
  ASSERT_EQ(one.cracks.size(), two.cracks.size());
  for (std::size_t k = 0; k < one.cracks.size(); ++k) {
    EXPECT_EQ(one.cracks[k].time, two.cracks[k].time);
    EXPECT_EQ(one.cracks[k].disc1, two.cracks[k].disc1);
    EXPECT_EQ(one.cracks[k].x, two.cracks[k].x);
  }
}

TEST(Cut, TheRockResistsAndPushesOutAndBreaks) {
  const auto run = dem2d::run_cut(small_cut(), small_bed(), {.frames = 2});
  EXPECT_GT(run.mean_force_x, 0.0);
  EXPECT_GT(run.mean_force_y, 0.0) << "with positive back rake the rock pushes the cutter out";
  EXPECT_GT(run.cracks_tensile, 10);
  EXPECT_EQ(run.time.size(), 400u);
  EXPECT_NEAR(run.time.back(), 8e-3 / 2.0, 1e-12);
  EXPECT_EQ(run.frames.size(), 2u);
  for (const dem2d::Crack& crack : run.cracks) {
    EXPECT_GE(crack.time, 0.0);
    EXPECT_LE(crack.time, run.duration);
  }
}

TEST(Cut, TheBedIsHeldByItsOutermostColumnAndFreeAtItsSurfaceAndWhereTheCutterEnters) {
  const auto cut = small_cut();
  const auto bed = small_bed();
  dem2d::World world = dem2d::make_cut_world(cut, bed);
  const dem2d::Discs start = world.discs;
  const double column = 2.0 * *std::max_element(bed.radius.begin(), bed.radius.end());
  const double tip_y = bed.height - cut.depth_of_cut;
  int held = 0, left = 0;
  for (std::size_t i = 0; i < start.x.size(); ++i) {
    const bool at_left = start.x[i] < column && start.y[i] < tip_y - 2.0 * column;
    const bool outermost = at_left || start.y[i] < column || start.x[i] > bed.width - column;
    EXPECT_EQ(start.inverse_mass[i] == 0.0, outermost) << start.x[i] << " " << start.y[i];
    held += outermost ? 1 : 0;
    left += at_left && start.y[i] > column ? 1 : 0;
  }
  EXPECT_GT(held, 30);
  EXPECT_GT(left, 2);
  world.boundaries[0].velocity_x = 20.0;
  for (int step = 0; step < 200; ++step) dem2d::advance(world);
  for (std::size_t i = 0; i < start.x.size(); ++i) {
    if (start.inverse_mass[i] != 0.0) continue;
    EXPECT_EQ(world.discs.x[i], start.x[i]);
    EXPECT_EQ(world.discs.y[i], start.y[i]);
    EXPECT_EQ(world.discs.angle[i], start.angle[i]);
  }
}

TEST(Cut, TheRunInIsCutButNotCounted) {
  dem2d::CutCase cut = small_cut();
  const dem2d::CutRun all = dem2d::run_cut(cut, small_bed());
  cut.run_in = 3e-3;
  cut.cut_length -= cut.run_in;
  const dem2d::CutRun rest = dem2d::run_cut(cut, small_bed());
  const std::size_t skipped = all.force_x.size() - rest.force_x.size();
  EXPECT_EQ(skipped, static_cast<std::size_t>(std::llround(3e-3 / cut.sampling_distance)));
  const std::vector<double> tail(all.force_x.begin() + static_cast<std::ptrdiff_t>(skipped), all.force_x.end());
  EXPECT_EQ(rest.force_x, tail);
  EXPECT_EQ(rest.time.front(), all.time[skipped]);
  EXPECT_EQ(rest.energies.size(), rest.force_x.size());
  EXPECT_EQ(rest.energy_residual_fraction, all.energy_residual_fraction);
  EXPECT_EQ(rest.steps, all.steps);
  EXPECT_NEAR(rest.cut_length, 5e-3, 1e-12);
  double sum = 0.0;
  for (const double f : tail) sum += f;
  EXPECT_NEAR(rest.mean_force_x, sum / static_cast<double>(tail.size()), 1e-9 * rest.mean_force_x);
}

TEST(Cut, ACutterThatMovesAwayFromTheRockFeelsNothing) {
  auto cut = small_cut();
  const auto bed = small_bed();
  dem2d::World world = dem2d::make_cut_world(cut, bed);
  world.boundaries[0].velocity_x = -1.0;
  for (int step = 0; step < 500; ++step) {
    dem2d::advance(world);
    ASSERT_EQ(world.boundaries[0].force_x, 0.0);
  }
  // nothing is locked in: without a cutter the bed stays exactly where it was made
  ASSERT_EQ(world.discs.id.size(), bed.x.size());
  for (std::size_t i = 0; i < bed.x.size(); ++i) {
    const auto born = static_cast<std::size_t>(world.discs.id[i]);
    EXPECT_EQ(world.discs.x[i], bed.x[born]);
    EXPECT_EQ(world.discs.y[i], bed.y[born]);
  }
}

TEST(RunFile, RoundTripAndPicture) {
  const auto cut = small_cut();
  const auto run = dem2d::run_cut(cut, small_bed());
  const scratch::Folder folder("run_file");
  const auto path = folder / "run.h5";
  dem2d::write_run(run, cut, 3, path);
  const dem2d::RunFile file = dem2d::read_run(path);
  EXPECT_EQ(file.run.force_x, run.force_x);
  EXPECT_EQ(file.run.cracks.size(), run.cracks.size());
  EXPECT_EQ(file.seed, 3u);
  EXPECT_TRUE(dem2d::read_complete_run(path, dem2d::cut_hash(cut, 3)).has_value());
  EXPECT_FALSE(dem2d::read_complete_run(path, dem2d::cut_hash(cut, 4)).has_value());
  EXPECT_EQ(views::draw_snapshot(file).substr(1, 3), "PNG");

  const std::string bytes = base::read_whole(path);
  base::write_whole(path, bytes.substr(0, bytes.size() - 1000));
  EXPECT_FALSE(dem2d::read_complete_run(path, dem2d::cut_hash(cut, 3)).has_value());
}

}  // namespace
