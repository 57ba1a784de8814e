#pragma once
/// Points that fill a box evenly, however many of them are taken: a study, or a table to learn from, that can go on.
///
/// **Equation** u_ik = frac(s_k + phi_b(i)), b the k-th prime, phi_b(i) = sum_j a_j b^(-j-1) where i = sum_j a_j b^j:
/// the digits of i behind the point, mirrored.
/// **Symbols** i = 1, 2, ... the point, k its coordinates, s_k a shift.
/// **Source** [Halton1960]; a random shift makes independent repetitions [CranleyPatterson1976].
/// **Validity** up to `most_dimensions`: of two large primes the first points lie on lines.

#include <cstdint>
#include <vector>

namespace bitrock::base {

/// Coordinates that `EvenPoints` fill well.
inline constexpr int most_dimensions = 16;

/// Points in the unit cube, one list of `dimensions` coordinates in [0, 1) a point. Seed 0: no shift; others draw it.
class EvenPoints {
 public:
  /// Of so many coordinates, from 1 to `most_dimensions`.
  explicit EvenPoints(int dimensions, std::uint64_t seed = 0);
  /// Point number `index`, from 1. The same for the same seed on every machine.
  std::vector<double> point(std::int64_t index) const;

 private:
  std::vector<double> shifts_;
};

/// Stretched so that 4 % of evenly spread numbers become 0 and 4 % become 1: points on the faces of the box, where what
/// is learnt between points would otherwise have to go on beyond the last one.
double with_ends(double evenly);

}  // namespace bitrock::base
