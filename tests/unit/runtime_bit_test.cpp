// The bit file: what it may say, what is refused and in which words, and the shipped bit against its own recipe.
#include "runtime/bit/bit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "runtime/bit/asked_range.hpp"

using namespace bitrock;

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

TEST(BitFile, ADiameterInInchesIsTakenForWhatItIs) {
  EXPECT_EQ(
      message("[bit]\nname = 'b'\ndiameter_mm = 8.5\n" + cutter_table),
      "bit.toml:3: bit.diameter_mm = 8.5 (must be at least 10 and at most 5000; is it in inch? Then write 215.9)");
}

TEST(AskedRange, SaysWhatTheCuttersAskOutsideAndByHowMuch) {
  const runtime::Bit bit =
      read(bit_table + cutter_table + "[[cutter]]\nradius_mm = 90\nwidth_mm = 10\nback_rake_deg = 40\n");
  surrogate::Model model;
  model.inputs = {{{.name = "cutter_speed_m_per_s", .low = 0.5, .high = 2.0},
                   {.name = "depth_of_cut_mm", .low = 0.5, .high = 4.0},
                   {.name = "back_rake_deg", .low = 10.0, .high = 30.0}}};
  const double turning = 4.0 * std::numbers::pi;  // 2 turns a second
  const auto asked = runtime::asked_ranges(bit, turning, 4e-3);
  EXPECT_NEAR(asked[0].low, 0.05 * turning, 1e-12);
  EXPECT_NEAR(asked[0].high, 0.09 * turning, 1e-12);
  EXPECT_NEAR(asked[1].low, 2.0, 1e-12);  // 4 mm/s over 2 turns a second
  EXPECT_EQ(asked[1].low, asked[1].high);
  EXPECT_EQ(runtime::asked_outside(bit, model, turning, 4e-3),
            "back_rake_deg 20 to 40 (trained 10 to 30: 50 % of that range above it)");
  EXPECT_EQ(runtime::rakes_outside(bit, model), runtime::asked_outside(bit, model, turning, 4e-3));
  EXPECT_EQ(runtime::asked_outside(bit, model, turning, 0.3e-3),
            "depth_of_cut_mm 0.15 (trained 0.5 to 4: 10 % of that range below it); "
            "back_rake_deg 20 to 40 (trained 10 to 30: 50 % of that range above it)");
  model.inputs[2].low = model.inputs[2].high = 25.0;
  EXPECT_EQ(runtime::rakes_outside(bit, model), "back_rake_deg 20 to 40 (trained at 25 alone)");
}

TEST(BitFile, CuttersThatDoNotCoverTheFaceOnceAreWarnedOf) {
  EXPECT_TRUE(runtime::warnings(read(bit_table + cutter_table)).empty());
  const std::string narrow = "[[cutter]]\nradius_mm = 80\nwidth_mm = 20\nback_rake_deg = 20\n";
  const auto small = runtime::warnings(read(bit_table + narrow));
  ASSERT_EQ(small.size(), 1u);
  EXPECT_EQ(small[0],
            "bit 'b': the widths of its 1 cutters add up to 20 mm, 0.2 of its radius of 100 mm: each cutter takes the "
            "whole depth of its ring, so rock is left standing and the force is too small (let the rings meet, their "
            "edges half-way between neighbouring cutters)");
  const auto twice = runtime::warnings(read(bit_table + cutter_table + cutter_table));
  ASSERT_EQ(twice.size(), 2u);
  EXPECT_NE(twice[0].find("some rock is cut twice and the force is too large (width_mm is the width of the ring that a "
                          "cutter takes alone, not that of its face: let the edges of the rings lie half-way between "
                          "neighbouring cutters)"),
            std::string::npos)
      << twice[0];
  EXPECT_EQ(twice[1],
            "bit 'b': cutters run on one circle, and each takes the whole depth there: 1 and 2 (write the cutters of a "
            "circle as one, with their mean back rake)");
  EXPECT_TRUE(runtime::warnings(runtime::read_bit(BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml")).empty());
}

TEST(BitFile, RefusalsNameLineKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(message(bit_table), "bit.toml: no [[cutter]] (a bit needs at least one)");
  EXPECT_EQ(message(bit_table + "[[cutter]]\nradius_mm = 120\nwidth_mm = 1\nback_rake_deg = 20"),
            "bit.toml:5: cutter.radius_mm = 120 (must be at least 0.01 and at most 100; entry 1 of [[cutter]])");
  EXPECT_EQ(message(bit_table + cutter_table + "[[cutter]]\nradius_mm = 0\nwidth_mm = 1\nback_rake_deg = 20"),
            "bit.toml:9: cutter.radius_mm = 0 (must be at least 0.01 and at most 100; entry 2 of [[cutter]])");
  EXPECT_EQ(message(bit_table + "[[cutter]]\nradius_mm = 50\nwidth_mm = 0\nback_rake_deg = 20"),
            "bit.toml:6: cutter.width_mm = 0 (must be at least 0.01 and at most 200; entry 1 of [[cutter]])");
  EXPECT_EQ(message(bit_table + "combine = 'mean'\n" + cutter_table),
            "bit.toml:4: bit.combine = 'mean' (must be 'sum' or 'max')");
  EXPECT_EQ(message(bit_table + "amplitude_fit = 'paper'\n" + cutter_table),
            "bit.toml:4: bit.amplitude_fit = 'paper' (must be 'band_preserving' or 'article')");
  EXPECT_EQ(message(bit_table + "pulse_width_factor = 3\n" + cutter_table),
            "bit.toml:4: bit.pulse_width_factor = 3 (must be at least 0.01 and at most 2)");
  EXPECT_EQ(message(bit_table + "window_angle_deg = 0\n" + cutter_table),
            "bit.toml:4: bit.window_angle_deg = 0 (must be at least 1 and at most 360)");
  EXPECT_EQ(message(bit_table + "seed = -1\n" + cutter_table),
            "bit.toml:4: bit.seed = -1 (must be at least 0 and at most 2147483647)");
  EXPECT_EQ(message(bit_table + cutter_table + "back_rak_deg = 3"),
            "bit.toml:8: cutter.back_rak_deg is unknown (no such key; did you mean back_rake_deg?)");
  EXPECT_EQ(message("[bit]\nname = 'b'\n" + cutter_table),
            "bit.toml:1: bit.diameter_mm is missing (diameter of the bit; at least 10 and at most 5000)");
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
