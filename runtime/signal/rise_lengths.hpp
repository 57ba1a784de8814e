#pragma once
/// How far the force climbs before it drops: the lengths of the pulses of a sawtooth force, from two correlation
/// lengths of the force. The mode "sawtooth" does not use it yet: its pulses still climb in proportion to their heights
/// (sawtooth_law.hpp), which is too narrow a law for deep cuts.
///
/// **Equation.** A pulse climbs over rho w^n (1 - q + q w) and drops over delta, w drawn from the density exp(-w), cut
/// off at 6, n a whole number and q from 0 to 1, and
///
///     delta = 0.4 l_s
///
/// p = n + q and rho / l are those for which the autocorrelation of the train has fallen to 3/4 at l_s and to 1/e at l.
/// With delta in the same proportion they depend on l_s / l alone: the table below, between whose rows they are linear
/// (both lags are met within 1.5 %). p = 0: all pulses are alike; 1: their lengths go as w; 2: as its square. The
/// larger p, the more short ones and the longer the longest.
///
/// **Symbols.** l [m] correlation length (lag at 1/e); l_s [m] short correlation length (lag at 3/4); rho [m];
/// p, n, q, w [1].
///
/// **Source.** Derived in docs/theory/force_signal.md, "Two lengths"; the rows are those of
/// tests/validation/rise_lengths.py, and tests/verification/rise_lengths_test.cpp finds both lags again by another
/// quadrature. The drop of 0.4 l_s and the form of the law are chosen by the spectra of 16 cuts (docs/decisions/0016).
///
/// **Validity.** l_s / l from 0.147 to 0.452; beyond, the nearest row serves (`clamped`). The cuts of the article's
/// rock have 0.19 to 0.42.

#include <algorithm>
#include <array>
#include <cstddef>

namespace bitrock::runtime {

inline constexpr double drop_share = 0.4;    ///< delta / l_s [1]
inline constexpr double most_climbed = 6.0;  ///< w at most [1]

struct RiseLengths {
  double exponent = 0.0;  ///< p [1]
  double scale = 0.0;     ///< rho [m]
  double mean = 0.0;      ///< of all rises [m]
  double longest = 0.0;   ///< rise of w = 6 [m]
  double drop = 0.0;      ///< delta [m]
  bool clamped = false;   ///< l_s / l lies outside the table
};

struct RiseRow {
  double exponent;  ///< p
  double ratio;     ///< l_s / l
  double scale;     ///< rho / l
};

inline constexpr int highest_power = 2;  ///< n at most [1]

/// Means of w^k: k! (1 - e^-6 sum over j <= k of 6^j / j!) / (1 - e^-6).
inline constexpr std::array<double, 4> mean_powers{1.0, 0.9850905300589324, 1.88072424047146, 5.105431803535949};

inline constexpr std::array<RiseRow, 26> rise_table{
    {{0.0, 0.452245, 2.484315}, {0.1, 0.450999, 2.483704}, {0.2, 0.447618, 2.475667}, {0.3, 0.441860, 2.458057},
     {0.4, 0.432680, 2.424377}, {0.5, 0.418126, 2.362591}, {0.6, 0.396058, 2.258240}, {0.7, 0.368292, 2.116327},
     {0.8, 0.340720, 1.956881}, {0.9, 0.321261, 1.794771}, {1.0, 0.312220, 1.639799}, {1.1, 0.290080, 1.378273},
     {1.2, 0.270029, 1.163915}, {1.3, 0.252860, 0.990500}, {1.4, 0.238809, 0.851220}, {1.5, 0.227693, 0.739407},
     {1.6, 0.219113, 0.649206}, {1.7, 0.212611, 0.575840}, {1.8, 0.207755, 0.515568}, {1.9, 0.204171, 0.465528},
     {2.0, 0.201557, 0.423546}, {2.1, 0.182205, 0.314367}, {2.2, 0.168547, 0.244423}, {2.3, 0.158902, 0.197361},
     {2.4, 0.152012, 0.164212}, {2.5, 0.146951, 0.139961}}};

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
                    .drop = drop_share * inside * correlation_length,
                    .clamped = inside != ratio};
  const int power = whole_power(found.exponent);
  const double share = found.exponent - power;
  found.mean = found.scale * ((1.0 - share) * mean_powers[static_cast<std::size_t>(power)] +
                              share * mean_powers[static_cast<std::size_t>(power) + 1]);
  found.longest = found.scale * unit_rise(found.exponent, most_climbed);
  return found;
}

}  // namespace bitrock::runtime
