#pragma once
/// One angular window of one cutter, drawn: where its peaks lie, how high and how wide they are. It has room for any
/// number of them. What force they make is in `pulse_train.hpp`.

#include "runtime/signal/fixed_list.hpp"
#include "runtime/signal/peak_amplitudes.hpp"
#include "runtime/signal/peak_counts.hpp"
#include "runtime/signal/peak_statistics.hpp"
#include "runtime/signal/pulse_train.hpp"
#include "runtime/signal/settings.hpp"

namespace bitrock::runtime {

/// One component of a drawn window.
struct ComponentDraw {
  PeakCounts counts;        ///< that were drawn
  FitOutcome fit;           ///< of the amplitudes
  double half_width = 0.0;  ///< [rad] h; 0 when there are no peaks
  bool narrowed = false;    ///< h is one window and should be more
};

/// A peak of both components: they share its angle.
struct Peak {
  double angle = 0.0;  ///< [rad] R, from the beginning of the window
  double x = 0.0;      ///< [N/m]
  double y = 0.0;      ///< [N/m]
};

/// The peaks of one window, and what came of the wishes for each component.
struct PeakWindow {
  FixedList<Peak, largest_peak_count> peaks;  ///< highest of x first, then by bands of x
  ComponentDraw x;                            ///< cutting direction
  ComponentDraw y;                            ///< out of the rock
};

/// **What** Draws the window of address `key` into `window`.
/// **Equation** R_i = theta_T u_i, i = 1..N; heights as in `draw_amplitudes`; h = f theta_T / (2 nu), at most theta_T.
/// **Symbols** N peaks of a component, nu expected; u_i uniform in [0, 1); R_i [rad]; f [1]; theta_T [rad]; h [rad].
/// **Source** R_i: [BitRock2026, sec. 3.3], where the listing fills A[] but the text says R[].
/// **Differences and validity** The article gives no pulse width. Here a pulse covers f / (np1 + np23 + np4) metres of
/// cut, whatever the window: with f = 1 the pulses, laid side by side, just fill the windows. The two components count
/// separately; peak i of both has angle R_i, and as counting starts at the top band their high peaks fall together.
/// Statistics must be `usable`; `path_radius` [m] above 0.
/// With overlapping pulses added up a window gives the mean force h sum A_i / theta_T, and as sum A_i has the mean
/// nu Amean over the windows, all of them together give f Amean / 2, for any length of window. Only where nu < f / 2
/// would a pulse reach beyond the next window: it is `narrowed`, and the mean force is smaller by the factor 2 nu / f.
void draw_window(PeakWindow& window, const CutterStatistics& statistics, double path_radius,
                 const SignalSettings& settings, const WindowKey& key);

/// Puts the pulses of the window into `train`, whose angle 0 lies `shift` [rad] before the beginning of the window;
/// only those felt between 0 and theta_T. Call `restart` after the last.
void put_pulses(const PeakWindow& window, double shift, double window_angle, PulseTrain& train);

}  // namespace bitrock::runtime
