#pragma once
/// What `lab` tells of its tests: the numbers of each and their mean and scatter, as a table.

#include "cli/command.hpp"
#include "studies/lab/series.hpp"

namespace bitrock::cli {

void print_table(const CommonOptions& options, const studies::LabResults& results);

/// Of results with `half_rate`; `strain_rate` [1/s] is the full one.
void print_rate_check(const CommonOptions& options, double strain_rate, const studies::LabResults& results);

}  // namespace bitrock::cli
