// The bit file: what it may say, what is refused and in which words, and the shipped bit against its own recipe.
#include "runtime/bit/bit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"

namespace {

const std::string bit_table = "[bit]\nname = 'b'\ndiameter_mm = 200\n";
const std::string cutter_table = "[[cutter]]\nradius_mm = 50\nwidth_mm = 100\nback_rake_deg = 20\n";

runtime::Bit read(const std::string& text) {
  base::ConfigFile file = base::ConfigFile::from_text(text, "bit.toml");
  return runtime::read_bit(file);
}

std::string message(const std::string& text) {
  try {
    read(text);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BitFile, DefaultsAndUnits) {
  const runtime::Bit bit = read(bit_table + cutter_table);
  EXPECT_EQ(bit.name, "b");
  EXPECT_DOUBLE_EQ(bit.diameter, 0.2);
  EXPECT_DOUBLE_EQ(bit.signal.window_angle, std::numbers::pi / 3.0);
  EXPECT_EQ(bit.signal.pulse_width_factor, 1.0);
  EXPECT_EQ(bit.signal.combine, runtime::Combine::sum);
  EXPECT_EQ(bit.signal.amplitude_fit, runtime::AmplitudeFit::band_preserving);
  EXPECT_EQ(bit.signal.seed, 1u);
  ASSERT_EQ(bit.cutters.size(), 1u);
  EXPECT_EQ(bit.cutters[0].number, 1);
  EXPECT_DOUBLE_EQ(bit.cutters[0].radius, 0.05);
  EXPECT_DOUBLE_EQ(bit.cutters[0].width, 0.1);
  EXPECT_DOUBLE_EQ(bit.cutters[0].back_rake, std::numbers::pi / 9.0);
}

TEST(BitFile, EverySettingIsRead) {
  const runtime::Bit bit = read(bit_table +
                                "window_angle_deg = 90\npulse_width_factor = 0.5\ncombine = 'max'\n"
                                "amplitude_fit = 'article'\nseed = 42\n" +
                                cutter_table + cutter_table);
  EXPECT_DOUBLE_EQ(bit.signal.window_angle, std::numbers::pi / 2.0);
  EXPECT_EQ(bit.signal.pulse_width_factor, 0.5);
  EXPECT_EQ(bit.signal.combine, runtime::Combine::max);
  EXPECT_EQ(bit.signal.amplitude_fit, runtime::AmplitudeFit::article);
  EXPECT_EQ(bit.signal.seed, 42u);
  EXPECT_EQ(bit.cutters[1].number, 2);
}

TEST(BitFile, RefusalsNameLineKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(message(bit_table), "bit.toml: no [[cutter]] (a bit needs at least one)");
  EXPECT_EQ(message(bit_table + "[[cutter]]\nradius_mm = 120\nwidth_mm = 1\nback_rake_deg = 20"),
            "bit.toml:5: cutter.radius_mm = 120 (must be above 0 and at most 100; entry 1 of [[cutter]])");
  EXPECT_EQ(message(bit_table + cutter_table + "[[cutter]]\nradius_mm = 0\nwidth_mm = 1\nback_rake_deg = 20"),
            "bit.toml:9: cutter.radius_mm = 0 (must be above 0 and at most 100; entry 2 of [[cutter]])");
  EXPECT_EQ(message(bit_table + "[[cutter]]\nradius_mm = 50\nwidth_mm = 0\nback_rake_deg = 20"),
            "bit.toml:6: cutter.width_mm = 0 (must be above 0 and at most 200; entry 1 of [[cutter]])");
  EXPECT_EQ(message(bit_table + "combine = 'mean'\n" + cutter_table),
            "bit.toml:4: bit.combine = 'mean' (must be 'sum' or 'max')");
  EXPECT_EQ(message(bit_table + "amplitude_fit = 'paper'\n" + cutter_table),
            "bit.toml:4: bit.amplitude_fit = 'paper' (must be 'band_preserving' or 'article')");
  EXPECT_EQ(message(bit_table + "pulse_width_factor = 3\n" + cutter_table),
            "bit.toml:4: bit.pulse_width_factor = 3 (must be above 0 and at most 2)");
  EXPECT_EQ(message(bit_table + "window_angle_deg = 0\n" + cutter_table),
            "bit.toml:4: bit.window_angle_deg = 0 (must be at least 1 and at most 360)");
  EXPECT_EQ(message(bit_table + "seed = -1\n" + cutter_table), "bit.toml:4: bit.seed = -1 (must be at least 0)");
  EXPECT_EQ(message(bit_table + cutter_table + "back_rak_deg = 3"),
            "bit.toml:8: cutter.back_rak_deg is unknown (no such key; did you mean back_rake_deg?)");
  EXPECT_EQ(message("[bit]\nname = 'b'\n" + cutter_table),
            "bit.toml:1: bit.diameter_mm is missing (diameter of the bit; at least 1 and at most 10000)");
}

TEST(ShippedBit, IsItsOwnRecipe) {
  const runtime::Bit bit = runtime::read_bit(std::filesystem::path(BITROCK_SOURCE_DIR) / "campaigns/bits/pdc15.toml");
  const double outer = 0.5 * 215.9e-3;
  const std::size_t count = 15;
  ASSERT_EQ(bit.cutters.size(), count);
  EXPECT_DOUBLE_EQ(bit.diameter, 2.0 * outer);
  const auto edge = [=](std::size_t i) { return outer * std::sqrt(static_cast<double>(i) / 15.0); };
  const auto radius = [=](std::size_t i) { return 0.5 * (edge(i) + edge(i + 1)); };
  const double rounding = 0.501e-6;  // [m] the file has three decimals of a millimetre
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const runtime::Cutter& cutter = bit.cutters[i];
    EXPECT_NEAR(cutter.radius, radius(i), rounding);
    EXPECT_NEAR(cutter.width, edge(i + 1) - edge(i), rounding);
    const double rake = 15.0 + 10.0 * (radius(i) - radius(0)) / (radius(count - 1) - radius(0));
    EXPECT_NEAR(cutter.back_rake * 180.0 / std::numbers::pi, rake, 0.00501);
    sum += cutter.width;
  }
  EXPECT_NEAR(sum, outer, 15.0 * rounding);
}

}  // namespace
