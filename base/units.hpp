#pragma once
/// The units that files and messages speak, as factors to SI, and the way back. SI value = number * unit.

#include <numbers>

namespace base {

inline constexpr double um = 1e-6, mm = 1e-3;            ///< [m]
inline constexpr double MPa = 1e6, GPa = 1e9;            ///< [Pa]
inline constexpr double deg = std::numbers::pi / 180.0;  ///< [rad]

/// The number that stood in the file: `si / unit` to 12 digits, so that 0.002 m / mm is 2 and not 2.0000000000000004.
double in_units(double si, double unit);

}  // namespace base
