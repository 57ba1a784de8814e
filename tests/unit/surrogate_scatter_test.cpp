// Means over the cuts of a case, and the law of their scatter: exact sums, and laws that were put in and come out.
#include "surrogate/train/scatter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "tests/unit/surrogate_fixture.hpp"

using namespace bitrock;

namespace {

using surrogate::article_output_count;
using surrogate::averaged;
using surrogate::TrainingData;
using surrogate::TrainingRow;
using surrogate_fixture::features_header;
using surrogate_fixture::read_text;

TEST(SurrogateAverages, AreMeansWithTheirStandardErrors) {
  const TrainingData means = averaged(read_text(features_header + "1,1,0.5,2,15,0.05,0.1,100,40,3,7,10,50,20,2,5,9\n"
                                                                  "2,1,1.5,2,15,0.15,0.1,100,40,3,7,10,50,20,2,5,9\n"
                                                                  "1,2,0.5,2,15,0.05,0.1,130,40,5,7,10,50,20,2,5,9\n"
                                                                  "1,3,0.5,2,15,0.05,0.1,160,40,4,7,10,50,20,2,5,9\n"));
  ASSERT_EQ(means.rows.size(), 2u);
  const TrainingRow& first = means.rows[0];
  EXPECT_EQ(first.case_number, 1);
  EXPECT_EQ(first.cuts, 3);
  EXPECT_DOUBLE_EQ(first.cut_length, 0.05);
  EXPECT_DOUBLE_EQ(first.outputs[0], 130.0);
  EXPECT_DOUBLE_EQ(first.outputs[2], 80.0);  // 4 peaks on 50 mm
  ASSERT_TRUE(first.standard_errors.has_value());
  EXPECT_NEAR((*first.standard_errors)[0], 30.0 / std::sqrt(3.0), 1e-12);
  EXPECT_EQ((*first.standard_errors)[1], 0.0);
  EXPECT_NEAR((*first.standard_errors)[2], 20.0 / std::sqrt(3.0), 1e-12);
  EXPECT_FALSE(means.rows[1].standard_errors.has_value());  // one cut says nothing of its scatter
  EXPECT_EQ(means.rows[1].outputs[0], 100.0);
}

TEST(SurrogateAverages, AFileOfMeansBringsItsOwn) {
  std::string header = features_header, values = "1,3,0.5,2,15,0.05,0.1,100,40,3,7,10,50,20,2,5,9";
  header.replace(header.find("seed"), 4, "seeds");
  header.pop_back();
  for (const char* name : {"x_amax_N_per_m", "x_amean_N_per_m", "x_np1", "x_np23", "x_np4", "y_amax_N_per_m",
                           "y_amean_N_per_m", "y_np1", "y_np23", "y_np4"}) {
    header += std::string(",") + name + "_standard_error";
    values += ",2";
  }
  std::string other = values;
  other.replace(0, 4, "2,1,");
  const TrainingData data = read_text(header + "\n" + values + "\n" + other + "\n");
  EXPECT_FALSE(data.has_seeds);
  EXPECT_EQ(data.rows[0].cuts, 3);
  EXPECT_EQ((*data.rows[0].standard_errors)[0], 2.0);
  EXPECT_DOUBLE_EQ((*data.rows[0].standard_errors)[2], 2.0 / 0.05);
  EXPECT_FALSE(data.rows[1].standard_errors.has_value());
  EXPECT_EQ(averaged(data).rows[0].cuts, 3);
  EXPECT_EQ((*averaged(data).rows[0].standard_errors)[0], 2.0);
}

TEST(SurrogateScatter, IsPooledOverTheCases) {
  // Case 1: three cuts, amplitude 100, standard error 10, so a cut has variance 300; case 2: two cuts, 200, 20: 800.
  // phi = (2 x 300 + 1 x 800) / (2 x 100^2 + 1 x 200^2). Counts, 80 and 40 a metre on 0.5 m and 0.25 m, with 10 and 20:
  // phi = (2 x 300 + 1 x 800) / (2 x 80/0.5 + 1 x 40/0.25). The third case was cut once.
  std::vector<TrainingRow> means(3);
  for (TrainingRow& row : means) row.outputs.fill(100.0), row.cut_length = 0.5;
  means[0].cuts = 3;
  means[0].outputs[2] = 80.0;
  means[0].standard_errors.emplace().fill(10.0);
  means[1].cuts = 2;
  means[1].outputs.fill(200.0);
  means[1].outputs[2] = 40.0;
  means[1].cut_length = 0.25;
  means[1].standard_errors.emplace().fill(20.0);
  const surrogate::ScatterLaw law = surrogate::scatter_law(means);
  EXPECT_EQ(law.degrees_of_freedom, 3);
  EXPECT_DOUBLE_EQ(law.phi[0], 1400.0 / 60000.0);
  EXPECT_DOUBLE_EQ(law.phi[2], 1400.0 / (320.0 + 160.0));
  EXPECT_DOUBLE_EQ(surrogate::standard_error(law, 0, 300.0, 0.1, 4), std::sqrt(law.phi[0] / 4.0) * 300.0);
  EXPECT_DOUBLE_EQ(surrogate::standard_error(law, 2, 300.0, 0.1, 4), std::sqrt(law.phi[2] * 3000.0 / 4.0));
  EXPECT_EQ(surrogate::scatter_law(std::vector<TrainingRow>(2)).degrees_of_freedom, 0);
}

TEST(SurrogateScatter, FindsTheLawThatWasPutIn) {
  // 300 cases of three cuts: amplitudes of 1 to 10, and mean heights of 0.4 of them, that scatter by 12 %, counts of 5
  // to 50 that come independently of each other. phi of 600 degrees of freedom has a relative standard error of
  // sqrt(2/600) = 6 %; four of them.
  base::Random random(41);
  std::string text = features_header;
  const auto poisson = [&](double mean) {
    int count = -1;
    for (double left = mean; left > 0.0; ++count) left += std::log(base::uniform(random));
    return std::max(count, 0);
  };
  for (int number = 1; number <= 300; ++number) {
    const double amplitude = base::uniform(random, 1.0, 10.0), rate = base::uniform(random, 100.0, 1000.0);
    for (int seed = 1; seed <= 3; ++seed) {
      text += fmt::format("{},{},1,{},15,0.05,0.05", number, seed, 1 + number % 5);
      for (int direction = 0; direction < 2; ++direction) {
        for (const double share : {1.0, 0.4})
          text += fmt::format(",{}", share * amplitude * (1.0 + 0.12 * base::normal(random)));
        for (int i = 0; i < 3; ++i) text += fmt::format(",{}", poisson(0.05 * rate));
      }
      text += "\n";
    }
  }
  const surrogate::ScatterLaw law = surrogate::scatter_law(averaged(read_text(text)).rows);
  for (std::size_t i = 0; i < article_output_count; ++i) {
    const double expected = i % 5 < 2 ? 0.12 * 0.12 : 1.0;
    EXPECT_NEAR(law.phi[i] / expected, 1.0, 0.24) << i;
  }
}

}  // namespace
