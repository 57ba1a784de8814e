// Graded specimens: which sizes lie where, and that the border between them is rock as any other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/specimen/grading.hpp"

using namespace bitrock;

namespace {

constexpr double width = 40e-3, height = 24e-3, fine_depth = 12e-3;
constexpr double border = height - fine_depth;

dem2d::Rock graded_rock(double depth = fine_depth) {
  dem2d::Rock rock;  // radii 0.5 to 0.75 mm
  rock.fine_depth = depth;
  return rock;
}

const dem2d::Specimen& graded() {
  static const dem2d::Specimen made = dem2d::make_specimen(graded_rock(), width, height, 3, 1);
  return made;
}

bool is_coarse(const dem2d::Specimen& specimen, std::size_t disc) {
  // radii 0.5 to 0.75 mm and 1 to 1.5 mm have grown by one factor
  return specimen.radius[disc] > 0.875e-3 * specimen.radius_factor;
}

TEST(Grading, LayersFillTheHeight) {
  EXPECT_EQ(dem2d::layers(graded_rock(0.0), height).size(), 1u) << "not graded";
  EXPECT_EQ(dem2d::layers(graded_rock(height), height).size(), 1u) << "no room for a coarse layer";
  const std::vector<dem2d::Layer> both = dem2d::layers(graded_rock(), height);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].low, 0.0);
  EXPECT_EQ(both[0].high, border);
  EXPECT_EQ(both[0].size, 2.0);
  EXPECT_EQ(both[1].low, border);
  EXPECT_EQ(both[1].high, height);
  EXPECT_EQ(both[1].size, 1.0);
  EXPECT_EQ(dem2d::largest_radius(graded_rock(), height), 1.5e-3);
  EXPECT_EQ(dem2d::largest_radius(graded_rock(), fine_depth), 0.75e-3);
}

TEST(Grading, FineDiscsLieAboveAndCoarseOnesBelow) {
  const dem2d::Specimen& specimen = graded();
  std::size_t coarse = 0;
  for (std::size_t i = 0; i < specimen.x.size(); ++i) {
    const double least = 0.5e-3 * specimen.radius_factor * (is_coarse(specimen, i) ? 2.0 : 1.0);
    EXPECT_GE(specimen.radius[i], least * (1.0 - 1e-12));
    EXPECT_LE(specimen.radius[i], 1.5 * least * (1.0 + 1e-12));
    coarse += is_coarse(specimen, i) ? 1 : 0;
    // a disc ends where it was put, give or take the diameter by which packing moves it
    EXPECT_TRUE(is_coarse(specimen, i) || specimen.y[i] > border - 3e-3) << specimen.y[i];
    EXPECT_TRUE(!is_coarse(specimen, i) || specimen.y[i] < border + 3e-3) << specimen.y[i];
  }
  // half of the area in discs four times as large: a fifth of the number, give or take one disc of each layer
  EXPECT_NEAR(static_cast<double>(coarse), 0.2 * static_cast<double>(specimen.x.size()), 10.0);
  const double expected = dem2d::expected_discs(graded_rock(), width, height);
  EXPECT_NEAR(expected, 0.625 * dem2d::expected_discs(graded_rock(0.0), width, height), 1e-9 * expected);
  EXPECT_NEAR(static_cast<double>(specimen.x.size()), expected, 0.03 * expected);  // radii are drawn
}

TEST(Grading, BothLayersAreAsDenselyJoinedAsRockOfOneSize) {
  const dem2d::Specimen& specimen = graded();
  const dem2d::Specimen plain = dem2d::make_specimen(graded_rock(0.0), width, height, 3, 1);
  EXPECT_NEAR(dem2d::porosity(specimen), dem2d::porosity(plain), 0.01);
  EXPECT_NEAR(dem2d::coordination_number(specimen), dem2d::coordination_number(plain), 0.25);
  EXPECT_NEAR(specimen.pressure, specimen.rock.packing_pressure, 0.01 * specimen.rock.packing_pressure);
}

TEST(Grading, TheBorderIsJoinedLikeTheRestOfTheRock) {
  // Joints that cross a level, as a share of the width: the sum of 2 min(R1, R2) |n_y| of those whose centres lie on
  // both sides. It must not fall at the border below what it is within the layers.
  const dem2d::Specimen& specimen = graded();
  const auto joined = [&specimen](double level) {
    double sum = 0.0;
    for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
      const auto i = static_cast<std::size_t>(specimen.disc1[k]), j = static_cast<std::size_t>(specimen.disc2[k]);
      if ((specimen.y[i] < level) == (specimen.y[j] < level)) continue;
      const double dx = specimen.x[j] - specimen.x[i], dy = specimen.y[j] - specimen.y[i];
      sum += 2.0 * std::min(specimen.radius[i], specimen.radius[j]) * std::fabs(dy) / std::hypot(dx, dy);
    }
    return sum / width;
  };
  const auto mean_joined = [&joined](double low, double high) {
    double sum = 0.0;
    for (int k = 0; k < 20; ++k) sum += joined(low + (k + 0.5) / 20.0 * (high - low)) / 20.0;
    return sum;
  };
  const double within = std::min(mean_joined(4e-3, border - 3e-3), mean_joined(border + 3e-3, height - 2e-3));
  EXPECT_GT(mean_joined(border - 1e-3, border + 1e-3), 0.85 * within);
}

TEST(Grading, IsTheSameForTheSameSeedAndAnyThreads) {
  const dem2d::Specimen again = dem2d::make_specimen(graded_rock(), width, height, 3, 2);
  EXPECT_EQ(again.x, graded().x);
  EXPECT_EQ(again.y, graded().y);
  EXPECT_EQ(again.radius, graded().radius);
  EXPECT_EQ(again.disc2, graded().disc2);
  EXPECT_NE(dem2d::make_specimen(graded_rock(), width, height, 4, 1).x, graded().x);
}

TEST(Grading, RefusesLayersThinnerThanADisc) {
  const auto message = [](double depth) {
    try {
      dem2d::check_specimen_size(graded_rock(depth), width, height, "bed");
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(fine_depth), "");
  EXPECT_EQ(message(22e-3),
            "bed: grading.fine_depth_mm = 22 leaves a layer of 40 x 2 mm for discs of radius 1.5 mm (at least one "
            "diameter high and four wide)");
  EXPECT_NE(message(1e-3).find("a layer of 40 x 1 mm for discs of radius 0.75 mm"), std::string::npos);
}

}  // namespace
