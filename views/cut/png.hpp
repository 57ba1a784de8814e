#pragma once
/// Pictures as PNG bytes, alone and several as one.

#include <span>
#include <string>

struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier)

namespace bitrock::views {

/// The bytes of a page. Throws `base::SimulationError` when it could not be drawn.
std::string png_of(_cairo_surface* page);

/// Pictures, each PNG bytes, one below the other; white beside those that are narrower than the widest.
std::string stacked(std::span<const std::string> pictures);

}  // namespace bitrock::views
