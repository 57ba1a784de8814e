// Training data: what is read, what is divided by the length of cut, and every message a user can get.
#include "surrogate/train/data.hpp"

#include <gtest/gtest.h>

#include "base/text.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::TrainingData;
using surrogate_fixture::features_header;
using surrogate_fixture::read_text;

const std::string row_1_1 = "1,1,0.5,2,15,0.05,0.1,1000,400,3,7,10,500,200,2,5,9\n";
const std::string row_1_2 = "1,2,0.5,2,15,0.04,0.1,1100,410,4,6,10,510,210,3,5,9\n";
const std::string row_2_1 = "2,1,1.5,2,15,0.15,0.1,1000,400,3,7,10,500,200,2,5,9\n";

std::vector<double> listed(const surrogate::Outputs& outputs) {
  return {outputs.begin(), outputs.end()};
}

/// The message for a file of these rows, from its name on; the file is features.csv.
std::string message(const std::string& text) {
  const std::string all = surrogate_fixture::refusal([&] { read_text(text); });
  const std::size_t name = all.find("features.csv");
  return name == std::string::npos ? all : all.substr(name);
}

TEST(SurrogateData, ReadsRowsAndTakesCountsPerMetre) {
  const std::string text = features_header + row_1_1 + row_1_2 + row_2_1;
  const TrainingData data = read_text(text);
  EXPECT_EQ(data.file, "features.csv");
  EXPECT_EQ(data.fingerprint, base::fingerprint_text(text));
  EXPECT_TRUE(data.has_seeds);
  ASSERT_EQ(data.rows.size(), 3u);
  EXPECT_EQ(data.rows[1].case_number, 1);
  EXPECT_EQ(data.rows[1].seed, 2);
  EXPECT_EQ(data.rows[1].line, 3);
  EXPECT_EQ(data.rows[0].inputs, (std::array<double, 3>{0.5, 2.0, 15.0}));
  EXPECT_EQ(listed(data.rows[0].outputs),
            (std::vector<double>{1000, 400, 3 / 0.05, 7 / 0.05, 10 / 0.05, 500, 200, 2 / 0.05, 5 / 0.05, 9 / 0.05}));
  EXPECT_EQ(surrogate::case_numbers(data), (std::vector<int>{1, 2}));
}

TEST(SurrogateData, TakesAMeanFileWithoutSeedsAndWithOtherColumnsInOtherOrder) {
  const TrainingData data = read_text(
      "depth_of_cut_mm,case,cutter_speed_m_per_s,back_rake_deg,cut_length_m,x_amax_N_per_m,"
      "x_amax_N_per_m_standard_error,x_amean_N_per_m,x_np1,x_np23,x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,"
      "y_np4,seeds\n"
      "2,8,0.5,-10,0.5,12,0.7,11,13,14,15,17,16,18,19,20,3\n"
      "3,9,0.5,-10,0.5,12,0.7,11,13,14,15,17,16,18,19,20,3\n");
  EXPECT_FALSE(data.has_seeds);
  EXPECT_EQ(data.rows[0].inputs, (std::array<double, 3>{0.5, 2.0, -10.0}));
  EXPECT_EQ(listed(data.rows[0].outputs), (std::vector<double>{12, 11, 26, 28, 30, 17, 16, 36, 38, 40}));
}

TEST(SurrogateData, ColumnsAndNumbersMustBeThere) {
  const std::string needed =
      "; needed are: case, cutter_speed_m_per_s, depth_of_cut_mm, back_rake_deg, cut_length_m, x_amax_N_per_m, "
      "x_amean_N_per_m, x_np1, x_np23, x_np4, y_amax_N_per_m, y_amean_N_per_m, y_np1, y_np23, y_np4; the file has: ";
  EXPECT_EQ(
      message("case,seed,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,x_mean,x_amax_N_per_m,"
              "x_np1,x_np23,x_np4,y_amean_N_per_m,y_np1,y_np23,y_np4\n1,1,1,1,1,1,1,1,1,1,1,1,1,1,1\n"),
      "features.csv: columns are missing: x_amean_N_per_m, y_amax_N_per_m" + needed +
          "case, seed, cutter_speed_m_per_s, depth_of_cut_mm, back_rake_deg, cut_length_m, x_mean, x_amax_N_per_m, "
          "x_np1, x_np23, x_np4, y_amean_N_per_m, y_np1, y_np23, y_np4");
  std::string renamed = features_header + row_1_1 + row_2_1;
  renamed.replace(renamed.find("cut_length_m"), 12, "cutlength_mm");
  EXPECT_EQ(message(renamed).find("features.csv: a column is missing: cut_length_m (is it cutlength_mm?)" + needed),
            0U);
  EXPECT_EQ(message(features_header), "features.csv: only a header (at least one row is needed)");
  EXPECT_EQ(message(features_header + "1,1,0.5,2,x,0.05,0.1,1000,400,3,7,10,500,200,2,5,9\n"),
            "features.csv:2: column back_rake_deg: 'x' is not a number");
  EXPECT_EQ(message(features_header + "1,1,0.5,2,15,0.05,0.1,nan,400,3,7,10,500,200,2,5,9\n"),
            "features.csv:2: column x_amax_N_per_m: nan (only finite numbers are allowed)");
}

/// The rows with the columns that say how their peaks were counted.
std::string counted(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text = features_header;
  text.insert(text.size() - 1, ",sampling_um,peak_smoothing_um,peak_min_prominence,peak_min_distance_mm");
  for (const auto& [row, counting] : rows) text += row.substr(0, row.size() - 1) + "," + counting + "\n";
  return text;
}

TEST(SurrogateData, PeaksThatWereCountedInDifferentWaysDoNotMix) {
  const std::string converging = "20,40,0.02,0", article = "20,0,0,0", finer = "10,0,0,0";
  const TrainingData good = read_text(counted({{row_1_1, converging}, {row_2_1, "10,40,0.02,0"}}));
  ASSERT_TRUE(good.counting.has_value());
  EXPECT_EQ(good.counting->smoothing_um, 40.0);
  EXPECT_EQ(good.counting->sampling_um, 0.0) << "smoothed peaks do not depend on it";
  EXPECT_EQ(message(counted({{row_1_1, converging}, {row_2_1, article}})),
            "features.csv:3: peaks are counted with smoothing 0 um, prominence 0, distance 0 mm, samples every 20 um "
            "(line 2: with smoothing 40 um, prominence 0.02, distance 0 mm; numbers of both do not mix: make the table "
            "anew with bitrock campaign features)");
  EXPECT_NE(message(counted({{row_1_1, article}, {row_2_1, finer}})).find("samples every 10 um"), std::string::npos);
  const TrainingData silent = read_text(features_header + row_1_2 + row_2_1);
  EXPECT_FALSE(silent.counting.has_value());
  EXPECT_NE(surrogate_fixture::refusal([&] {
              surrogate::joined({good, silent});
            }).find("in a way that is not said, hence as in the article (numbers of both do not mix"),
            std::string::npos);
  const TrainingData articles = read_text(counted({{row_1_2, article}, {row_2_1, article}}));
  EXPECT_EQ(surrogate::joined({articles, silent}).rows.size(), 4U) << "a table that does not say is the article's";
  const TrainingData same = read_text(counted({{row_1_2, converging}, {row_2_1, converging}}));
  EXPECT_TRUE(surrogate::mix(surrogate::joined({good, same}).counting, good.counting));
  EXPECT_TRUE(surrogate::joined({silent, articles}).counting.has_value());
}

/// The rows with the pressure of the mud they were cut under.
std::string under_mud(const std::vector<std::pair<std::string, std::string>>& rows) {
  std::string text = features_header;
  text.insert(text.size() - 1, ",fluid_pressure_MPa");
  for (const auto& [row, pressure] : rows) text += row.substr(0, row.size() - 1) + "," + pressure + "\n";
  return text;
}

TEST(SurrogateData, ThePressureOfTheMudIsReadWhetherItVariesOrNot) {
  const TrainingData mud = read_text(under_mud({{row_1_1, "20"}, {row_2_1, "20"}}));
  EXPECT_EQ(surrogate::one_pressure(mud), 20.0);
  const TrainingData both = read_text(under_mud({{row_1_1, "20"}, {row_2_1, "0"}}));
  EXPECT_FALSE(surrogate::one_pressure(both).has_value());
  EXPECT_EQ(surrogate::varying_further(both), std::vector<std::size_t>{0});
  EXPECT_NE(message(under_mud({{row_1_1, "20"}, {row_1_2, "0"}, {row_2_1, "0"}})).find("case 1 has fluid_pressure_MPa"),
            std::string::npos);
  EXPECT_NE(message(under_mud({{row_1_1, "-1"}, {row_2_1, "-1"}})).find("fluid_pressure_MPa = -1"), std::string::npos);
  const TrainingData silent = read_text(features_header + row_1_2 + row_2_1);
  EXPECT_EQ(surrogate::one_pressure(silent), 0.0) << "older tables are of cuts without mud";
  EXPECT_FALSE(surrogate::one_pressure(surrogate::joined({mud, silent})).has_value());
  const TrainingData more = read_text(under_mud({{row_1_2, "20"}, {row_2_1, "20"}}));
  EXPECT_EQ(surrogate::one_pressure(surrogate::joined({mud, more})), 20.0);
}

TEST(SurrogateData, ARowCutShortIsRefused) {
  const std::string text = features_header + row_1_1 + row_1_2 + row_2_1;
  const std::size_t last_row = features_header.size() + row_1_1.size() + row_1_2.size();
  const std::size_t last_cell = text.rfind(',');
  for (std::size_t length = last_row + 1; length <= last_cell; ++length) {
    EXPECT_NE(message(text.substr(0, length)).find("features.csv:4: "), std::string::npos) << length;
  }
  for (std::size_t length = 0; length <= features_header.size(); length += 5) {
    EXPECT_EQ(message(text.substr(0, length)).find("features.csv: "), 0u) << length;
  }
}

TEST(SurrogateData, ValuesOutOfRangeCarryTheirLine) {
  const auto with_row = [](const std::string& row) { return message(features_header + row_1_1 + row); };
  EXPECT_EQ(with_row("2,1,1.5,2,15,0,0.1,1000,400,3,7,10,500,200,2,5,9\n"),
            "features.csv:3: cut_length_m = 0 (must be above 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,1.5,2,15,0.1,0.1,1e308,400,3,7,10,500,200,2,5,9\n"),
            "features.csv:3: x_amax_N_per_m = 1e+308 (must be at least 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,1.5,2,15,0.1,0.1,-5,400,3,7,10,500,200,2,5,9\n"),
            "features.csv:3: x_amax_N_per_m = -5 (must be at least 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,1.5,2,15,0.1,0.1,5,4,3,7,10,500,200,2,-1,9\n"),
            "features.csv:3: y_np23 = -1 (must be at least 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,0,2,15,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: cutter_speed_m_per_s = 0 (must be above 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,1,-2,15,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: depth_of_cut_mm = -2 (must be above 0 and at most 1000000000000)");
  EXPECT_EQ(with_row("2,1,1,2,90,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: back_rake_deg = 90 (must be above -90 and below 90)");
  EXPECT_EQ(with_row("2.5,1,1,2,15,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: case = 2.5 (must be a whole number)");
  EXPECT_EQ(with_row("-2,1,1,2,15,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: case = -2 (must be at least 0 and at most 2147483647)");
  EXPECT_EQ(with_row("2,0.5,1,2,15,0.1,0.1,5,4,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: seed = 0.5 (must be a whole number)");
  EXPECT_EQ(with_row("2,1,1,2,15,1e-300,0.1,5,4,3,7,1e10,500,200,2,1,9\n"),
            "features.csv:3: x_np1 = 3 over cut_length_m = 1e-300 (must be 0 or from 1e-12 to 1e+12)");
}

TEST(SurrogateData, WhatNoForceCanHaveIsRefused) {
  const auto with_row = [](const std::string& row) { return message(features_header + row_1_1 + row); };
  EXPECT_EQ(with_row("2,1,1,2,15,0.1,0.1,400,1000,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: x_amean_N_per_m = 1000 is above x_amax_N_per_m = 400 (the mean height of peaks cannot be "
            "above the highest: are the columns swapped?)");
  EXPECT_EQ(with_row("2,1,1,2,15,0.1,0.1,5,4,3,7,10,500,501,2,1,9\n").substr(0, 39),
            "features.csv:3: y_amean_N_per_m = 501 i");
  EXPECT_EQ(with_row("2,1,1,2,15,0.1,0.1,5e-200,0,3,7,10,500,200,2,1,9\n"),
            "features.csv:3: x_amax_N_per_m = 5e-200 (must be 0 or from 1e-12 to 1e+12)");
  EXPECT_EQ(with_row("2,1,1,2,15,0.1,0.1,5,5,3,7,10,0,0,0,0,0\n"), "accepted");
}

TEST(SurrogateData, ColumnsThatAreNotUsedMayHoldText) {
  std::string header = features_header;
  header.insert(header.find("duration_s"), "tested by,");
  const TrainingData data = read_text(header + "1,1,0.5,2,15,0.05,\"Li, Ann\",,1000,400,3,7,10,500,200,2,5,9\n" +
                                      "2,1,1.5,2,15,0.15,,n/a,1000,400,3,7,10,500,200,2,5,9\n");
  EXPECT_EQ(data.rows[1].outputs[0], 1000.0);
}

TEST(SurrogateData, RowsMustAgreeWithEachOther) {
  EXPECT_EQ(message(features_header + row_1_1 + row_2_1 + row_1_1),
            "features.csv:4: case 1, seed 1 comes twice (first in line 2)");
  EXPECT_EQ(message(features_header + row_1_1 + "1,2,0.5,2,20,0.05,0.1,1000,400,3,7,10,500,200,2,5,9\n" + row_2_1),
            "features.csv:3: case 1 has back_rake_deg = 20 (line 2 has 15; all rows of a case must agree)");
  EXPECT_EQ(message(features_header + row_1_1 + row_1_2),
            "features.csv:3: only one case (at least 2 are needed: one to learn from, one to test)");
}

TEST(SurrogateData, WithoutSeedsACaseMayComeOnce) {
  const std::string header =
      "case,cutter_speed_m_per_s,depth_of_cut_mm,back_rake_deg,cut_length_m,x_amax_N_per_m,x_amean_N_per_m,x_np1,x_"
      "np23,"
      "x_np4,y_amax_N_per_m,y_amean_N_per_m,y_np1,y_np23,y_np4\n";
  const std::string row = "4,1,2,15,0.1,5,4,3,7,10,500,200,2,1,9\n";
  EXPECT_EQ(message(header + row + row), "features.csv:3: case 4 comes twice (first in line 2)");
}

}  // namespace
