#pragma once
/// The fracture picture of a cut as PNG: discs by fragment, cracks where they opened, the cutter, a scale in
/// millimetres.

#include <string>

#include "dem2d/output/run_file.hpp"

namespace dem2d {

/// PNG bytes of the last frame. `width_px` sets the size; the height follows from the region shown.
std::string draw_snapshot(const RunFile& run, int width_px = 1400);

}  // namespace dem2d
