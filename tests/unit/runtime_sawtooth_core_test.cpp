// The mode "sawtooth" through the C interface.
#include <array>
#include <numbers>

#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "tests/unit/sawtooth_fixtures.hpp"

using namespace sawtooth_test;

namespace {

surrogate::Model moments_model() {
  surrogate::Model model = runtime_test::constant_model(runtime_test::usual_pair());
  const runtime::ForceMoments m = usual_moments();
  model.outputs.resize(surrogate::most_outputs);
  const std::array<double, 7> values{
      m.x_mean, m.x_sd, m.y_mean, m.y_sd, m.correlation_length, m.short_correlation_length, m.xy_correlation};
  for (std::size_t i = 0; i < values.size(); ++i) {
    surrogate::OutputModel& output = model.outputs[surrogate::article_output_count + i];
    output.network.layers = {3, 1};
    output.network.parameters = {0.0, i < 4 ? 0.2 : 0.0, 0.0, 1.0};  // forces grow with the depth
    output.variable.scale = values[i];
  }
  return model;
}

runtime::Bit four_cutters(runtime::SignalMode mode) {
  runtime::Bit bit{.name = "test", .diameter = 0.2};
  bit.signal.window_angle = std::numbers::pi / 3.0;
  bit.signal.mode = mode;
  for (int i = 1; i <= 4; ++i)
    bit.cutters.push_back({.number = i, .radius = 0.02 * i, .width = 0.02, .back_rake = 0.3});
  return bit;
}

struct Made {
  std::vector<double> memory;
  bitrock_core* core = nullptr;
};
Made made(runtime::SignalMode mode, const surrogate::Model& model) {
  const runtime::CoreDescription description = runtime::describe(four_cutters(mode), model);
  Made result;
  std::size_t bytes = 0;
  EXPECT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_OK);
  result.memory.resize(bytes / sizeof(double) + 1);
  EXPECT_EQ(bitrock_core_create(result.memory.data(), bytes, &description.plain, &result.core), BITROCK_OK);
  return result;
}
bitrock_load load_at(const Made& it, double angle, double rotation = 6.0, double advance = 2e-3) {
  bitrock_load load{};
  EXPECT_EQ(bitrock_core_update(it.core, angle, rotation, advance, &load), BITROCK_OK);
  return load;
}

TEST(SawtoothCore, MeanLoadIsTheSumOfMeans) {
  const surrogate::Model model = moments_model();
  for (const runtime::SignalMode mode : {runtime::SignalMode::sawtooth, runtime::SignalMode::article}) {
    const Made it = made(mode, model);
    double torque = 0.0, force = 0.0, expected_torque = 0.0, expected_force = 0.0;
    for (const runtime::Cutter& c : four_cutters(mode).cutters) {
      const surrogate::Prediction p =
          predict(model, clamped_to_training_range(model, runtime::cut_conditions(c.radius, c.back_rake, 6.0, 2e-3)));
      expected_torque += c.width * c.radius * p.moments[0];
      expected_force += c.width * p.moments[2];
    }
    constexpr int samples = 400000;
    for (int i = 0; i < samples; ++i) {
      const bitrock_load load = load_at(it, 0.01 * i);
      torque += load.torque_N_m / samples;
      force += load.axial_force_N / samples;
    }
    EXPECT_NEAR(torque, expected_torque, 0.01 * expected_torque);
    EXPECT_NEAR(force, expected_force, 0.01 * expected_force);
  }
}

TEST(SawtoothCore, IsTheDefaultOfAModelThatCan) {
  surrogate::Model model = moments_model();
  EXPECT_EQ(runtime::mode_for(runtime::SignalMode::automatic, model), runtime::SignalMode::sawtooth);
  model.outputs.resize(surrogate::article_output_count);
  EXPECT_EQ(runtime::mode_for(runtime::SignalMode::automatic, model), runtime::SignalMode::article);
  const runtime::CoreDescription description = runtime::describe(four_cutters(runtime::SignalMode::sawtooth), model);
  std::size_t bytes = 0;
  EXPECT_EQ(bitrock_core_size(&description.plain, &bytes), BITROCK_NO_MOMENTS);
  EXPECT_ANY_THROW(runtime::BitForce(four_cutters(runtime::SignalMode::sawtooth), model));
}

TEST(SawtoothCore, ArticleWithoutMeansIsTheLiteralOne) {
  surrogate::Model model = moments_model();
  const Made with = made(runtime::SignalMode::article, model);
  model.outputs.resize(surrogate::article_output_count);
  const Made article = made(runtime::SignalMode::article, model);
  const Made literal = made(runtime::SignalMode::article_literal, model);
  bool differs = false;
  for (int i = 0; i < 5000; ++i) {
    const bitrock_load a = load_at(article, 1e-3 * i), b = load_at(literal, 1e-3 * i);
    ASSERT_EQ(a.torque_N_m, b.torque_N_m);
    ASSERT_EQ(a.axial_force_N, b.axial_force_N);
    differs = differs || load_at(with, 1e-3 * i).torque_N_m != a.torque_N_m;
  }
  EXPECT_TRUE(differs);
}

TEST(SawtoothCore, AStepTakenBackLeavesNoTrace) {
  const surrogate::Model model = moments_model();
  const Made plain = made(runtime::SignalMode::sawtooth, model), tried = made(runtime::SignalMode::sawtooth, model);
  std::size_t bytes = 0;
  bitrock_core_state_size(tried.core, &bytes);
  std::vector<std::byte> state(bytes);
  const auto rotation = [](double angle) { return 6.0 + 3.0 * std::sin(0.7 * angle); };
  for (int i = 0; i < 4000; ++i) {
    const double angle = 3e-3 * i;
    ASSERT_EQ(bitrock_core_save(tried.core, state.data(), bytes), BITROCK_OK);
    load_at(tried, angle + 0.9 * (i % 5), 20.0, 1e-3);
    ASSERT_EQ(bitrock_core_restore(tried.core, state.data(), bytes), BITROCK_OK);
    const bitrock_load a = load_at(plain, angle, rotation(angle)), b = load_at(tried, angle, rotation(angle));
    ASSERT_EQ(a.torque_N_m, b.torque_N_m);
    ASSERT_EQ(a.axial_force_N, b.axial_force_N);
  }
  bitrock_tally a{}, b{};
  bitrock_core_tally(plain.core, &a);
  bitrock_core_tally(tried.core, &b);
  EXPECT_EQ(a.drawn, b.drawn);
  EXPECT_EQ(a.asked, b.asked);
}

TEST(SawtoothCore, WithoutAdvanceTheLoadEnds) {
  const Made it = made(runtime::SignalMode::sawtooth, moments_model());
  double seen = 0.0;
  for (int i = 0; i < 300; ++i) seen += load_at(it, 0.01 * i).torque_N_m;
  EXPECT_GT(seen, 0.0);
  load_at(it, 4.2, 6.0, 0.0);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(load_at(it, 5.3 + 0.01 * i, 6.0, 0.0).torque_N_m, 0.0);
  EXPECT_EQ(load_at(it, 15.29).torque_N_m, 0.0);  // the angle stands, and so does what was drawn
}

}  // namespace
