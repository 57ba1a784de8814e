// The comparison of rebuilt forces with the DEM's: a "DEM" that is itself a train of sawteeth is rebuilt like itself,
// and what is not like it shows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/errors.hpp"
#include "studies/rebuild/constant_model.hpp"
#include "studies/rebuild/rebuild.hpp"
#include "tests/unit/campaign_fixture.hpp"

using namespace bitrock;

namespace {

using runtime::SignalMode;

constexpr std::size_t moments_from = surrogate::article_output_count;

/// What a cut of 2 mm in the article's rock is like.
surrogate::OutputValues usual_statistics() {
  surrogate::OutputValues values{.items = {1.8e5, 6e4, 100.0, 600.0, 800.0, 1e5, 3.3e4, 120.0, 650.0, 700.0, 3e4, 4.1e4,
                                           1.6e4, 2.2e4, 0.42e-3, 0.15e-3, 0.9}};
  values.count = surrogate::most_outputs;
  return values;
}

/// A case whose "DEM" is a train of sawteeth: several cuts 50 mm long.
studies::KnownCase sawtooth_case(int cuts, double depth = 2e-3) {
  constexpr std::size_t samples = 2500;
  studies::KnownCase known{.file = "made", .case_number = 7, .mean_diameter = 0.5e-3, .cuts = {}};
  studies::CutForces cut;
  cut.cut = {
      .case_number = 7, .seed = 1, .cutter_speed = 1.0, .depth_of_cut = depth, .back_rake = 0.35, .cut_length = 0.05};
  cut.x.assign(samples, 0.0F);
  cut.y = cut.x;
  known.cuts.push_back(cut);
  runtime::DrawTally draws;
  const studies::RebuiltForce force =
      studies::rebuilt_force(studies::constant_model(usual_statistics()), SignalMode::sawtooth, known, cuts, 99, draws);
  known.cuts.clear();
  for (int seed = 1; seed <= cuts; ++seed) {
    const std::size_t from = samples * static_cast<std::size_t>(seed - 1);
    cut.cut.seed = seed;
    for (std::size_t i = 0; i < samples; ++i) {
      cut.x[i] = static_cast<float>(force.x[from + i]);
      cut.y[i] = static_cast<float>(force.y[from + i]);
    }
    known.cuts.push_back(cut);
  }
  return known;
}

const studies::RebuiltCut& of(const studies::Rebuilding& all, SignalMode mode, bool from_model = false) {
  for (const studies::RebuiltCut& one : all.comparisons) {
    if (one.mode == mode && one.from_model == from_model) return one;
  }
  throw std::logic_error("no such comparison");
}

TEST(ConstantModel, AnswersWhatItWasMadeOf) {
  const surrogate::OutputValues values = usual_statistics();
  const surrogate::Model model = studies::constant_model(values);
  const surrogate::Prediction answer = predict(model, {.cutter_speed = 0.3, .depth_of_cut = 4e-3, .back_rake = 0.2});
  EXPECT_EQ(listed(answer), values);
  EXPECT_TRUE(answer.inside_training_range);
}

/// Of all cuts of a case, one behind the other.
peaks::Moments moments_of_all(const studies::KnownCase& known, std::vector<float> studies::CutForces::*component) {
  std::vector<double> all;
  for (const studies::CutForces& cut : known.cuts)
    all.insert(all.end(), (cut.*component).begin(), (cut.*component).end());
  return peaks::moments(all, 20e-6);
}

TEST(RebuiltForce, HasTheMomentsThatItIsMadeOf) {
  const peaks::Moments x = moments_of_all(sawtooth_case(400), &studies::CutForces::x);
  const surrogate::OutputValues wanted = usual_statistics();
  EXPECT_NEAR(x.mean, wanted[moments_from], 0.02 * wanted[moments_from]);
  EXPECT_NEAR(x.sd, wanted[moments_from + 1], 0.02 * wanted[moments_from + 1]);
  EXPECT_NEAR(x.correlation_length, wanted[moments_from + 4], 0.03 * wanted[moments_from + 4]);
  EXPECT_NEAR(x.short_correlation_length, wanted[moments_from + 5], 0.03 * wanted[moments_from + 5]);
}

// Each cut is 120 correlation lengths long, and its own mean takes a share of its variance: without a correction its
// lengths would be 5 % too short.
TEST(Rebuild, LengthsOfShortRecordsAreThoseOfAnEndlessOne) {
  const studies::KnownCase known = sawtooth_case(400);
  const peaks::Moments x = moments_of_all(known, &studies::CutForces::x),
                       y = moments_of_all(known, &studies::CutForces::y);
  const studies::Rebuilding all = studies::rebuild({known}, nullptr, {.draws = 1});
  const surrogate::OutputValues own = studies::own_statistics(all.dem[0], all.known[0]);
  const double usual = 0.5 * (x.correlation_length + y.correlation_length);
  const double brief = 0.5 * (x.short_correlation_length + y.short_correlation_length);
  EXPECT_NEAR(own[moments_from + 4], usual, 0.02 * usual);
  EXPECT_NEAR(own[moments_from + 5], brief, 0.02 * brief);
}

TEST(Rebuild, ATrainOfSawteethIsRebuiltLikeItself) {
  const surrogate::Model model = studies::constant_model(usual_statistics());
  const studies::Rebuilding all = studies::rebuild({sawtooth_case(200)}, &model, {.draws = 200, .jobs = 2});
  ASSERT_EQ(all.comparisons.size(), 2u);
  for (const studies::RebuiltCut& one : all.comparisons) {
    for (const studies::ComponentLikeness& seen : {one.likeness.x, one.likeness.y}) {
      EXPECT_NEAR(seen.mean_ratio, 1.0, 0.05);
      EXPECT_NEAR(seen.sd_ratio, 1.0, 0.05);
      EXPECT_NEAR(seen.damage_range_ratio, 1.0, 0.05);
      EXPECT_NEAR(seen.low_share, seen.low_share_dem, 0.02);
      EXPECT_NEAR(seen.correlation_length_ratio, 1.0, 0.03);
      for (const double off : seen.octave_difference) EXPECT_NEAR(off, 0.0, 1.0);
    }
    EXPECT_NEAR(one.likeness.xy_correlation, one.likeness.xy_correlation_dem, 0.02);
    EXPECT_EQ(one.draws.length_clamped, 0);
  }
  for (const bool from_model : {false, true}) {
    for (const studies::Measure& one : studies::measures(all, from_model, SignalMode::sawtooth)) {
      if (one.name == "mean") continue;  // its bar of 2 % is nearer than 200 draws come
      EXPECT_EQ(one.within, 1.0) << one.name << " " << one.worst;
    }
  }
}

// The printed procedure has half of A_mean as its mean, whatever the cut; the width that meets the mean rights it.
TEST(Rebuild, TheArticlesModesShowWhatTheyMiss) {
  const studies::Rebuilding all = studies::rebuild(
      {sawtooth_case(100)}, nullptr, {.modes = {SignalMode::article, SignalMode::article_literal}, .draws = 100});
  const surrogate::OutputValues own = studies::own_statistics(all.dem[0], all.known[0]);
  const double half = 0.5 * own[1] / own[moments_from];
  EXPECT_NEAR(of(all, SignalMode::article_literal).likeness.x.mean_ratio, half, 0.05 * half);
  EXPECT_NEAR(of(all, SignalMode::article).likeness.x.mean_ratio, 1.0, 0.05);
}

TEST(Rebuild, IsTheSameForAnyNumberOfJobs) {
  std::vector<studies::KnownCase> known;
  for (const double depth : {1e-3, 2e-3, 3e-3}) known.push_back(sawtooth_case(3, depth));
  const studies::Rebuilding one = studies::rebuild(known, nullptr, {.draws = 4, .jobs = 1});
  const studies::Rebuilding three = studies::rebuild(known, nullptr, {.draws = 4, .jobs = 3});
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.comparisons[i].likeness.x.sd_ratio, three.comparisons[i].likeness.x.sd_ratio);
    EXPECT_EQ(one.comparisons[i].known, i);
  }
  EXPECT_NE(one.comparisons[0].likeness.x.sd_ratio, one.comparisons[1].likeness.x.sd_ratio) << "draws of their own";
}

TEST(Rebuild, CasesWithoutAForceAreLeftOutInWords) {
  studies::KnownCase still = sawtooth_case(1);
  std::fill(still.cuts[0].y.begin(), still.cuts[0].y.end(), 5.0F);
  const studies::Rebuilding all = studies::rebuild({still, sawtooth_case(2)}, nullptr, {.draws = 2});
  ASSERT_EQ(all.left_out.size(), 1u);
  EXPECT_EQ(all.left_out[0], "case 7 of made: the force has no mean above 0 or no deviation in one direction");
  EXPECT_EQ(all.comparisons.size(), 1u);
}

TEST(Measures, AreOfTheDepthsAskedForAndCountWhatIsWithin) {
  studies::Rebuilding all;
  for (const double depth : {1e-3, 5e-3}) {
    all.known.push_back(sawtooth_case(1, depth));
    studies::RebuiltCut one{
        .known = all.known.size() - 1, .mode = SignalMode::sawtooth, .rebuilt = {}, .likeness = {}, .draws = {}};
    one.likeness.x.mean_ratio = depth < 2e-3 ? 1.01 : 0.96;
    one.likeness.xy_correlation_dem = 0.9;
    one.likeness.xy_correlation = 0.75;
    all.comparisons.push_back(one);
  }
  const studies::Measure both = studies::measures(all, false, SignalMode::sawtooth).front();
  EXPECT_EQ(both.name, "mean");
  EXPECT_EQ(both.count, 2);
  EXPECT_NEAR(both.worst, -4.0, 1e-9);
  EXPECT_NEAR(both.rms, std::sqrt(0.5 * (1.0 + 16.0)), 1e-9);
  EXPECT_EQ(both.bar, 2.0);
  EXPECT_EQ(both.within, 0.5);
  EXPECT_EQ(studies::measures(all, false, SignalMode::sawtooth, 0.0, 2e-3).front().count, 1);
  EXPECT_NEAR(studies::measures(all, false, SignalMode::sawtooth).back().worst, -0.15, 1e-12);
  EXPECT_TRUE(studies::measures(all, true, SignalMode::sawtooth).empty());
}

std::string message(const std::filesystem::path& path) {
  try {
    studies::read_known_cuts(path);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

struct KnownCuts : ::testing::Test {
  const scratch::Folder dir{"known_cuts"};
  const std::filesystem::path cuts = dir / "cuts";

  void SetUp() override { std::filesystem::create_directories(cuts); }

  /// Of two conditions, two seeds each.
  studies::ForcesFile forces() {
    studies::ForcesFile file{.study = "s.toml", .mean_diameter = 0.5e-3, .cuts = {}};
    for (const double depth : {1e-3, 2e-3}) {
      for (studies::CutForces& cut : sawtooth_case(2, depth).cuts) {
        cut.cut.case_number = depth < 1.5e-3 ? 1 : 2;
        cut.cut.hash = fmt::format("{:016x}", 100 * cut.cut.case_number + cut.cut.seed);
        cut.cut.duration = 0.05;
        cut.cut.discs = 100;
        cut.cut.step = 1e-7;
        file.cuts.push_back(std::move(cut));
      }
    }
    return file;
  }
};

TEST_F(KnownCuts, OfOneConditionAreOneCase) {
  studies::write_forces(forces(), cuts / "forces.h5");
  for (const std::filesystem::path& path : {cuts / "forces.h5", cuts}) {
    const std::vector<studies::KnownCase> known = studies::read_known_cuts(path);
    ASSERT_EQ(known.size(), 2u);
    EXPECT_EQ(known[1].case_number, 2);
    EXPECT_EQ(known[1].cuts.size(), 2u);
    EXPECT_EQ(known[1].cuts[1].cut.seed, 2);
    EXPECT_EQ(known[0].mean_diameter, 0.5e-3);
  }
}

TEST_F(KnownCuts, SampledDifferentlyAreRefusedAndSoIsAnEmptyFolder) {
  studies::ForcesFile file = forces();
  file.cuts[1].x.resize(1250);
  file.cuts[1].y.resize(1250);
  studies::write_forces(file, cuts / "forces.h5");
  EXPECT_NE(message(cuts).find("sampled each 20 and 40 um"), std::string::npos);
  std::filesystem::remove(cuts / "forces.h5");
  EXPECT_NE(message(cuts).find("no forces.h5 and no runs"), std::string::npos);
  EXPECT_ANY_THROW(studies::read_known_cuts(cuts / "nothing.h5"));
}

}  // namespace
