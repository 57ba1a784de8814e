#pragma once
/// The mud of a well on rock that it does not enter: a pressure on the outer faces of its pieces.
///
/// **Equation.** The mud fills everything outside of a piece. On the polygon of its outer face, disc centres x_1 ...
/// x_n in counter-clockwise order, the pressure p on each side is shared by its two ends, so that a disc feels
///
///     F_k = p/2 perp(x_(k+1) - x_(k-1))        perp(a, b) = (-b, a), which points inward
///
/// once for each time the walk passes it. This is -p dA/dx_k, A the area of the polygon: the work of the mud on a piece
/// is -p times the change of its area, whatever the motion, and a piece that floats feels neither force nor moment.
///
/// **Symbols.** p [Pa] pressure of the mud less that of the pores, F [N/m] per metre of thickness, A [m2].
///
/// **Source.** Derived here from virtual work. That this pressure, not the depth of the well, is what strengthens rock
/// that takes in fluid slowly: [CunninghamEenink1959], [DetournayAtkinson2000]; pressing on the exposed discs of a
/// bonded assembly while it is cut: [Ledgerwood2007].
///
/// **Validity.** Rock whose pores keep their pressure while the chip is made (shale, tight sandstone): where mud enters
/// as fast as cracks open it presses from all sides and does nothing, the case without mud. A gap takes the mud in once
/// it is wider than the seal gap. Whether debris lets it in is the largest unknown, a choice (`debris_seals`).

#include <vector>

#include "dem2d/fluid/outer_faces.hpp"

namespace bitrock::dem2d {

/// [1] Ten micrometres in grains of half a millimetre: a narrower crack takes as long to fill with mud as a chip is
/// made (docs/theory/mud.md). Of the smallest radius.
inline constexpr double usual_seal_gap_over_radius = 0.05;

struct Mud {
  double pressure = 0.0;     ///< p [Pa]; 0: there is none
  double seal_gap = 0.0;     ///< a gap of joint or debris narrower than this keeps the mud out [m]
  bool debris_seals = true;  ///< loose discs that touch keep it out too; otherwise only joints do

  OuterFaces faces;                      ///< of the last look
  std::vector<double> force_x, force_y;  ///< at each stop of `faces` [N/m]
  double work = 0.0;                     ///< done on the discs so far; while energy is measured [J/m]

  // when it was looked at last
  long long lists_version = -1;  ///< of the neighbour lists
  int steps = 0;                 ///< since then

  // room for a look
  FaceSearch search;                      ///< of the outer faces
  std::vector<int> disc1, disc2;          ///< edges: what keeps the mud out
  std::vector<std::vector<char>> sealed;  ///< of the boundaries that seal, whether a disc touches them
};

}  // namespace bitrock::dem2d
