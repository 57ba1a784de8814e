#pragma once
/// gnuplot, run on a script that was made here.

#include <filesystem>
#include <string>

#include "report/gnuplot.hpp"

namespace bitrock::report {

/// Draws `picture`, which gets its name when it is whole. gnuplot takes names that begin with < or | for commands, so
/// it works in a folder of our own on names of our own. Throws `SimulationError` with gnuplot's words when it fails.
void draw(const GnuplotFiles& files, const std::filesystem::path& picture);

/// Whether it can, and what to say where it cannot.
bool can_draw();
inline constexpr const char* no_gnuplot = "gnuplot is not installed (apt-get install gnuplot-nox)";

}  // namespace bitrock::report
