#pragma once
/// Pictures of laboratory tests as PNG: the broken core, and the stress-strain curves of several specimens.

#include <span>
#include <string>

#include "dem2d/lab/lab_test.hpp"

namespace bitrock::views {

/// The core at the end of the test: discs by fragment, cracks by mode, platens or grips, a scale in millimetres.
std::string draw_broken_core(const dem2d::LabRun& run, const std::string& rock_name, int width_px = 900);

/// Stress over strain, one line a specimen; in compression and tension also stress over lateral strain, on the other
/// side of zero. `runs` are of one test; at least one.
std::string draw_curves(std::span<const dem2d::LabRun> runs, const std::string& rock_name, int width_px = 1100);

}  // namespace bitrock::views
