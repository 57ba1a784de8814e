#include "studies/well/bending_magnification.hpp"

#include <cmath>
#include <numbers>

namespace bitrock::studies {

namespace {

/// `stand` [1] is g / (kappa L^2).
double pulled(double u, double stand) {
  const double half = 0.5 * u, missing = 0.5 - std::tanh(half) / u;
  if (missing <= stand) return u / std::tanh(u);
  const double lies = u * std::sqrt(0.5 * stand);  // sqrt(g T / (2 kappa EI))
  constexpr double hardly = 0.05;                  // what touches bends by 1e-4 less than this, and digits go
  if (u < hardly || lies <= half / std::tanh(half) - 1.0) return 1.0 + 2.0 * lies;
  constexpr double endless = 100.0;  // cosh u and sinh u are the same, and soon too large
  if (u > endless) return u * (u * (0.5 + stand) - 1.0) / (u - 2.0);
  const double c = std::cosh(u), s = std::sinh(u);
  return (u * s - u * u * c + u * u * (0.5 - stand) * (c - 1.0)) / (2.0 * (c - 1.0) - u * s);
}

double pushed(double u, double stand) {
  // the push at which the body touches, or that of the pipe where it is less
  double low = 0.0, high = std::fmin(u, std::numbers::pi * (1.0 - 1e-9));
  const auto is_free = [stand](double v) { return std::tan(0.5 * v) / v - 0.5 <= stand; };
  if (is_free(high)) return high / std::sin(high);
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    (is_free(middle) ? low : high) = middle;
  }
  return low > 0.0 ? low / std::sin(low) : 1.0;
}

}  // namespace

double bending_magnification(const BetweenToolJoints& pipe, double tension, double curvature) {
  const double u = std::sqrt(std::fabs(tension) / pipe.bending_stiffness) * pipe.half_distance;
  constexpr double nothing = 1e-3;  // B is 1 + u^2 / 3 there, or + u^2 / 6
  if (u < nothing) return 1.0;
  const double sag = curvature * pipe.half_distance * pipe.half_distance;
  if (!(sag > 0.0)) return tension > 0.0 ? u / std::tanh(u) : 1.0;  // B of no bending has no say
  const double stand = pipe.stand_off / sag;
  return tension > 0.0 ? pulled(u, stand) : pushed(u, stand);
}

}  // namespace bitrock::studies
