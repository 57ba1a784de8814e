#pragma once
/// The figures of drill runs that page and pictures for paper share: what is drawn over time, as a spectrum, as an
/// orbit. One run, or a few side by side. Numbers come from the files and `base::welch`; drawing is report/'s business.

#include <string>
#include <vector>

#include "report/gnuplot.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "views/drill/panels.hpp"

namespace bitrock::views {

/// A run with what is derived from its series after the settling time.
struct ShownRun {
  std::string label;  ///< of the run in tables and legends
  runtime::DrillFile file;
  base::Spectrum bit_speed;      ///< [rpm^2/Hz]
  base::Spectrum weight_on_bit;  ///< [kN^2/Hz]
  base::Spectrum torque;         ///< [(N m)^2/Hz]
};

/// Labels are the names of the files without folder and ending, or whole where two are the same. The spectra of all
/// runs have the same resolution, that of a sixth of the shortest: eleven half-overlapping segments of it.
std::vector<ShownRun> shown_runs(const std::vector<std::string>& names, std::vector<runtime::DrillFile> files);

/// Instant from which on samples count in the summary and the spectra [index].
std::size_t first_settled(const runtime::DrillFile& file);

/// Over time, a closer look, spectra, orbits. A row of panels belongs together: for several runs it is one quantity, a
/// panel each; spectra are laid over each other.
std::vector<report::Figure> drill_figures(const std::vector<ShownRun>& runs);

/// One run on one sheet of paper: its last seconds, as the article shows them, and where the vibrations are.
report::Figure drill_sheet(const ShownRun& run);

}  // namespace bitrock::views
