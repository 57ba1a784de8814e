#pragma once
/// The figures of runs in a well that page and pictures for paper share: loads over time, the string over its depth,
/// stresses with their spectra, how joints wander in the hole, damage. One run, or a few side by side.

#include <optional>
#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/well/fatigue_of_joints.hpp"
#include "views/drill/panels.hpp"

namespace bitrock::views {

/// A run with what is derived from it.
struct ShownWell {
  std::string label;                         ///< of the run in tables and legends
  runtime::WellFile file;                    ///< as read
  std::vector<base::Spectrum> spectra;       ///< of the stress of each point after settling [MPa^2/Hz]
  std::vector<studies::PointDamage> damage;  ///< of each point; empty where it cannot be counted
  std::vector<studies::JointDamage> joints;  ///< from the bit up, where the run kept them
  std::string no_damage;                     ///< why not
};

/// More would not fit side by side.
inline constexpr std::size_t most_shown_wells = 3;

/// The damage is that of `studies::usual_fatigue_wish`. The spectra of all runs have the same resolution, that of a
/// sixth of the shortest time after settling, but no finer than 2 s give: lines of a turn stay apart.
std::vector<ShownWell> shown_wells(const std::vector<std::string>& names, std::vector<runtime::WellFile> files);

/// Over time, a closer look, along the string, stresses, spectra, orbits, damage; those that the runs have.
std::vector<report::Figure> well_figures(const std::vector<ShownWell>& runs);

/// Where the hole goes on one sheet of paper, the string at its last instant in it: depth over distance, and from
/// above. Nothing for a run without frames.
std::optional<report::Figure> well_profile(const ShownWell& run);

/// Net turns of a joint about the middle of its hole [rad/s] over samples `sample` [s] apart; positive as the drive
/// turns (forward whirl). 0 where it lies still on one side.
double whirl_rate(const runtime::Orbit& orbit, double sample);

}  // namespace bitrock::views
