#pragma once
/// The force history of one cutter, per metre of its width, as a function of the angle the bit has cut through. It
/// holds the few windows whose pulses can be felt at that angle. It does not know the bit, the rock or the network:
/// whoever owns it gives the statistics when a window comes into reach. One block of bytes without pointers; takes no
/// memory, throws nothing.

#include <array>
#include <cstdint>

#include "runtime/signal/peak_window.hpp"
#include "runtime/signal/tallies.hpp"
#include "runtime/signal/window_memory.hpp"

namespace bitrock::runtime {

/// All that a cutter remembers. What it has drawn follows from this and its settings, so a copy of this much is enough
/// to come back to a moment.
struct CutterMemory {
  std::int64_t entered = no_window;                         ///< window of the last `enter_window`
  std::array<std::int64_t, windows_kept> kept{};            ///< which window lies in each place
  std::array<CutterStatistics, windows_kept> statistics{};  ///< with which each was drawn
  DrawTally tally;                                          ///< of its windows
};

/// One cutter under way.
struct CutterForce {
  SignalSettings settings;                       ///< of the bit
  int cutter = 0;                                ///< number on the bit, part of the address of every draw
  double path_radius = 0.0;                      ///< [m] of the circle it cuts, above 0
  CutterMemory memory;                           ///< what it remembers
  std::array<PeakWindow, windows_kept> windows;  ///< as they were drawn, by place
  PulseTrain train;  ///< of the window entered last; its angle 0 is where that window begins
};

/// A cutter that has not entered a window.
void set_up(CutterForce& force, const SignalSettings& settings, int cutter, double path_radius);

/// The statistics as a window is drawn with them.
CutterStatistics latched(const CutterStatistics& statistics);

/// **What** Draws those of the windows k-1, k, k+1 that are not there yet.
/// **Differences and validity** Statistics are latched: a window is drawn once, with the statistics of the moment when
/// it comes into reach, which is one window before it begins, because its first pulses already reach back. Later
/// changes of the statistics wait for the next window. (The article takes new network outputs at every time step;
/// then the force jumps whenever a count changes.) So the force is twice continuously differentiable in the angle
/// even across edges and while conditions change. With unchanging statistics it depends on the angle alone, not on
/// the way there.
/// Afterwards `force_at(cutter.train, settings.combine, angle)` is the force at `angle` from the beginning of the
/// window, 0 <= angle <= theta_T. The statistics must be finite.
void enter_window(CutterForce& cutter, std::int64_t window, const CutterStatistics& statistics);

/// Comes back to a moment of this cutter (or one with the same settings): the same forces follow, to the last bit.
/// Draws only what differs from what is there.
void restore(CutterForce& cutter, const CutterMemory& memory);

}  // namespace bitrock::runtime
