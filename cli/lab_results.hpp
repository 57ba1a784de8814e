#pragma once
/// What `lab` tells of its tests: the numbers of each and their mean and scatter, as JSON and as a table.

#include "cli/command.hpp"
#include "studies/lab/series.hpp"

namespace bitrock::cli {

/// `runs`, `failures`, `not_tested`; when there are runs also `mean`, `sd` and `rate_check`
/// (docs/reference/formats.md).
nlohmann::json runs_json(const studies::LabResults& results);

void print_table(const CommonOptions& options, const studies::LabResults& results);

/// Of results with `half_rate`; `strain_rate` [1/s] is the full one.
void print_rate_check(const CommonOptions& options, double strain_rate, const studies::LabResults& results);

}  // namespace bitrock::cli
