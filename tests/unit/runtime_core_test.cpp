// The core through its C interface: what every host may rely on. Same force after a step taken back, whatever the step
// size, however many bits live beside each other; nothing changed by a call that fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <thread>

#include "base/random.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/core/core.hpp"
#include "surrogate/net/layers.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

using runtime_test::usual_pair;

constexpr double pi = std::numbers::pi;
constexpr double window_angle = pi / 3.0;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

runtime::Bit three_cutters(std::uint64_t seed = 5) {
  runtime::Bit bit{.name = "test", .diameter = 0.2};
  bit.signal.window_angle = window_angle;
  bit.signal.seed = seed;
  for (int i = 1; i <= 3; ++i)
    bit.cutters.push_back({.number = i, .radius = 0.03 * i, .width = 0.02, .back_rake = 0.3});
  return bit;
}

/// Networks of several layers and all kinds of output, with random weights: heights of 1e5 N/m, some 100 peaks a metre,
/// all of them depending on all conditions.
surrogate::Model lively_model(std::uint64_t seed = 3) {
  surrogate::Model model = runtime_test::constant_model(usual_pair());
  base::Random random(seed);
  for (surrogate::Variable& input : model.inputs) {
    input.offset = 0.5 * (input.low + input.high);
    input.scale = 0.5 * (input.high - input.low);
  }
  for (std::size_t i = 0; i < model.outputs.size(); ++i) {
    surrogate::OutputModel& output = model.outputs[i];
    output.network.layers = {3, 4, 6, 3, 1};
    output.network.output = static_cast<surrogate::OutputActivation>(i % 3);
    initialise(output.network, random);
    output.variable.offset = output.variable.scale;
    output.variable.scale *= 0.1;
    if (i % 4 != 1) continue;
    output.log_reference = output.variable.offset;  // offset and scale are those of a logarithm then
    output.variable.offset = 0.7;
    output.variable.scale = 0.05;
  }
  return model;
}

/// A core and the memory it lies in.
struct Made {
  std::vector<double> memory;
  bitrock_core* core = nullptr;
};

Made made(const bitrock_description& description) {
  Made result;
  std::size_t bytes = 0;
  EXPECT_EQ(bitrock_core_size(&description, &bytes), BITROCK_OK);
  result.memory.resize(bytes / sizeof(double) + 1);
  EXPECT_EQ(bitrock_core_create(result.memory.data(), bytes, &description, &result.core), BITROCK_OK);
  return result;
}

Made made(std::uint64_t seed = 5) {
  const surrogate::Model model = lively_model();
  const runtime::CoreDescription description = runtime::describe(three_cutters(seed), model);
  return made(description.plain);
}

bitrock_load load_at(bitrock_core* core, double angle, double rotation = 6.0, double rop = 2e-3) {
  bitrock_load load{};
  EXPECT_EQ(bitrock_core_update(core, angle, rotation, rop, &load), BITROCK_OK);
  return load;
}

void expect_same(const bitrock_load& a, const bitrock_load& b) {
  ASSERT_EQ(a.axial_force_N, b.axial_force_N);
  ASSERT_EQ(a.torque_N_m, b.torque_N_m);
}

std::vector<std::byte> state_of(const bitrock_core* core) {
  std::size_t bytes = 0;
  EXPECT_EQ(bitrock_core_state_size(core, &bytes), BITROCK_OK);
  std::vector<std::byte> state(bytes);
  EXPECT_EQ(bitrock_core_save(core, state.data(), bytes), BITROCK_OK);
  return state;
}

/// Rates that change all the time, also while the angle is in one window.
double rotation_at(double angle) {
  return 6.0 + 4.0 * std::sin(0.7 * angle);
}
double rop_at(double angle) {
  return 2e-3 * (1.0 + 0.8 * std::sin(1.3 * angle));
}

TEST(Core, IsTheSumOfCuttersThatAskTheModelThemselves) {
  const surrogate::Model model = lively_model();
  const runtime::Bit bit = three_cutters();
  const runtime::CoreDescription description = runtime::describe(bit, model);
  const Made whole = made(description.plain);
  std::vector<runtime::CutterForce> parts;
  for (const runtime::Cutter& c : bit.cutters) {
    parts.push_back(runtime_test::cutter_force(bit.signal, c.number, c.radius));
  }
  double last_window = -1e9;
  for (int i = 0; i < 3000; ++i) {
    const double angle = 0.01 * i - 15.0, k = std::floor(angle / window_angle);
    double force = 0.0, torque = 0.0;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const runtime::Cutter& c = bit.cutters[n];
      if (k != last_window) {
        const surrogate::Prediction p = predict(
            model, clamped_to_training_range(
                       model, runtime::cut_conditions(c.radius, c.back_rake, rotation_at(angle), rop_at(angle))));
        enter_window(parts[n], static_cast<std::int64_t>(k), runtime::named(listed(p).items));
      }
      const runtime::ForcePerMetre f = force_at(parts[n].train, runtime::Combine::sum, angle - k * window_angle);
      force += c.width * f.y;
      torque += c.width * c.radius * f.x;
    }
    last_window = k;
    expect_same(load_at(whole.core, angle, rotation_at(angle), rop_at(angle)),
                {.axial_force_N = force, .torque_N_m = torque});
  }
}

TEST(Core, ManyPulsesAtOnceAreAddedInTheSameOrder) {
  // one peak of x as wide as the window and 200 of y: at every angle more than an `ActiveCutter` holds
  const runtime::CutterStatistics crowd{.x = {.amax = 2e5, .amean = 2e5, .np1 = 12.0},
                                        .y = {.amax = 2e5, .amean = 1e5, .np1 = 500.0, .np23 = 1000.0, .np4 = 500.0}};
  for (const runtime::Combine combine : {runtime::Combine::sum, runtime::Combine::max}) {
    runtime::Bit bit = three_cutters();
    bit.signal.combine = combine;
    const surrogate::Model model = runtime_test::constant_model(crowd);
    const runtime::CoreDescription description = runtime::describe(bit, model);
    const Made whole = made(description.plain);
    std::vector<runtime::CutterForce> parts;
    for (const runtime::Cutter& c : bit.cutters) {
      parts.push_back(runtime_test::cutter_force(bit.signal, c.number, c.radius));
    }
    std::size_t most = 0;
    for (int i = 0; i < 300; ++i) {
      const double angle = 0.011 * i, k = std::floor(angle / window_angle);
      double force = 0.0;
      for (std::size_t n = 0; n < parts.size(); ++n) {
        enter_window(parts[n], static_cast<std::int64_t>(k), crowd);
        force += 0.02 * force_at(parts[n].train, combine, angle - k * window_angle).y;
        most = std::max(most, parts[n].train.active.size());
      }
      ASSERT_EQ(load_at(whole.core, angle).axial_force_N, force);
    }
    EXPECT_GT(most, 2 * runtime::most_active);
  }
}

TEST(Core, WideVectorsGiveTheSameBits) {
  for (const runtime::Combine combine : {runtime::Combine::sum, runtime::Combine::max}) {
    runtime::Bit bit = three_cutters();
    bit.signal.combine = combine;
    bit.signal.pulse_width_factor = 2.0;
    const surrogate::Model model = lively_model();
    const runtime::CoreDescription description = runtime::describe(bit, model);
    const Made as_the_machine_has = made(description.plain), narrow = made(description.plain);
    reinterpret_cast<runtime::Core*>(narrow.core)->wide = false;
    for (int i = 0; i < 5000; ++i)
      expect_same(load_at(narrow.core, 0.003 * i), load_at(as_the_machine_has.core, 0.003 * i));
  }
}

TEST(Core, AtConstantRatesTheLoadDependsOnTheAngleAlone) {
  const Made fine = made(), coarse = made(), jumping = made(), backward = made();
  std::vector<bitrock_load> loads;
  for (int i = 0; i < 40000; ++i) {
    const bitrock_load load = load_at(fine.core, 1e-3 * i - 20.0);
    if (i % 7 == 0) loads.push_back(load);
  }
  const auto angle_of = [](std::size_t n) { return 1e-3 * static_cast<double>(7 * n) - 20.0; };
  for (std::size_t n = 0; n < loads.size(); n += 5) expect_same(load_at(coarse.core, angle_of(n)), loads[n]);
  for (std::size_t n = 0; n < loads.size(); n += 500) expect_same(load_at(jumping.core, angle_of(n)), loads[n]);
  for (std::size_t n = loads.size(); n-- > 0;) expect_same(load_at(backward.core, angle_of(n)), loads[n]);
}

TEST(Core, RatesWithinAWindowChangeNothingUntilTheNextIsDrawn) {
  const Made steady = made(), restless = made();
  expect_same(load_at(restless.core, 0.1), load_at(steady.core, 0.1));
  for (int i = 0; i < 2000; ++i) {
    // window 1 came into reach together with window 0
    const double angle = 0.1 + (2.0 * window_angle - 0.11) * i / 2000.0;
    const bool entering = i > 0 && std::floor(angle / window_angle) != std::floor((angle - 0.01) / window_angle);
    const bitrock_load expected = load_at(steady.core, angle);
    expect_same(load_at(restless.core, angle, entering ? 6.0 : rotation_at(31.0 * i), entering ? 2e-3 : 0.0), expected);
  }
  // a standing bit: the angle, and so the load, stays
  const bitrock_load standing = load_at(steady.core, 1.5);
  for (const double rotation : {1.0, 0.0, -2.0}) {
    for (const double rop : {1e-3, 0.0, -1e-3}) expect_same(load_at(steady.core, 1.5, rotation, rop), standing);
  }
}

TEST(Core, AStepTakenBackLeavesNoTrace) {
  // `tried` makes excursions of every length, into windows drawn at other rates and back, before every accepted step
  const Made plain = made(), tried = made();
  double angle = 0.3;
  for (int i = 0; i < 600; ++i) {
    const std::vector<std::byte> before = state_of(tried.core);
    const double reach = 0.02 * static_cast<double>((7 * i) % 400);  // up to eight windows
    for (int n = 1; n <= 4; ++n) load_at(tried.core, angle + reach * n / 4.0, 2.0 + 0.02 * i, 4e-3);
    bitrock_core_accept(tried.core, 1e6 + i, 99.0, 1.0);
    load_at(tried.core, angle - reach, 9.0, 1e-3);
    ASSERT_EQ(bitrock_core_restore(tried.core, before.data(), before.size()), BITROCK_OK);
    ASSERT_EQ(state_of(tried.core), before);

    // every third step ends within a hair of an edge, on one side or the other
    angle += 0.05;
    const double edge = window_angle * std::round(angle / window_angle);
    const double at = i % 3 == 0 ? edge + (i % 2 == 0 ? 1e-12 : -1e-12) : angle;
    const bitrock_load expected = load_at(plain.core, at, rotation_at(angle), rop_at(angle));
    expect_same(load_at(tried.core, at, rotation_at(angle), rop_at(angle)), expected);
    for (bitrock_core* core : {plain.core, tried.core}) {
      ASSERT_EQ(bitrock_core_accept(core, 0.01 * (i + 1), rotation_at(angle), rop_at(angle)), BITROCK_OK);
    }
  }
  EXPECT_EQ(state_of(tried.core), state_of(plain.core));  // tallies and averages too
}

TEST(Core, AStateGoesOnInAnotherCoreAndACopyOfTheBytesIsACore) {
  const Made original = made();
  for (int i = 0; i < 500; ++i) {
    load_at(original.core, 0.02 * i, rotation_at(0.02 * i), rop_at(0.02 * i));
    ASSERT_EQ(bitrock_core_accept(original.core, 0.002 * i, rotation_at(0.02 * i), 1e-3), BITROCK_OK);
  }
  const Made fresh = made();
  const std::vector<std::byte> state = state_of(original.core);
  ASSERT_EQ(bitrock_core_restore(fresh.core, state.data(), state.size()), BITROCK_OK);
  std::vector<double> copied = original.memory;
  auto* const copy = reinterpret_cast<bitrock_core*>(copied.data());
  for (int i = 500; i < 1000; ++i) {
    const double angle = 0.02 * i;
    const bitrock_load expected = load_at(original.core, angle, rotation_at(angle), rop_at(angle));
    expect_same(load_at(fresh.core, angle, rotation_at(angle), rop_at(angle)), expected);
    expect_same(load_at(copy, angle, rotation_at(angle), rop_at(angle)), expected);
  }
  EXPECT_EQ(state_of(fresh.core), state_of(original.core));
  EXPECT_EQ(state_of(copy), state_of(original.core));

  ASSERT_EQ(bitrock_core_reset(copy), BITROCK_OK);
  EXPECT_EQ(state_of(copy), state_of(made().core));
  expect_same(load_at(copy, 0.5), load_at(made().core, 0.5));
}

/// The bytes of a state, taken apart, changed and sealed again, as a stranger who knows the program can.
struct OpenState {
  struct Average {
    double window, constant_since;
    std::int64_t first, count;
  };
  std::vector<std::byte> bytes;
  runtime::ClampTally clamps;
  runtime::DrawTally draws;
  runtime::WindowMemory windows;
  Average rotation, rate_of_penetration;
  std::vector<double> time, rotation_value, rotation_integral, advance_value, advance_integral;

  static constexpr std::size_t sealed_from = 4 * sizeof(std::uint64_t);

  std::size_t used() const {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data() + sizeof(size), sizeof(size));
    return size;
  }

  explicit OpenState(std::vector<std::byte> state) : bytes(std::move(state)) {
    const std::size_t fixed = sealed_from + sizeof(clamps) + sizeof(draws) + sizeof(windows) + 2 * sizeof(Average);
    for (std::vector<double>* list : lists()) list->resize((used() - fixed) / (5 * sizeof(double)));
    walk([](std::byte* part, const std::byte* at, std::size_t size) { std::copy_n(at, size, part); });
  }

  std::array<std::vector<double>*, 5> lists() {
    return {&time, &rotation_value, &rotation_integral, &advance_value, &advance_integral};
  }

  template <class Copy>
  void walk(const Copy& copy) {
    std::byte* at = bytes.data() + sealed_from;
    const auto next = [&](void* part, std::size_t size) {
      copy(static_cast<std::byte*>(part), at, size);  // an empty list has no bytes, and may have no address
      at += size;
    };
    next(&clamps, sizeof(clamps));
    next(&draws, sizeof(draws));
    next(&windows, sizeof(windows));
    next(&rotation, sizeof(rotation));
    next(&rate_of_penetration, sizeof(rate_of_penetration));
    for (std::vector<double>* list : lists()) next(list->data(), list->size() * sizeof(double));
    ASSERT_EQ(at, bytes.data() + used());
  }

  std::vector<std::byte> sealed() {
    walk([](const std::byte* part, std::byte* at, std::size_t size) { std::copy_n(part, size, at); });
    std::array<std::uint64_t, 4> sums{1, 2, 3, used()};
    for (std::size_t at = sealed_from, lane = 0; at < used(); at += 8, lane = (lane + 1) % 4) {
      std::uint64_t word;
      std::memcpy(&word, bytes.data() + at, 8);
      sums[lane] = (sums[lane] ^ word) * 0x9e3779b97f4a7c15ULL;
      sums[lane] ^= sums[lane] >> 32;
    }
    std::uint64_t whole = 0;
    for (const std::uint64_t sum : sums) whole = base::mix(whole ^ sum);
    std::memcpy(bytes.data() + 3 * sizeof(std::uint64_t), &whole, 8);
    return bytes;
  }
};

TEST(Core, BytesThatAreNotItsStateAreRefusedAndChangeNothing) {
  const Made core = made(), other_seed = made(6);
  load_at(core.core, 1.0);
  load_at(other_seed.core, 1.0);
  const std::vector<std::byte> good = state_of(core.core), foreign = state_of(other_seed.core);
  EXPECT_EQ(bitrock_core_restore(core.core, foreign.data(), foreign.size()), BITROCK_BAD_STATE);
  EXPECT_EQ(bitrock_core_restore(core.core, good.data(), good.size() - 1), BITROCK_BAD_STATE);
  const std::size_t used = OpenState(good).used();
  for (std::size_t at = 0; at < used; at += 7) {
    std::vector<std::byte> flipped = good;
    flipped[at] ^= std::byte{4};
    ASSERT_EQ(bitrock_core_restore(core.core, flipped.data(), flipped.size()), BITROCK_BAD_STATE) << at;
  }
  EXPECT_EQ(state_of(core.core), good);
  std::byte small[8];
  EXPECT_EQ(bitrock_core_save(core.core, small, sizeof(small)), BITROCK_BAD_MEMORY);
}

TEST(Core, AStateIsLookedAtAlsoWhenItsChecksumFits) {
  const Made core = made();
  for (int i = 0; i < 20; ++i) {
    load_at(core.core, 0.3 * i);
    ASSERT_EQ(bitrock_core_accept(core.core, 0.01 * i, 6.0, 2e-3), BITROCK_OK);
  }
  const std::vector<std::byte> good = state_of(core.core);
  ASSERT_EQ(OpenState(good).sealed(), good) << "this test seals as the program does";
  const auto refused = [&](const char* what, const std::function<void(OpenState&)>& change) {
    OpenState state(good);
    change(state);
    const std::vector<std::byte> bytes = state.sealed();
    EXPECT_EQ(bitrock_core_restore(core.core, bytes.data(), bytes.size()), BITROCK_BAD_STATE) << what;
    EXPECT_EQ(state_of(core.core), good) << what;
  };
  constexpr int most = std::numeric_limits<int>::max();
  for (const int wrong : {-1, 257, most, -most}) {
    refused("count", [=](OpenState& s) { s.rotation.count = s.rate_of_penetration.count = wrong; });
    refused("first", [=](OpenState& s) { s.rotation.first = s.rate_of_penetration.first = wrong; });
  }
  refused("first of a ring that is not full", [](OpenState& s) { s.rotation.first = s.rate_of_penetration.first = 3; });
  refused("averages of other lengths", [](OpenState& s) { s.rotation.count -= 1; });
  refused("averages of other beginnings", [](OpenState& s) { s.rotation.first += 1; });
  refused("times that fall", [](OpenState& s) { s.time[3] = -1.0; });
  refused("another window", [](OpenState& s) { s.rotation.window = 1e-300; });
  for (const double wrong : {not_a_number, infinite, -infinite}) {
    refused("time", [=](OpenState& s) { s.time[2] = wrong; });
    refused("value", [=](OpenState& s) { s.rotation_value[0] = wrong; });
    refused("integral", [=](OpenState& s) { s.advance_integral[1] = wrong; });
    refused("rotation", [=](OpenState& s) { s.windows.rotation[1] = wrong; });
    refused("advance", [=](OpenState& s) { s.windows.rate_of_penetration[2] = wrong; });
  }
  refused("a count below 0", [](OpenState& s) { s.clamps.asked = -5; });
  refused("a tally below 0", [](OpenState& s) { s.draws.drawn = -5; });
  refused("a window out of place", [](OpenState& s) { ++s.windows.kept[2]; });
  refused("a window that no angle reaches",
          [](OpenState& s) { s.windows.entered = std::numeric_limits<std::int64_t>::max(); });
  refused("a window entered without being drawn", [](OpenState& s) { s.windows.entered += 7; });
  refused("windows without a beginning", [](OpenState& s) { s.windows.entered = runtime::no_window; });
}

TEST(Core, TwoCoresDoNotKnowOfEachOther) {
  std::vector<bitrock_load> alone;
  const Made first = made();
  for (int i = 0; i < 3000; ++i) alone.push_back(load_at(first.core, 0.01 * i));
  // in turn, at other angles and rates
  const Made here = made(), there = made(8);
  for (int i = 0; i < 3000; ++i) {
    load_at(there.core, 50.0 - 0.03 * i, 9.0, 1e-3);
    expect_same(load_at(here.core, 0.01 * i), alone[static_cast<std::size_t>(i)]);
  }
  // at the same time
  std::vector<bitrock_load> by_threads[2];
  std::thread threads[2];
  for (int t = 0; t < 2; ++t) {
    threads[t] = std::thread([&by_threads, t] {
      const Made core = made();
      for (int i = 0; i < 3000; ++i) by_threads[t].push_back(load_at(core.core, 0.01 * i));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<bitrock_load>& loads : by_threads) {
    for (std::size_t i = 0; i < alone.size(); ++i) expect_same(loads[i], alone[i]);
  }
}

TEST(Core, WhatIsNotFiniteIsRefusedAndChangesNothing) {
  const Made core = made();
  load_at(core.core, 1.0);
  ASSERT_EQ(bitrock_core_accept(core.core, 1.0, 6.0, 2e-3), BITROCK_OK);
  const std::vector<std::byte> before = state_of(core.core);
  bitrock_load load{.axial_force_N = 7.0, .torque_N_m = 8.0};
  for (const double bad : {not_a_number, infinite, -infinite}) {
    EXPECT_EQ(bitrock_core_update(core.core, bad, 6.0, 2e-3, &load), BITROCK_NOT_FINITE);
    EXPECT_EQ(bitrock_core_update(core.core, 9.0, bad, 2e-3, &load), BITROCK_NOT_FINITE);
    EXPECT_EQ(bitrock_core_update(core.core, 9.0, 6.0, bad, &load), BITROCK_NOT_FINITE);
    EXPECT_EQ(bitrock_core_accept(core.core, bad, 6.0, 2e-3), BITROCK_NOT_FINITE);
    EXPECT_EQ(bitrock_core_accept(core.core, 2.0, bad, 2e-3), BITROCK_NOT_FINITE);
    EXPECT_EQ(bitrock_core_accept(core.core, 2.0, 6.0, bad), BITROCK_NOT_FINITE);
  }
  EXPECT_EQ(bitrock_core_update(core.core, 1.1e15 * window_angle, 6.0, 2e-3, &load), BITROCK_ANGLE_TOO_LARGE);
  EXPECT_EQ(bitrock_core_update(core.core, -1e300, 6.0, 2e-3, &load), BITROCK_ANGLE_TOO_LARGE);
  EXPECT_EQ(bitrock_core_accept(core.core, 1.0, 6.0, 2e-3), BITROCK_TIME_NOT_LATER);
  EXPECT_EQ(bitrock_core_accept(core.core, 0.5, 6.0, 2e-3), BITROCK_TIME_NOT_LATER);
  EXPECT_EQ(load.axial_force_N, 7.0);
  EXPECT_EQ(load.torque_N_m, 8.0);
  EXPECT_EQ(state_of(core.core), before);
}

// Without advance nothing is cut once the means have passed and the windows drawn before are behind: the mean of rates
// that were something and are 0 now is 0, not a rounding that the networks would answer with their shallowest cut.
TEST(Core, WithoutAdvanceTheLoadEndsWhateverWasBefore) {
  int conditions = 0;
  for (const double rpm : {9.0, 37.0, 60.0, 121.0, 200.0}) {
    for (const double rop : {1.1e-4, 1e-3, 4.3e-3, 1e-2}) {
      for (const double h : {1e-4, 1e-3, 3.7e-3, 0.03}) {
        const double rotation = rpm * pi / 30.0;
        const Made core = made();
        double time = 0.0, angle = 0.0, largest = 0.0;
        const auto step = [&](double advance) {
          double mean_rotation = 0.0, mean_rop = 0.0;
          EXPECT_EQ(bitrock_core_averages(core.core, &mean_rotation, &mean_rop), BITROCK_OK);
          time += h;
          angle += h * rotation;
          const bitrock_load load = load_at(core.core, angle, mean_rotation, mean_rop);
          EXPECT_EQ(bitrock_core_accept(core.core, time, rotation, advance), BITROCK_OK);
          return load;
        };
        ASSERT_EQ(bitrock_core_accept(core.core, 0.0, rotation, rop), BITROCK_OK);
        while (time < 1.0) largest = std::max(largest, step(rop * (1.0 + 0.3 * std::sin(37.0 * time))).torque_N_m);
        ASSERT_GT(largest, 0.0);
        const double stopped = time;
        while (time < stopped + 0.1 + 2.0 * h) step(0.0);
        // two windows are drawn, and the pulses of the second may reach into a third
        const double last_drawn = angle + 3.0 * window_angle;
        while (angle < last_drawn) step(0.0);
        for (int i = 0; i < 500; ++i) expect_same(step(0.0), {.axial_force_N = 0.0, .torque_N_m = 0.0});
        ++conditions;
      }
    }
  }
  EXPECT_EQ(conditions, 80);
}

TEST(Core, AnAdvanceOfLessThanANanometreASecondCutsNothing) {
  const Made none = made(), little = made();
  for (const double rop : {-1.0, -1e-20, 0.0, 1e-300, 1e-18, 1e-12, runtime::slowest_advance}) {
    expect_same(load_at(none.core, 0.7, 6.0, rop), {.axial_force_N = 0.0, .torque_N_m = 0.0});
    EXPECT_EQ(bitrock_core_reset(none.core), BITROCK_OK);
  }
  double largest = 0.0;
  for (int i = 0; i < 100; ++i) {
    largest = std::max(largest, load_at(little.core, 0.01 * i, 6.0, 1.1 * runtime::slowest_advance).torque_N_m);
  }
  EXPECT_GT(largest, 0.0);
}

TEST(Core, ExtremeButFiniteMotionGivesFiniteLoads) {
  const Made core = made();
  double angle = 0.0;
  for (const double rotation : {0.0, -1e300, 1e300, 1e-300, 6.0}) {
    for (const double rop : {0.0, -1e300, 1e300, 1e-300, 2e-3}) {
      for (int i = 0; i < 20; ++i) {
        const bitrock_load load = load_at(core.core, angle += 0.3, rotation, rop);
        ASSERT_TRUE(std::isfinite(load.axial_force_N) && std::isfinite(load.torque_N_m));
        ASSERT_GE(std::min(load.axial_force_N, load.torque_N_m), 0.0);
      }
    }
  }
}

TEST(Core, ABadPredictionIsReportedAndChangesNothing) {
  surrogate::Model model = runtime_test::depth_proportional_model(usual_pair());
  model.outputs[6].variable.scale = 1e308;  // above 2 mm there is no double for the answer
  const runtime::CoreDescription description = runtime::describe(three_cutters(), model);
  const Made core = made(description.plain);
  load_at(core.core, 0.5, 6.0, 1e-3);
  const std::vector<std::byte> before = state_of(core.core);
  bitrock_load load{};
  EXPECT_EQ(bitrock_core_update(core.core, 1.5, 2.0 * pi, 3e-3, &load), BITROCK_BAD_PREDICTION);
  std::int64_t cutter = 0;
  std::int32_t output = 0;
  EXPECT_EQ(bitrock_core_fault(core.core, &cutter, &output), BITROCK_OK);
  EXPECT_EQ(cutter, 1);
  EXPECT_EQ(output, 6);
  EXPECT_EQ(state_of(core.core), before);
}

TEST(Core, AveragesAreTimeWeightedAndPartialAtTheStart) {
  const Made core = made();
  double rotation = 0.0, rop = 0.0;
  EXPECT_EQ(bitrock_core_averages(core.core, &rotation, &rop), BITROCK_NOTHING_ACCEPTED);
  // steps of 1 to 7 ms; rotation a ramp, which comes 50 ms late once a window is full; rate constant from the start
  double time = 2.0;
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(bitrock_core_accept(core.core, time, 3.0 + 4.0 * time, 2e-3), BITROCK_OK);
    ASSERT_EQ(bitrock_core_averages(core.core, &rotation, &rop), BITROCK_OK);
    const double covered = std::min(0.1, time - 2.0);
    ASSERT_NEAR(rotation, 3.0 + 4.0 * (time - 0.5 * covered), 1e-10);  // rounding of an integral of some units
    ASSERT_NEAR(rop, 2e-3, 1e-14);
    time += 1e-3 * (1 + (i * i) % 7);
  }
}

TEST(Core, EveryMistakeInADescriptionHasItsStatus) {
  const surrogate::Model model = lively_model();
  const runtime::CoreDescription good = runtime::describe(three_cutters(), model);
  const auto status_of = [&](auto change) {
    runtime::CoreDescription bad = good;
    bad.plain.cutters = bad.cutters.data();
    change(bad);
    std::size_t bytes = 0;
    return bitrock_core_size(&bad.plain, &bytes);
  };
  using Description = runtime::CoreDescription;
  EXPECT_EQ(status_of([](Description&) {}), BITROCK_OK);
  for (const double bad : {0.0, -1.0, not_a_number, infinite}) {
    EXPECT_EQ(status_of([=](Description& d) { d.plain.signal.window_angle_rad = bad; }), BITROCK_BAD_SIGNAL);
    EXPECT_EQ(status_of([=](Description& d) { d.plain.signal.pulse_width_factor = bad; }), BITROCK_BAD_SIGNAL);
    EXPECT_EQ(status_of([=](Description& d) { d.plain.signal.average_window_s = bad; }), BITROCK_BAD_SIGNAL);
    EXPECT_EQ(status_of([=](Description& d) { d.cutters[1].radius_m = bad; }), BITROCK_BAD_CUTTER);
    EXPECT_EQ(status_of([=](Description& d) { d.cutters[2].width_m = bad; }), BITROCK_BAD_CUTTER);
    EXPECT_EQ(status_of([=](Description& d) { d.plain.model.inputs[1].scale = bad; }), BITROCK_BAD_MODEL);
  }
  EXPECT_EQ(status_of([](Description& d) { d.plain.signal.pulse_width_factor = 2.1; }), BITROCK_BAD_SIGNAL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.signal.combine = 2; }), BITROCK_BAD_SIGNAL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.signal.amplitude_fit = -1; }), BITROCK_BAD_SIGNAL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.cutter_count = 0; }), BITROCK_BAD_CUTTER);
  EXPECT_EQ(status_of([](Description& d) { d.plain.cutter_count = 1001; }), BITROCK_BAD_CUTTER);
  EXPECT_EQ(status_of([](Description& d) { d.plain.cutters = nullptr; }), BITROCK_NULL_POINTER);
  EXPECT_EQ(status_of([](Description& d) { d.cutters[0].back_rake_rad = not_a_number; }), BITROCK_BAD_CUTTER);
  EXPECT_EQ(status_of([](Description& d) { d.cutters[0].number = std::int64_t{1} << 31; }), BITROCK_BAD_CUTTER);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.inputs[0].low = 2.0; }), BITROCK_BAD_MODEL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.outputs[3].offset = infinite; }), BITROCK_BAD_MODEL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.outputs[3].log_reference = -1.0; }), BITROCK_BAD_MODEL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.outputs[3].output_activation = 3; }), BITROCK_BAD_MODEL);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.outputs[3].layers = nullptr; }), BITROCK_NULL_POINTER);
  EXPECT_EQ(status_of([](Description& d) { d.plain.model.outputs[9].parameters = nullptr; }), BITROCK_NULL_POINTER);
  for (const std::vector<std::int32_t>& layers :
       {std::vector<std::int32_t>{3}, {2, 1}, {3, 2}, {3, 0, 1}, {3, 65, 1}, std::vector<std::int32_t>(17, 3)}) {
    EXPECT_EQ(status_of([&](Description& d) {
                d.plain.model.outputs[0].layers = layers.data();
                d.plain.model.outputs[0].layer_count = static_cast<std::int32_t>(layers.size());
              }),
              BITROCK_BAD_MODEL);
  }
  std::vector<double> parameters = model.outputs[4].network.parameters;
  parameters.back() = not_a_number;
  EXPECT_EQ(status_of([&](Description& d) { d.plain.model.outputs[4].parameters = parameters.data(); }),
            BITROCK_BAD_MODEL);
}

TEST(Core, PointersAndMemoryAreLookedAt) {
  const surrogate::Model model = lively_model();
  const runtime::CoreDescription description = runtime::describe(three_cutters(), model);
  std::size_t bytes = 0;
  ASSERT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_OK);
  std::vector<double> memory(bytes / sizeof(double) + 2);
  bitrock_core* core = nullptr;
  EXPECT_EQ(bitrock_core_size(nullptr, &bytes), BITROCK_NULL_POINTER);
  EXPECT_EQ(bitrock_core_create(nullptr, bytes, &description.plain, &core), BITROCK_NULL_POINTER);
  EXPECT_EQ(bitrock_core_create(memory.data(), bytes - 1, &description.plain, &core), BITROCK_BAD_MEMORY);
  EXPECT_EQ(bitrock_core_create(reinterpret_cast<std::byte*>(memory.data()) + 8, bytes, &description.plain, &core),
            BITROCK_BAD_MEMORY);
  EXPECT_EQ(core, nullptr);
  auto* const not_made = reinterpret_cast<bitrock_core*>(memory.data());
  bitrock_load load{};
  bitrock_tally tally{};
  EXPECT_EQ(bitrock_core_update(not_made, 0.0, 1.0, 1e-3, &load), BITROCK_NOT_A_CORE);
  EXPECT_EQ(bitrock_core_tally(not_made, &tally), BITROCK_NOT_A_CORE);
  EXPECT_EQ(bitrock_core_save(not_made, memory.data(), bytes), BITROCK_NOT_A_CORE);
  EXPECT_EQ(bitrock_core_update(not_made, 0.0, 1.0, 1e-3, nullptr), BITROCK_NULL_POINTER);
  EXPECT_EQ(bitrock_core_reset(nullptr), BITROCK_NULL_POINTER);
  EXPECT_EQ(bitrock_runtime_version(), BITROCK_RUNTIME_VERSION);
  for (int status = BITROCK_OK; status <= BITROCK_BAD_STATE; ++status) {
    EXPECT_STRNE(bitrock_status_text(static_cast<bitrock_status>(status)), "unknown status");
  }
}

TEST(Core, ACopiedBitGoesOnFromWhereTheOriginalIs) {
  runtime::BitForce original(three_cutters(), lively_model());
  original.at({.angle = 0.4, .rotation = 6.0, .rate_of_penetration = 2e-3});
  runtime::BitForce copy = original;
  original.at({.angle = 30.0, .rotation = 3.0, .rate_of_penetration = 1e-3});
  runtime::BitForce again(three_cutters(), lively_model());
  for (int i = 0; i < 300; ++i) {
    const runtime::BitMotion motion{.angle = 0.4 + 0.02 * i, .rotation = 6.0, .rate_of_penetration = 2e-3};
    ASSERT_EQ(copy.at(motion).torque, again.at(motion).torque);
  }
}

/// The C interface and `BitForce` stand beside each other over one core: the same forces, tallies and states.
TEST(Core, TheCInterfaceHasTheBitsOfBitForce) {
  const surrogate::Model model = lively_model();
  const runtime::Bit bit = three_cutters();
  const runtime::CoreDescription description = runtime::describe(bit, model);
  const Made c = made(description.plain);
  runtime::BitForce cpp(bit, model);
  base::Random random(11);
  double angle = 0.0;
  for (int i = 0; i < 20000; ++i) {
    angle += 0.01 * (base::uniform(random) - 0.1);
    const double rotation = 1.0 + 20.0 * base::uniform(random), rop = 4e-3 * base::uniform(random) - 2e-4;
    const bitrock_load load = load_at(c.core, angle, rotation, rop);
    const runtime::BitLoad seen = cpp.at({.angle = angle, .rotation = rotation, .rate_of_penetration = rop});
    ASSERT_EQ(load.axial_force_N, seen.axial_force);
    ASSERT_EQ(load.torque_N_m, seen.torque);
  }
  bitrock_tally tally{};
  ASSERT_EQ(bitrock_core_tally(c.core, &tally), BITROCK_OK);
  EXPECT_GT(tally.asked, 100);
  EXPECT_EQ(tally.asked, cpp.clamps().asked);
  EXPECT_EQ(tally.depth_below, cpp.clamps().depth_below);
  EXPECT_EQ(tally.speed_above, cpp.clamps().speed_above);
  EXPECT_EQ(tally.drawn, cpp.draws().drawn);
  EXPECT_EQ(tally.mean_missed, cpp.draws().mean_missed);
  std::size_t bytes = 0;
  ASSERT_EQ(bitrock_core_state_size(c.core, &bytes), BITROCK_OK);
  ASSERT_EQ(bytes, cpp.state_size());
  std::vector<std::byte> of_c(bytes), of_cpp(bytes);
  ASSERT_EQ(bitrock_core_save(c.core, of_c.data(), bytes), BITROCK_OK);
  cpp.save(of_cpp);
  EXPECT_EQ(std::memcmp(of_c.data(), of_cpp.data(), bytes), 0);
}

}  // namespace
