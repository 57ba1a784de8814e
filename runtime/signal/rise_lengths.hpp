#pragma once
/// How far the force climbs before it drops: the lengths of the pulses of a sawtooth force, from two correlation
/// lengths of the force.
///
/// **Equation.** A pulse climbs over rho w^p and drops over delta, w drawn from the density exp(-w), cut off at 6, and
///
///     delta = 0.4 l_s
///
/// p and rho / l are those for which the autocorrelation of the train has fallen to 3/4 at l_s and to 1/e at l. With
/// delta in the same proportion they depend on l_s / l alone: the table below, between whose rows they are linear.
/// p = 0: all pulses are alike; the larger p, the more short ones and the longer the longest.
///
/// **Symbols.** l [m] correlation length (lag at 1/e); l_s [m] short correlation length (lag at 3/4); rho [m]; p, w
/// [1].
///
/// **Source.** Derived in docs/theory/force_signal.md; the rows are those of tests/validation/rise_lengths.py, and
/// tests/verification/rise_lengths_test.cpp finds both lags again by another quadrature. The drop of 0.4 l_s and the
/// form of the law are chosen by the spectra of 16 cuts (docs/decisions/0016).
///
/// **Validity.** l_s / l from 0.171 to 0.452; beyond, the nearest row serves (`clamped`). The cuts of the article's
/// rock have 0.19 to 0.42.

#include <array>
#include <cmath>

namespace bitrock::runtime {

inline constexpr double drop_share = 0.4;    ///< delta / l_s [1]
inline constexpr double most_climbed = 6.0;  ///< w at most [1]

struct RiseLengths {
  double exponent = 0.0;  ///< p [1]
  double scale = 0.0;     ///< rho [m]
  double mean = 0.0;      ///< of rho w^p [m]
  double longest = 0.0;   ///< rho 6^p [m]
  double drop = 0.0;      ///< delta [m]
  bool clamped = false;   ///< l_s / l lies outside the table
};

struct RiseRow {
  double exponent;  ///< p
  double ratio;     ///< l_s / l
  double scale;     ///< rho / l
  double mean;      ///< mean rise / l
};

inline constexpr std::array<RiseRow, 25> rise_table{
    {{0.0, 0.452245, 2.484315, 2.484315}, {0.1, 0.449342, 2.601151, 2.472910}, {0.2, 0.440178, 2.653695, 2.432877},
     {0.3, 0.426203, 2.641567, 2.364874}, {0.4, 0.409775, 2.574740, 2.276246}, {0.5, 0.392496, 2.465453, 2.174209},
     {0.6, 0.375233, 2.325389, 2.064403}, {0.7, 0.358423, 2.164863, 1.951003}, {0.8, 0.342272, 1.992593, 1.837030},
     {0.9, 0.326864, 1.815701, 1.724642}, {1.0, 0.312220, 1.639799, 1.615350}, {1.1, 0.298329, 1.469146, 1.510184},
     {1.2, 0.285162, 1.306821, 1.409813}, {1.3, 0.272684, 1.154906, 1.314640}, {1.4, 0.260857, 1.014663, 1.224867},
     {1.5, 0.249644, 0.886699, 1.140547}, {1.6, 0.239006, 0.771117, 1.061627}, {1.7, 0.228910, 0.667638, 0.987972},
     {1.8, 0.219324, 0.575717, 0.919395}, {1.9, 0.210216, 0.494632, 0.855679}, {2.0, 0.201556, 0.423546, 0.796573},
     {2.1, 0.193330, 0.361562, 0.741798}, {2.2, 0.185501, 0.307785, 0.691092}, {2.3, 0.178054, 0.261350, 0.644222},
     {2.4, 0.170952, 0.221412, 0.600917}}};

/// Both lengths are finite and above 0.
inline RiseLengths rise_lengths(double correlation_length, double short_correlation_length) {
  const double ratio = short_correlation_length / correlation_length;
  const double highest = rise_table.front().ratio, lowest = rise_table.back().ratio;
  const double inside = ratio > highest ? highest : ratio < lowest ? lowest : ratio;
  std::size_t row = 1;
  while (row + 1 < rise_table.size() && rise_table[row].ratio > inside) ++row;
  const RiseRow &above = rise_table[row - 1], &below = rise_table[row];
  const double part = (above.ratio - inside) / (above.ratio - below.ratio);
  const auto between = [part](double a, double b) { return a + part * (b - a); };
  RiseLengths found{.exponent = between(above.exponent, below.exponent),
                    .scale = correlation_length * between(above.scale, below.scale),
                    .mean = correlation_length * between(above.mean, below.mean),
                    .drop = drop_share * inside * correlation_length,
                    .clamped = inside != ratio};
  found.longest = found.scale * std::pow(most_climbed, found.exponent);
  return found;
}

}  // namespace bitrock::runtime
