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

/// The number that stood in the file: `si / unit` to 12 digits, so that 0.002 m / mm is 2 and not 2.0000000000000004.
double in_units(double si, double unit);

}  // namespace bitrock::base
