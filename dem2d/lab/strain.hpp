#pragma once
/// The mean strain of a group of discs: the slopes of the planes that fit their displacements best.
///
/// **Equation.** For displacements u at reference places X, least squares of u = a + G (X - mean X):
///
///     G = U S^-1,   S = sum (X - mean X) (X - mean X)^T,   U = sum u (X - mean X)^T
///
/// **Symbols.** X, u [m]; G [1] displacement gradient: G_xx and G_yy are the strains along x and y (small strain).
///
/// **Differences and validity.** Exact for a uniform gradient, whatever the places; rigid motion gives zero strain (a
/// rotation only to first order). Needs three discs that do not lie on one line.

#include <span>

namespace bitrock::dem2d {

struct DisplacementGradient {
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  ///< first letter: of the displacement; second: of the slope [1]
};

/// The four spans are of one length; (x, y) are the places now, (start_x, start_y) those at the start [m].
DisplacementGradient fit_gradient(std::span<const double> start_x, std::span<const double> start_y,
                                  std::span<const double> x, std::span<const double> y);

}  // namespace bitrock::dem2d
