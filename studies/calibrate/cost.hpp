#pragma once
/// What a calibration will cost, before it begins.

#include "studies/calibrate/target.hpp"

namespace bitrock::studies {

/// Evaluations that a search usually takes: on few specimens, then on all.
inline constexpr int usual_coarse_evaluations = 5, usual_fine_evaluations = 3;

struct CalibrationCost {
  double discs = 0.0;                      ///< of a specimen
  double core_seconds_per_specimen = 0.0;  ///< all tests of it, without packing
  double core_seconds = 0.0;               ///< of the usual evaluations
};
/// Of the usual number of evaluations, none of which is in a journal yet.
CalibrationCost cost_of(const CalibrationTarget& target);

/// On the clock, with this many cores [min].
double expected_minutes(const CalibrationCost& cost, int cores);

}  // namespace bitrock::studies
