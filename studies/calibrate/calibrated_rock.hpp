#pragma once
/// The rock file that a calibration ends with: a complete rock, and above it, as comments, what was wanted, what was
/// reached with which scatter, and the command that did it. A rock that misses its target says so, in its name too.

#include <optional>
#include <string>
#include <vector>

#include "studies/calibrate/calibration.hpp"

namespace bitrock::studies {

/// The calibrated rock on specimens that the calibration has not seen.
struct FreshSpecimens {
  std::vector<int> seeds;  ///< of these specimens
  Evaluation result;       ///< with the best micro-parameters
};

/// How far a mean over about ten fresh specimens may be from the target, in the measure of `error_of`: twice to three
/// times the default tolerance, because two samples of specimens differ by their standard errors.
double fresh_tolerance(Property property);

/// The calibrated rock itself: the start rock with the best micro-parameters and the target's name.
dem2d::Rock calibrated_rock(const CalibrationTarget& target, const Calibration& calibration);

/// One line a wanted number: "UCS: wanted 70.5 MPa, reached 70.9 +- 2.1 MPa (+0.6 %)". Scatter is the standard
/// deviation from specimen to specimen.
std::vector<std::string> lines_about(const CalibrationTarget& target, const Evaluation& evaluation);

/// Why a calibration that did not reach its target ended, with what is at its limit and what one could do; one text.
std::string reason_of(const CalibrationTarget& target, const Calibration& calibration);

/// Throws `base::SimulationError` when the calibration did not reach its target, with the reason, the nearest
/// evaluation, and the file that keeps it.
void require_reached(const CalibrationTarget& target, const Calibration& calibration, const std::string& rock_file);

/// The file. `command` is what the user typed. Throws `base::SimulationError` when it would be no rock file.
std::string calibrated_rock_toml(const CalibrationTarget& target, const Calibration& calibration,
                                 const std::string& command, const std::optional<FreshSpecimens>& fresh = {});

}  // namespace bitrock::studies
