// The FMU in the hands of an importer: the runtime's own forces to the last bit, steps taken back, instances beside
// each other, and what has to be refused without harm.
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>

#include "base/text.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/constant_speed.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/laws/progression_angle.hpp"
#include "surrogate/net/model_file.hpp"
#include "tests/export/fmu_fixture.hpp"

using namespace bitrock;

namespace {

using fmu_test::Fmu;
using importer::Instance, importer::Outputs;
namespace fs = std::filesystem;

constexpr double turning = 12.5, advancing = 4e-3, pushing = 1e5;  // [rad/s], [m/s], [N]
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Inputs that change all the time, with the bit off the rock and turning backwards now and then.
double rotation_at(double t) {
  return 10.0 + 12.0 * std::sin(3.0 * t);
}
double rop_at(double t) {
  return 3e-3 * (1.0 + 0.9 * std::sin(5.0 * t));
}
double weight_at(double t) {
  return 5e4 + 8e4 * std::sin(2.0 * t);
}

/// `steps` steps from `first` of this length with these inputs.
std::vector<Outputs> run(Instance& instance, int first, int steps, double length) {
  std::vector<Outputs> history;
  for (int i = first; i < first + steps; ++i) {
    const double t = length * i;
    EXPECT_EQ(instance.set(rotation_at(t), rop_at(t), weight_at(t)), importer::ok) << instance.log;
    EXPECT_EQ(instance.step(t, length * (i + 1)), importer::ok) << instance.log;
    history.push_back(instance.get());
  }
  return history;
}

TEST_F(Fmu, SpeaksTheVersionOfTheStandard) {
  EXPECT_STREQ(library.fmi2GetVersion(), "2.0");
  EXPECT_STREQ(library.fmi2GetTypesPlatform(), "default");
}

TEST_F(Fmu, GivesTheBitsOfSignalAtConstantRates) {
  const runtime::ConstantSpeed drive{
      .rotation = turning, .rate_of_penetration = advancing, .duration = 4.0, .rate = 1000.0};
  const runtime::Signal expected = runtime::constant_speed_signal(bit, model, drive);
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(turning, advancing, pushing), importer::ok) << instance.log;
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.time_s.size(); ++i) {
    if (i > 0) {
      ASSERT_EQ(instance.step(expected.time_s[i - 1], expected.time_s[i]), importer::ok) << instance.log;
    }
    const Outputs seen = instance.get();
    ASSERT_EQ(seen.angle, expected.angle_rad[i]);
    ASSERT_EQ(seen.torque, expected.torque_N_m[i]) << i;
    ASSERT_EQ(seen.axial_force, expected.axial_force_N[i]) << i;
    ASSERT_EQ(seen.depth, expected.summary.depth_of_cut_m);
    largest = std::max(largest, seen.torque);
  }
  EXPECT_GT(largest, 10.0);
  EXPECT_EQ(instance.get().questions, expected.summary.clamps.asked);
  EXPECT_EQ(instance.get().clamped, expected.summary.clamps.clamped());
}

TEST_F(Fmu, GivesTheBitsOfTheCInterfaceWhileRatesChange) {
  const runtime::CoreDescription description = runtime::describe(bit, model);
  std::size_t bytes = 0;
  ASSERT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_OK);
  std::vector<double> memory(bytes / sizeof(double) + 1);
  bitrock_core* core = nullptr;
  ASSERT_EQ(bitrock_core_create(memory.data(), bytes, &description.plain, &core), BITROCK_OK);

  Instance instance(library, guid, resources);
  const double first_rotation = rotation_at(0.0), first_rop = rop_at(0.0), h = 1e-3;
  ASSERT_EQ(instance.start(first_rotation, first_rop, weight_at(0.0)), importer::ok) << instance.log;
  bitrock_load load{};
  ASSERT_EQ(bitrock_core_accept(core, 0.0, first_rotation, first_rop), BITROCK_OK);
  ASSERT_EQ(bitrock_core_update(core, 0.0, first_rotation, first_rop, &load), BITROCK_OK);
  EXPECT_EQ(instance.get().torque, load.torque_N_m);

  double angle = 0.0, angle_since = 0.0, since = 0.0, cutting = first_rotation, begin = 0.0, last_step = 0.0;
  int off = 0, standing = 0;
  for (int i = 0; i < 8000; ++i) {
    const double t = h * i, end = t + (h * (i + 1) - t), speed = rotation_at(t), push = weight_at(t);
    if (const double now = runtime::progression(speed, push, 0.0); now != cutting) {
      angle_since = angle_since + cutting * (begin - since) + runtime::missing_angle(cutting, now, last_step);
      since = begin;
      cutting = now;
    }
    last_step = end - begin;
    begin = end;
    angle = std::max(angle, angle_since + cutting * (end - since));
    double rotation = 0.0, rop = 0.0;
    ASSERT_EQ(bitrock_core_averages(core, &rotation, &rop), BITROCK_OK);
    ASSERT_EQ(bitrock_core_update(core, angle, rotation, rop, &load), BITROCK_OK);
    ASSERT_EQ(bitrock_core_accept(core, end, speed, rop_at(t)), BITROCK_OK);
    const Outputs seen = run(instance, i, 1, h).front();
    ASSERT_EQ(seen.angle, angle) << i;
    ASSERT_EQ(seen.torque, push > 0.0 ? load.torque_N_m : 0.0) << i;
    ASSERT_EQ(seen.axial_force, push > 0.0 ? load.axial_force_N : 0.0) << i;
    off += push > 0.0 ? 0 : 1;
    standing += speed > 0.0 ? 0 : 1;
  }
  EXPECT_GT(off, 500);
  EXPECT_GT(standing, 500);
  bitrock_tally tally{};
  ASSERT_EQ(bitrock_core_tally(core, &tally), BITROCK_OK);
  EXPECT_EQ(instance.get().questions, tally.asked);
}

TEST_F(Fmu, IsTheSameForEveryStepWhileInputsDoNotChange) {
  Instance fine(library, guid, resources), coarse(library, guid, resources), uneven(library, guid, resources);
  for (Instance* instance : {&fine, &coarse, &uneven})
    ASSERT_EQ(instance->start(turning, advancing, pushing), importer::ok) << instance->log;
  for (int i = 0; i < 40; ++i) {
    const double t = 0.125 * i;
    for (int k = 0; k < 64; ++k) fine.step(t + k / 512.0, t + (k + 1) / 512.0);
    coarse.step(t, t + 0.125);
    uneven.step(t, t + 0.03125);
    uneven.step(t + 0.03125, t + 0.125);
    Outputs seen = coarse.get();
    seen.questions = fine.get().questions;  // one step is longer than a window: some are skipped, and never asked about
    seen.clamped = fine.get().clamped;
    ASSERT_EQ(fine.get(), seen) << i;
    ASSERT_EQ(fine.get().torque, uneven.get().torque) << i;
    ASSERT_EQ(fine.get().axial_force, uneven.get().axial_force) << i;
  }
  EXPECT_GT(fine.get().questions, 100);
}

/// The article's swings: 60 rpm and 15 m/h, by these shares, twice a second.
struct Swing {
  double of_rotation, of_advance;
};

/// Outputs at every millisecond from 1 s to 4 s.
std::vector<Outputs> swung(Instance& instance, const Swing& swing, int steps_a_millisecond) {
  const double h = 1e-3 / steps_a_millisecond;
  const auto set = [&](double t) {
    const double sine = std::sin(4.0 * std::numbers::pi * t), later = std::sin(4.0 * std::numbers::pi * t + 1.0);
    return instance.set(2.0 * std::numbers::pi * (1.0 + swing.of_rotation * sine),
                        15.0 / 3600.0 * (1.0 + swing.of_advance * later), pushing);
  };
  EXPECT_EQ(instance.start(2.0 * std::numbers::pi, 15.0 / 3600.0, pushing), importer::ok);
  std::vector<Outputs> seen;
  for (int i = 0; i < 4000 * steps_a_millisecond; ++i) {
    if (i >= 1000 * steps_a_millisecond && i % steps_a_millisecond == 0) seen.push_back(instance.get());
    set(h * i);
    instance.step(h * i, h * (i + 1));
  }
  return seen;
}

// The table of docs/reference/formats.md: how far two runs with other steps are apart while the inputs change, for the
// shipped networks and the shipped bit.
TEST_F(Fmu, OtherStepsGiveNearlyTheSameForceWhileInputsChange) {
  const fs::path folder = dir / "shipped";
  const surrogate::Model shipped =
      surrogate::read_model(fs::path(BITROCK_SOURCE_DIR) / "campaigns/paper240/model.json");
  base::write_whole(dir / "shipped.fmu", fmu::fmu_file(bit, shipped).bytes);
  unpack(dir / "shipped.fmu", folder);
  const std::string its_guid = fmu_test::parse(base::read_whole(folder / "modelDescription.xml")).at("guid");
  for (const auto& [name, swing] :
       {std::pair{"rotation", Swing{0.8, 0.0}}, std::pair{"rate of penetration", Swing{0.0, 0.8}},
        std::pair{"both", Swing{0.8, 0.8}}}) {
    const auto run_with = [&, swing = swing](int steps_a_millisecond) {
      Instance instance(library, its_guid, uri(folder / "resources"));
      return swung(instance, swing, steps_a_millisecond);
    };
    const std::vector<Outputs> fine = run_with(20);
    fmt::print("| {} |", name);
    for (const int steps : {1, 2, 5, 10}) {
      const std::vector<Outputs> coarse = run_with(steps);
      for (const auto component : {&Outputs::torque, &Outputs::axial_force}) {
        double apart = 0.0, square = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i) {
          apart += std::pow(coarse[i].*component - fine[i].*component, 2);
          square += std::pow(fine[i].*component, 2);
        }
        const double share = std::sqrt(apart / square);
        fmt::print("{}{:.1f} %{}", component == &Outputs::torque ? " " : ", ", 100.0 * share,
                   component == &Outputs::torque ? "" : " |");
        EXPECT_LT(share, 0.05) << name << " " << 1.0 / steps << " ms";
      }
    }
    fmt::print("\n");
  }
}

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

TEST_F(Fmu, AStepTakenBackLeavesNoTrace) {
  Instance tried(library, guid, resources), straight(library, guid, resources);
  for (Instance* instance : {&tried, &straight}) ASSERT_EQ(instance->start(10.0, 3e-3, 5e4), importer::ok);
  importer::State state = nullptr;
  for (int i = 0; i < 60; ++i) {
    ASSERT_EQ(library.fmi2GetFMUstate(tried.component, &state), importer::ok);  // into the same memory every time
    const Outputs before = tried.get();
    for (int k = 1; k <= 5; ++k) {
      tried.set(30.0 * k, 1e-2 / k, 1e5);
      ASSERT_EQ(tried.step(0.05 * i + 0.1 * (k - 1), 0.05 * i + 0.1 * k), importer::ok) << tried.log;
    }
    ASSERT_EQ(library.fmi2SetFMUstate(tried.component, state), importer::ok) << tried.log;
    ASSERT_EQ(tried.get(), before);
    ASSERT_EQ(run(tried, i, 1, 0.05), run(straight, i, 1, 0.05)) << i;
    ASSERT_EQ(tried.state(), straight.state()) << i;
  }
  EXPECT_EQ(library.fmi2FreeFMUstate(tried.component, &state), importer::ok);
  EXPECT_EQ(state, nullptr);
}

TEST_F(Fmu, GoesOnInAnotherInstanceWithParametersAndAll) {
  Instance first(library, guid, resources), second(library, guid, resources);
  ASSERT_EQ(first.set_integer(13, 77), importer::ok);  // seed
  ASSERT_EQ(first.set_real(10, 0.25), importer::ok);   // averaging_time_s
  ASSERT_EQ(first.set_integer(14, 2), importer::ok);   // combine: max
  ASSERT_EQ(first.start(10.0, 3e-3, 5e4), importer::ok);
  ASSERT_EQ(second.start(1.0, 1e-3, 5e4, 8.0), importer::ok);
  run(first, 0, 3000, 1e-3);
  const std::vector<char> state = first.state();
  ASSERT_EQ(second.set_state(state), importer::ok) << second.log;
  EXPECT_EQ(second.get(), first.get());
  EXPECT_EQ(run(second, 3000, 3000, 1e-3), run(first, 3000, 3000, 1e-3));
  EXPECT_EQ(second.state(), first.state());
  int seed = 0;
  const unsigned reference = 13;
  ASSERT_EQ(library.fmi2GetInteger(second.component, &reference, 1, &seed), importer::ok);
  EXPECT_EQ(seed, 77);
  // a state of before the start is one too
  Instance third(library, guid, resources);
  const std::vector<char> begin = third.state();
  ASSERT_EQ(second.set_state(begin), importer::ok) << second.log;
  ASSERT_EQ(second.start(10.0, 3e-3, 5e4), importer::ok);
  ASSERT_EQ(third.start(10.0, 3e-3, 5e4), importer::ok);
  EXPECT_EQ(run(second, 0, 500, 1e-3), run(third, 0, 500, 1e-3));
}

TEST_F(Fmu, RefusesStatesThatAreDamagedOrForeign) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(10.0, 3e-3, 5e4), importer::ok);
  run(instance, 0, 100, 1e-2);
  const std::vector<char> good = instance.state();
  run(instance, 100, 10, 1e-2);
  const std::vector<char> now = instance.state();
  constexpr std::size_t head = 264;  // [bytes]; then the state of the core, whose second word says how much it uses
  std::uint64_t used = 0;
  std::memcpy(&used, good.data() + head + 8, sizeof(used));
  ASSERT_LE(head + used, good.size());
  for (std::size_t i = 0; i < head + used; i += i < 600 ? 1 : 97) {
    std::vector<char> bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x10);
    ASSERT_EQ(instance.set_state(bad), importer::error) << i;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, good.size() - 1, good.size() + 1}) {
    std::vector<char> bad = good;
    bad.resize(size);
    EXPECT_EQ(instance.set_state(bad), importer::error) << size;
  }
  runtime::Bit other = bit;
  other.cutters[0].width *= 1.01;
  base::write_whole(dir / "other.fmu", fmu::fmu_file(other, model).bytes);
  unpack(dir / "other.fmu", dir / "other");
  const std::string other_guid = fmu_test::parse(base::read_whole(dir / "other/modelDescription.xml")).at("guid");
  Instance foreign(library, other_guid, uri(dir / "other/resources"));
  ASSERT_NE(foreign.component, nullptr) << foreign.log;
  EXPECT_EQ(instance.set_state(foreign.state()), importer::error);
  EXPECT_NE(instance.log.find("not of this FMU"), std::string::npos);
  EXPECT_EQ(library.fmi2SetFMUstate(instance.component, nullptr), importer::error);
  EXPECT_EQ(instance.state(), now);
  EXPECT_EQ(instance.set_state(good), importer::ok) << instance.log;
}

TEST_F(Fmu, AStateIsLookedAtAlsoWhenItsChecksumFits) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(instance.start(10.0, 3e-3, 5e4), importer::ok);
  run(instance, 0, 100, 1e-2);
  const std::vector<char> good = instance.state();
  constexpr std::size_t checksum_at = 16, sealed_from = 24, signal_at = 32, moment_at = 136, head = 264;  // [bytes]
  const auto sealed = [&](std::vector<char> state) {
    const std::uint64_t sum = base::fingerprint({state.data() + sealed_from, head - sealed_from});
    std::memcpy(state.data() + checksum_at, &sum, sizeof(sum));
    return state;
  };
  ASSERT_EQ(sealed(good), good) << "this test seals as the program does";
  const auto refused = [&](std::size_t at, auto value) {
    std::vector<char> bad = good;
    static_assert(sizeof(value) == 8);
    std::memcpy(bad.data() + at, &value, sizeof(value));
    EXPECT_EQ(instance.set_state(sealed(bad)), importer::error) << at << ": " << value;
    EXPECT_EQ(instance.state(), good) << at << ": " << value;
  };
  for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{4}, std::int64_t{1} << 40}) {
    refused(moment_at, wrong);      // phase
    refused(moment_at + 8, wrong);  // stale
  }
  for (const double wrong : {not_a_number, infinite}) {
    for (std::size_t at = signal_at; at < signal_at + 24; at += 8) refused(at, wrong);  // the signal of the core
    for (std::size_t word = 2; word < 16; ++word) {
      const bool stop_time = word == 3, begun = word == 12;
      if (!(stop_time && wrong == infinite) && !begun) refused(moment_at + 8 * word, wrong);
    }
  }
  refused(moment_at + 8 * 12, std::int64_t{2});  // begun
  EXPECT_EQ(instance.set_state(good), importer::ok) << instance.log;
}

TEST_F(Fmu, InstancesDoNotKnowOfEachOtherAlsoOnTwoThreads) {
  const auto history_of = [this](int seed) {
    Instance instance(library, guid, resources);
    EXPECT_EQ(instance.set_integer(13, seed), importer::ok);
    EXPECT_EQ(instance.start(10.0, 3e-3, 5e4), importer::ok);
    return run(instance, 0, 4000, 1e-3);
  };
  const std::vector<Outputs> one_alone = history_of(1), two_alone = history_of(2);
  std::vector<Outputs> one, two;
  std::thread beside([&] { one = history_of(1); });
  two = history_of(2);
  beside.join();
  EXPECT_EQ(one, one_alone);
  EXPECT_EQ(two, two_alone);
  EXPECT_NE(one, two);
}

TEST_F(Fmu, InitialisationMayBeRepeatedAndResetBringsTheBeginningBack) {
  Instance instance(library, guid, resources), fresh(library, guid, resources);
  ASSERT_EQ(instance.set_integer(13, 5), importer::ok);
  ASSERT_EQ(instance.start(20.0, 1e-3, 5e4), importer::ok);
  run(instance, 0, 300, 1e-2);
  ASSERT_EQ(library.fmi2Reset(instance.component), importer::ok);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 1, 1e-6, 0.0, 0, 0.0), importer::ok);
  ASSERT_EQ(library.fmi2EnterInitializationMode(instance.component), importer::ok);
  for (int i = 0; i < 5; ++i) {  // a loop of the importer: inputs, outputs, other inputs
    ASSERT_EQ(instance.set(40.0 - i, 1e-2, 5e4), importer::ok);
    EXPECT_GT(instance.get().questions, 0);
  }
  ASSERT_EQ(instance.set(10.0, 3e-3, 5e4), importer::ok);
  ASSERT_EQ(library.fmi2ExitInitializationMode(instance.component), importer::ok);
  ASSERT_EQ(fresh.start(10.0, 3e-3, 5e4), importer::ok);
  EXPECT_EQ(instance.get(), fresh.get());
  EXPECT_EQ(run(instance, 0, 300, 1e-2), run(fresh, 0, 300, 1e-2));
}

TEST_F(Fmu, AFailedCallSaysWhyAndChangesNothing) {
  Instance instance(library, guid, resources);
  ASSERT_EQ(library.fmi2DoStep(instance.component, 0.0, 0.1, 0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, not_a_number, 0, 0.0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, 1.0, 1, 1.0), importer::error);
  ASSERT_EQ(library.fmi2SetupExperiment(instance.component, 0, 0.0, 0.0, 1, 5.0), importer::ok);
  for (const auto& [reference, value] : {std::pair{9u, -1.0}, {10u, 0.0}, {11u, -1.0}, {12u, 2.01}, {10u, infinite}})
    EXPECT_EQ(instance.set_real(reference, value), importer::error) << reference;
  for (const auto& [reference, value] : {std::pair{13u, -1}, {14u, 0}, {14u, 3}, {15u, 3}, {15u, -2147483647 - 1}})
    EXPECT_EQ(instance.set_integer(reference, value), importer::error) << reference;
  ASSERT_EQ(library.fmi2EnterInitializationMode(instance.component), importer::ok);
  ASSERT_EQ(instance.set(10.0, 3e-3, 5e4), importer::ok);
  ASSERT_EQ(library.fmi2ExitInitializationMode(instance.component), importer::ok);
  run(instance, 0, 50, 0.03125);
  const double t = 50 * 0.03125;
  const std::vector<char> now = instance.state();
  instance.log.clear();

  const auto expect_error = [&](int status, const std::string& words) {
    EXPECT_EQ(status, importer::error) << words;
    EXPECT_NE(instance.log.find(words), std::string::npos) << instance.log << "\nlacks: " << words;
    EXPECT_EQ(instance.state(), now) << words;
    instance.log.clear();
  };
  for (const double bad : {not_a_number, infinite, -infinite}) {
    expect_error(instance.set(bad, 3e-3, 5e4), "rotation_rad_per_s: the value must be finite");
    expect_error(instance.set(11.0, bad, 5e4), "rate_of_penetration_m_per_s: the value must be finite");
    expect_error(instance.set(11.0, 2e-3, bad), "weight_on_bit_N: the value must be finite");
    expect_error(library.fmi2DoStep(instance.component, bad, 0.1, 0), "not finite");
    expect_error(library.fmi2DoStep(instance.component, t, bad, 0), "not finite");
  }
  expect_error(instance.step(t, t), "the step must be above 0");
  expect_error(instance.step(t, t - 0.1), "the step must be above 0");
  expect_error(instance.step(t - 0.03125, t), "must begin where the one before ended");
  expect_error(instance.step(t + 0.03125, t + 0.0625), "must begin where the one before ended");
  expect_error(instance.step(t, 5.001), "after the stop time");
  expect_error(library.fmi2DoStep(instance.component, t, 1e-20, 0), "too short");
  expect_error(instance.set_real(importer::torque, 1.0), "torque_N_m: an output cannot be set");
  expect_error(instance.set_real(9, 1.0), "threshold_weight_N: a parameter is fixed");
  expect_error(instance.set_real(999, 1.0), "(no such variable)");
  expect_error(instance.set_integer(importer::rotation, 1), "not a variable of this type");
  expect_error(library.fmi2ExitInitializationMode(instance.component), "not allowed in this phase");
  expect_error(library.fmi2SetReal(instance.component, nullptr, 1, nullptr), "null pointer");
  const unsigned none[1] = {0};
  int whole[1] = {0};
  double real[1] = {0.0};
  const char* text[1] = {""};
  expect_error(library.fmi2GetBoolean(instance.component, none, 1, whole), "no variables of this type");
  expect_error(library.fmi2SetString(instance.component, none, 1, text), "no variables of this type");
  expect_error(library.fmi2GetDirectionalDerivative(instance.component, none, 1, none, 1, real, real), "not provided");
  expect_error(library.fmi2SetRealInputDerivatives(instance.component, none, 1, whole, real), "no variables");
  expect_error(library.fmi2CancelStep(instance.component), "no step is pending");
  EXPECT_EQ(library.fmi2GetBoolean(instance.component, none, 0, whole), importer::ok);

  EXPECT_EQ(library.fmi2GetStatus(instance.component, 0, whole), importer::discard);
  EXPECT_EQ(library.fmi2GetIntegerStatus(instance.component, 0, whole), importer::discard);
  EXPECT_EQ(library.fmi2GetStringStatus(instance.component, 1, text), importer::discard);
  EXPECT_EQ(library.fmi2GetRealStatus(instance.component, 0, real), importer::discard);
  EXPECT_EQ(library.fmi2GetRealStatus(instance.component, 2, real), importer::ok);
  EXPECT_EQ(real[0], t);
  EXPECT_EQ(library.fmi2GetBooleanStatus(instance.component, 3, whole), importer::ok);
  EXPECT_EQ(whole[0], 0);

  EXPECT_EQ(run(instance, 50, 50, 0.03125).size(), 50U);  // it goes on
  ASSERT_EQ(library.fmi2Terminate(instance.component), importer::ok);
  EXPECT_EQ(instance.step(100 * 0.03125, 3.3), importer::error);
  EXPECT_EQ(library.fmi2DoStep(nullptr, 0.0, 0.1, 0), importer::error);
  library.fmi2FreeInstance(nullptr);
}

/// As importers in Python, Java or .NET: they cannot take variable arguments, and show the message as it is.
void take_plain(void* environment, const char*, int, const char*, const char* message, ...) {
  *static_cast<std::string*>(environment) += message;
}

TEST_F(Fmu, ItsMessagesAreWholeWithoutFurtherArguments) {
  std::string plain;
  const importer::Callbacks callbacks{take_plain, nullptr, nullptr, nullptr, &plain};
  const char* const location = "file:///no/such/100%25/%25s/resources";
  EXPECT_EQ(library.fmi2Instantiate("bit", 1, guid.c_str(), location, &callbacks, 0, 0), nullptr);
  EXPECT_NE(plain.find("fmi2Instantiate: "), std::string::npos) << plain;
  EXPECT_NE(plain.find("/no/such/100%%/%%s/resources"), std::string::npos) << plain;
  const Instance with_arguments(library, guid, location);
  EXPECT_NE(with_arguments.log.find("/no/such/100%/%s/resources"), std::string::npos) << with_arguments.log;
}

}  // namespace
