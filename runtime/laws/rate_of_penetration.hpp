#pragma once
/// How fast a bit drills at a given weight and rotation. At a fixed rotation each law is a straight line in the weight,
/// cut off at zero; they are given as that line, so that the moving rock (`rock_contact.hpp`) can be solved exactly.

#include <cmath>

namespace bitrock::runtime {

/// Rate of penetration = max(0, slope * weight + offset) above the threshold, 0 at and below it and without rotation.
struct AdvanceLine {
  double slope = 0.0;      ///< [m/s/N] 0 or more
  double offset = 0.0;     ///< [m/s]
  double threshold = 0.0;  ///< [N] weight that does not yet drill, 0 or more
};

/// [m/s] `weight` [N] on the bit.
inline double rate_of_penetration(const AdvanceLine& line, double weight) {
  if (!(weight > line.threshold)) return 0.0;
  return std::fmax(0.0, line.slope * weight + line.offset);
}

/// Constants recalled from [YigitChristoforou2006], not verified; they belong to one bit in one formation.
struct RootAdvance {
  double c1 = 1.35e-8;  ///< [m/s / (N (rad/s)^(1/2))]
  double c2 = -1.9e-4;  ///< [m/s]
};

/// **What** The article's law at the rotation x.
/// **Equation** ROP = C1 W sqrt(x) + C2, at least 0; 0 for x <= 0.
/// **Symbols** ROP [m/s]; W [N] weight on bit; x [rad/s] rotation of the bit.
/// **Source** [BitRock2026, sec. 3.5], where the root is lost in print; with it in [YigitChristoforou2006].
/// **Differences and validity** There W and x are means; here they are of the instant. With the recalled constants
/// nothing is drilled below 5.6 kN at 60 rpm.
inline AdvanceLine advance_line(const RootAdvance& law, double rotation, double threshold) {
  if (!(rotation > 0.0)) return {.threshold = threshold};
  return {.slope = law.c1 * std::sqrt(rotation), .offset = law.c2, .threshold = threshold};
}

/// Constants of a published program [LoboTorsional, fun_ROP.m].
struct RegularizedAdvance {
  double a1 = 3.429e-3;  ///< [m/s]
  double a2 = 5.672e-8;  ///< [m/s/N]
  double a3 = 1.374e-4;  ///< [m/rad]
  double x0 = 2.0;       ///< [rad/s] rotation below which drilling ceases
};

/// **What** An alternative with a source one can read.
/// **Equation** Z = x / sqrt(x^2 + x0^2), ROP = Z^2 (a2 W - a1) + a3 Z x, at least 0; 0 for x <= 0.
/// **Symbols** as above; a1, a2, a3, x0 as in the table.
/// **Source** [LoboTorsional, fun_ROP.m]; of the form of [TuckerWang2003].
inline AdvanceLine advance_line(const RegularizedAdvance& law, double rotation, double threshold) {
  if (!(rotation > 0.0)) return {.threshold = threshold};
  const double z = rotation / std::sqrt(rotation * rotation + law.x0 * law.x0);
  return {.slope = z * z * law.a2, .offset = z * law.a3 * rotation - z * z * law.a1, .threshold = threshold};
}

}  // namespace bitrock::runtime
