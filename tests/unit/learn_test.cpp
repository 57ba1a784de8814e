// The design of `learn`, what it says of its own error, and what its notebook refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "studies/campaign/plan.hpp"
#include "studies/learn/learn.hpp"
#include "studies/learn/notebook.hpp"
#include "tests/unit/campaign_fixture.hpp"

using namespace bitrock;

namespace {

namespace fx = campaign_fixture;

const std::string like =
    fx::head +
    "[grid]\ncutter_speeds_m_per_s = [0.1, 2]\ndepths_of_cut_mm = [2, 5]\nback_rakes_deg = [10, 30]\n"
    "[by_depth]\ncut_length_depths = 20\nbed_height_depths = 5\nbed_beyond_depths = 4\n";

class Learn : public testing::Test {
 protected:
  const scratch::Folder dir{"learn"};
  studies::Study study() { return fx::study(dir, like); }
};

TEST_F(Learn, ADesignGoesOnWhereItStopped) {
  studies::LearnDesign parts(study(), studies::range_of(study()), 7), whole(study(), studies::range_of(study()), 7);
  const studies::Study all = whole.next(20, 1), first = parts.next(12, 1), second = parts.next(8, 2);
  std::vector<double> speeds = first.table.cutter_speed;
  speeds.insert(speeds.end(), second.table.cutter_speed.begin(), second.table.cutter_speed.end());
  EXPECT_EQ(speeds, all.table.cutter_speed);
  EXPECT_EQ(first.seeds, std::vector<int>{8});
  EXPECT_EQ(second.seeds, std::vector<int>{9}) << "a rock of its own";
}

TEST_F(Learn, ConditionsLieInTheRangeOnStepsOfDepthAndNoneTwice) {
  const studies::LearnRange range = studies::range_of(study());
  EXPECT_EQ(range.low_speed, 0.1);
  EXPECT_EQ(range.high_depth, 5e-3);
  studies::LearnDesign design(study(), range, 1);
  std::set<std::tuple<double, double, double>> seen;
  std::set<double> depths;
  for (const studies::Job& job : studies::jobs(design.next(200, 1))) {
    const dem2d::CutCase& cut = job.cut;
    EXPECT_TRUE(cut.cutter_speed >= 0.1 && cut.cutter_speed <= 2.0);
    EXPECT_TRUE(cut.back_rake >= range.low_rake && cut.back_rake <= range.high_rake);
    depths.insert(cut.depth_of_cut);
    EXPECT_TRUE(seen.emplace(cut.cutter_speed, cut.depth_of_cut, cut.back_rake).second);
  }
  EXPECT_EQ(depths.size(), static_cast<std::size_t>(studies::depth_steps));
  EXPECT_EQ(*depths.begin(), 2e-3);
  EXPECT_EQ(*depths.rbegin(), 5e-3);
}

TEST_F(Learn, ARangeOfOneConditionIsRefused) {
  studies::Study one = study();
  one.grid = {.cutter_speeds = {1.0}, .depths_of_cut = {2e-3}, .back_rakes = {0.3}, .mud_pressures = {}};
  studies::LearnDesign design(one, studies::range_of(one), 1);
  EXPECT_NE(fx::message([&] { design.next(8, 1); }, "").find("only 1 different conditions"), std::string::npos);
}

TEST_F(Learn, PressuresLieEvenlyInTheirRootAndOnePressureStaysOne) {
  studies::Study one = study();
  one.grid.mud_pressures = {0.0, 10e6, 40e6};
  studies::LearnDesign design(one, studies::range_of(one), 1);
  const std::vector<double> pressures = design.next(200, 1).table.mud_pressure;
  ASSERT_EQ(pressures.size(), 200U);
  // 4 % on either face, and the others evenly in the root: half of them below a quarter of the highest
  EXPECT_NEAR(static_cast<double>(std::ranges::count(pressures, 0.0)), 8.0, 4.0);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(pressures, 40e6)), 8.0, 4.0);
  EXPECT_NEAR(static_cast<double>(std::ranges::count_if(pressures, [](double p) { return p < 10e6; })), 100.0, 6.0);
  studies::LearnDesign many(one, studies::range_of(one), 2);
  EXPECT_TRUE(std::ranges::all_of(many.next(2000, 1).table.mud_pressure, [](double p) {
    return p == 0.0 || (p >= 0.01e6 && p <= 40e6);  // as a cut may have it
  }));

  one.grid.mud_pressures = {20e6};
  studies::LearnDesign same(one, studies::range_of(one), 1), none(study(), studies::range_of(study()), 1);
  const studies::Study held = same.next(30, 1), dry = none.next(30, 1);
  EXPECT_EQ(held.table.mud_pressure, std::vector<double>(30, 20e6));
  EXPECT_TRUE(dry.table.mud_pressure.empty());
  EXPECT_EQ(held.table.cutter_speed, dry.table.cutter_speed) << "a pressure that does not vary takes no coordinate";
}

TEST_F(Learn, DearCutsAreFewerByTheRootOfTheirTime) {
  // At one depth the time goes as one over the speed. So the density goes as its root: of all cuts the share below
  // speed v is (v^1.5 - l^1.5) / (h^1.5 - l^1.5), but for the 4 % on the faces.
  studies::Study one = study();
  one.grid.depths_of_cut = {2e-3};
  studies::LearnDesign design(one, studies::range_of(one), 1);
  const std::vector<double> speeds = design.next(400, 1).table.cutter_speed;
  const auto inside = std::ranges::count_if(speeds, [](double v) { return v > 0.1 && v < 2.0; });
  const auto slow = std::ranges::count_if(speeds, [](double v) { return v > 0.1 && v < 1.0; });
  const double low = std::pow(0.1, 1.5), expected = (1.0 - low) / (std::pow(2.0, 1.5) - low);
  EXPECT_NEAR(static_cast<double>(slow) / static_cast<double>(inside), expected, 0.03);
}

TEST_F(Learn, ItsErrorIsThatOfCoefficientsFromNoisyCases) {
  // 120 cuts that scatter by 20 % around a power law: four coefficients leave 20 % sqrt(4 / 120) = 3.65 %.
  surrogate::TrainingData data{.file = "made up", .has_seeds = true};
  base::Random random(3);
  for (int i = 1; i <= 120; ++i) {
    surrogate::TrainingRow row{
        .case_number = i,
        .seed = 1,
        .inputs = {base::uniform(random, 0.1, 2.0), base::uniform(random, 0.5, 5.0), base::uniform(random, 10.0, 30.0)},
        .cut_length = 0.05};
    for (std::size_t o = 0; o < row.outputs.size(); ++o) {
      const double scatter = std::exp(0.2 * base::normal(random) - 0.02);
      row.outputs[o] = surrogate::is_count(o) ? 2000.0 / row.inputs[1] * scatter : 6e4 * row.inputs[1] * scatter;
    }
    data.rows.push_back(row);
  }
  const studies::Knowledge knowledge = studies::knowledge_of(data);
  EXPECT_EQ(knowledge.terms, 4);
  EXPECT_NEAR(knowledge.force_error, 0.2 * std::sqrt(4.0 / 120.0), 0.1 * 0.0365);
  EXPECT_NEAR(studies::expected_error(knowledge, 4.0), 0.5 * knowledge.force_error, 1e-15);
}

TEST_F(Learn, TheNotebookIsReadBackAndDamageIsSaid) {
  studies::write_notebook(dir.path(), {.request = "abc", .batches = {24, 7}, .elapsed = 12.5});
  const studies::LearnNotebook again = studies::read_notebook(dir.path());
  EXPECT_EQ(again.request, "abc");
  EXPECT_EQ(again.batches, (std::vector<int>{24, 7}));
  EXPECT_EQ(again.elapsed, 12.5);
  for (const std::string text : {"{", "{}", R"({"request": "a", "batches": [0], "elapsed_s": 1})",
                                 R"({"request": "a", "batches": [2], "elapsed_s": -1})", R"({"request": 3})"}) {
    base::write_whole(dir / "learn.json", text);
    EXPECT_THROW(studies::read_notebook(dir.path()), base::InputError) << text;
  }
}

TEST_F(Learn, AFolderBelongsToOneRequest) {
  studies::write_notebook(dir.path(), {.request = "of another rock", .batches = {24}, .elapsed = 1.0});
  EXPECT_NE(
      fx::message([&] { studies::learn({.like = study(), .folder = dir.path()}); }, "").find("begun with another"),
      std::string::npos);
}

}  // namespace
