// The bending of pipe between its tool joints, against closed forms, the borders of its cases, and a rod on a wall.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "studies/well/bending_magnification.hpp"

using namespace bitrock::studies;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Drill pipe of 127 x 108.61 mm, its tool joints 9.144 m apart, in a build of 10 degrees per 30 m.
const double stiffness = 200e9 * std::numbers::pi / 64.0 * (std::pow(0.127, 4) - std::pow(0.10861, 4));
constexpr double half = 9.144 / 2.0, curvature = std::numbers::pi / 180.0 * 10.0 / 30.0;

TEST(BendingMagnification, OfPipeThatHangsFreeBetweenItsToolJoints) {
  // K L / tanh(K L), 100 to 500 kN
  const double expected[] = {1.528, 1.966, 2.345, 2.680, 2.982};
  const BetweenToolJoints pipe{stiffness, half, endless};
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(bending_magnification(pipe, 1e5 * (k + 1), curvature), expected[k], 1e-3);
  EXPECT_EQ(bending_magnification(pipe, 0.0, curvature), 1.0);
  EXPECT_NEAR(bending_magnification(pipe, 1.0, curvature), 1.0, 1e-5);
  // pushed, it bows out: K L / sin(K L) in its middle, 1.163 at 50 kN
  const double u = std::sqrt(5e4 / stiffness) * half;
  EXPECT_NEAR(bending_magnification(pipe, -5e4, curvature), u / std::sin(u), 1e-12);
  EXPECT_NEAR(bending_magnification(pipe, -5e4, curvature), 1.163, 1e-3);
}

TEST(BendingMagnification, WithoutToolJointsItIsTheHoles) {
  for (const double tension : {-4e5, -1e3, 1e3, 4e5, 4e6}) {
    EXPECT_NEAR(bending_magnification({stiffness, half, 0.0}, tension, curvature), 1.0, 1e-9) << tension;
    EXPECT_EQ(bending_magnification({stiffness, 0.0, 0.02}, tension, curvature), 1.0) << tension;
  }
}

TEST(BendingMagnification, GoesOnWithoutAJumpFromFreeToTouchingToLying) {
  const BetweenToolJoints pipe{stiffness, half, 0.0206};  // 6 5/8 in tool joints on 5 in pipe
  double before = 1.0;
  for (double tension = -4e5; tension < 6e6; tension += 500.0) {
    const double now = bending_magnification(pipe, tension, curvature);
    EXPECT_TRUE(tension == -4e5 || std::abs(now - before) < 0.004) << tension;
    EXPECT_TRUE(tension < 1e3 || now > before) << tension;
    before = now;
  }
  EXPECT_NEAR(before, 1.0 + std::sqrt(2.0 * 0.0206 * 6e6 / (curvature * stiffness)), 1e-3) << "it lies on the wall";
  EXPECT_NEAR(bending_magnification({stiffness, 100.0 * half, 20.0}, 4e5, curvature),
              bending_magnification({stiffness, 100.0 * half, 20.0}, 4.0001e5, curvature), 1e-3);
}

/// The same pipe by finite differences, with the slope of the hole at both ends and nodes that touch the wall: a solver
/// of its own. Returns the largest curvature over the hole's.
double by_pieces(double tension, double stand_off, int pieces) {
  const int n = pieces + 1;  // nodes from one tool joint to the next
  const double l = 2.0 * half / pieces;
  // offset y from the centre line of the hole, towards its inside; tool joints lie at 0, the body has the room g
  // curvature of the pipe: kappa + y''; slope of the hole at the ends: y' = 0 there
  std::vector<double> y(static_cast<std::size_t>(n), 0.0);
  const auto at = [n](int i) { return static_cast<std::size_t>(i < 0 ? -i : i >= n ? 2 * (n - 1) - i : i); };
  std::vector<char> touches(static_cast<std::size_t>(n), 0);
  for (int round = 0; round < 200; ++round) {  // which nodes touch is found by trial
    // EI y'''' - T y'' = T kappa - wall, y(0) = y(2L) = 0, y' = 0 there by mirrored nodes
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::vector<double>> a(size, std::vector<double>(size + 1, 0.0));
    for (int i = 0; i < n; ++i) {
      auto& row = a[at(i)];
      if (i == 0 || i == n - 1 || touches[at(i)]) {
        row[at(i)] = 1.0;
        row[size] = i == 0 || i == n - 1 ? 0.0 : stand_off;
        continue;
      }
      const double b = stiffness / std::pow(l, 4), t = tension / (l * l);
      for (const auto& [d, weight] : {std::pair{-2, b}, {-1, -4 * b - t}, {0, 6 * b + 2 * t}, {1, -4 * b - t}, {2, b}})
        row[at(i + d)] += weight;
      row[size] = tension * curvature;
    }
    for (std::size_t k = 0; k < size; ++k) {  // Gauss
      std::size_t best = k;
      for (std::size_t i = k; i < size; ++i)
        if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
      std::swap(a[k], a[best]);
      for (std::size_t i = k + 1; i < size; ++i) {
        const double factor = a[i][k] / a[k][k];
        if (factor == 0.0) continue;
        for (std::size_t j = k; j <= size; ++j) a[i][j] -= factor * a[k][j];
      }
    }
    for (std::size_t k = size; k-- > 0;) {
      y[k] = a[k][size];
      for (std::size_t j = k + 1; j < size; ++j) y[k] -= a[k][j] * y[j];
      y[k] /= a[k][k];
    }
    bool settled = true;
    for (int i = 1; i + 1 < n; ++i) {
      const double b = stiffness / std::pow(l, 4), t = tension / (l * l);
      const double force = tension * curvature -
                           b * (y[at(i - 2)] - 4 * y[at(i - 1)] + 6 * y[at(i)] - 4 * y[at(i + 1)] + y[at(i + 2)]) +
                           t * (y[at(i - 1)] - 2 * y[at(i)] + y[at(i + 1)]);
      const char now = touches[at(i)] ? (force > 0.0 ? 1 : 0) : (y[at(i)] > stand_off ? 1 : 0);
      if (now != touches[at(i)]) settled = false;
      touches[at(i)] = now;
    }
    if (settled) break;
  }
  double largest = 0.0;
  for (int i = 0; i < n; ++i)
    largest = std::max(largest, std::abs(curvature + (y[at(i - 1)] - 2 * y[at(i)] + y[at(i + 1)]) / (l * l)));
  return largest / curvature;
}

TEST(BendingMagnification, IsThatOfARodOnAWall) {
  // free, touching, and lying on the wall; 200 pieces err by some 1e-3
  const struct {
    double tension, stand_off;
  } rows[] = {{1e5, 0.0206}, {2e5, 0.0206}, {4e5, 0.0206}, {4e5, 0.010}, {6e5, 0.0206}, {1.5e6, 0.010}, {3e6, 0.005}};
  for (const auto& row : rows) {
    const double law = bending_magnification({stiffness, half, row.stand_off}, row.tension, curvature);
    EXPECT_NEAR(by_pieces(row.tension, row.stand_off, 200) / law, 1.0, 4e-3) << row.tension << " " << row.stand_off;
  }
}

}  // namespace
