#pragma once
/// The smooth step of degree five and the pulse made of two of them: the shape of one force peak. It exists because a
/// solver of equations of motion needs a force without jumps in value, slope or curvature. It knows nothing of forces
/// or angles.

namespace bitrock::runtime {

/// **What** Smooth step from 0 to 1 on the unit interval, the core of both functions below.
/// **Equation** S(s) = s^3 (10 - 15 s + 6 s^2), 0 <= s <= 1; S' = 30 s^2 (1 - s)^2, S'' = 60 s (1 - s)(1 - 2 s).
/// **Symbols** s [1].
/// **Source** [BitRock2026, sec. 3.3]; the same polynomial in [Perlin2002].
/// **Differences and validity** S(1 - s) = 1 - S(s), integral 1/2, integral of the square 181/462, largest slope 15/8
/// in the middle. S' = S'' = 0 at both ends, so pieces join with continuous curvature. Not clamped: callers keep s
/// inside. The bracket has no real root, hence S >= 0 for s >= 0 to the last bit.
inline double smooth_unit_step(double s) {
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

/// **What** Step from y0 at x0 to y1 at x1.
/// **Equation** y0 for x <= x0; y0 + (y1 - y0) S((x - x0) / (x1 - x0)) for x0 < x < x1; y1 for x >= x1.
/// **Symbols** x, x0, x1 one unit; y0, y1 another.
/// **Source** [BitRock2026, sec. 3.3], "STEP5".
/// **Validity** x0 < x1. Twice continuously differentiable everywhere.
inline double step5(double x, double x0, double y0, double x1, double y1) {
  if (x <= x0) return y0;
  if (x >= x1) return y1;
  return y0 + (y1 - y0) * smooth_unit_step((x - x0) / (x1 - x0));
}

/// **What** Pulse of height 1 at R with half-width h: one step up followed by one step down.
/// **Equation** step5(x, R - h, 0, R, 1) - step5(x, R, 0, R + h, 1) = S(1 - |x - R| / h) inside, 0 outside.
/// **Symbols** `distance` = x - R and h in one unit; `inverse_half_width` = 1 / h.
/// **Source** [BitRock2026, sec. 3.3], the sum of its two steps.
/// **Differences and validity** The right-hand form needs one polynomial and is never negative. h > 0. Integral h,
/// integral of the square 2 h 181/462, largest slope 15 / (8 h).
inline double unit_pulse(double distance, double inverse_half_width) {
  const double s = 1.0 - (distance < 0.0 ? -distance : distance) * inverse_half_width;
  return s > 0.0 ? smooth_unit_step(s) : 0.0;
}

}  // namespace bitrock::runtime
