#pragma once
/// What `lab` tells of its tests.

#include <string>

#include "studies/lab/series.hpp"

namespace bitrock::views {

/// What the tests will be and cost (`lab --check`).
std::string plan_line(const studies::LabSeries& series, const studies::LabCost& cost);

/// The numbers of each test, and their mean and scatter; empty when no test is finished.
std::string lab_table(const studies::LabResults& results);

/// The Mohr-Coulomb line of tests under several pressures; empty of others.
std::string envelope_lines(const studies::LabResults& results);

/// Of results with `half_rate`; `strain_rate` [1/s] is the full one.
std::string rate_check_line(double strain_rate, const studies::LabResults& results);

}  // namespace bitrock::views
