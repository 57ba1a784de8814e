#pragma once
/// A bed of rock as it lies in a well: under the pressure of the mud before the cutter comes.
///
/// The bed is let go on all sides and pressed as a block that floats in mud (specimen/press.hpp), so the stress is the
/// same in all directions and the ends of a window (window.hpp) are pressed as by the rock beyond. Then what was held
/// is held again where it lies now, and the cutter comes down by as much as the surface has. Between sides that stand
/// still the thrust of a cut under mud, some tens of MPa over the bed, would tear it from its floor.

#include "base/progress.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// What the pressure did to the bed.
struct Settled {
  double surface_drop = 0.0;  ///< of the surface, the bottom standing [m]
  double shortening = 0.0;    ///< of the bed along the cut, its left edge standing [m]
  int cracks = 0;             ///< elements that broke under the pressure alone
  long long steps = 0;        ///< that it took
};

/// Brings the world of `make_cut_world` under the pressure of the mud, at rest, and puts the cutter (boundary 0) to the
/// surface. Time, cracks, losses and work begin at 0 then. Throws as `press` does.
Settled settle_under_mud(World& world, const CutCase& cut, const base::ProgressCallback& progress = {});

}  // namespace bitrock::dem2d
