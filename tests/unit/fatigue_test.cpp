// S-N curves and the damage of turning pipe, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/well/bending_magnification.hpp"
#include "studies/well/fatigue.hpp"
#include "studies/well/fatigue_of_joints.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

constexpr double pi = std::numbers::pi, steel = 200e9;

/// Drill pipe of 127 x 108.61 mm and a collar of 165.1 x 71.4375 mm in a build of 10 degrees per 30 m.
constexpr double pipe_radius = 0.127 / 2, collar_radius = 0.1651 / 2, build_radius = 30.0 / (10.0 * pi / 180.0);

TEST(SnCurve, LivesOfTheBuildByB1) {
  const studies::SnCurve* const b1 = studies::find_sn_curve("B1 air");
  ASSERT_NE(b1, nullptr);
  EXPECT_EQ(studies::find_sn_curve("B7"), nullptr);
  // a turn in the build is one cycle of twice E r / R
  const double pipe = 2.0 * steel * pipe_radius / build_radius, collar = 2.0 * steel * collar_radius / build_radius;
  EXPECT_NEAR(pipe, 147.77e6, 0.01e6);
  EXPECT_NEAR(studies::cycles_to_failure(*b1, pipe), 2.746e6, 0.001e6);
  EXPECT_NEAR(3600.0 / studies::cycles_to_failure(*b1, pipe), 1.311e-3, 1e-6) << "an hour at 60 rpm";
  EXPECT_NEAR(3600.0 / studies::cycles_to_failure(*b1, collar), 3.745e-3, 1e-6);
  // the two lines meet at 1e7 cycles, 107 MPa
  EXPECT_NEAR(studies::cycles_to_failure(*b1, 106.97e6), 1e7, 0.01e7);
  EXPECT_NEAR(studies::cycles_to_failure(*b1, 50e6), std::pow(10.0, 17.146 - 5.0 * std::log10(50.0)), 1e3);
  EXPECT_TRUE(std::isinf(studies::cycles_to_failure(*b1, 0.0)));
}

TEST(SnCurve, ThroughPoints) {
  const studies::SnCurve curve = studies::sn_curve_through({400, 200, 100}, {1e5, 8e5, 1e7}, "own", "case.toml");
  EXPECT_NEAR(studies::cycles_to_failure(curve, 400e6), 1e5, 1.0);
  EXPECT_NEAR(studies::cycles_to_failure(curve, 200e6), 8e5, 10.0);
  EXPECT_NEAR(studies::cycles_to_failure(curve, 800e6), 1e5 / 8.0, 1.0) << "the first line goes on: slope 3";
  EXPECT_NEAR(studies::cycles_to_failure(curve, 50e6), 1e7 * 12.5, 1e3) << "the last one, too";
  const auto refused = [](std::vector<double> ranges, std::vector<double> cycles) {
    try {
      studies::sn_curve_through(ranges, cycles, "own", "case.toml");
    } catch (const base::InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(refused({400, 400}, {1e5, 1e6}).find("case.toml: 100000 cycles at 400 MPa, then"), std::string::npos);
  EXPECT_NE(refused({400, 200}, {1e5, 1e5}).find("ranges must fall and cycles rise"), std::string::npos);
  EXPECT_NE(refused({400, -1}, {1e5, 1e6}).find("all above 0"), std::string::npos);
  EXPECT_NE(refused({400, std::nan("")}, {1e5, 1e6}).find("all above 0"), std::string::npos);
  EXPECT_NE(refused({400}, {1e5}).find("at least two points"), std::string::npos);
}

TEST(Goodman, TensionShortensTheLifeAndPressureDoesNot) {
  EXPECT_DOUBLE_EQ(studies::goodman_range(100e6, 200e6, 1000e6), 125e6);
  EXPECT_DOUBLE_EQ(studies::goodman_range(100e6, -200e6, 1000e6), 100e6);
  EXPECT_TRUE(std::isinf(studies::goodman_range(100e6, 1000e6, 1000e6)));
}

TEST(FatigueOfARun, EightFibresOfAPipeThatTurnsInTheBuild) {
  // the moment E I / R stands still in space; in the frame of the pipe it turns the other way: one cycle a turn in
  // every fibre, about the mean stress of the tension
  const double area = pi / 4.0 * (0.127 * 0.127 - 0.10861 * 0.10861);
  const studies::SnCurve& curve = *studies::find_sn_curve("B1 air");
  constexpr int turns = 50, steps = 200, fibres = 8;
  const double range = 2.0 * steel * pipe_radius / build_radius;
  const auto damage_of = [&](double tension) {
    runtime::StressHistories run;
    run.points.resize(fibres);
    for (int k = 0; k <= turns * steps; ++k) {
      run.time.push_back(3600.0 * k / (turns * steps));  // an hour: damage an hour is the damage
      for (int fibre = 0; fibre < fibres; ++fibre) {
        const double angle = 2.0 * pi * k / steps, psi = 2.0 * pi * fibre / fibres;
        run.points[static_cast<std::size_t>(fibre)].stress.push_back(tension / area +
                                                                     0.5 * range * std::sin(psi + angle));
      }
    }
    std::vector<double> damage;
    for (const studies::PointDamage& point :
         studies::damage_of(run, {.curve = curve, .tensile_strength = 1000e6, .from = 0.0}, "run.h5"))
      damage.push_back(point.damage_per_hour);
    return damage;
  };
  for (const double each : damage_of(0.0))
    EXPECT_NEAR(each, turns / studies::cycles_to_failure(curve, range),
                0.02 * turns / 2.746e6);  // the ends of the record
  const double mean = 300e3 / area;
  for (const double each : damage_of(300e3)) {
    const double expected = turns / studies::cycles_to_failure(curve, range / (1.0 - mean / 1000e6));
    EXPECT_NEAR(each, expected, 0.02 * expected);
  }
}

/// A run of 25 s whose two points feel one cycle a second: that of drill pipe in the build, and half of it.
runtime::WellRun turning_run() {
  runtime::WellRun run;
  run.series.stress_Pa.resize(2);
  run.stresses = {{.point = {.name = "pipe in the build"}, .stress = {.measured_depth = 1300.0}},
                  {.point = {.name = "half as bent"}, .stress = {.measured_depth = 1400.0}}};
  for (int k = 0; k <= 25000; ++k) {
    const double t = 325.0 + 1e-3 * k, stress = 73.885e6 * std::cos(2.0 * pi * t);
    run.series.time_s.push_back(t);
    run.series.stress_Pa[0].push_back(stress);
    run.series.stress_Pa[1].push_back(0.5 * stress);
  }
  for (auto* column : {&run.series.hook_load_N, &run.series.drive_torque_N_m, &run.series.drive_rotation_rad_per_s,
                       &run.series.bit_rotation_rad_per_s, &run.series.weight_on_bit_N, &run.series.source_force_N,
                       &run.series.torque_on_bit_N_m, &run.series.rop_m_per_s, &run.series.bit_depth_m,
                       &run.series.fed_m, &run.series.bit_side_force_N})
    column->assign(run.series.time_s.size(), 0.0);
  return run;
}

TEST(FatigueOfARun, DamagePerHourOfPipeThatTurnsInTheBuild) {
  const scratch::Folder folder("fatigue");
  runtime::WellCase well;
  well.drill.run.settling = 325.0;
  runtime::write_well_run(turning_run(), well, "", folder / "run.h5");
  const runtime::StressHistories histories = runtime::read_stress_histories(folder / "run.h5");
  ASSERT_EQ(histories.points.size(), 2u);
  EXPECT_EQ(histories.points[0].name, "pipe in the build");
  EXPECT_EQ(histories.points[1].measured_depth, 1400.0);
  EXPECT_EQ(histories.settling, 325.0);
  studies::FatigueWish wish{.curve = *studies::find_sn_curve("B1 air"), .tensile_strength = 689e6};
  const auto damages = studies::damage_of(histories, wish, "run.h5");
  EXPECT_NEAR(damages[0].damage_per_hour, 1.311e-3, 0.002e-3);  // 60 rpm
  EXPECT_NEAR(damages[0].cycles_per_hour, 3600.0, 1.0);
  EXPECT_NEAR(damages[0].largest_range, 147.77e6, 1e4);
  // 73.9 MPa are beyond the knee of the curve: slope 5
  EXPECT_NEAR(damages[1].damage_per_hour, 3600.0 / std::pow(10.0, 17.146 - 5.0 * std::log10(73.885)), 0.001e-4);
  EXPECT_NEAR(damages[1].hours_to_failure, 1.0 / damages[1].damage_per_hour, 1.0);
  wish.from = 340.0;  // damage an hour does not depend on how long one looks
  EXPECT_NEAR(studies::damage_of(histories, wish, "run.h5")[0].damage_per_hour, 1.311e-3, 0.002e-3);
}

TEST(FatigueOfJoints, AJointThatTurnsInTheBuildSuffersByItsToolJoints) {
  // drill pipe with 6 5/8 in tool joints 9.144 m apart under 134 kN turns in the build: its moment E I / R goes round
  // in the frame of the pipe, one cycle a turn of 2 B E r / R about the mean of the tension, at every angle
  constexpr double tension = 134e3, stand_off = 0.0206, distance = 9.144;
  const runtime::PipeSection ring{.outer_diameter = 0.127, .inner_diameter = 0.10861};
  const double stiffness = runtime::beam_of(ring).bending, moment = stiffness / build_radius;
  runtime::WellRun run = turning_run();
  runtime::JointHistory joint{.above_bit = 240.0,
                              .measured_depth = 1300.0,
                              .outer_diameter = ring.outer_diameter,
                              .inner_diameter = ring.inner_diameter,
                              .bending_stiffness = stiffness,
                              .tool_joint_distance = distance,
                              .stand_off = stand_off};
  for (const double t : run.series.time_s) {
    if (t <= 325.0) continue;  // settling
    joint.tension.push_back(static_cast<float>(tension));
    joint.axial.push_back(static_cast<float>(tension / runtime::area(ring)));
    joint.moment_2.push_back(static_cast<float>(moment * std::cos(2.0 * pi * t)));
    joint.moment_3.push_back(static_cast<float>(moment * std::sin(2.0 * pi * t)));
  }
  runtime::JointHistory slick = joint;  // without tool joints
  slick.tool_joint_distance = 0.0;
  run.joints = {joint, slick};
  const scratch::Folder folder("fatigue_joints");
  runtime::WellCase well;
  well.drill.run.settling = 325.0;
  runtime::write_well_run(run, well, "", folder / "run.h5");
  const runtime::StressHistories histories = runtime::read_stress_histories(folder / "run.h5");
  const studies::FatigueWish wish{.curve = *studies::find_sn_curve("B1 air"), .tensile_strength = 689e6};
  const auto damages = studies::damage_of_joints(histories, wish, "run.h5");
  ASSERT_EQ(damages.size(), 2u);
  const double b = studies::bending_magnification({stiffness, 0.5 * distance, stand_off}, tension, 1.0 / build_radius);
  EXPECT_GT(b, 1.6);
  const double range = 2.0 * steel * pipe_radius / build_radius, mean = tension / runtime::area(ring);
  for (int k = 0; k < 2; ++k) {
    const double times = k == 0 ? b : 1.0;
    const double lives = studies::cycles_to_failure(wish.curve, times * range / (1.0 - mean / 689e6));
    EXPECT_NEAR(damages[k].magnification, times, 1e-5);
    EXPECT_NEAR(damages[k].largest_range, times * range, 1e-4 * range);
    EXPECT_NEAR(damages[k].mean, mean, 1e-3 * range);
    EXPECT_NEAR(damages[k].damage_per_hour, 3600.0 / lives, 3e-3 * 3600.0 / lives);
    EXPECT_EQ(damages[k].measured_depth, 1300.0);
  }
  EXPECT_NEAR(damages[0].damage_per_hour / damages[1].damage_per_hour, std::pow(b, 4.0), 0.02 * std::pow(b, 4.0))
      << "slope 4 of the curve";
  const std::string csv = studies::damage_csv(damages);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "measured_depth_m,above_bit_m,damage_per_hour,cycles_per_hour,largest_range_Pa,mean_Pa,"
            "bending_magnification,angle_deg");
  studies::FatigueWish early = wish;
  early.from = 320.0;
  EXPECT_NO_THROW(studies::damage_of_joints(histories, wish, "run.h5"));
  runtime::StressHistories longer = histories;
  longer.time.insert(longer.time.begin(), 324.0);
  try {
    studies::damage_of_joints(longer, early, "run.h5");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("joints are kept after 325 s only"), std::string::npos) << error.what();
  }
}

TEST(FatigueOfARun, SaysWhatItCannotCount) {
  const auto refused = [](const runtime::StressHistories& run, const studies::FatigueWish& wish) {
    try {
      studies::damage_of(run, wish, "run.h5");
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const studies::FatigueWish wish{.curve = *studies::find_sn_curve("B1 air"), .tensile_strength = 689e6, .from = 0.0};
  runtime::StressHistories run{.time = {0.0, 1.0, 2.0, 3.0}};
  EXPECT_NE(refused(run, wish).find("no stress points (give the case some: [[stress_point]])"), std::string::npos);
  run.points = {{.name = "a", .measured_depth = 10.0, .stress = {0.0, 700e6, 690e6, 700e6}}};
  EXPECT_NE(refused(run, wish).find("the mean stress alone reaches the tensile strength of 689 MPa"),
            std::string::npos);
  studies::FatigueWish late = wish;
  late.from = 2.5;
  EXPECT_NE(refused(run, late).find("run.h5: 1 samples from 2.5 s to 3 s (a cycle needs 3"), std::string::npos);
  run.points[0].stress.assign(4, 5e6);
  EXPECT_TRUE(std::isinf(studies::damage_of(run, wish, "run.h5")[0].hours_to_failure)) << "nothing moves: endless";
}

}  // namespace
