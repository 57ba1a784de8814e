// States of the FMU of a string, instances beside each other, and what has to be refused without harm.
#include <array>
#include <cstring>
#include <limits>
#include <thread>

#include "base/random.hpp"
#include "tests/export/string_fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::Element, fmu_test::StringFile, fmu_test::StringFmu, fmu_test::StringInstance;
namespace fs = std::filesystem;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Outputs after each of some steps of 7 ms.
std::vector<std::vector<double>> run(StringInstance& string, int first, int steps) {
  std::vector<std::vector<double>> history;
  for (int i = first; i < first + steps; ++i) {
    EXPECT_EQ(string.step(7e-3 * i, 7e-3 * (i + 1)), importer::ok) << string.fmu.log;
    history.push_back(string.outputs());
  }
  return history;
}

void expect_exact_states(const StringFile& fmu, int before, const std::string& input, double value) {
  StringInstance tried(fmu), straight(fmu), second(fmu);
  for (StringInstance* string : {&tried, &straight}) {
    ASSERT_EQ(string->start(), importer::ok) << string->fmu.log;
    run(*string, 0, before);
  }
  const std::vector<char> state = tried.fmu.state();
  const std::vector<double> outputs = tried.outputs();
  ASSERT_EQ(tried.set(input, value), importer::ok) << tried.fmu.log;
  run(tried, before, 40);
  EXPECT_NE(tried.outputs(), outputs);
  ASSERT_EQ(tried.fmu.set_state(state), importer::ok) << tried.fmu.log;
  EXPECT_EQ(tried.outputs(), outputs);
  EXPECT_EQ(tried.fmu.state(), state);
  ASSERT_EQ(second.fmu.set_state(state), importer::ok) << second.fmu.log;  // one that has not begun
  const auto expected = run(straight, before, 60);
  EXPECT_EQ(run(tried, before, 60), expected);
  EXPECT_EQ(run(second, before, 60), expected);
  EXPECT_EQ(second.fmu.state(), straight.fmu.state());
}

TEST_F(StringFmu, AStateInMidRunBringsTheSameBitsAgainInTwoDimensions) {
  expect_exact_states(exported(source / "campaigns/drill/stick_slip.toml"), 100, "set_rotation_rad_per_s", 9.0);
}

TEST_F(StringFmu, AStateInMidRunBringsTheSameBitsAgainBelowABlock) {
  const fs::path file = changed("normal", {{"hook_load_kN = 25",
                                            "hoist = \"autodriller\"\nweight_on_bit_kN = 14\n"
                                            "line_stiffness_N_per_m = 8e6"}});
  expect_exact_states(exported(file), 100, "set_rotation_rad_per_s", 9.0);
}

TEST_F(StringFmu, AStateInMidRunBringsTheSameBitsAgainUnderTorqueAndHookLoad) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance first(fmu), second(fmu);
  ASSERT_EQ(first.set("block_mass_kg", 15e3), importer::ok);
  for (StringInstance* string : {&first, &second}) ASSERT_EQ(string->start(), importer::ok);
  const double hanging = first["hook_load_N"] + 262.0 * 10.5;  // with the pipe of the trip
  run(first, 0, 500);
  ASSERT_EQ(first.choose("rig", 2), importer::ok);
  ASSERT_EQ(first.choose("drive_input", 2), importer::ok);
  ASSERT_EQ(first.choose("hoist_input", 2), importer::ok);
  ASSERT_EQ(first.set("set_torque_N_m", 500.0), importer::ok);
  ASSERT_EQ(first.set("set_hook_load_N", hanging - 100.0), importer::ok);
  run(first, 500, 40);
  ASSERT_EQ(second.fmu.set_state(first.fmu.state()), importer::ok) << second.fmu.log;
  EXPECT_EQ(second.whole("drive_input"), 2);
  EXPECT_EQ(second.whole("hoist_input"), 2);
  EXPECT_EQ(second["block_mass_kg"], 15e3);
  EXPECT_EQ(second["block_speed_m_per_s"], first["block_speed_m_per_s"]);
  EXPECT_NE(first["block_speed_m_per_s"], 0.0);
  EXPECT_EQ(run(second, 540, 60), run(first, 540, 60));
}

TEST_F(StringFmu, AStateInMidRunBringsTheSameBitsAgainInAWell) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  expect_exact_states(fmu, 330, "set_block_speed_m_per_s", 0.0);
}

TEST_F(StringFmu, AStateGoesOnWithSeedAndParametersInAWell) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance first(fmu), second(fmu);
  ASSERT_EQ(first.choose("seed", 77), importer::ok);
  ASSERT_EQ(first.set("hole_friction_factor", 1.5), importer::ok);
  for (StringInstance* string : {&first, &second}) ASSERT_EQ(string->start(), importer::ok);
  run(first, 0, 1250);  // the bit is on the rock, whose noise the seed draws
  ASSERT_EQ(second.fmu.set_state(first.fmu.state()), importer::ok) << second.fmu.log;
  EXPECT_EQ(second.whole("seed"), 77);
  EXPECT_EQ(second["hole_friction_factor"], 1.5);
  EXPECT_NE(second["source_force_N"], 0.0);
  EXPECT_EQ(run(second, 1250, 50), run(first, 1250, 50));
}

TEST_F(StringFmu, AStateGoesOnWithSeedAndParametersInTwoDimensions) {
  const StringFile fmu = exported(source / "campaigns/drill/normal.toml");
  StringInstance first(fmu), second(fmu), other(fmu);
  ASSERT_EQ(first.choose("seed", 77), importer::ok);
  for (StringInstance* string : {&first, &second, &other}) ASSERT_EQ(string->start(), importer::ok);
  run(first, 0, 50);
  run(second, 0, 3);
  ASSERT_EQ(second.fmu.set_state(first.fmu.state()), importer::ok) << second.fmu.log;
  EXPECT_EQ(second.whole("seed"), 77);
  EXPECT_EQ(second.whole("clamped_conditions"), first.whole("clamped_conditions"));
  EXPECT_EQ(run(second, 50, 50), run(first, 50, 50));
  EXPECT_NE(run(other, 0, 100).back(), first.outputs()) << "another seed, another force";
}

TEST_F(StringFmu, ResetBringsTheBeginningBack) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance used(fmu), fresh(fmu);
  ASSERT_EQ(used.set("hole_friction_factor", 2.0), importer::ok);
  ASSERT_EQ(used.choose("seed", 5), importer::ok);
  ASSERT_EQ(used.start(), importer::ok);
  run(used, 0, 300);
  ASSERT_EQ(fmu.library.fmi2Reset(used.fmu.component), importer::ok);
  EXPECT_EQ(used["hole_friction_factor"], 1.0);
  EXPECT_EQ(used["hook_load_N"], 0.0) << "nothing is known before the start";
  for (StringInstance* string : {&used, &fresh}) ASSERT_EQ(string->start(), importer::ok);
  EXPECT_EQ(run(used, 0, 300), run(fresh, 0, 300));
}

TEST_F(StringFmu, RefusesStatesThatAreDamagedOrForeign) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok);
  run(string, 0, 50);
  const std::vector<char> good = string.fmu.state();
  for (std::size_t i = 0; i < good.size(); i += i < 400 ? 1 : 997) {
    std::vector<char> bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    ASSERT_EQ(string.fmu.set_state(bad), importer::error) << i;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, good.size() - 1, good.size() + 1}) {
    std::vector<char> bad = good;
    bad.resize(size);
    EXPECT_EQ(string.fmu.set_state(bad), importer::error) << size;
  }
  EXPECT_EQ(string.fmu.state(), good);
  const StringFile other = exported(source / "campaigns/drill/normal.toml");
  StringInstance foreign(other);
  EXPECT_EQ(string.fmu.set_state(foreign.fmu.state()), importer::error);
}

/// States that are wrong and yet have the right checksum: refused, or one that answers.
TEST_F(StringFmu, NoStateWithARightChecksumDoesHarm) {
  for (const fs::path& file :
       {written("short", fmu_test::short_well), changed("normal", {{"source = \"bit\"", "source = \"none\""}})}) {
    const StringFile fmu = exported(file);
    StringInstance string(fmu);
    ASSERT_EQ(string.start(), importer::ok);
    run(string, 0, 20);
    const std::vector<char> good = string.fmu.state();
    base::Random random(5);
    int refused = 0, taken = 0;
    for (int trial = 0; trial < 300; ++trial) {
      std::vector<char> bad = good;
      // the head, where phases and settings are, as often as all of it
      const std::size_t words = (trial % 2 == 0 ? std::size_t{400} : bad.size()) / 8;
      const std::size_t at = 32 + 8 * base::below(random, words - 4);
      const std::array<std::uint64_t, 6> values{0, 1, 65, UINT64_MAX, std::uint64_t{1} << 61, random()};
      std::memcpy(bad.data() + at, &values[base::below(random, values.size())], 8);
      const std::uint64_t sum = base::fingerprint({bad.data() + 24, bad.size() - 24});
      std::memcpy(bad.data() + 16, &sum, 8);
      if (string.fmu.set_state(bad) != importer::ok) {
        ++refused;
      } else {
        ++taken;
        fmu.library.fmi2DoStep(string.fmu.component, 0.14, 0.01, 0);
      }
      ASSERT_EQ(string.fmu.set_state(good), importer::ok) << string.fmu.log;
    }
    EXPECT_GT(refused, 30);
    EXPECT_GT(taken, 30);
    EXPECT_EQ(string.fmu.state(), good);
  }
}

TEST_F(StringFmu, InstancesDoNotKnowOfEachOtherAlsoOnTwoThreads) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  const auto history_of = [&](int seed) {
    StringInstance string(fmu);
    EXPECT_EQ(string.choose("seed", seed), importer::ok);
    EXPECT_EQ(string.start(), importer::ok);
    return run(string, 0, 1300);  // to the bottom
  };
  const auto one_alone = history_of(1), two_alone = history_of(2);
  std::vector<std::vector<double>> one, two;
  std::thread beside([&] { one = history_of(1); });
  two = history_of(2);
  beside.join();
  EXPECT_EQ(one, one_alone);
  EXPECT_EQ(two, two_alone);
  EXPECT_NE(one, two);
}

TEST_F(StringFmu, AFailedCallSaysWhyAndChangesNothing) {
  const StringFile fmu = exported(written("short", fmu_test::short_well));
  StringInstance string(fmu);
  EXPECT_EQ(string.set("hole_friction_factor", -1.0), importer::error);
  EXPECT_EQ(string.choose("rig", 0), importer::error);
  EXPECT_EQ(string.choose("rig", 3), importer::error);
  EXPECT_EQ(string.choose("seed", -1), importer::error);
  ASSERT_EQ(string.start(), importer::ok);
  run(string, 0, 30);
  const std::vector<char> now = string.fmu.state();
  const auto expect_error = [&](int status, const std::string& words) {
    EXPECT_EQ(status, importer::error) << words;
    EXPECT_NE(string.fmu.log.find(words), std::string::npos) << string.fmu.log << "\nlacks: " << words;
    EXPECT_EQ(string.fmu.state(), now) << words;
    string.fmu.log.clear();
  };
  const double t = 7e-3 * 30;
  expect_error(string.set("set_rotation_rad_per_s", not_a_number), "must be finite");
  expect_error(string.set("set_rotation_rad_per_s", -1.0), "must be 0 or more");
  expect_error(string.set("hook_load_N", 1.0), "an output cannot be set");
  expect_error(string.set("hole_friction_factor", 2.0), "a parameter is fixed");
  expect_error(string.fmu.set_real(3, 1.0), "(no such variable)");    // set_weight_on_bit_N, which a well does not have
  expect_error(string.fmu.set_real(102, 1.0), "(no such variable)");  // a third stress point
  expect_error(string.fmu.set_real(4000000000U, 1.0), "(no such variable)");
  expect_error(string.step(t, t - 0.1), "the step must be above 0");
  expect_error(string.step(t + 0.1, t + 0.2), "must begin where the one before ended");
  expect_error(string.step(t, 1e12), "1e12 steps");
}

TEST_F(StringFmu, AStringThatBreaksSaysSoAndIsGoodAgainAfterAReset) {
  const StringFile fmu = exported(source / "campaigns/drill/normal.toml");
  StringInstance string(fmu);
  ASSERT_EQ(string.start(), importer::ok);
  ASSERT_EQ(string.set("set_rotation_rad_per_s", 1e300), importer::ok);
  ASSERT_EQ(string.step(0.0, 0.1), importer::error);
  EXPECT_NE(string.fmu.log.find("fmi2DoStep: "), std::string::npos) << string.fmu.log;
  ASSERT_EQ(string.set("set_rotation_rad_per_s", 6.0), importer::ok);
  EXPECT_EQ(string.step(0.0, 0.1), importer::error);
  ASSERT_EQ(fmu.library.fmi2Reset(string.fmu.component), importer::ok);
  ASSERT_EQ(string.start(), importer::ok) << string.fmu.log;
  StringInstance fresh(fmu);
  ASSERT_EQ(fresh.start(), importer::ok);
  EXPECT_EQ(run(string, 0, 20), run(fresh, 0, 20));
}

}  // namespace
