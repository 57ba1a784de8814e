#pragma once
/// Where a crack is to be shown at a later instant. A crack is recorded at the place where it opened; afterwards its
/// two discs move. While they stay near each other the crack moves with them; when they have parted it is no longer a
/// crack but a surface, and a line at the old place would lie in thin air (drawn between the two discs, it would cross
/// the picture).

#include <optional>
#include <span>
#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::views {

/// Discs at one instant; the spans are of one length.
struct DrawnDiscs {
  std::span<const double> x, y, radius;  ///< [m]
  std::span<const int> id, fragment;
  int born;  ///< discs at the start: ids are below this
};

struct Segment {
  double x1, y1, x2, y2;  ///< [m]
};

/// The face between the two discs of each crack, where they are now: all elements of a joint share it. It is as long as
/// the smaller disc is thick. Empty where the discs have parted: a gap above a quarter of R1 + R2, or one has left.
std::vector<std::optional<Segment>> crack_faces(const DrawnDiscs& discs, std::span<const dem2d::Crack> cracks);

/// Cracks that exist at an instant [s].
std::vector<dem2d::Crack> cracks_until(std::span<const dem2d::Crack> cracks, double time);

}  // namespace bitrock::views
