// How the bit of an FMU moves: its angle, and what it feels when it stands, turns back, leaves the rock or begins.
#include <cmath>

#include "tests/export/fmu_inputs.hpp"

using namespace bitrock;

namespace {

using namespace fmu_test;
using importer::Instance, importer::Outputs;

TEST_F(Fmu, TheAngleNeverFallsAndFollowsARotationThatReverses) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(6.0, advancing, pushing), importer::ok);
  double t = 0.0, before = 0.0, expected = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double h = 1e-4 * (1 + (7 * i) % 10), rotation = 6.0 + 9.0 * std::sin(11.0 * t);
    ASSERT_EQ(instance.set(rotation, advancing, pushing), importer::ok);
    ASSERT_EQ(instance.step(t, t + h), importer::ok) << instance.log;
    for (int k = 0; k < 20; ++k) {  // the middle of twenty pieces
      expected += h / 20.0 * std::max(0.0, 6.0 + 9.0 * std::sin(11.0 * (t + (k + 0.5) * h / 20.0)));
    }
    t += h;
    const double angle = instance.get().angle;
    ASSERT_GE(angle, before);
    // 0.1 mrad of the step that is not yet known, and less than 0.1 mrad for each of the 2 x 19 halts
    ASSERT_NEAR(angle, expected, 4e-3) << t;
    before = angle;
  }
  EXPECT_GT(before, 60.0);
}

TEST_F(Fmu, WithoutAdvanceNothingIsFeltOnceMeansAndDrawnWindowsHavePassed) {
  int conditions = 0;
  for (const double rotation : {2.1, 4.0, 6.283, 12.5, 21.0}) {
    for (const double advance : {1e-4, 1.3e-3, 4e-3, 1e-2}) {
      for (const double h : {1e-3, 3.7e-3, 0.02}) {
        Instance instance(library, guid, resources);
        ASSERT_EQ(instance.start(rotation, advance, pushing), importer::ok);
        int i = 0;
        const auto step = [&] {
          EXPECT_EQ(instance.step(h * i, h * (i + 1)), importer::ok) << instance.log;
          ++i;
          return instance.get();
        };
        double largest = 0.0;
        while (h * i < 1.5) largest = std::max(largest, step().torque);
        ASSERT_GT(largest, 0.0);
        ASSERT_EQ(instance.set(rotation, 0.0, pushing), importer::ok);
        const double stopped = h * i;
        while (h * i < stopped + 0.1 + 2.0 * h) step();
        const double last_drawn = instance.get().angle + 3.0 * bit.signal.window_angle;  // two, and reach
        while (step().angle < last_drawn) {
        }
        const int questions = instance.get().questions;
        for (int k = 0; k < 300; ++k) {
          const Outputs seen = step();
          ASSERT_EQ(std::fabs(seen.torque) + std::fabs(seen.axial_force) + seen.depth, 0.0) << rotation << " " << h;
          ASSERT_EQ(seen.questions, questions);
        }
        // standing, turning back, and drilling again
        for (const double other : {0.0, -rotation}) {
          ASSERT_EQ(instance.set(other, 0.0, pushing), importer::ok);
          ASSERT_EQ(step().torque, 0.0);
        }
        ASSERT_EQ(instance.set(rotation, advance, pushing), importer::ok);
        largest = 0.0;
        for (int k = 0; k * h < 2.5; ++k) largest = std::max(largest, step().torque);
        EXPECT_GT(largest, 0.0);
        ++conditions;
      }
    }
  }
  EXPECT_EQ(conditions, 60);
}

TEST_F(Fmu, StartsFromNothing) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(0.0, 0.0, 0.0), importer::ok);
  double t = 0.0;
  for (const auto& [rotation, advance] : {std::pair{0.0, 0.0},
                                          {turning, 0.0},
                                          {-turning, advancing},
                                          {0.0, advancing},
                                          {turning, -advancing},
                                          {turning, 1e-12}}) {
    ASSERT_EQ(instance.set(rotation, advance, pushing), importer::ok);
    for (int i = 0; i < 200; ++i) {
      ASSERT_EQ(instance.step(t, t + 0.01), importer::ok) << instance.log;
      t += 0.01;
      const Outputs seen = instance.get();
      ASSERT_EQ(std::fabs(seen.torque) + std::fabs(seen.axial_force) + seen.depth, 0.0) << rotation << " " << advance;
      ASSERT_EQ(seen.questions, 0);
    }
  }
  ASSERT_EQ(instance.set(turning, advancing, pushing), importer::ok);
  double largest = 0.0;
  for (int i = 0; i < 100; ++i, t += 0.01) {
    ASSERT_EQ(instance.step(t, t + 0.01), importer::ok) << instance.log;
    largest = std::max(largest, instance.get().torque);
  }
  EXPECT_GT(largest, 0.0);
}

TEST_F(Fmu, BeginsWithTheInputsOfTheStepInWhichItFirstCuts) {
  Instance late(library, guid, resources), at_once(library, guid, resources);
  ASSERT_EQ(late.start(0.0, 0.0, 0.0), importer::ok);
  ASSERT_EQ(late.step(0.0, 0.5), importer::ok);
  late.set(0.0, advancing, pushing);
  ASSERT_EQ(late.step(0.5, 1.0), importer::ok);
  EXPECT_EQ(late.get(), Outputs{});
  late.set(turning, advancing, pushing);
  ASSERT_EQ(at_once.start(turning, advancing, pushing, 1.0), importer::ok);
  for (int i = 0; i < 400; ++i) {
    const double t = 1.0 + i / 256.0, end = 1.0 + (i + 1) / 256.0;
    late.step(t, end);
    at_once.step(t, end);
    ASSERT_EQ(late.get(), at_once.get()) << i;
  }
  EXPECT_GT(late.get().questions, 0);
}

TEST_F(Fmu, StandsStillOffTheRockBelowTheThresholdAndBackwards) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.set_real(9, 2e4), importer::ok) << instance.log;  // threshold_weight_N
  ASSERT_EQ(instance.start(turning, advancing, pushing), importer::ok);
  double t = 0.0;
  const auto step = [&](double speed, double push) {
    EXPECT_EQ(instance.set(speed, advancing, push), importer::ok);
    EXPECT_EQ(instance.step(t, t + 0.25), importer::ok) << instance.log;
    t += 0.25;
    return instance.get();
  };
  const Outputs cut = step(turning, pushing);
  EXPECT_EQ(cut.angle, 0.25 * turning);
  for (const auto& [speed, push] : {std::pair{0.0, pushing}, {-turning, pushing}, {turning, 2e4}, {-0.0, 1.0}}) {
    const Outputs stood = step(speed, push);
    EXPECT_EQ(stood.angle, cut.angle);
    EXPECT_EQ(stood.torque, cut.torque);
    EXPECT_EQ(stood.axial_force, cut.axial_force);
  }
  for (const double push : {0.0, -1e5}) {
    const Outputs lifted = step(turning, push);
    EXPECT_EQ(lifted.angle, cut.angle);
    EXPECT_EQ(std::fabs(lifted.torque) + std::fabs(lifted.axial_force) + lifted.depth, 0.0);
  }
  EXPECT_GT(step(turning, 2.0001e4).angle, cut.angle);
}

}  // namespace
