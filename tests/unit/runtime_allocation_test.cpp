// After construction the runtime takes no memory: every allocation of this program is counted.
#include <gtest/gtest.h>

#include "runtime/bit/bit_force.hpp"
#include "tests/allocations.hpp"
#include "tests/unit/runtime_fixtures.hpp"

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

}  // namespace
