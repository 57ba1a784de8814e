// A spectrum by Welch's method against what can be said exactly: the variance it adds up to, lines, noise.
#include "base/spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/errors.hpp"
#include "base/random.hpp"

using namespace bitrock;

namespace {

constexpr double rate = 500.0;  // [Hz]

std::vector<double> noise(std::size_t count, double deviation) {
  base::Random random(7);
  std::vector<double> signal(count);
  for (double& value : signal) value = deviation * base::normal(random);
  return signal;
}

/// A sine of amplitude 3 around 10 that has `turns` periods in `segment` samples.
std::vector<double> sine(std::size_t count, std::size_t segment, double turns) {
  std::vector<double> signal(count);
  for (std::size_t n = 0; n < count; ++n) {
    const double phase = 2.0 * std::numbers::pi * turns * static_cast<double>(n) / static_cast<double>(segment);
    signal[n] = 10.0 + 3.0 * std::sin(phase + 0.4);
  }
  return signal;
}

double integral(const base::Spectrum& spectrum) {
  double sum = 0.0;
  for (const double value : spectrum.density) sum += value;
  return sum * spectrum.frequency[1];
}

/// Mean over the segments of sum w^2 (x - m)^2 / sum w^2, written down again from its definition.
double variance_under_windows(const std::vector<double>& signal, std::size_t length) {
  double mean = 0.0, sum = 0.0, count = 0.0;
  for (const double value : signal) mean += value / static_cast<double>(signal.size());
  for (std::size_t begin = 0; begin + length <= signal.size(); begin += length / 2, count += 1.0) {
    double squares = 0.0, weights = 0.0;
    for (std::size_t n = 0; n < length; ++n) {
      const double w =
          0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(length));
      squares += w * w * std::pow(signal[begin + n] - mean, 2);
      weights += w * w;
    }
    sum += squares / weights;
  }
  return sum / count;
}

TEST(Spectrum, IntegralIsTheVarianceUnderTheWindowsForEvenAndOddSegments) {  // Parseval
  const std::vector<double> signal = noise(1000, 2.5);
  for (const std::size_t length : {250u, 249u, 128u, 7u, 4u, 1000u}) {
    const double exact = variance_under_windows(signal, length);
    EXPECT_NEAR(integral(base::welch(signal, rate, length)), exact, 1e-12 * exact) << length;
  }
}

TEST(Spectrum, IntegralIsTheVarianceOfASteadySignal) {
  // Of 10 000 independent samples: the variance has a relative scatter of sqrt(2 / 10 000) = 1.4 %.
  const double whole = integral(base::welch(noise(10'000, 2.5), rate, 400));
  EXPECT_NEAR(whole, 2.5 * 2.5, 3.0 * 0.0142 * 2.5 * 2.5);
}

TEST(Spectrum, SineGivesHalfItsAmplitudeSquaredInThreeBins) {
  constexpr std::size_t length = 250, turns = 20;
  const base::Spectrum spectrum = base::welch(sine(1000, length, turns), rate, length);
  const double step = spectrum.frequency[1], power = 0.5 * 3.0 * 3.0;
  EXPECT_EQ(step, 2.0);
  EXPECT_EQ(base::strongest_frequency(spectrum), 40.0);
  // The window of Hann spreads a line as 1/4, 1, 1/4 of 3/2.
  EXPECT_NEAR(spectrum.density[turns] * step, power / 1.5, 1e-12 * power);
  EXPECT_NEAR(spectrum.density[turns - 1] * step, power / 6.0, 1e-12 * power);
  EXPECT_NEAR(spectrum.density[turns + 1] * step, power / 6.0, 1e-12 * power);
  EXPECT_NEAR(integral(spectrum), power, 1e-12 * power);
  EXPECT_LT(spectrum.density[turns + 2], 1e-24);
}

TEST(Spectrum, WhiteNoiseIsFlatWithinTheScatterItStates) {
  constexpr std::size_t length = 200;
  const base::Spectrum spectrum = base::welch(noise(20'100, 3.0), rate, length);
  ASSERT_EQ(spectrum.segments, 200);
  // Without overlap 200 segments would scatter by sqrt(1 / 200); half of a Hann window shared adds 2 / 36 of it.
  EXPECT_NEAR(spectrum.relative_deviation, std::sqrt((1.0 + 2.0 / 36.0 * 199.0 / 200.0) / 200.0), 1e-12);
  const double level = 3.0 * 3.0 * 2.0 / rate;  // variance over half the rate
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t j = 2; j + 2 < spectrum.density.size(); ++j, count += 1.0) {
    sum += spectrum.density[j] / level;
    squares += std::pow(spectrum.density[j] / level - 1.0, 2);
    EXPECT_NEAR(spectrum.density[j], level, 4.5 * spectrum.relative_deviation * level) << spectrum.frequency[j];
  }
  EXPECT_NEAR(sum / count, 1.0, 3.0 * std::sqrt(2.0 / 20'100));
  // A scatter from 97 values, neighbours of which share half of theirs: known to about 10 %.
  EXPECT_NEAR(std::sqrt(squares / count), spectrum.relative_deviation, 0.3 * spectrum.relative_deviation);
}

TEST(Spectrum, ScalesWithTheSquareOfTheSignalAndTheRateMovesItAlong) {
  const std::vector<double> one = noise(600, 1.0), two = noise(600, 2.0);
  const base::Spectrum slow = base::welch(one, rate, 100), fast = base::welch(two, 4.0 * rate, 100);
  for (std::size_t j = 0; j < slow.density.size(); ++j) {
    EXPECT_NEAR(fast.density[j], slow.density[j], 1e-12 * slow.density[j]);
    EXPECT_NEAR(fast.frequency[j], 4.0 * slow.frequency[j], 1e-12 * fast.frequency[j]);
  }
}

TEST(Spectrum, ConstantSignalHasNone) {
  const base::Spectrum spectrum = base::welch(std::vector<double>(100, 4.0), rate, 20);
  ASSERT_EQ(spectrum.density.size(), 11u);
  EXPECT_EQ(*std::max_element(spectrum.density.begin(), spectrum.density.end()), 0.0);
  EXPECT_EQ(base::strongest_frequency(spectrum), 0.0);
}

TEST(Spectrum, ShortSignalsAreOneSegmentOrNothing) {
  const base::Spectrum one = base::welch(noise(10, 1.0), rate, 1000);
  EXPECT_EQ(one.segments, 1);
  EXPECT_EQ(one.density.size(), 6u);
  EXPECT_EQ(one.relative_deviation, 1.0);
  EXPECT_EQ(one.frequency.back(), rate / 2.0);
  EXPECT_TRUE(base::welch(noise(3, 1.0), rate, 1000).density.empty());
  EXPECT_TRUE(base::welch({}, rate, 1000).density.empty());
}

TEST(Spectrum, RefusesWhatHasNone) {
  std::vector<double> signal = noise(20, 1.0);
  EXPECT_THROW(base::welch(signal, 0.0, 10), base::InputError);
  EXPECT_THROW(base::welch(signal, rate, 3), base::InputError);
  signal[4] = std::numeric_limits<double>::quiet_NaN();
  try {
    base::welch(signal, rate, 10);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("sample 5 of 20"), std::string::npos) << error.what();
  }
}

TEST(Spectrum, QuickLengthsHaveSmallFactors) {
  EXPECT_EQ(base::quick_length(0), 1u);
  EXPECT_EQ(base::quick_length(7), 6u);
  EXPECT_EQ(base::quick_length(2083), 2048u);
  EXPECT_EQ(base::quick_length(2187), 2187u);
  for (std::size_t most = 1; most < 3000; ++most) {  // by looking at every number
    std::size_t best = 0;
    for (std::size_t n = most; best == 0; --n) {
      std::size_t rest = n;
      for (const std::size_t factor : {2u, 3u, 5u}) {
        while (rest % factor == 0) rest /= factor;
      }
      if (rest == 1) best = n;
    }
    ASSERT_EQ(base::quick_length(most), best) << most;
  }
}

}  // namespace
