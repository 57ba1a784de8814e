// The force of the mode "sawtooth": its law, its events, and long records of it against the closed forms of a filtered
// Poisson process. Whatever is compared with a record may be off by four standard errors of that record, which are
// found from a hundred pieces of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/core/core.hpp"
#include "runtime/signal/sawtooth_force.hpp"
#include "runtime/signal/step5.hpp"
#include "tests/unit/runtime_fixtures.hpp"

using namespace bitrock;

namespace {

constexpr double radius = 0.05;  // [m]

runtime::ForceMoments usual_moments() {
  return {.x_mean = 1e5,
          .x_sd = 1.4e5,
          .y_mean = 0.7e5,
          .y_sd = 0.9e5,
          .correlation_length = 0.4e-3,
          .xy_correlation = 0.8};
}

runtime::SignalSettings usual_settings() {
  runtime::SignalSettings settings = runtime_test::usual_settings();
  settings.mode = runtime::SignalMode::sawtooth;
  return settings;
}

runtime::SawtoothLaw law_of(const runtime::ForceMoments& moments) {
  runtime::DrawTally tally;
  return runtime::sawtooth_law(moments, usual_settings(), radius, tally);
}

/// One cutter with the same moments in all windows.
struct Cutter {
  std::unique_ptr<runtime::SawtoothForce> force = std::make_unique<runtime::SawtoothForce>();
  runtime::SawtoothReach reach;
  std::int64_t window = runtime::no_window;

  explicit Cutter(const runtime::ForceMoments& moments, int number = 1, bool wide = runtime::has_wide_vectors(),
                  const runtime::SignalSettings& settings = usual_settings(), double path_radius = radius) {
    set_up(*force, settings, number, path_radius, wide);
    runtime::DrawTally tally;
    force->laws.fill(runtime::sawtooth_law(moments, settings, path_radius, tally));
  }
  runtime::ForcePerMetre at(double angle) {
    const auto now = static_cast<std::int64_t>(std::floor(angle / force->window_angle));
    const double from_begin = angle - static_cast<double>(now) * force->window_angle;
    if (now != window) reach = {};
    window = now;
    if (!(from_begin > reach.after && from_begin < reach.until)) follow(*force, now, from_begin, reach);
    runtime::FourNumbers x{}, y{};
    runtime::take(force->stream.blocks.data(), reach, 1.0 / force->drop, from_begin, x, y);
    return {.x = (x[0] + x[1]) + (x[2] + x[3]), .y = (y[0] + y[1]) + (y[2] + y[3])};
  }
};

/// Integral of g -> f(g) over the heights of the law: exponential, those above c at c.
double over_heights(double c, const std::function<double(double)>& f) {
  std::vector<double> points;
  for (int i = 0; i <= 64; ++i) points.push_back(c * i / 64.0);
  return runtime_test::integral(points, [&](double g) { return std::exp(-g) * f(g); }) + std::exp(-c) * f(c);
}

/// The pulse of height and length 1, rise rho g and drop delta.
double pulse(double s, double rise, double drop) {
  if (s <= 0.0 || s >= rise + drop) return 0.0;
  return runtime::smooth_unit_step(s < rise ? s / rise : 1.0 - (s - rise) / drop);
}

/// lambda a^2 E[g^2 integral of f(s) f(s + lag)], by quadrature.
double covariance(const runtime::SawtoothLaw& law, double density, double a, double b, double lag) {
  return density * a * b * over_heights(law.highest, [&](double g) {
           const double rise = law.rise * g, length = rise + law.drop;
           if (lag >= length || g == 0.0) return 0.0;
           std::vector<double> points{0.0, length - lag};
           for (const double bend : {rise, rise - lag}) {
             if (bend > 0.0 && bend < length - lag) points.push_back(bend);
           }
           std::sort(points.begin(), points.end());
           return g * g * runtime_test::integral(points, [&](double s) {
                    return pulse(s, rise, law.drop) * pulse(s + lag, rise, law.drop);
                  });
         });
}

double x_density(const runtime::SawtoothLaw& law) {
  return law.density * law.x_below;
}
double y_density(const runtime::SawtoothLaw& law) {
  return law.density * (1.0 - law.x_below + law.both_below);
}

/// Mean over pieces of a record, and its standard error.
struct Estimate {
  double value = 0.0, error = 0.0;
};
Estimate estimate(const std::vector<double>& pieces) {
  Estimate result;
  const auto n = static_cast<double>(pieces.size());
  for (const double piece : pieces) result.value += piece / n;
  for (const double piece : pieces) result.error += (piece - result.value) * (piece - result.value) / (n * (n - 1.0));
  result.error = std::sqrt(result.error);
  return result;
}
void expect_met(const Estimate& seen, double exact, double largest_error) {
  EXPECT_NEAR(seen.value, exact, 4.0 * seen.error);
  EXPECT_LT(seen.error, largest_error);  // or the record says too little
}

struct Record {
  double step = 0.0;  ///< [rad]
  std::vector<double> x, y;
};
Record record(Cutter& cutter, double step, std::size_t samples) {
  Record made{.step = step};
  for (std::size_t i = 0; i < samples; ++i) {
    const runtime::ForcePerMetre force = cutter.at(step * static_cast<double>(i));
    made.x.push_back(force.x);
    made.y.push_back(force.y);
  }
  return made;
}

/// Mean of a function of the sample number over each of a hundred pieces.
Estimate over_pieces(std::size_t samples, const std::function<double(std::size_t)>& f) {
  constexpr std::size_t pieces = 100;
  std::vector<double> means;
  for (std::size_t p = 0; p < pieces; ++p) {
    double sum = 0.0;
    for (std::size_t i = p * samples / pieces; i < (p + 1) * samples / pieces; ++i) sum += f(i);
    means.push_back(sum / (static_cast<double>(samples) / pieces));
  }
  return estimate(means);
}

TEST(SawtoothLaw, MeanAndDeviationFollowFromTheEvents) {
  const runtime::ForceMoments wanted = usual_moments();
  for (const double length : {0.08e-3, 0.4e-3, 2e-3}) {
    runtime::ForceMoments moments = wanted;
    moments.correlation_length = length;
    const runtime::SawtoothLaw law = law_of(moments);
    const double area = over_heights(law.highest, [&](double g) { return 0.5 * g * (law.rise * g + law.drop); });
    EXPECT_NEAR(x_density(law) * law.x_height * area, wanted.x_mean, 1e-9 * wanted.x_mean);
    EXPECT_NEAR(y_density(law) * law.y_height * area, wanted.y_mean, 1e-9 * wanted.y_mean);
    EXPECT_NEAR(std::sqrt(covariance(law, x_density(law), law.x_height, law.x_height, 0.0)), wanted.x_sd,
                1e-6 * wanted.x_sd);
    EXPECT_NEAR(std::sqrt(covariance(law, y_density(law), law.y_height, law.y_height, 0.0)), wanted.y_sd,
                1e-6 * wanted.y_sd);
    const double both = covariance(law, law.density * law.both_below, law.x_height, law.y_height, 0.0);
    EXPECT_NEAR(both / (wanted.x_sd * wanted.y_sd), wanted.xy_correlation, 1e-6);
  }
}

TEST(SawtoothLaw, AutocorrelationIsOneOverEAtTheCorrelationLength) {
  for (const double length : {0.07e-3, 0.1e-3, 0.2e-3, 0.4e-3, 1e-3, 2.5e-3}) {
    runtime::ForceMoments moments = usual_moments();
    moments.correlation_length = length;
    const runtime::SawtoothLaw law = law_of(moments);
    double low = 0.5 * length / radius, high = 2.0 * length / radius;
    const double wanted = covariance(law, 1.0, 1.0, 1.0, 0.0) / std::numbers::e;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (covariance(law, 1.0, 1.0, 1.0, middle) > wanted ? low : high) = middle;
    }
    EXPECT_NEAR(low * radius / length, 1.0, 0.006) << length;
  }
}

TEST(SawtoothLaw, WhatCannotBeHadIsCounted) {
  const auto tally_of = [](const runtime::ForceMoments& moments, double path_radius) {
    runtime::DrawTally tally;
    const runtime::SawtoothLaw law = runtime::sawtooth_law(moments, usual_settings(), path_radius, tally);
    EXPECT_TRUE(std::isfinite(law.density + law.x_height + law.y_height + law.rise + law.cell));
    EXPECT_GE(law.cell, (law.rise * law.highest + law.drop));  // or a pulse would be lost
    return tally;
  };
  runtime::ForceMoments moments = usual_moments();
  EXPECT_EQ(tally_of(moments, radius).drawn, 2);
  EXPECT_EQ(tally_of(moments, radius).capped, 0);
  moments.correlation_length = 0.03e-3;
  EXPECT_EQ(tally_of(moments, radius).length_clamped, 1);
  moments = usual_moments();
  moments.xy_correlation = 0.99;  // more than the ratio of 1.29 and 1.4 allows
  EXPECT_EQ(tally_of(moments, radius).correlation_clamped, 1);
  moments.xy_correlation = -0.1;
  EXPECT_EQ(tally_of(moments, radius).correlation_clamped, 1);
  EXPECT_EQ(tally_of(usual_moments(), 1e-3).narrowed, 1);  // a window of 1 mm
  EXPECT_EQ(tally_of(usual_moments(), 1e-5).narrowed, 1);
  moments = usual_moments();
  moments.x_sd = 0.0;
  EXPECT_EQ(tally_of(moments, radius).capped, 1);
  EXPECT_EQ(tally_of({.x_mean = 1e308, .x_sd = 1e308, .correlation_length = 1e308}, radius).drawn, 1);
  EXPECT_EQ(tally_of({.x_mean = -1.0, .x_sd = 1.0}, radius).drawn, 0);
}

TEST(SawtoothLaw, TheMeanIsKeptWhereOtherThingsAreNot) {
  for (const double path_radius : {1e-3, 2e-3, radius}) {
    for (const double sd : {0.0, 1e5}) {
      runtime::ForceMoments moments = usual_moments();
      moments.x_sd = sd;
      runtime::DrawTally tally;
      const runtime::SawtoothLaw law = runtime::sawtooth_law(moments, usual_settings(), path_radius, tally);
      const double area = over_heights(law.highest, [&](double g) { return 0.5 * g * (law.rise * g + law.drop); });
      EXPECT_NEAR(x_density(law) * law.x_height * area, moments.x_mean, 1e-6 * moments.x_mean);
    }
  }
}

TEST(SawtoothCell, LogarithmIsThatOfTheLibrary) {
  base::Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double u = i == 0 ? 0x1.0p-25 : std::max(base::uniform(random), 0x1.0p-25), high = 1e3 * u;
    const runtime::FourNumbers x{u, high, 1.0, 2.0};
    runtime::FourNumbers result;
    runtime::logarithm(x, result);
    EXPECT_NEAR(result[0], std::log(u), 4e-15 * std::max(1.0, std::abs(std::log(u))));
    EXPECT_NEAR(result[1], std::log(high), 4e-15 * std::max(1.0, std::abs(std::log(high))));
    EXPECT_EQ(result[2], 0.0);
  }
}

TEST(SawtoothCell, TheSameBitsForAnyVectors) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  std::vector<runtime::SawtoothBlock> wide(runtime::most_cell_blocks), narrow(runtime::most_cell_blocks);
  for (std::int64_t window = -50; window < 50; ++window) {
    const std::uint64_t word = runtime::window_word(3, 2, window);
    const std::size_t count = draw_cell(law, word, 0, runtime::has_wide_vectors(), wide.data());
    ASSERT_EQ(draw_cell(law, word, 0, false, narrow.data()), count);
    ASSERT_GT(count, 0u);
    double before = 0.0;
    for (std::size_t i = 0; i < 4 * count; ++i) {
      const runtime::SawtoothBlock &a = wide[i / 4], &b = narrow[i / 4];
      for (const auto member :
           {&runtime::SawtoothBlock::begin, &runtime::SawtoothBlock::peak, &runtime::SawtoothBlock::inverse_rise,
            &runtime::SawtoothBlock::x, &runtime::SawtoothBlock::y}) {
        ASSERT_EQ((a.*member)[i % 4], (b.*member)[i % 4]);
      }
      ASSERT_GE(a.begin[i % 4], before);
      before = a.begin[i % 4];
    }
  }
}

TEST(SawtoothCell, CountsArePoissonAndKindsHaveTheirShares) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  std::vector<runtime::SawtoothBlock> blocks(runtime::most_cell_blocks);
  constexpr int windows = 3000;
  std::vector<double> counts;
  double events = 0.0, in_x = 0.0, in_y = 0.0, in_both = 0.0, heights = 0.0;
  for (int window = 0; window < windows; ++window) {
    double count = 0.0;
    for (std::int64_t cell = 0; cell < law.cells; ++cell) {
      const std::size_t drawn = draw_cell(law, runtime::window_word(9, 4, window), cell, false, blocks.data());
      for (std::size_t i = 0; i < 4 * drawn; ++i) {
        const runtime::SawtoothBlock& block = blocks[i / 4];
        if (!(block.begin[i % 4] < runtime::never)) continue;
        const bool x = block.x[i % 4] > 0.0, y = block.y[i % 4] > 0.0;
        in_x += x;
        in_y += y;
        in_both += x && y;
        heights += 1.0 / (block.inverse_rise[i % 4] * law.rise);
        ++count;
      }
    }
    events += count;
    counts.push_back(count);
  }
  const double expected = law.density * usual_settings().window_angle;
  const Estimate mean = estimate(counts);
  EXPECT_NEAR(mean.value, expected, 4.0 * std::sqrt(expected / windows));
  const double dispersion = mean.error * mean.error * windows / mean.value;
  EXPECT_NEAR(dispersion, 1.0, 4.0 * std::sqrt(2.0 / windows));
  const auto expect_share = [&](double seen, double share) {
    EXPECT_NEAR(seen / events, share, 4.0 * std::sqrt(share * (1.0 - share) / events));
  };
  expect_share(in_x, law.x_below);
  expect_share(in_both, law.both_below);
  expect_share(in_y, 1.0 - law.x_below + law.both_below);
  EXPECT_NEAR(heights / events, 1.0 - std::exp(-8.0), 4.0 / std::sqrt(events));
}

TEST(SawtoothForce, LongRecordHasTheMomentsOfTheProcess) {
  const runtime::ForceMoments wanted = usual_moments();
  Cutter cutter(wanted);
  const runtime::SawtoothLaw law = law_of(wanted);
  const double length = wanted.correlation_length / radius;
  constexpr std::size_t samples = 2'000'000;
  const Record r = record(cutter, length / 5.0, samples);
  const double mx = wanted.x_mean, my = wanted.y_mean;
  expect_met(over_pieces(samples, [&](std::size_t i) { return r.x[i]; }), mx, 0.01 * mx);
  expect_met(over_pieces(samples, [&](std::size_t i) { return r.y[i]; }), my, 0.01 * my);
  for (const std::size_t lag : {0u, 1u, 3u, 5u, 10u, 20u}) {
    const double at = r.step * static_cast<double>(lag);
    const Estimate x = over_pieces(samples - 20, [&](std::size_t i) { return (r.x[i] - mx) * (r.x[i + lag] - mx); });
    expect_met(x, covariance(law, x_density(law), law.x_height, law.x_height, at), 0.01 * wanted.x_sd * wanted.x_sd);
    const Estimate y = over_pieces(samples - 20, [&](std::size_t i) { return (r.y[i] - my) * (r.y[i + lag] - my); });
    expect_met(y, covariance(law, y_density(law), law.y_height, law.y_height, at), 0.01 * wanted.y_sd * wanted.y_sd);
  }
  expect_met(over_pieces(samples, [&](std::size_t i) { return (r.x[i] - mx) * (r.y[i] - my); }),
             wanted.xy_correlation * wanted.x_sd * wanted.y_sd, 0.01 * wanted.x_sd * wanted.y_sd);
}

// Nothing is felt where no pulse reaches: their number at a place is Poisson, with lambda (rho G_1 + delta) in the
// mean.
TEST(SawtoothForce, WithoutForceAsOftenAsNoPulseReaches) {
  const runtime::SawtoothLaw law = law_of(usual_moments());
  Cutter cutter(usual_moments());
  constexpr std::size_t samples = 1'000'000;
  const Record r = record(cutter, 0.4e-3 / radius, samples);
  const double felt = law.rise * (1.0 - std::exp(-law.highest)) + law.drop;
  expect_met(over_pieces(samples, [&](std::size_t i) { return r.x[i] == 0.0 ? 1.0 : 0.0; }),
             std::exp(-x_density(law) * felt), 0.005);
  EXPECT_GE(*std::min_element(r.x.begin(), r.x.end()), 0.0);
}

TEST(SawtoothForce, TheAngleAloneDecidesWhicheverWay) {
  for (const double path_radius : {radius, 2e-3}) {  // many cells a window, and one
    Cutter forward(usual_moments(), 1, runtime::has_wide_vectors(), usual_settings(), path_radius);
    Cutter jumping(usual_moments(), 1, false, usual_settings(), path_radius);
    std::vector<double> angles;
    for (int i = 0; i < 40000; ++i) angles.push_back(-3.0 + 2e-4 * i);
    std::vector<runtime::ForcePerMetre> seen;
    for (const double angle : angles) seen.push_back(forward.at(angle));
    base::Random random(5);
    for (int i = 0; i < 20000; ++i) {
      const auto at = static_cast<std::size_t>(base::below(random, angles.size()));
      const runtime::ForcePerMetre force = jumping.at(angles[at]);
      ASSERT_EQ(force.x, seen[at].x);
      ASSERT_EQ(force.y, seen[at].y);
    }
    for (std::size_t i = angles.size(); i-- > 0;) ASSERT_EQ(jumping.at(angles[i]).x, seen[i].x);
    for (std::size_t i = 0; i < angles.size(); i += 7) ASSERT_EQ(jumping.at(angles[i]).y, seen[i].y);
  }
}

TEST(SawtoothForce, CuttersWindowsAndSeedsDrawIndependently) {
  runtime::SignalSettings other = usual_settings();
  other.seed += 1;
  Cutter first(usual_moments()), second(usual_moments(), 2),
      third(usual_moments(), 1, runtime::has_wide_vectors(), other);
  constexpr std::size_t samples = 300'000;
  const double step = 0.8e-3 / radius, mean = usual_moments().x_mean, sd = usual_moments().x_sd;
  const Record a = record(first, step, samples), b = record(second, step, samples), c = record(third, step, samples);
  for (const Record* r : {&b, &c}) {
    const Estimate seen =
        over_pieces(samples, [&](std::size_t i) { return (a.x[i] - mean) * (r->x[i] - mean) / (sd * sd); });
    EXPECT_NEAR(seen.value, 0.0, 4.0 * seen.error);
  }
}

// A polynomial of degree five between its points: the second difference over h goes to 0 with h at each of them, and a
// jump in slope or curvature would not.
TEST(SawtoothForce, TwiceDifferentiable) {
  Cutter cutter(usual_moments());
  const double window = cutter.force->window_angle;
  const auto jump_of_curvature = [&](double at, double h) {
    const auto curvature = [&](double t) {
      return (cutter.at(t - h).x - 2.0 * cutter.at(t).x + cutter.at(t + h).x) / (h * h);
    };
    return std::abs(curvature(at + h) - curvature(at - h));
  };
  const runtime::SawtoothLaw& law = cutter.force->laws[0];
  // third derivative of the steepest pulse: 60 a g / length^3, of the drop
  const double steepest = 60.0 * law.x_height * 8.0 / std::pow(law.drop, 3);
  const double h = 1e-3 * law.drop;
  for (int k = 1; k < 20; ++k) {
    EXPECT_LE(jump_of_curvature(k * window, h), 8.0 * steepest * 2.0 * h + 1e-3 * steepest * law.drop);
    cutter.at(k * window + 0.3);
    const runtime::SawtoothBlock block = cutter.force->stream.blocks[cutter.force->stream.count - 1];
    for (const double point : {block.begin[0], block.peak[0], block.peak[0] + law.drop}) {
      EXPECT_LE(jump_of_curvature(k * window + point, h), 8.0 * steepest * 2.0 * h + 1e-3 * steepest * law.drop);
    }
  }
}

// Through the C interface.

surrogate::Model moments_model() {
  surrogate::Model model = runtime_test::constant_model(runtime_test::usual_pair());
  const runtime::ForceMoments m = usual_moments();
  model.outputs.resize(surrogate::most_outputs);
  const std::array<double, 6> values{m.x_mean, m.x_sd, m.y_mean, m.y_sd, m.correlation_length, m.xy_correlation};
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
