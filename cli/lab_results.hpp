#pragma once
/// What `lab` tells of its tests: the numbers of each and their mean and scatter, as JSON and as a table.

#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "dem2d/lab/lab_test.hpp"

namespace cli {

/// The tests that were finished, in the order of the seeds; with --rate-check those finished at both rates.
struct LabResults {
  std::vector<dem2d::LabRun> runs, half_rate;                   ///< the second empty without --rate-check
  std::vector<std::pair<std::uint64_t, std::string>> failures;  ///< seed, reason
  std::vector<std::uint64_t> not_tested;                        ///< seeds
  std::exception_ptr ended_by;                                  ///< what ended the work before all seeds were done
};

/// `runs`, `failures`, `not_tested`; when there are runs also `mean`, `sd` and `rate_check` (docs/formats.md).
nlohmann::json runs_json(const LabResults& results);

void print_table(const CommonOptions& options, const LabResults& results);

/// `json` is that of `lab`, with a `rate_check`.
void print_rate_check(const CommonOptions& options, const nlohmann::json& json);

}  // namespace cli
