#pragma once
/// Mass and inertia of the bit, which move with the lowest lump of the string.

namespace bitrock::runtime {

/// Mass recalled from the literature for bits of about 8 1/2 in, not verified; the article gives none.
inline constexpr double usual_bit_mass = 65.0;  ///< [kg]

/// **What** Moment of inertia of the bit about its axis, taken as a full cylinder.
/// **Equation** J = m R^2 / 2.
/// **Symbols** m [kg]; R [m] radius of the bit; J [kg m^2].
/// **Source** elementary. **Validity** 0.38 kg m^2 for 65 kg and 8 1/2 in: a twentieth of the string of the 150 m case.
inline double bit_inertia(double mass, double radius) {
  return 0.5 * mass * radius * radius;
}

}  // namespace bitrock::runtime
