// Cracks move with their discs while these stay together, and are gone when they have parted.
#include "views/cut/crack_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace bitrock;

namespace {

struct Discs {
  std::vector<double> x, y, radius;
  std::vector<int> id, fragment;
  views::DrawnDiscs drawn(int born) const { return {x, y, radius, id, fragment, born}; }
};

const std::vector<dem2d::Crack> crack_of_3_and_5{
    {.time = 1.0, .length = 0.5, .mode = dem2d::ElementState::broken_in_tension, .disc1 = 3, .disc2 = 5}};

TEST(CrackFaces, LieBetweenTheDiscsAcrossTheirLine) {
  // radii 1 and 2 touch at (11, 20); the face is as long as the smaller disc is thick, along y
  const Discs level{{10.0, 13.0}, {20.0, 20.0}, {1.0, 2.0}, {3, 5}, {0, 0}};
  const auto faces = views::crack_faces(level.drawn(6), crack_of_3_and_5);
  ASSERT_TRUE(faces.at(0).has_value());
  EXPECT_DOUBLE_EQ(faces[0]->x1, 11.0);
  EXPECT_DOUBLE_EQ(faces[0]->y1, 19.0);
  EXPECT_DOUBLE_EQ(faces[0]->x2, 11.0);
  EXPECT_DOUBLE_EQ(faces[0]->y2, 21.0);
  // the same pair turned by a quarter, stored the other way round: the crack has turned with it
  const Discs turned{{10.0, 10.0}, {23.0, 20.0}, {2.0, 1.0}, {5, 3}, {0, 0}};
  const auto later = views::crack_faces(turned.drawn(6), crack_of_3_and_5);
  ASSERT_TRUE(later.at(0).has_value());
  EXPECT_DOUBLE_EQ(later[0]->y1, 21.0);
  EXPECT_DOUBLE_EQ(later[0]->y2, 21.0);
  EXPECT_DOUBLE_EQ(std::abs(later[0]->x2 - later[0]->x1), 2.0);
}

TEST(CrackFaces, GoWhenTheDiscsHaveParted) {
  // parted: farther than 1.25 times the sum of the radii, which is 3
  const Discs near{{0.0, 3.74}, {0.0, 0.0}, {1.0, 2.0}, {3, 5}, {0, 1}};
  const Discs far{{0.0, 3.76}, {0.0, 0.0}, {1.0, 2.0}, {3, 5}, {0, 1}};
  const Discs left{{0.0}, {0.0}, {1.0}, {3}, {0}};
  EXPECT_TRUE(views::crack_faces(near.drawn(6), crack_of_3_and_5).at(0).has_value());
  EXPECT_FALSE(views::crack_faces(far.drawn(6), crack_of_3_and_5).at(0).has_value());
  EXPECT_FALSE(views::crack_faces(left.drawn(6), crack_of_3_and_5).at(0).has_value());
  EXPECT_FALSE(views::crack_faces(near.drawn(5), crack_of_3_and_5).at(0).has_value()) << "no such disc was born";
}

TEST(CracksUntil, CountsTheInstantItself) {
  const std::vector<dem2d::Crack> cracks{{.time = 1.0}, {.time = 2.0}, {.time = 3.0}};
  EXPECT_EQ(views::cracks_until(cracks, 0.5).size(), 0u);
  EXPECT_EQ(views::cracks_until(cracks, 2.0).size(), 2u);
  EXPECT_EQ(views::cracks_until(cracks, 9.0).size(), 3u);
}

}  // namespace
