#pragma once
/// Natural frequencies that are known in closed form for a string of one pipe, to hold the computed ones against
/// (`modes.hpp` has the formulas).

#include <optional>
#include <vector>

#include "runtime/drillstring/drill_case.hpp"

namespace bitrock::runtime {

struct ClosedForms {
  /// [Hz] first one of the continuous pipe.
  double axial_continuous = 0.0,
         torsional_continuous = 0.0;  ///< [Hz] first ones of the continuous pipe, free at the bit
  std::vector<double> equal_lumps;    ///< [Hz] of the case's equal torsional lumps
};

/// Nothing for a string of several pipes, or given as chains.
std::optional<ClosedForms> closed_forms(const DrillCase& drill);

}  // namespace bitrock::runtime
