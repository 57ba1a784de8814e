#pragma once
/// Strength tests of one rock, a core a seed, side by side; on request each again at half the rate of loading.

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/progress.hpp"
#include "base/statistics.hpp"
#include "dem2d/lab/lab_test.hpp"

namespace bitrock::studies {

/// What is tested: the cores and the settings, complete.
struct LabSeries {
  dem2d::LabTest test = dem2d::LabTest::ucs;  ///< the same for all cores
  dem2d::Rock rock;                           ///< of the cores
  dem2d::LabSettings settings;                ///< of each test, but for pressure and cut
  std::vector<std::uint64_t> seeds;           ///< a core each
  std::vector<double> pressures{0.0};         ///< each seed is tested under each confining pressure [Pa]; triaxial only
  std::vector<double> notches{0.0};           ///< each seed is tested with a cut of each length [m]; toughness only
  std::optional<dem2d::Specimen> given;       ///< tested in place of cores packed here; `seeds` then holds its seed
  bool rate_check = false;                    ///< each core is tested again at half the rate
};

/// A core that is tested.
struct LabCore {
  std::uint64_t seed;      ///< that packed it
  double pressure, notch;  ///< [Pa], [m]
};
/// All of a series: pressure by pressure, cut by cut, seed by seed.
std::vector<LabCore> cores_of(const LabSeries& series);

/// The rate of loading is the usual one of the rock where the settings leave it 0; a toughness test without lengths of
/// cuts has one of the usual share of the width. Throws `InputError` when the
/// settings do not fit the test or the rock.
void complete(LabSeries& series, const std::string& rock_file);

/// Tests these discs, with the joints of the rock of the series; the radii of the rock are then theirs. Before
/// `complete`. Throws `InputError` when they are not of the size that the test needs.
void take_given(LabSeries& series, dem2d::Specimen given);

/// The tests that were finished, in the order of the seeds; with the rate check those finished at both rates.
struct LabResults {
  std::vector<dem2d::LabRun> runs, half_rate;                   ///< the second empty without the rate check
  std::vector<std::pair<std::uint64_t, std::string>> failures;  ///< seed, reason
  std::vector<std::uint64_t> not_tested;                        ///< seeds
  std::exception_ptr ended_by;                                  ///< what ended the work before all seeds were done
};

/// Runs the tests, `jobs` at a time. A test that fails is a result too; `finished` hears of each that did not, one at a
/// time, as soon as it is done. Throws nothing of a test: what ended the series stands in the results.
LabResults run_series(const LabSeries& series, int jobs, const base::ProgressCallback& progress,
                      const std::function<void(const dem2d::LabRun&)>& finished);

/// Throws when not every seed gave a result: what ended the work, or `SimulationError` with the reasons.
void require_all(const LabResults& results);

/// What the series will cost; discs of one core.
struct LabCost {
  double discs = 0.0;         ///< as expected; of a given specimen, as they are
  double duration = 0.0;      ///< [s] simulated, until the expected strength; under the last of the pressures
  double core_seconds = 0.0;  ///< of all tests, without packing
};
/// Of a series that is complete.
LabCost cost_of(const LabSeries& series);

/// A quantity of a test whose mean and scatter are told, with its name in JSON.
struct LabQuantity {
  const char* key;                     ///< ends in its unit
  double (*of)(const dem2d::LabRun&);  ///< in the unit of the key
};
/// Peak stress first.
std::span<const LabQuantity> lab_quantities();
/// Mean and scatter over the runs, in the unit of the key.
base::Summary summary_of(const LabQuantity& quantity, std::span<const dem2d::LabRun> runs);

/// The tests of `LabResults`, those under one confining pressure and with cuts of one length together.
std::vector<std::span<const dem2d::LabRun>> by_condition(std::span<const dem2d::LabRun> runs);

/// Halving the rate may change the mean strength by this share [1] before the rate counts as too fast.
inline constexpr double allowed_rate_change = 0.03;

/// Whether the rate of loading has a say in the strength.
struct RateCheck {
  double mean_strength = 0.0, mean_at_half_rate = 0.0;  ///< [Pa]
  double change = 0.0;                                  ///< [1] of the mean by halving the rate
  bool slow_enough = false;                             ///< `change` is below `allowed_rate_change`, up or down
};
/// Of results with `half_rate`.
RateCheck rate_check_of(const LabResults& results);

/// A row a sample: strain, lateral strain, stress, cracks (docs/reference/formats.md).
std::string curve_csv(const dem2d::LabRun& run);

/// The rock with the size of its cores, read back to the same bits.
std::string rock_text(const LabSeries& series);

/// The command that makes these results again from the text of the rock.
std::string command_again(const LabSeries& series);

}  // namespace bitrock::studies
