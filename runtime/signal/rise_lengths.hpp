#pragma once
/// How far the force climbs before it drops: the lengths of the pulses of a sawtooth force (sawtooth_law.hpp), from two
/// correlation lengths of the force.
///
/// **Equation.** A pulse climbs over delta / 10 + rho w^n (1 - q + q w) and drops over delta, w drawn from the density
/// exp(-w), cut off at 6, n a whole number and q from 0 to 1, and
///
///     delta = 0.4 l_s
///
/// p = n + q and rho / l are those for which the autocorrelation of the train has fallen to 3/4 at l_s and to 1/e at l.
/// With delta in the same proportion they depend on l_s / l alone: the table below, between whose rows they are linear
/// (both lags are met within 1.5 %). p = 0: all pulses are alike; 1: their lengths go as w; 2: as its square. The
/// larger p, the more short ones and the longer the longest. The tenth of delta keeps a force from jumping: with p = 2
/// a tenth of the pulses would climb over less than a hundredth of rho.
///
/// **Symbols.** l [m] correlation length (lag at 1/e); l_s [m] short correlation length (lag at 3/4); rho [m];
/// p, n, q, w [1].
///
/// **Source.** Derived in docs/theory/force_signal.md, "Two lengths"; the rows are those of
/// tests/validation/rise_lengths.py, and tests/verification/rise_lengths_test.cpp finds both lags again by another
/// quadrature. The drop of 0.4 l_s and the form of the law are chosen by the spectra of 16 cuts (docs/decisions/0016).
///
/// **Validity.** l_s / l from 0.145 to 0.452; beyond, the nearest row serves (`clamped`). The cuts of the article's
/// rock have 0.19 to 0.42.

#include <algorithm>
#include <array>
#include <cstddef>

namespace bitrock::runtime {

inline constexpr double drop_share = 0.4;                   ///< delta / l_s [1]
inline constexpr double least_share = 0.1;                  ///< of delta, that every pulse climbs over [1]
inline constexpr double most_climbed = 6.0;                 ///< w at most [1]
inline constexpr double least_unit = 0.002478752176666358;  ///< exp(-most_climbed)

struct RiseLengths {
  double exponent = 0.0;  ///< p [1]
  double scale = 0.0;     ///< rho [m]
  double least = 0.0;     ///< rise of w = 0, where p is not 0 [m]
  double mean = 0.0;      ///< of all rises [m]
  double longest = 0.0;   ///< rise of w = 6 [m]
  double drop = 0.0;      ///< delta [m]
  bool clamped = false;   ///< l_s / l lies outside the table
};

/// One row of the table.
struct RiseRow {
  double exponent;  ///< p
  double ratio;     ///< l_s / l
  double scale;     ///< rho / l
};

inline constexpr int highest_power = 2;  ///< n at most [1]

/// Means of w^k: k! (1 - e^-6 sum over j <= k of 6^j / j!) / (1 - e^-6).
inline constexpr std::array<double, 4> mean_powers{1.0, 0.9850905300589324, 1.88072424047146, 5.105431803535949};

/// Falling in l_s / l, rising in p by 0.1; from tests/validation/rise_lengths.py.
inline constexpr std::array<RiseRow, 26> rise_table{
    {{0.0, 0.452245, 2.466225}, {0.1, 0.451016, 2.465695}, {0.2, 0.447683, 2.457934}, {0.3, 0.442015, 2.440894},
     {0.4, 0.433005, 2.408337}, {0.5, 0.418762, 2.348689}, {0.6, 0.397136, 2.247647}, {0.7, 0.369697, 2.109010},
     {0.8, 0.342119, 1.952256}, {0.9, 0.322168, 1.792166}, {1.0, 0.312611, 1.638638}, {1.1, 0.290485, 1.379017},
     {1.2, 0.270375, 1.165886}, {1.3, 0.253076, 0.993167}, {1.4, 0.238843, 0.854220}, {1.5, 0.227512, 0.742518},
     {1.6, 0.218706, 0.652302}, {1.7, 0.211977, 0.578856}, {1.8, 0.206902, 0.518475}, {1.9, 0.203112, 0.468312},
     {2.0, 0.200310, 0.426201}, {2.1, 0.180837, 0.316753}, {2.2, 0.167037, 0.246489}, {2.3, 0.157240, 0.199148},
     {2.4, 0.150182, 0.165785}, {2.5, 0.144997, 0.141332}}};

/// n.
inline int whole_power(double exponent) {
  return std::min(static_cast<int>(exponent), highest_power);
}

/// w^n (1 - q + q w).
inline double unit_rise(double exponent, double w) {
  const int power = whole_power(exponent);
  const double part = exponent - power, last = 1.0 - part + part * w;
  return power == 0 ? last : power == 1 ? w * last : w * w * last;
}

/// Both lengths are finite and above 0; in any unit, which is that of the result.
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
                    .drop = drop_share * inside * correlation_length,
                    .clamped = inside != ratio};
  found.least = least_share * found.drop;
  const int power = whole_power(found.exponent);
  const double share = found.exponent - power;
  found.mean = found.least + found.scale * ((1.0 - share) * mean_powers[static_cast<std::size_t>(power)] +
                                            share * mean_powers[static_cast<std::size_t>(power) + 1]);
  found.longest = found.least + found.scale * unit_rise(found.exponent, most_climbed);
  return found;
}

/// All lengths times this.
inline RiseLengths shortened(const RiseLengths& lengths, double factor) {
  RiseLengths found = lengths;
  for (double* const length : {&found.scale, &found.least, &found.mean, &found.longest, &found.drop}) *length *= factor;
  return found;
}

}  // namespace bitrock::runtime
