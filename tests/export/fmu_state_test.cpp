// States of the FMU of a bit: steps taken back, instances beside each other, and states that have to be refused.
#include <cstring>
#include <thread>

#include "base/text.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "tests/export/fmu_inputs.hpp"

using namespace bitrock;

namespace {

using namespace fmu_test;
using importer::Instance, importer::Outputs;

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

}  // namespace
