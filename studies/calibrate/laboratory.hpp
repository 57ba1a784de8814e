#pragma once
/// The laboratory of a calibration: tests one set of micro-parameters on several specimens, side by side on the cores.
/// A specimen is packed once a seed, because packing knows nothing of joints, and serves every evaluation; so the
/// means of two evaluations differ less by chance than means over different specimens would.

#include <functional>
#include <map>
#include <vector>

#include "studies/calibrate/calibration.hpp"
#include "studies/calibrate/journal.hpp"

namespace bitrock::studies {

/// Raised by hand whenever a test of the same specimen would give another result: kept tests then count no more.
inline constexpr int laboratory_version = 1;

/// Core size from the start rock's [specimen], the rest as in `bitrock lab`.
dem2d::LabSettings lab_settings_of(const CalibrationTarget& target, double confining_pressure = 0.0);

/// All that a test depends on but micro-parameters and seed, as text: the key of the journal.
std::string journal_inputs(const CalibrationTarget& target);

/// Tests of this target, the longest first.
std::vector<LaboratoryTest> tests_of(const CalibrationTarget& target);

/// Throws `InputError` naming the start rock when the tests of this target cannot be made on its core.
void check_tests(const CalibrationTarget& target);

/// What a laboratory has done.
struct LaboratoryCount {
  int tests = 0;              ///< run by this call of the program
  int reused = 0;             ///< found in the journal
  double core_seconds = 0.0;  ///< of the tests that were run
};

/// Keeps the specimens it has packed, and counts what it does.
class Laboratory {
 public:
  /// Both must outlive it. `threads`: tests at a time, 1 or more. Throws as `check_tests` does.
  Laboratory(const CalibrationTarget& target, Journal& journal, int threads);

  /// Means over the specimens of these seeds. Progress counts tests. Throws `SimulationError` when a test gives no
  /// strength, and `Interrupted` when the user stopped; tests that ended before are in the journal.
  Evaluation evaluate(const Micro& micro, const std::vector<int>& seeds, const base::ProgressCallback& progress = {});

  const LaboratoryCount& count() const { return count_; }  ///< since it was made

 private:
  void pack(const std::vector<int>& seeds);

  const CalibrationTarget& target_;
  dem2d::LabSettings settings_;
  Journal& journal_;
  int threads_;
  std::map<int, dem2d::Specimen> specimens_;
  LaboratoryCount count_;
};

/// first, first + 1, ... of that number.
std::vector<int> seeds_from(int first, int count);

}  // namespace bitrock::studies
