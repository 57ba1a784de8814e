#pragma once
/// How a top drive gives way to the string, so that it does not throw back every torsional wave: speed control that is
/// tuned as a spring and a damper.

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace bitrock::runtime {

inline constexpr double usual_drive_inertia = 2900.0;  ///< [kg m^2] of a top drive with its motors [Simulator4nDOF]

/// **What** The drive as the string feels it: an inertia that a spring and a damper pull along with the set speed.
/// **Equation** J w' = C (W - w) + k (Phi - phi) - T. Towards the string it is an impedance Z = C + i (J w - k / w).
/// A wave on a string of impedance zeta = sqrt(rho G) j comes back from it by the factor r = (Z - zeta) / (Z + zeta).
/// **Symbols** w, phi [rad/s, rad] of the drive; W, Phi what is set; T [N m] of the drive on the string; C is the
/// proportional, k the integral gain of a PI control of speed; w in Z: angular frequency [rad/s]; rho [kg/m^3], G [Pa],
/// j [m^4] of the pipe at the top.
/// **Source** waves and impedances: textbooks. Torque feedback against stick-slip [HalseyKyllingstadKylling1988], PI
/// tuned to the stick-slip frequency [KyllingstadNessjoen2009], impedance of the string at all frequencies
/// [Dwars2015]; the rules below are derived here.
/// **Validity** Linear: no limit of torque or speed of the motor, no delay of measuring. A stiff drive has no control.
struct DriveControl {
  double inertia = 0.0;    ///< J [kg m^2]; 0: the drive is stiff, its speed is imposed
  double damping = 0.0;    ///< C [N m s/rad]
  double stiffness = 0.0;  ///< k [N m/rad]
};

/// **What** Soft torque: k cancels the inertia at the period of stick-slip, so that the string feels C there.
/// **Equation** k = J (2 pi / T)^2; C = max(zeta, sqrt(32 J zeta / T)) where none is asked for.
/// **Symbols** T [s] slowest period of the string that hangs from a drive at rest, 4 L / c for uniform pipe.
/// **Source** derived here: at the distance d from w1 = 2 pi / T the top of a uniform string that is free below has the
/// impedance -4 i zeta / (T d), and the drive C + 2 i J d. Free vibration needs 2 i J d^2 + C d - 4 i zeta / T = 0; the
/// slower of its two modes decays fastest where both decay alike, C^2 = 32 J zeta / T, at the rate C / 4J.
/// **Validity** C well above zeta: drives that are heavy beside the string. zeta itself where that is more: then no
/// wave of that period comes back.
inline DriveControl soft_torque(double inertia, double impedance, double period) {
  const double frequency = 2.0 * std::numbers::pi / period;
  return {.inertia = inertia,
          .damping = std::max(impedance, std::sqrt(32.0 * inertia * impedance / period)),
          .stiffness = inertia * frequency * frequency};
}

/// **What** Matched: a fast control follows W - (T - mean of T) / zeta, so that no wave comes back.
/// **Equation** C = zeta, J = zeta t, k = zeta / (2 T).
/// **Symbols** t [s] how late the drive follows; 2 T [s] the time over which the mean of T is taken: with that mean,
/// the drive comes back to the set speed.
/// **Source** derived here: w = W - (T - T_m) / zeta with T_m the mean of a low-pass filter of time 2 T is the drive
/// with J = 0 and k = zeta / 2T; a first-order delay t of w is J = zeta t.
/// **Validity** |r| is about (w t - 1 / (2 T w)) / 2: small from the first period of the string up to 1 / t.
inline DriveControl matched(double impedance, double period, double reaction_time) {
  return {.inertia = impedance * reaction_time, .damping = impedance, .stiffness = impedance / (2.0 * period)};
}

/// Z [N m s/rad] at an angular frequency above 0.
inline std::complex<double> impedance_of(const DriveControl& drive, double frequency) {
  return {drive.damping, drive.inertia * frequency - drive.stiffness / frequency};
}

/// r [1] of the wave of rotation that comes up a string of this impedance.
inline std::complex<double> reflection_of(const DriveControl& drive, double impedance, double frequency) {
  const std::complex<double> z = impedance_of(drive, frequency);
  return (z - impedance) / (z + impedance);
}

}  // namespace bitrock::runtime
