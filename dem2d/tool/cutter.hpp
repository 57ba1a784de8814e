#pragma once
/// The outline of a single PDC cutter in the plane of the cut: a rectangle, leaned by the back rake.
///
/// The face looks forward and down: its outward normal is (cos rake, -sin rake), so it pushes the rock ahead (x) and
/// into the hole (-y), and the rock pushes the cutter back and up. Behind the tip the lower side rises with the same
/// angle: the clearance equals the rake. With little rake uncut grains rub under it and add axial force that is not
/// from cutting. The depth of cut is the height of the rock surface above the tip.
///
/// Source of the geometry: back rake as in [DetournayDefourny1992]; four straight walls sized by cutter
/// diameter and thickness as the text of [BitRock2026] tells of its fig. 1.

#include "dem2d/tool/convex_polygon.hpp"

namespace bitrock::dem2d {

struct CutterShape {
  double diameter;   ///< length of the face [m]
  double thickness;  ///< of the cutter behind the face [m]
  double back_rake;  ///< lean of the face out of the vertical [rad], 0 <= back rake < pi/2
};

/// The outline with its tip at (tip_x, tip_y).
ConvexPolygon cutter_outline(const CutterShape& shape, double tip_x, double tip_y);

}  // namespace bitrock::dem2d
