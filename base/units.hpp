#pragma once
/// The units that files and messages speak, as factors to SI, and the way back. SI value = number * unit.

#include <numbers>

namespace bitrock::base {

inline constexpr double um = 1e-6, mm = 1e-3;                 ///< [m]
inline constexpr double mm2 = 1e-6;                           ///< [m^2]
inline constexpr double ms = 1e-3;                            ///< [s]
inline constexpr double kN = 1e3;                             ///< [N]
inline constexpr double MPa = 1e6, GPa = 1e9;                 ///< [Pa]
inline constexpr double deg = std::numbers::pi / 180.0;       ///< [rad]
inline constexpr double rpm = 2.0 * std::numbers::pi / 60.0;  ///< [rad/s] turns a minute
inline constexpr double m_per_h = 1.0 / 3600.0;               ///< [m/s]
inline constexpr double percent = 0.01;                       ///< [1]

// Units of the oil field. Foot, inch, pound, gallon and standard gravity are exact by definition, and so is what
// follows from them [ThompsonTaylor2008].
inline constexpr double foot = 0.3048, inch = 0.0254;      ///< [m]
inline constexpr double us_survey_foot = 1200.0 / 3937.0;  ///< [m] 2 parts in a million longer
inline constexpr double pound = 0.45359237;                ///< [kg]
inline constexpr double pound_force = 9.80665 * pound;     ///< [N] 4.448222
inline constexpr double klbf = 1e3 * pound_force;          ///< [N]
inline constexpr double ft_lbf = foot * pound_force;       ///< [N m] 1.355818
inline constexpr double lb_per_ft = pound / foot;          ///< [kg/m] 1.488164
inline constexpr double ppg =
    pound / (231 * inch * inch * inch);                     ///< [kg/m^3] 119.8264; pound per US gallon of 231 in^3
inline constexpr double psi = pound_force / (inch * inch);  ///< [Pa] 6894.757

/// The number that stood in the file: `si / unit` to 12 digits, so that 0.002 m / mm is 2 and not 2.0000000000000004.
double in_units(double si, double unit);

}  // namespace bitrock::base
