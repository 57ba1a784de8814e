#pragma once
/// What the stress-strain curve of a test says: strength, secant moduli, crack initiation (equations in lab_test.hpp).

#include <span>

#include "dem2d/lab/lab_test.hpp"

namespace bitrock::dem2d {

struct CurveResult {
  double peak_stress, strain_at_peak;  ///< [Pa], [1]
  double youngs_modulus;               ///< secant from 0 to half the peak [Pa]
  double poissons_ratio;               ///< over the same part [1]
  int cracks_at_half;                  ///< at half the peak: more than 0, and the two above hold their opening
  double uncracked_modulus;            ///< secant over the part before the first crack, at most to half the peak [Pa]
  double uncracked_ratio;              ///< over the same part [1]; both NaN when the first point has cracks
  double crack_initiation_stress;      ///< [Pa]; the peak when nothing broke before it
  int cracks_at_peak;                  ///< elements broken at the peak
};

/// `curve` holds at least one point with positive stress.
CurveResult read_curve(std::span<const LabSample> curve);

}  // namespace bitrock::dem2d
