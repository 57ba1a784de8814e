#pragma once
/// The fracture picture of a cut as PNG: discs by fragment, cracks where their discs are, the cutter, a scale in
/// millimetres; under it, on the same scale along the cut, the force history as in fig. 2 of [BitRock2026], of which
/// the text tells: the force stands below the place where the tip of the cutter was. Later than the instant of the
/// picture, it is drawn pale.

#include <span>
#include <string>

#include "dem2d/files/run_file.hpp"

namespace bitrock::views {

/// The forces that the two panels reach from and to [N/m].
struct ForceScale {
  double low_x = 0.0, high_x = 0.0;  ///< along the cut
  double low_y = 0.0, high_y = 0.0;  ///< out of the rock
};

/// The least scale that shows all forces of these runs, and no force.
ForceScale force_scale(std::span<const dem2d::RunFile> runs);

/// PNG bytes of one instant. `width_px` sets the size; the height follows from the region shown. Pictures of one scale
/// can be compared.
std::string draw_snapshot(const dem2d::RunFile& run, const dem2d::Frame& frame, int width_px, const ForceScale& scale);

/// On the scale of its own forces.
std::string draw_snapshot(const dem2d::RunFile& run, const dem2d::Frame& frame, int width_px = 1400);

/// The end of the cut.
std::string draw_snapshot(const dem2d::RunFile& run, int width_px = 1400);

}  // namespace bitrock::views
