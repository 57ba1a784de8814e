#include "dem2d/lab/strain.hpp"

#include <cstddef>

namespace bitrock::dem2d {

DisplacementGradient fit_gradient(std::span<const double> start_x, std::span<const double> start_y,
                                  std::span<const double> x, std::span<const double> y) {
  const std::size_t count = start_x.size();
  double mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    mean_x += start_x[i];
    mean_y += start_y[i];
  }
  mean_x /= static_cast<double>(count);
  mean_y /= static_cast<double>(count);

  double sxx = 0.0, sxy = 0.0, syy = 0.0, ux = 0.0, uy = 0.0, vx = 0.0, vy = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = start_x[i] - mean_x, dy = start_y[i] - mean_y;
    const double u = x[i] - start_x[i], v = y[i] - start_y[i];
    sxx += dx * dx;
    sxy += dx * dy;
    syy += dy * dy;
    ux += u * dx;
    uy += u * dy;
    vx += v * dx;
    vy += v * dy;
  }
  const double determinant = sxx * syy - sxy * sxy;
  return {.xx = (ux * syy - uy * sxy) / determinant,
          .xy = (uy * sxx - ux * sxy) / determinant,
          .yx = (vx * syy - vy * sxy) / determinant,
          .yy = (vy * sxx - vx * sxy) / determinant};
}

}  // namespace bitrock::dem2d
