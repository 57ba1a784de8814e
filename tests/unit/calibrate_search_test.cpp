// The search for micro-parameters, on rocks that are formulas: every answer is known, an evaluation costs nothing.
#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/random.hpp"
#include "studies/calibrate/calibration.hpp"

using namespace bitrock;

namespace {

using studies::Micro, studies::Property, studies::SearchEnd;

/// A rock as a formula. All stresses scale with E*, tensile strength and cohesion together, as in the engine.
struct ModelRock {
  double curvature = 0.0;   ///< 0: straight in the logarithms
  double saturation = 1e9;  ///< UCS / tensile strength never exceeds this
  double scatter = 0.0;     ///< of one specimen [1]
  double chaos = 0.0;       ///< of one specimen when its micro-parameters change a little [1]
  double largest_nu = 10.0;
  double pressure = 20e6;       ///< of the triaxial tests [Pa]; it does not scale with the rock
  std::uint64_t replicate = 0;  ///< another one, another chance
  int calls = 0, tests = 0;

  studies::PerProperty<double> exact(const Micro& micro) const {
    const double modulus = micro[0], kappa = std::log(micro[1] / 2.5), tension = micro[2];
    const double ratio = std::log(micro[3] / tension / 5.0), brittle = std::log(tension / modulus / 0.0067);
    const double strength = 0.65 * tension * std::exp(-0.2 * kappa - curvature * kappa * kappa);
    const double wide = 10.0 * std::exp(0.5 * ratio - curvature * ratio * ratio - 0.25 * kappa + 0.03 * brittle);
    const double friction = std::pow(micro[4] / 0.577, 0.1);
    const double times = wide / std::pow(1.0 + std::pow(wide / saturation, 6.0), 1.0 / 6.0) * friction;
    const double nu = 0.19 + 0.16 * kappa - 0.5 * curvature * kappa * kappa;
    const double ucs = strength * times * (1.0 + 0.15 * micro[5]);
    return {ucs, strength, modulus * std::exp(-0.22 * kappa + 0.01 * brittle), std::min(nu, largest_nu),
            ucs + pressure * (2.7 + 1.3 * micro[5]) * friction};
  }

  studies::Evaluation evaluate(const Micro& micro, int seeds) {
    ++calls;
    tests += seeds;
    studies::Evaluation made{.micro = micro};
    for (const Property property : studies::all_properties) {
      const std::size_t i = studies::index_of(property);
      const double share = property == Property::youngs_modulus || property == Property::poissons_ratio ? 0.2 : 1.0;
      std::vector<double> values;
      for (int seed = 1; seed <= seeds; ++seed) {
        base::Random own(base::mix(replicate) ^ (static_cast<std::uint64_t>(1000 * seed) + i));
        base::Random now(
            base::mix(replicate + static_cast<std::uint64_t>(micro[3]) + 7919 * static_cast<std::uint64_t>(seed) + i) ^
            static_cast<std::uint64_t>(micro[1] * 1e6));
        const double noise = share * (scatter * base::normal(own) + chaos * base::normal(now));
        values.push_back(exact(micro)[i] * (1.0 + noise));
      }
      made.measured[i] = base::summarise(values);
    }
    return made;
  }
};

studies::CalibrationTarget article() {
  studies::CalibrationTarget target{.name = "model"};
  target.wanted = {70.5e6, 7.1e6, 1.48e9, 0.23};
  target.settings = {.seeds = 1, .scouting_seeds = 1};
  return target;
}

studies::Calibration run(ModelRock& rock, const studies::CalibrationTarget& target, bool friction = false) {
  return studies::calibrate(target, {.friction = friction},
                            [&rock](const Micro& micro, int seeds) { return rock.evaluate(micro, seeds); });
}

/// Largest error over the tolerance, of what the formula gives without noise.
double worst(const ModelRock& rock, const studies::CalibrationTarget& target, const Micro& micro) {
  double largest = 0.0;
  for (const Property property : studies::all_properties) {
    if (!studies::is_wanted(target, property)) continue;
    const std::size_t i = studies::index_of(property);
    const double error = studies::error_of(property, rock.exact(micro)[i], target.wanted[i]);
    largest = std::max(largest, std::abs(error) / studies::tolerance_of(target, property));
  }
  return largest;
}

TEST(CalibrationSearch, ReachesFourNumbersOfAStraightRockInFewEvaluations) {
  ModelRock rock;
  const auto target = article();
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_LE(worst(rock, target, found.best.micro), 1.0);
  EXPECT_LE(rock.calls, 4);
  for (const auto parameter : {studies::MicroParameter::effective_modulus, studies::MicroParameter::cohesion}) {
    const double value = found.best.micro[studies::index_of(parameter)];
    EXPECT_EQ(value, studies::rounded(parameter, value));  // as it will stand in the rock file
  }
}

TEST(CalibrationSearch, ReachesTheConfinedStrengthByTheFrictionAngle) {
  // the article's rock has about 130 MPa under 20 MPa with a friction angle of 0, and 160 with 60 degrees
  for (const double confined : {128e6, 140e6, 150e6}) {
    ModelRock rock{.curvature = 0.1};
    auto target = article();
    target.wanted[studies::index_of(Property::confined_strength)] = confined;
    const auto found = run(rock, target);
    EXPECT_EQ(found.end, SearchEnd::reached) << confined;
    EXPECT_LE(worst(rock, target, found.best.micro), 1.0);
    EXPECT_LE(rock.calls, 9);
  }
  ModelRock rock;
  auto target = article();
  target.wanted[studies::index_of(Property::confined_strength)] = 220e6;
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::out_of_reach);
  ASSERT_EQ(found.limits.size(), 1u);
  EXPECT_EQ(found.limits[0], "friction angle 60 deg is the largest allowed");
}

TEST(CalibrationSearch, ReachesACurvedRockFarFromTheStart) {
  for (const double scale : {0.05, 1.0, 40.0}) {
    ModelRock rock{.curvature = 0.1};
    auto target = article();
    target.wanted = {scale * 55e6, scale * 4.2e6, 20.0 * scale * 1e9, 0.28};
    const auto found = run(rock, target);
    EXPECT_EQ(found.end, SearchEnd::reached) << scale;
    EXPECT_LE(worst(rock, target, found.best.micro), 1.0) << scale;
    EXPECT_LE(rock.calls, 7) << scale;
  }
}

TEST(CalibrationSearch, AllStressesScaleInOneStep) {
  // twenty times stiffer and stronger: only E*, tensile strength and cohesion change, so the second evaluation hits
  ModelRock rock;
  auto target = article();
  const auto at_start = rock.exact(studies::micro_of(target.start));
  target.wanted = {20 * at_start[0], 20 * at_start[1], 20 * at_start[2], at_start[3]};
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_EQ(rock.calls, 2);
  EXPECT_NEAR(found.best.micro[0], 20 * 1.5e9, 1.0);
  EXPECT_DOUBLE_EQ(found.best.micro[1], 2.5);
}

TEST(CalibrationSearch, NoiseOfTheSpecimensIsNotChased) {
  // 4 % from specimen to specimen, 1.5 % whenever a parameter changes: the mean of 12 is known to 1.2 %
  ModelRock rock{.curvature = 0.1, .scatter = 0.04, .chaos = 0.015};
  auto target = article();
  target.settings = {.seeds = 12, .scouting_seeds = 4};
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::reached);
  for (const Property property : studies::all_properties) {
    EXPECT_TRUE(studies::is_met(target, property, found.best.measured[studies::index_of(property)]));
  }
  EXPECT_EQ(found.best.measured[0].count, 12);
  EXPECT_LE(rock.calls, 10);
  EXPECT_LE(worst(rock, target, found.best.micro), 4.0);  // 3 standard errors of 1.2 %, tolerance 1 %
}

TEST(CalibrationSearch, AFewUnluckySpecimensDoNotDecideThatATargetIsOutOfReach) {
  // the first 3 specimens are 20 % weaker than the rock, whose largest strength ratio, 11, is 10 % above the wanted one
  ModelRock rock{.saturation = 11.0};
  auto target = article();
  target.settings = {.seeds = 12, .scouting_seeds = 3};
  const auto found = studies::calibrate(target, {}, [&](const Micro& micro, int seeds) {
    studies::Evaluation made = rock.evaluate(micro, 1);
    for (auto& measured : made.measured) measured.count = seeds;
    base::Summary& strength = made.measured[0];
    strength.mean *= seeds == 3 ? 0.8 : 1.0;
    strength.standard_error = strength.mean * (seeds == 3 ? 0.08 : 0.01);
    return made;
  });
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_LE(worst(rock, target, found.best.micro), 1.0);
}

TEST(CalibrationSearch, WhatIsNotGivenStaysBitForBit) {
  for (const Property only : studies::all_properties) {
    ModelRock rock{.curvature = 0.1};
    auto target = article();
    target.start.joint_modulus = 1.5e9 / 3.0;  // no round numbers
    target.start.tensile_strength = 31e6 / 3.0;
    target.start.cohesion = 151e6 / 3.0;
    target.start.joint_stiffness_ratio = 7.0 / 3.0;
    const auto at_start = rock.exact(studies::micro_of(target.start));
    target.wanted = {};
    target.wanted[studies::index_of(only)] = 1.2 * at_start[studies::index_of(only)];
    const auto found = run(rock, target);
    EXPECT_EQ(found.end, SearchEnd::reached);
    EXPECT_LE(worst(rock, target, found.best.micro), 1.0);
    int changed = 0;
    for (std::size_t i = 0; i < found.best.micro.size(); ++i) {
      changed += found.best.micro[i] != studies::micro_of(target.start)[i];
    }
    EXPECT_EQ(changed, 1) << studies::words_of(only).name;
  }
}

TEST(CalibrationSearch, APairOfTargetsLeavesTheOtherTwo) {
  ModelRock rock{.curvature = 0.1};
  auto target = article();
  target.wanted[studies::index_of(Property::youngs_modulus)] = 0.0;
  target.wanted[studies::index_of(Property::poissons_ratio)] = 0.0;
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_LE(worst(rock, target, found.best.micro), 1.0);
  EXPECT_EQ(found.best.micro[0], target.start.joint_modulus);
  EXPECT_EQ(found.best.micro[1], target.start.joint_stiffness_ratio);
}

TEST(CalibrationSearch, APoissonsRatioOutOfReachEndsSoonWithTheRestMet) {
  ModelRock rock{.curvature = 0.1, .largest_nu = 0.33};
  auto target = article();
  target.wanted[studies::index_of(Property::poissons_ratio)] = 0.45;
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::out_of_reach);
  EXPECT_LE(rock.calls, 7);
  EXPECT_NEAR(found.best.measured[3].mean, 0.33, 0.03);
  for (const std::size_t i : {0u, 1u, 2u}) EXPECT_NEAR(found.best.measured[i].mean / target.wanted[i], 1.0, 0.03);
  EXPECT_NEAR(found.evaluations[1].micro[1], 2.5 * std::exp(0.9), 0.01);  // not farther at once than lines are trusted
  ASSERT_EQ(found.limits.size(), 1u);
  EXPECT_EQ(found.limits[0], "stiffness ratio 10 is the largest allowed");
}

TEST(CalibrationSearch, AStrengthRatioOutOfReachEndsSoonWithTheNearest) {
  ModelRock rock{.saturation = 13.0};
  auto target = article();
  target.wanted[studies::index_of(Property::ucs)] = 40 * 7.1e6;
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::out_of_reach);
  EXPECT_LE(rock.calls, 7);
  EXPECT_GE(found.best.measured[0].mean / found.best.measured[1].mean, 12.5);
  for (const std::size_t i : {1u, 2u}) EXPECT_NEAR(found.best.measured[i].mean / target.wanted[i], 1.0, 0.03);
  EXPECT_NEAR(found.best.measured[3].mean, 0.23, 0.015);
  ASSERT_FALSE(found.limits.empty());
  EXPECT_NE(found.limits.back().find("cohesion / tensile strength 30 is the largest"), std::string::npos);
}

TEST(CalibrationSearch, AWrongSlopeDoesNotTurnTheSearchAwayFromItsLimit) {
  // where cohesion no longer helps, chance decides the measured slope; a negative one must not send the search back
  auto target = article();
  target.wanted = {40 * 7.1e6, 0.0, 0.0, 0.0};
  const auto found = studies::calibrate(target, {}, [](const Micro& micro, int) {
    studies::Evaluation made{.micro = micro};
    made.measured[0] = {.count = 1, .mean = 70e6 * std::pow(micro[3] / 50e6, -0.2)};
    return made;
  });
  EXPECT_EQ(found.end, SearchEnd::out_of_reach);
  EXPECT_LE(found.evaluations.size(), 6u);
  for (const auto& evaluation : found.evaluations) EXPECT_GE(evaluation.micro[3], 50e6);
  ASSERT_EQ(found.limits.size(), 1u);
  EXPECT_EQ(found.limits[0], "cohesion 300 MPa is the largest allowed");
}

TEST(CalibrationSearch, FrictionHelpsWhereCohesionIsAtItsLimit) {
  auto target = article();
  target.wanted[studies::index_of(Property::ucs)] = 13.5 * 7.1e6;
  ModelRock without{.saturation = 13.0}, with{.saturation = 13.0};
  EXPECT_EQ(run(without, target).end, SearchEnd::out_of_reach);
  const auto found = run(with, target, true);
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_GT(found.best.micro[4], target.start.friction);
  EXPECT_LE(worst(with, target, found.best.micro), 1.0);
}

TEST(CalibrationSearch, FrictionThatHelpsMayStartFromNone) {
  auto target = article();
  target.start.friction = 0.0;
  target.wanted[studies::index_of(Property::ucs)] = 11.0 * 7.1e6;
  ModelRock rock{.saturation = 13.0};
  const auto found = studies::calibrate(target, {.friction = true}, [&](Micro micro, int seeds) {
    const double friction = micro[4];
    micro[4] = std::max(friction, 0.05);  // the formula has no strength without friction; a rock has some
    studies::Evaluation made = rock.evaluate(micro, seeds);
    made.micro[4] = friction;
    return made;
  });
  EXPECT_EQ(found.end, SearchEnd::reached);
  EXPECT_NEAR(found.best.micro[4], 0.577 * std::pow(11.0 / 13.0, 10.0), 0.02);  // UCS goes with its tenth root
  bool at_least = false;  // a zero has no logarithm: the search for friction begins at the least allowed
  for (const auto& evaluation : found.evaluations) at_least = at_least || evaluation.micro[4] == 0.05;
  EXPECT_TRUE(at_least);
}

TEST(CalibrationSearch, NoTryLeavesTheRangesOfARockFile) {
  // E needs more than a rock file allows, and the strengths follow it
  ModelRock rock;
  studies::CalibrationTarget target = article();
  target.wanted = {4900e6, 450e6, 990e9, 0.23};
  const auto evaluate = [&](const Micro& micro, int seeds) {
    dem2d::Rock tried = studies::with_micro(target.start, micro);
    EXPECT_NO_THROW(dem2d::parse_rock(base::to_toml(dem2d::describe(tried)), "tried.toml"));
    return rock.evaluate(micro, seeds);
  };
  const studies::Calibration found = studies::calibrate(target, {}, evaluate);
  EXPECT_LE(found.best.micro[0], 1000e9);
  EXPECT_GT(found.best.micro[0], 900e9);
}

TEST(CalibrationSearch, TheBudgetIsKept) {
  ModelRock rock{.curvature = 0.1};
  auto target = article();
  target.wanted = {500e6, 20e6, 80e9, 0.30};
  target.settings.most_evaluations = 2;
  const auto found = run(rock, target);
  EXPECT_EQ(found.end, SearchEnd::out_of_budget);
  EXPECT_EQ(rock.calls, 2);
  EXPECT_EQ(found.evaluations.size(), 2u);
}

TEST(CalibrationSearch, AStepIntoARockThatCannotBeTestedIsTakenBack) {
  ModelRock rock;
  const auto target = article();
  int refused = 0;
  const auto found = studies::calibrate(target, {}, [&](const Micro& micro, int seeds) {
    if (rock.calls == 1 && refused == 0) {
      ++refused;
      throw base::SimulationError("it did not break");
    }
    return rock.evaluate(micro, seeds);
  });
  EXPECT_EQ(found.end, SearchEnd::reached);
  ASSERT_EQ(found.failures.size(), 1u);
  EXPECT_EQ(found.failures[0], "it did not break");
  EXPECT_EQ(found.evaluations[1].failure, "it did not break");
  EXPECT_EQ(found.evaluations[0].failure, "");
}

TEST(CalibrationSearch, AStartThatCannotBeTestedSaysWhyAndWhatToChange) {
  const auto message = [](const studies::CalibrationTarget& target, int seeds_that_fail) -> std::string {
    ModelRock rock;
    try {
      studies::calibrate(target, {}, [&](const Micro& micro, int seeds) {
        if (seeds == seeds_that_fail) throw base::SimulationError("it did not break");
        return rock.evaluate(micro, seeds);
      });
    } catch (const base::SimulationError& error) {
      return error.what();
    }
    return "";
  };
  auto target = article();
  EXPECT_EQ(message(target, 1).find("the start rock could not be tested: it did not break (choose another start.rock"),
            0u);
  target.settings = {.seeds = 12, .scouting_seeds = 4};
  EXPECT_EQ(message(target, 12).find("the micro-parameters found so far could not be tested on 12 specimens: it did"),
            0u);
}

}  // namespace
