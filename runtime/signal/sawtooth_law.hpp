#pragma once
/// The law of the sawtooth force of one cutter: from mean, standard deviation, two correlation lengths and correlation
/// of the two components to the numbers that its pulses are drawn with. Everything follows in closed form. What draws
/// the pulses is in `sawtooth_cell.hpp`, what makes the load on a bit of them in `felt_pulses.hpp`.

#include <cstdint>

#include "runtime/signal/force_moments.hpp"
#include "runtime/signal/settings.hpp"
#include "runtime/signal/tallies.hpp"

namespace bitrock::runtime {

/// [m] Correlation lengths below this count as this, and are counted (`length_clamped`): a fiftieth of a small grain.
inline constexpr double shortest_length = 1e-6;

/// What the pulses of one window of one cutter are drawn with. Angles, because that is what a bit turns.
struct SawtoothLaw {
  double density = 0.0;       ///< [1/rad] pulses, of whatever kind
  double both_below = 0.0;    ///< [1] share of the pulses that are felt in x and y
  double x_below = 0.0;       ///< [1] the same and the share of those felt in x alone; the rest is felt in y alone
  double x_height = 0.0;      ///< [N/m] a of x
  double y_height = 0.0;      ///< [N/m] a of y
  int power = 0;              ///< n [1]: a pulse climbs over least_rise + rise w^n (1 - part + part w)
  double part = 0.0;          ///< q [1]
  double rise = 0.0;          ///< [rad] rho
  double least_rise = 0.0;    ///< [rad]
  double drop = 0.0;          ///< [rad] delta
  double mean_gap = 0.0;      ///< [rad] 1 / density
  double inverse_drop = 0.0;  ///< [1/rad]
  std::int64_t cells = 1;     ///< equal parts of the window that are drawn one after the other
  double cell = 0.0;          ///< [rad] length of one; no pulse is longer
};

/// Most pulses that are expected in a cell of each component; together with `most_in_cell` of sawtooth_cell.hpp this
/// leaves eight standard deviations of their number as room.
inline constexpr double most_expected = 390.0;

/// Pulses of a cell where there may be fewer: many enough that a new cell is seldom.
inline constexpr double usual_expected = 128.0;

/// **What** The law whose force has the wanted moments.
/// **Equation** Pulses begin on the path at the points of a Poisson process; one that begins at b makes
///
///     a g S((s - b) / h)  on the way up,   a g S(1 - (s - b - h) / delta)  on the way down,
///
/// with a height g drawn from exp(-g) and a rise h = delta / 10 + rho w^n (1 - q + q w), w drawn from exp(-w), cut off
/// at 6. The two correlation lengths give rho, n, q and delta (`rise_lengths.hpp`). As E[g] = 1, E[g^2] = 2 and g does
/// not depend on h, Campbell's theorem says, with I2 = 181/462 the integral of S^2,
///
///     mean = lambda a (E[h] + delta) / 2,   variance = 2 lambda a^2 I2 (E[h] + delta);   so, for each component,
///
///     a = sd^2 / (4 I2 mean),   lambda = 2 mean / (a (E[h] + delta)).
///
/// Pulses come in three kinds: felt in x and y with one g (lambda_b a metre), in x alone (lambda_x - lambda_b), in y
/// alone (lambda_y - lambda_b). Kinds are independent, so the correlation is
///
///     r = lambda_b / sqrt(lambda_x lambda_y),   0 <= r <= min(sd / mean) / max(sd / mean).
///
/// **Symbols** s [m] way of the cutter; S `smooth_unit_step` of step5.hpp; lambda [1/m] pulses; a [N/m]; rho, h, delta
/// [m]; g, w, q, n [1]; r [1] correlation of x and y.
/// **Source** [Campbell1909; not consulted], [Rice1944; not consulted] for the moments of such a process. The pulse, a
/// sawtooth that climbs slowly and drops quickly, exponential heights and lengths of two kinds are ours: they came out
/// best of some thirty forms against forces of the DEM (docs/decisions/0016). Derived in docs/theory/force_signal.md.
/// **Differences and validity** Mean, deviations and correlation are exact; both lags are met within 1.5 %. Two
/// lengths whose ratio no train has, and lengths below `shortest_length`, become the nearest that can be had
/// (`length_clamped`). r out of reach becomes the nearest that can be had (`correlation_clamped`). A window shorter
/// than the longest pulse makes rises shorter, with mean and deviations kept (`narrowed`). A force so steady that more
/// than `most_expected` pulses would be needed in a cell keeps its mean and scatters more (`capped`): with lengths
/// alike (l_s / l = 0.3) below sd / mean of some 0.25, with mixed ones (0.2) of 0.4. A component without a mean has no
/// pulses. Moments must be finite; negative ones count as 0. `path_radius` [m] and window angle above 0.
SawtoothLaw sawtooth_law(const ForceMoments& moments, const SignalSettings& settings, double path_radius,
                         DrawTally& tally);

}  // namespace bitrock::runtime
