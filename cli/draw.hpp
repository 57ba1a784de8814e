#pragma once
/// gnuplot, run on a script that `report/` made.

#include <filesystem>

namespace cli {

/// Runs `script` in its folder so that it draws `picture`, which is drawn aside and gets its name when it is whole.
/// Throws `SimulationError` with gnuplot's words when it fails.
void draw(const std::filesystem::path& script, const std::filesystem::path& picture);

/// Whether it can, and what to say where it cannot.
bool can_draw();
inline constexpr const char* no_gnuplot = "gnuplot is not installed (apt-get install gnuplot-nox)";

}  // namespace cli
