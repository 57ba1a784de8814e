// How fast a force history of 10^7 samples becomes peaks and statistics, beside a plain sum over the same samples,
// which is as fast as this core reads memory; on all vector units. Two signals: one like the force on a cutter, with
// periods of hardly any force, and pure noise, the worst case, where every third sample is a peak. The program fails
// when the vector units, or a plain loop, disagree. See docs/results/performance.md.
//
//   bench_peaks [--quick]      --quick: 10^6 samples
#include <fmt/format.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "base/thread_time.hpp"
#include "peaks/find_peaks.hpp"
#include "peaks/statistics.hpp"
#include "peaks/zero_force.hpp"

using namespace bitrock;

namespace {

/// Exponential with that mean, at least 1 [samples].
int draw_length(base::Random& random, double mean) {
  return 1 + static_cast<int>(-mean * std::log(1.0 - base::uniform(random)));
}

/// Chip after chip: a force that wanders about a level of its own, then grains that barely touch the cutter. Half of
/// the time there is hardly any force, and 7 % of the samples are peaks; in cuts of the article's rock 32 to 68 % of
/// the samples are quiet and 2 to 9 % are peaks.
std::vector<double> like_a_cut(std::size_t samples) {
  std::vector<double> force;
  force.reserve(samples);
  base::Random random(1);
  while (force.size() < samples) {
    const double level = 1e5 * base::uniform(random);
    double wander = 0.0, slow = 0.0;
    for (int left = draw_length(random, 50.0); left > 0 && force.size() < samples; --left) {
      wander = 0.9 * wander + 0.2 * level * base::uniform(random, -1.0, 1.0);
      slow = 0.9 * slow + 0.1 * wander;
      force.push_back(std::max(0.0, level + slow));
    }
    for (int left = draw_length(random, 40.0); left > 0 && force.size() < samples; --left) {
      force.push_back(base::uniform(random) < 0.3 ? 0.0 : 500.0 * base::uniform(random));
    }
  }
  return force;
}

std::vector<double> noise(std::size_t samples) {
  std::vector<double> force(samples);
  base::Random random(2);
  for (double& value : force) value = base::uniform(random);
  return force;
}

/// With as many chains as it takes not to wait for an addition.
double sum(const std::vector<double>& signal) {
  std::array<double, 16> chain{};
  for (std::size_t i = 0; i + chain.size() <= signal.size(); i += chain.size()) {
    for (std::size_t k = 0; k < chain.size(); ++k) chain[k] += signal[i + k];
  }
  double total = 0.0;
  for (const double value : chain) total += value;
  return total;
}

/// The number of peaks, sample by sample, of a signal of finite numbers.
double plain_loop(const std::vector<double>& signal, double least) {
  std::size_t count = 0;
  for (std::size_t i = 1; i + 1 < signal.size(); ++i) {
    if (!(signal[i - 1] < signal[i]) || !(signal[i] > least)) continue;
    std::size_t end = i + 1;
    while (end < signal.size() && signal[end] == signal[i]) ++end;
    if (end < signal.size() && signal[end] < signal[i]) ++count;
  }
  return static_cast<double>(count);
}

struct Pass {
  std::string name;
  std::function<double()> run;
};

/// Least time on the core of some rounds, in which the passes take turns [s].
std::vector<double> least_times(const std::vector<Pass>& passes, std::vector<double>& results) {
  std::vector<double> least(passes.size(), 1e300);
  results.resize(passes.size());
  for (int round = 0; round < 9; ++round) {
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const double start = base::thread_time();
      results[k] = passes[k].run();
      least[k] = std::min(least[k], base::thread_time() - start);
    }
  }
  return least;
}

/// Whether all units agree.
bool measure(const std::string& name, const std::vector<double>& signal) {
  const double least = peaks::minimum_height(signal);
  const std::vector<Pass> passes{
      {"plain sum: the speed of memory", [&] { return sum(signal); }},
      {"plain loop over peaks", [&] { return plain_loop(signal, least); }},
      {"find_peaks", [&] { return static_cast<double>(peaks::find_peaks(signal, least).size()); }},
      {"peak_statistics", [&] { return static_cast<double>(peaks::peak_statistics(signal).count()); }},
      {"zero_force", [&] { return static_cast<double>(peaks::zero_force(signal, least).quiet); }}};
  bool same = true;
  std::vector<double> expected, results;
  for (const auto& [unit, target] : {std::pair{"best", std::int64_t{0}}, std::pair{"AVX2", std::int64_t{HWY_AVX2}},
                                     std::pair{"plain code", std::int64_t{HWY_EMU128 | HWY_SCALAR}}}) {
    hwy::SetSupportedTargetsForTest(target);
    const std::vector<double> times = least_times(passes, results);
    if (expected.empty()) expected = results;
    same = same && results == expected && results[1] == results[2] && results[2] == results[3];
    for (std::size_t k = 0; k < passes.size(); ++k) {
      const double samples = static_cast<double>(signal.size());
      fmt::print("| {} | {} | {} | {:.2f} | {:.1f} | {:.2f} |\n", name, unit, passes[k].name, 1e9 * times[k] / samples,
                 1e-9 * 8.0 * samples / times[k], times[0] / times[k]);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  fmt::print("{}: {:.3f} of the samples are peaks, {:.2f} are quiet\n", name,
             results[2] / static_cast<double>(signal.size()), results[4] / static_cast<double>(signal.size()));
  if (!same) fmt::print("FAILED: {}: not all ways find the same peaks\n", name);
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = std::find(argv, argv + argc, std::string("--quick")) != argv + argc;
  const std::size_t samples = quick ? 1000000 : 10000000;
  fmt::print(
      "| signal | vector unit | pass | ns / sample | GB/s | speed over that of the sum |\n|---|---|---|---|---|---|\n");
  const bool same = measure("like a cut", like_a_cut(samples));
  return measure("noise", noise(samples)) && same ? 0 : 1;
}
