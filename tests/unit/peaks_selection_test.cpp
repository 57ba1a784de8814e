// Prominence, distance and smoothing of peaks, and what makes their numbers independent of the sampling.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "peaks/definition.hpp"
#include "peaks/find_peaks.hpp"
#include "peaks/moments.hpp"
#include "peaks/smoothing.hpp"
#include "tests/unit/peaks_signals.hpp"

using namespace bitrock;

namespace {

using peaks_signals::infinity, peaks_signals::nan_value;
using Indices = std::vector<std::size_t>;
using Values = std::vector<double>;

/// 48 numbers of no pattern, with equal heights, flat tops and high ends among them.
const Values rough{7, 3, 5, 2, 2, 6, 6, 1, 4, 4, 9, 0, 3, 8, 8, 8, 5, 6, 2, 7, 1, 1, 5, 9,
                   4, 6, 3, 9, 9, 2, 5, 0, 8, 7, 7, 8, 3, 4, 1, 6, 2, 6, 5, 6, 0, 2, 1, 8};

TEST(Prominence, OfARoughSignalAsSciPyHasIt) {
  // scipy.signal.find_peaks(rough), peak_prominences; SciPy reports the middle of a flat top, here it is the first
  const Indices found = peaks::find_peaks(rough);
  EXPECT_EQ(found, (Indices{2, 5, 10, 13, 17, 19, 23, 25, 27, 30, 32, 35, 37, 39, 41, 43, 45}));
  EXPECT_EQ(peaks::prominences(rough, found), (Values{2, 4, 8, 7, 1, 5, 9, 2, 9, 3, 8, 8, 1, 5, 5, 5, 1}));
}

TEST(Prominence, ANaNOrAnInfinityEndsTheSignal) {
  const Values signal{0, 9, 0, nan_value, 4, 6, 5, infinity, 3, 4, 2};
  const Indices found{5, 9};
  EXPECT_EQ(peaks::prominences(signal, found), (Values{1, 1}));
}

TEST(Prominence, AHigherEndIsABorderToo) {
  const Values signal{5, 1, 3, 0, 9};
  EXPECT_EQ(peaks::prominences(signal, Indices{2}), (Values{2}));
}

TEST(Selection, LeavesTheProminentAndAmongThoseTheHighest) {
  const Indices found = peaks::find_peaks(rough);
  // scipy.signal.find_peaks(rough, prominence=0.5 * 9)
  EXPECT_EQ(peaks::selected(rough, found, 9.0, {.min_prominence = 0.5}),
            (Indices{10, 13, 19, 23, 27, 32, 35, 39, 41, 43}));
  // scipy.signal.find_peaks(rough, distance=5): of equal peaks SciPy keeps the later one, MATLAB and we the earlier
  EXPECT_EQ(peaks::selected(rough, found, 9.0, {.min_distance = 4.0}), (Indices{5, 10, 17, 23, 32, 39, 45}));
}

TEST(Selection, WhatIsExactlyAsFarAwayGoes) {
  const Values signal{0, 5, 0, 4, 0, 3, 0};
  const Indices found{1, 3, 5};
  EXPECT_EQ(peaks::selected(signal, found, 5.0, {.min_distance = 1.9}), (Indices{1, 3, 5}));
  EXPECT_EQ(peaks::selected(signal, found, 5.0, {.min_distance = 2.0}), (Indices{1, 5}));
}

TEST(Selection, NoneAskedForChangesNothing) {
  EXPECT_EQ(peaks::counted_peaks(rough, {}), peaks::counted_peaks(rough));
  const peaks::PeakStatistics a = peaks::peak_statistics(rough), b = peaks::peak_statistics(rough, peaks::Selection{});
  EXPECT_EQ(a.amax, b.amax);
  EXPECT_DOUBLE_EQ(a.amean, b.amean);
  EXPECT_EQ(a.np1, b.np1);
  EXPECT_EQ(a.np23, b.np23);
  EXPECT_EQ(a.np4, b.np4);
}

/// Variance of what becomes of one sample [samples^2].
double variance_of_smoothing(double length) {
  Values impulse(201, 0.0);
  impulse[100] = 1.0;
  const Values spread = peaks::smoothed(impulse, length);
  EXPECT_NEAR(std::accumulate(spread.begin(), spread.end(), 0.0), 1.0, 1e-12);
  double variance = 0.0;
  for (std::size_t i = 0; i < spread.size(); ++i) {
    const double away = static_cast<double>(i) - 100.0;
    variance += spread[i] * away * away;
    EXPECT_NEAR(spread[i], spread[200 - i], 1e-15);
    EXPECT_GE(spread[i], 0.0);
  }
  return variance;
}

TEST(Smoothing, WithTheSamplesOwnMeanIsTwoMeansOverTheLength) {
  for (const double length : {0.8, 1.0, 1.5, 2.0, 2.7, 4.0, 8.0, 13.37}) {
    EXPECT_NEAR(variance_of_smoothing(length) + 1.0 / 12.0, 2.0 * length * length / 12.0, 1e-10) << length;
  }
}

TEST(Smoothing, OfALengthBelowTheSamplingChangesNothing) {
  for (const double length : {0.0, 0.5, 0.7}) EXPECT_EQ(peaks::smoothed(rough, length), rough);
}

TEST(Smoothing, KeepsAConstantToTheEnds) {
  const Values constant(30, 4.0);
  for (const double value : peaks::smoothed(constant, 5.0)) EXPECT_NEAR(value, 4.0, 1e-14);
  EXPECT_EQ(peaks::smoothed(Values{3.0}, 5.0), Values{3.0});
  EXPECT_TRUE(peaks::smoothed(Values{}, 5.0).empty());
}

TEST(Definition, TheArticlesIsThePlainOne) {
  const peaks::PeakStatistics a = peaks::peak_statistics(rough, 1.0, peaks::as_in_the_article());
  const peaks::PeakStatistics b = peaks::peak_statistics(rough);
  EXPECT_EQ(a.amean, b.amean);
  EXPECT_EQ(a.count(), b.count());
}

/// A sawtooth force at 1 um of travel: it climbs over some tenths of a millimetre and drops, with the ringing of single
/// grains on top whose power rises down to the finest sampling.
Values fine_force() {
  std::mt19937_64 random(5);
  std::exponential_distribution<double> wait(1.0 / 600.0), height(1.0);
  std::normal_distribution<double> noise;
  Values force(200000, 0.0);
  for (double at = 500.0; at + 100.0 < 200000.0; at += wait(random)) {
    const double peak = height(random), rise = 400.0 * peak;
    for (double x = std::max(0.0, at - rise); x < at; x += 1.0)
      force[static_cast<std::size_t>(x)] += peak * (1.0 - (at - x) / rise);
  }
  double ringing = 0.0;
  for (double& value : force) {
    ringing = 0.7 * ringing + noise(random);
    value = std::max(0.0, value + 0.03 * ringing);
  }
  return force;
}

Values block_means(const Values& fine, std::size_t each) {
  Values means(fine.size() / each);
  for (std::size_t i = 0; i < means.size(); ++i) {
    for (std::size_t k = 0; k < each; ++k) means[i] += fine[i * each + k] / static_cast<double>(each);
  }
  return means;
}

TEST(Definition, ConvergingCountsDoNotDependOnTheSamplingAndTheArticlesDo) {
  const Values fine = fine_force();
  const auto counted = [&fine](std::size_t micrometres, const peaks::PeakDefinition& definition) {
    return peaks::peak_statistics(block_means(fine, micrometres), static_cast<double>(micrometres) * 1e-6, definition);
  };
  const peaks::PeakDefinition converging = peaks::converging(0.5e-3);
  const peaks::PeakStatistics reference = counted(10, converging);
  ASSERT_GT(reference.count(), 100);
  for (const std::size_t micrometres : {5u, 20u}) {
    const peaks::PeakStatistics other = counted(micrometres, converging);
    EXPECT_NEAR(other.count(), reference.count(), 0.03 * reference.count()) << micrometres;
    EXPECT_NEAR(other.amean, reference.amean, 0.03 * reference.amean) << micrometres;
    EXPECT_NEAR(other.amax, reference.amax, 0.03 * reference.amax) << micrometres;
  }
  EXPECT_GT(counted(5, peaks::as_in_the_article()).count(), 2 * counted(20, peaks::as_in_the_article()).count());
}

TEST(Moments, OfASineAreKnown) {
  const double wave = 1e-3, spacing = 1e-6;  // [m]
  Values x(100000), y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double phase = 2.0 * M_PI * static_cast<double>(i) * spacing / wave;
    x[i] = 3.0 + 2.0 * std::sin(phase);
    y[i] = 7.0 + 5.0 * std::sin(phase + M_PI / 3.0);
  }
  const peaks::Moments found = peaks::moments(x, spacing);
  EXPECT_NEAR(found.mean, 3.0, 1e-9);
  EXPECT_NEAR(found.sd, std::sqrt(2.0), 1e-9);
  // cos(2 pi lag / wave) = 1/e, and the record is 100 waves: its R is low by the share of the lag
  EXPECT_NEAR(found.correlation_length, std::acos(1.0 / M_E) / (2.0 * M_PI) * wave, 2e-3 * wave);
  EXPECT_NEAR(found.short_correlation_length, std::acos(0.75) / (2.0 * M_PI) * wave, 2e-3 * wave);
  EXPECT_EQ(found.low_share, 0.0);
  EXPECT_NEAR(peaks::correlation(x, y), 0.5, 1e-9);
}

TEST(Moments, OfAConstantAndOfNothing) {
  const peaks::Moments constant = peaks::moments(Values(10, 4.0), 1.0);
  EXPECT_EQ(constant.mean, 4.0);
  EXPECT_EQ(constant.sd, 0.0);
  EXPECT_EQ(constant.correlation_length, 0.0);
  EXPECT_EQ(constant.short_correlation_length, 0.0);
  EXPECT_EQ(peaks::correlation(Values(10, 4.0), Values(10, 1.0)), 0.0);
  EXPECT_EQ(peaks::moments(Values{}, 1.0).mean, 0.0);
}

TEST(Moments, TheLowShareIsOfTheMean) {
  EXPECT_EQ(peaks::moments(Values{0.0, 0.0, 0.1, 4.9, 5.0}, 1.0).low_share, 0.6);
}

}  // namespace
