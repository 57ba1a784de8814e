#pragma once
/// The law of the sawtooth force of one cutter: from mean, standard deviation, correlation length and correlation of
/// the two components to the numbers that its events are drawn with. Everything follows in closed form. What draws the
/// events is in `sawtooth_cell.hpp`, what makes a force of them in `sawtooth_force.hpp`.

#include <algorithm>
#include <cstdint>

#include "runtime/signal/force_moments.hpp"
#include "runtime/signal/settings.hpp"
#include "runtime/signal/tallies.hpp"

namespace bitrock::runtime {

/// Heights g above this count as this: a pulse then ends a known way behind its beginning.
inline constexpr double highest_unit = 8.0;

/// No pulse rises over less than this share of the length of its fall: below, the correlation length is made by the
/// fall alone.
inline constexpr double shortest_rise = 1.0 / 1.2;

/// Of the fit of the correlation length, `sawtooth_law`.
inline constexpr double length_of_rise = 1.3219, length_of_drop = 0.2650;

/// What the events of one window of one cutter are drawn with. Angles, because that is what a bit turns.
struct SawtoothLaw {
  double density = 0.0;     ///< [1/rad] events, of whatever kind
  double both_below = 0.0;  ///< [1] share of the events that are felt in x and y
  double x_below = 0.0;     ///< [1] the same and the share of those felt in x alone; the rest is felt in y alone
  double x_height = 0.0;    ///< [N/m] a of x
  double y_height = 0.0;    ///< [N/m] a of y
  double rise = 0.0;        ///< [rad] rho: a pulse of height g rises over rho g
  double drop = 0.0;        ///< [rad] delta
  double highest = 0.0;     ///< [1] c
  std::int64_t cells = 1;   ///< equal parts of the window that are drawn one after the other
  double cell = 0.0;        ///< [rad] length of one
};

/// Most events that are expected in a cell of each component; together with `most_in_cell` of sawtooth_cell.hpp this
/// leaves eight standard deviations of their number as room.
inline constexpr double most_expected = 100.0;

/// Events of a cell where there may be fewer: many enough that a new cell is seldom.
inline constexpr double usual_expected = 48.0;

/// [rad] delta on the path of a cutter, at most half a window.
inline double drop_angle(const SignalSettings& settings, double path_radius) {
  return std::min(settings.drop_length / path_radius, 0.5 * settings.window_angle);
}

/// **What** The law whose force has the wanted moments.
/// **Equation** Events lie on the path as the points of a Poisson process; one that begins at b with the height g makes
///
///     a g S((s - b) / (rho g))  on the way up,   a g S(1 - (s - b - rho g) / delta)  on the way down,
///
/// g = min(-ln u, c). With G_n = E[g^n] = n! (1 - e^-c sum over k < n of c^k / k!), the area and the square of a pulse
/// of a = 1 are in the mean
///
///     m1 = (rho G_2 + delta G_1) / 2,   m2 = I2 (rho G_3 + delta G_2),   I2 = 181/462.
///
/// Campbell's theorem: mean = lambda a m1, variance = lambda a^2 m2; so, for each component,
///
///     lambda = mean^2 m2 / (sd^2 m1^2),   a = mean / (lambda m1).
///
/// Events come in three kinds: felt in x and y with one g (lambda_b a metre), in x alone (lambda_x - lambda_b), in y
/// alone (lambda_y - lambda_b). Kinds are independent, so the covariance is lambda_b a_x a_y m2 and the correlation
///
///     r = lambda_b / sqrt(lambda_x lambda_y),   0 <= r <= min(sd / mean) / max(sd / mean).
///
/// rho = (l - 0.2650 delta) / 1.3219, l the correlation length.
/// **Symbols** s [m] way of the cutter; S `smooth_unit_step` of step5.hpp; lambda [1/m] events; a [N/m]; rho, delta
/// [m]; u uniform in (0, 1]; c [1] `highest_unit`; r [1] correlation of x and y.
/// **Source** [Campbell1909; not consulted], [Rice1944; not consulted] for the moments of such a process. The pulse, a
/// sawtooth that rises slowly and falls over a tenth of a grain, and its exponential heights are ours: they came out
/// best of some twenty-five forms against forces of the DEM. Derived in docs/theory/force_signal.md.
/// **Differences and validity** The fit of rho gives the lag at which the exact autocorrelation is 1/e within 0.6 % for
/// delta up to 1.2 rho; below that l (1.37 delta) rho stays delta / 1.2 (`length_clamped`). r out of reach becomes the
/// nearest that can be had (`correlation_clamped`). A window as long as no pulse lowers c, with mean and deviation kept
/// and l only nearly (`narrowed`). A force so steady that more than `most_expected` events would be needed in a cell
/// (sd / mean below some 0.4) keeps its mean and scatters more (`capped`). A component without a mean has no events.
/// Moments must be finite; negative ones count as 0. `path_radius` [m] and window angle above 0.
SawtoothLaw sawtooth_law(const ForceMoments& moments, const SignalSettings& settings, double path_radius,
                         DrawTally& tally);

}  // namespace bitrock::runtime
