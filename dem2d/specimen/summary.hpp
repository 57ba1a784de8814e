#pragma once
/// What is told of a specimen when it is made.

#include "dem2d/specimen/specimen.hpp"

namespace bitrock::dem2d {

struct SpecimenSummary {
  double porosity = 0.0;             ///< [1]
  double coordination_number = 0.0;  ///< [1]
  int floaters = 0;                  ///< discs with fewer than three joints
  Pieces pieces;                     ///< under the joints
  double critical_step = 0.0;        ///< of its world without boundaries [s]
};

/// Bonds the specimen to find its critical step.
SpecimenSummary summary_of(const Specimen& specimen);

}  // namespace bitrock::dem2d
