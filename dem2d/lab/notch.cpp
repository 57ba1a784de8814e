#include "dem2d/lab/notch.hpp"

#include <cmath>
#include <numbers>

namespace bitrock::dem2d {

double stress_intensity(double stress, double notch_length, double width) {
  const double a = 0.5 * notch_length, b = notch_length / width;
  const double of_strip =
      std::sqrt(1.0 / std::cos(0.5 * std::numbers::pi * b)) * (1.0 - 0.025 * b * b + 0.06 * b * b * b * b);
  return stress * std::sqrt(std::numbers::pi * a) * of_strip;
}

Notch middle_notch(const Specimen& specimen, double notch_length) {
  return {.x_low = 0.5 * (specimen.width - notch_length),
          .x_high = 0.5 * (specimen.width + notch_length),
          .y = 0.5 * specimen.height};
}

bool parts(const Notch& notch, double x1, double y1, double x2, double y2) {
  if ((y1 < notch.y) == (y2 < notch.y)) return false;
  const double x = x1 + (x2 - x1) * (notch.y - y1) / (y2 - y1);
  return notch.x_low <= x && x <= notch.x_high;
}

}  // namespace bitrock::dem2d
