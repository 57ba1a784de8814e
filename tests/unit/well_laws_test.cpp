// The laws of a string in a well against numbers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "runtime/well/beam.hpp"
#include "runtime/well/hole.hpp"
#include "runtime/well/rotation.hpp"
#include "runtime/well/wall_law.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

TEST(SlipImpulse, HasTheNumbersOfAWorkedExample) {
  // a joint of 10 m drill pipe on the wall, mu .25, N 2620 N, h .5 ms, slip (.2, .4) m/s: the root found apart
  const double wt = .00187169, wc = .00964771, most = .25 * 2620 * 5e-4;
  const SlipImpulse<double> p = slip_impulse(.2, .4, wt, wc, most);
  EXPECT_NEAR(p.along, -.1471316, 6e-8);
  EXPECT_NEAR(p.around, -.2925894, 6e-8);
  EXPECT_NEAR(.2 + wt * p.along, .1997246, 6e-8);
  EXPECT_NEAR(.4 + wc * p.around, .3971772, 6e-8);
}

TEST(SlipImpulse, StopsWhatItCanStop) {
  // demand |(u_t / W_t, u_c / W_c)| = .14887 N s is below the .3275 it has
  const double wt = .00187169, wc = .00964771, most = .3275;
  EXPECT_NEAR(std::hypot(2e-4 / wt, 1e-3 / wc), .14887, 6e-6);
  const SlipImpulse<double> p = slip_impulse(2e-4, 1e-3, wt, wc, most);
  EXPECT_NEAR(2e-4 + wt * p.along, 0.0, 1e-19);
  EXPECT_NEAR(1e-3 + wc * p.around, 0.0, 1e-19);
  const SlipImpulse<double> none = slip_impulse(0.0, 0.0, wt, wc, 0.0);
  EXPECT_EQ(none.along, 0.0);
  EXPECT_EQ(none.around, 0.0);
}

TEST(SlipImpulse, IsCoulombsLawAtTheEndOfTheStep) {
  // whatever the ratio of the two directions (pipe has 5) and however near to sticking: all it has, against the slip
  // that is left
  for (const double ratio : {1.0, 3.0, 10.0, 100.0}) {
    for (const double angle : {0.0, 0.3, 1.0, 1.5707}) {
      for (const double beyond : {1.001, 1.1, 2.0, 100.0}) {
        const double wt = 2e-3, wc = ratio * wt, most = 0.4;
        const double ut = beyond * most * wt * std::cos(angle), uc = -beyond * most * wc * std::sin(angle);
        const SlipImpulse<double> p = slip_impulse(ut, uc, wt, wc, most);
        EXPECT_NEAR(std::hypot(p.along, p.around), most, 1e-15);
        const double left_t = ut + wt * p.along, left_c = uc + wc * p.around;
        EXPECT_LT(p.along * left_t + p.around * left_c, 0.0);
        EXPECT_NEAR((p.along * left_c - p.around * left_t) / (most * std::hypot(ut, uc)), 0.0, 1e-8)
            << ratio << " " << angle << " " << beyond;
      }
    }
  }
}

TEST(SlipImpulse, FourGetTheBitsOfOne) {
  const FourNumbers ut{.2, 2e-4, 0.0, -1.0}, uc{.4, 1e-3, 0.0, 2.0}, wt{2e-3, 1e-3, 3e-3, 0.0},
      wc{9e-3, 1e-3, 0.0, 0.0}, most{.3, .3, 0.0, 0.0};
  const auto four = slip_impulse(ut, uc, wt, wc, most);
  for (int lane = 0; lane < 4; ++lane) {
    const SlipImpulse<double> one = slip_impulse(ut[lane], uc[lane], wt[lane], wc[lane], most[lane]);
    EXPECT_EQ(four.along[lane], one.along) << lane;
    EXPECT_EQ(four.around[lane], one.around) << lane;
  }
}

TEST(WallPush, PushesOnly) {
  const WallSpring wall;  // 5e7 N/m, 5e4 N s/m
  EXPECT_EQ(wall_push(wall, 1e-4, 0.0).force, 5000.0);
  EXPECT_EQ(wall_push(wall, 1e-4, 0.01).force, 5500.0);
  EXPECT_EQ(wall_push(wall, 1e-4, -0.2).force, 0.0);
  EXPECT_EQ(wall_push(wall, -1e-9, 5.0).force, 0.0);
  EXPECT_EQ(wall_push(wall, 1e-4, 0.0).energy, 0.25);
  // the damper takes 50 N 0.01 m/s... and all that the spring gives back while it may not pull
  EXPECT_NEAR(wall_push(wall, 1e-4, 0.01).damper_power, 5e4 * 0.01 * 0.01, 1e-12);
  EXPECT_NEAR(wall_push(wall, 1e-4, -0.2).damper_power, 5000.0 * 0.2, 1e-9);
}

TEST(Beam, ShearCoefficientOfAPipe) {
  // solid 6 (1 + nu) / (7 + 6 nu); thin 2 (1 + nu) / (4 + 3 nu)
  const double nu = 200.0 / (2.0 * 79.3) - 1.0;
  PipeSection pipe{.outer_diameter = 0.1, .inner_diameter = 0.0};
  EXPECT_NEAR(beam_of(pipe).shear / (79.3e9 * area(pipe)), 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu), 1e-14);
  pipe.inner_diameter = 0.0999999;
  EXPECT_NEAR(beam_of(pipe).shear / (79.3e9 * area(pipe)), 2.0 * (1.0 + nu) / (4.0 + 3.0 * nu), 1e-6);
}

TEST(Beam, DrillPipeAndCollars) {
  // by hand: pi / 4 (D^2 - d^2), pi / 64 (D^4 - d^4)
  const Beam pipe = beam_of({.outer_diameter = 0.127, .inner_diameter = 0.10861});
  EXPECT_NEAR(10.0 * pipe.mass, 267.14, 6e-3);
  EXPECT_NEAR(10.0 * pipe.polar_inertia, .93248, 6e-6);
  EXPECT_NEAR(267.14 * 100.0 / 12.0 + 10.0 * pipe.transverse_inertia, 2226.6, 6e-2);
  const Beam collar = beam_of({.outer_diameter = 0.1651, .inner_diameter = 0.0714375});
  EXPECT_NEAR(10.0 * collar.mass, 1365.9, 6e-2);
  EXPECT_NEAR(10.0 * collar.polar_inertia, 5.525, 6e-4);
}

TEST(Rotation, ByTwiceIsTheExponential) {
  for (const double half : {0.0, 1e-8, 1e-3, 0.1, 0.7, 1.0}) {
    const Quaternion<double> q = rotation_by_twice(Vector3{0.6 * half, 0.0, -0.8 * half});
    EXPECT_NEAR(q.w, std::cos(half), 1e-13);
    EXPECT_NEAR(q.x, 0.6 * std::sin(half), 1e-13);
    EXPECT_NEAR(q.z, -0.8 * std::sin(half), 1e-13);
  }
  for (const Vector3& d :
       {Vector3{0, 0, 1}, Vector3{0, 1, 0}, Vector3{1, 0, 0}, Vector3{-1, 0, 0}, unit(Vector3{-0.9, 0.1, 0.2})})
    EXPECT_LT(length(direction_of(rotation_to(d)) - d), 1e-14);
}

TEST(Hole, IsCutWhereASectionBeginsAndAStationLies) {
  const WellPath path = well_path({{0, 0, 0}, {100, 0, 0}, {190, 0.5, 0}});
  const std::vector<HolePiece> pieces = hole_pieces(path, {{150, 0.3, 0.2}, {180, 0.2, 0.4}});
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[1].arc.begin, 100.0);
  EXPECT_EQ(pieces[2].arc.begin, 150.0);
  EXPECT_EQ(pieces[2].radius, 0.1);  // the last section goes on
  EXPECT_EQ(pieces[1].friction, 0.2);
  for (const double depth : {120.0, 149.0, 151.0, 185.0, 300.0}) {
    std::size_t arc = 1;
    const WellPoint point = point_at(path, depth, arc);
    const std::size_t at = piece_at(pieces, point.position, 0);
    EXPECT_EQ(at, depth < 150.0 ? 1u : 2u);
    EXPECT_NEAR(foot_on(pieces[at].arc, point.position).measured_depth, depth, 1e-9);
    EXPECT_LT(length(foot_on(pieces[at].arc, point.position).offset), 1e-10);
  }
  EXPECT_THROW(hole_pieces(path, {}), base::InputError);
  EXPECT_THROW(hole_pieces(path, {{100, 0.0, 0.2}}), base::InputError);
  EXPECT_THROW(hole_pieces(path, {{100, 0.2, -0.1}}), base::InputError);
  EXPECT_THROW(hole_pieces(path, {{100, 0.2, 0.1}, {90, 0.2, 0.1}}), base::InputError);
}

}  // namespace
