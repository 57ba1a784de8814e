#pragma once
/// Natural frequencies that are known in closed form for a string of one pipe, to hold the computed ones against
/// (`modes.hpp` has the formulas).

#include <optional>
#include <vector>

#include "runtime/drillstring/drill_case.hpp"

namespace bitrock::runtime {

struct ClosedForms {
  double axial_continuous = 0.0;  ///< [Hz] lowest above 0 of the continuous pipe off bottom, held as its hoist holds it
  double torsional_continuous = 0.0;  ///< [Hz] lowest of the continuous pipe, held by its drive, free at the bit
  std::vector<double> equal_lumps;    ///< [Hz] of the case's equal torsional lumps
};

/// Nothing for a string of several pipes, or given as chains.
std::optional<ClosedForms> closed_forms(const DrillCase& drill);

}  // namespace bitrock::runtime
