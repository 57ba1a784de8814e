#include "dem2d/lab/curve.hpp"

#include <algorithm>
#include <limits>

namespace bitrock::dem2d {

namespace {

constexpr double secant_share = 0.5;       // of the peak stress [IsrmUniaxial1979]
constexpr double initiation_share = 0.01;  // of the cracks at the peak
constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

int cracks(const LabSample& sample) {
  return sample.cracks_tensile + sample.cracks_shear;
}

/// The curve where its stress first reaches `stress`, on the straight line between two samples; it begins at zero.
LabSample first_at(std::span<const LabSample> curve, double stress) {
  const auto at = std::find_if(curve.begin(), curve.end(), [stress](const LabSample& s) { return s.stress >= stress; });
  const LabSample before = at == curve.begin() ? LabSample{} : *(at - 1);
  const double share = (stress - before.stress) / (at->stress - before.stress);
  return {.strain = before.strain + share * (at->strain - before.strain),
          .lateral_strain = before.lateral_strain + share * (at->lateral_strain - before.lateral_strain),
          .stress = stress,
          .cracks_tensile = at->cracks_tensile,
          .cracks_shear = at->cracks_shear};
}

}  // namespace

CurveResult read_curve(std::span<const LabSample> curve) {
  const auto peak = std::max_element(curve.begin(), curve.end(),
                                     [](const LabSample& a, const LabSample& b) { return a.stress < b.stress; });
  const LabSample secant = first_at(curve, secant_share * peak->stress);
  const auto first_cracked = std::find_if(curve.begin(), curve.end(), [](const LabSample& s) { return cracks(s) > 0; });
  LabSample elastic = secant;
  if (cracks(secant) > 0) elastic = first_cracked == curve.begin() ? LabSample{} : *(first_cracked - 1);
  const double initiated = std::max(1.0, initiation_share * cracks(*peak));
  const auto initiation =
      std::find_if(curve.begin(), peak, [initiated](const LabSample& s) { return cracks(s) >= initiated; });
  return {.peak_stress = peak->stress,
          .strain_at_peak = peak->strain,
          .youngs_modulus = secant.stress / secant.strain,
          .poissons_ratio = -secant.lateral_strain / secant.strain,
          .cracks_at_half = cracks(secant),
          .uncracked_modulus = elastic.strain != 0.0 ? elastic.stress / elastic.strain : not_there,
          .uncracked_ratio = elastic.strain != 0.0 ? -elastic.lateral_strain / elastic.strain : not_there,
          .crack_initiation_stress = initiation->stress,
          .cracks_at_peak = cracks(*peak)};
}

}  // namespace bitrock::dem2d
