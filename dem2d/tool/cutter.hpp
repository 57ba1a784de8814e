#pragma once
/// The outline of a single PDC cutter in the plane of the cut: a rectangle, leaned by the back rake; on request with a
/// clearance of its own, a chamfered edge, or a wear flat.
///
/// The face looks forward and down: its outward normal is (cos rake, -sin rake), so it pushes the rock ahead (x) and
/// into the hole (-y), and the rock pushes the cutter back and up. Behind the edge the underside rises by the
/// clearance angle; that of a rectangle is the back rake. A chamfer takes the corner between face and underside off,
/// at 45 degrees to the face, from so far up the face. A wear flat is ground parallel to the cut, until it is so long.
///
///              face ___/
///                  /
///      underside  /          1 tip: the front end of what is lowest    2 chamfer    3 wear flat
///      \__       /
///         \__3__/ 2
///               1
///
/// The depth of cut is the height of the rock surface above the lowest point.
///
/// Source of the geometry: back rake as in [DetournayDefourny1992]; four straight walls sized by cutter
/// diameter and thickness as the text of [BitRock2026] tells of its fig. 1. Chamfer and wear flat: own, as cutters are
/// sold and worn.

#include "dem2d/tool/convex_polygon.hpp"

namespace bitrock::dem2d {

struct CutterShape {
  double diameter;         ///< length of the face [m]
  double thickness;        ///< of the cutter behind the face [m]
  double back_rake;        ///< lean of the face out of the vertical [rad], 0 <= back rake < pi/2
  double clearance = 0.0;  ///< rise of the underside [rad]; 0: the back rake
  double chamfer = 0.0;    ///< from the edge up the face [m]; 0: a sharp edge
  double wear_flat = 0.0;  ///< length along the cut [m]; 0: none
};

/// The outline with its tip at (tip_x, tip_y). A chamfer and a wear flat must leave some of the face and of the
/// underside.
ConvexPolygon cutter_outline(const CutterShape& shape, double tip_x, double tip_y);

/// How far the face is ahead of the tip at this height above it [m]: negative where it is behind.
double face_ahead_of_tip(const CutterShape& shape, double height);

/// The longest wear flat that leaves some of face and underside [m]; 0 of an underside along the cut, which is one.
double longest_wear_flat(const CutterShape& shape);

}  // namespace bitrock::dem2d
