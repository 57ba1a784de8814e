// After construction the runtime takes no memory: every allocation of this program is counted.
#include <gtest/gtest.h>

#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "tests/allocations.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

TEST(Allocation, TheCounterCounts) {
  const long before = allocations::so_far();
  const std::vector<double> memory(1000, 1.0);
  EXPECT_EQ(memory[999], 1.0);
  EXPECT_GT(allocations::so_far(), before);
}

TEST(Allocation, EvaluationTakesNone) {
  runtime::Bit bit = runtime::read_bit(std::filesystem::path(BITROCK_SOURCE_DIR) / "campaigns/bits/pdc15.toml");
  runtime::CutterStatistics statistics = runtime_test::usual_pair();
  statistics.y.np4 = 1e6;  // to the cap
  for (const runtime::AmplitudeFit fit : {runtime::AmplitudeFit::band_preserving, runtime::AmplitudeFit::article}) {
    bit.signal.amplitude_fit = fit;
    bit.signal.pulse_width_factor = 2.0;
    runtime::BitForce force(bit, runtime_test::constant_model(statistics));
    double largest = 0.0;
    const long before = allocations::so_far();
    for (int i = 0; i < 2000; ++i) {
      const double angle = i < 1000 ? 0.05 * i : 0.05 * (2000 - i);  // there and back, over many windows
      const runtime::BitLoad load = force.at({.angle = angle, .rotation = 6.0, .rate_of_penetration = 2e-3});
      largest = std::max(largest, load.torque);
    }
    EXPECT_EQ(allocations::so_far(), before);
    EXPECT_GT(largest, 0.0);
  }
}

TEST(Allocation, TheCoreTakesNoneWhateverItIsAsked) {
  const runtime::Bit bit = runtime::read_bit(std::filesystem::path(BITROCK_SOURCE_DIR) / "campaigns/bits/pdc15.toml");
  const surrogate::Model model = runtime_test::constant_model(runtime_test::usual_pair());
  const runtime::CoreDescription description = runtime::describe(bit, model);
  std::size_t bytes = 0, state_bytes = 0;
  ASSERT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_OK);
  std::vector<double> memory(bytes / sizeof(double) + 1), state;
  const long before_creation = allocations::so_far();
  bitrock_core* core = nullptr;
  ASSERT_EQ(bitrock_core_create(memory.data(), bytes, &description.plain, &core), BITROCK_OK);
  EXPECT_EQ(allocations::so_far(), before_creation);
  ASSERT_EQ(bitrock_core_state_size(core, &state_bytes), BITROCK_OK);
  state.resize(state_bytes / sizeof(double) + 1);

  bitrock_load load{};
  bitrock_tally tally{};
  double rotation = 0.0, rop = 0.0;
  int failed = 0;
  const long before = allocations::so_far();
  for (int i = 0; i < 500; ++i) {
    failed += bitrock_core_save(core, state.data(), state_bytes) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_update(core, 0.2 * i, 5.0, 1e-3, &load) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_restore(core, state.data(), state_bytes) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_update(core, 0.1 * i, 6.0, 2e-3, &load) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_accept(core, 0.01 * i, 6.0, 2e-3) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_averages(core, &rotation, &rop) != BITROCK_OK ? 1 : 0;
    failed += bitrock_core_tally(core, &tally) != BITROCK_OK ? 1 : 0;
  }
  failed += bitrock_core_reset(core) != BITROCK_OK ? 1 : 0;
  EXPECT_EQ(allocations::so_far(), before);
  EXPECT_EQ(failed, 0);
}

}  // namespace
