#pragma once
/// Friction between bit and rock as a function of the rotation: the article's smooth law, and one that truly sticks
/// (`karnopp.hpp` says when). Both only give a coefficient; weight and arm make a torque of it. They hold no state.

#include <cmath>

namespace bitrock::runtime {

/// Constants of the smooth law. Recalled from the literature on bit friction [YigitChristoforou2006], not verified:
/// values to calibrate, not properties of a rock. The article prints none.
struct SmoothFriction {
  double mu0 = 0.06;   ///< [1] scales the whole law
  double alpha = 2.0;  ///< [s/rad] height of the hump at low speed
  double beta = 1.0;   ///< [(s/rad)^(2 gamma)] where the hump ends
  double gamma = 1.0;  ///< [1] how fast it falls
  double nu = 0.01;    ///< [s/rad] viscous share
};

/// **What** Friction coefficient that is zero at rest, rises steeply, falls with speed, and rises slowly again.
/// **Equation** mu(x) = mu0 (tanh x + alpha x / (1 + beta |x|^(2 gamma)) + nu x).
/// **Symbols** x [rad/s] rotation of the bit, any sign; mu [1].
/// **Source** [BitRock2026, sec. 3.5], whose print has "tan" and no brackets: only this reading is bounded and gives
/// coefficients of the size of friction. The bracket stands so in [LoboTorsional, fun_Tbit.m], with other constants.
/// **Differences and validity** Odd. Nothing ever sticks: at a torque below the hump the bit creeps. With the default
/// constants friction falls with speed, and so feeds torsional vibration, between 13.5 and 134 rpm.
inline double friction_coefficient(const SmoothFriction& law, double x) {
  const double hump = law.alpha * x / (1.0 + law.beta * std::pow(std::abs(x), 2.0 * law.gamma));
  return law.mu0 * (std::tanh(x) + hump + law.nu * x);
}

/// Its slope: mu'(x) = mu0 (1 - tanh^2 x + alpha (1 + (1 - 2 gamma) b) / (1 + b)^2 + nu), b = beta |x|^(2 gamma)
/// [s/rad].
inline double friction_slope(const SmoothFriction& law, double x) {
  const double t = std::tanh(x), b = law.beta * std::pow(std::abs(x), 2.0 * law.gamma);
  return law.mu0 * (1.0 - t * t + law.alpha * (1.0 + (1.0 - 2.0 * law.gamma) * b) / ((1.0 + b) * (1.0 + b)) + law.nu);
}

/// Constants of the law that sticks, as published with a four-disc drill string [ChengWuChen2018, drillstring.m].
struct StribeckFriction {
  double resting = 0.8;  ///< [1] mu_s: coefficient that must be overcome to leave rest
  double sliding = 0.5;  ///< [1] mu_c: coefficient at high speed
  double decay = 0.9;    ///< [s/rad] gamma_b / v_f: how fast it falls from one to the other
};

/// **What** Size of the friction coefficient while sliding.
/// **Equation** mu(x) = mu_c + (mu_s - mu_c) exp(-(gamma_b / v_f) |x|).
/// **Symbols** x [rad/s]; mu, mu_s, mu_c [1].
/// **Source** [ChengWuChen2018, drillstring.m].
/// **Validity** Always above 0; the direction is that of sliding.
inline double friction_coefficient(const StribeckFriction& law, double x) {
  return law.sliding + (law.resting - law.sliding) * std::exp(-law.decay * std::abs(x));
}

/// Its slope for x > 0 [s/rad].
inline double friction_slope(const StribeckFriction& law, double x) {
  return -law.decay * (law.resting - law.sliding) * std::exp(-law.decay * std::abs(x));
}

}  // namespace bitrock::runtime
