#pragma once
/// The energy ledger of a world in motion, instant by instant.

#include "dem2d/step/energy.hpp"
#include "dem2d/step/stages.hpp"

using namespace bitrock;

namespace verification {

/// Advances and returns the ledger of the last of so many instants.
inline dem2d::Energies run(dem2d::World& world, int steps) {
  dem2d::Energies last;
  for (int step = 1; step <= steps; ++step) {
    dem2d::find_forces(world);
    if (step == steps) last = dem2d::read_energies(world);
    dem2d::move(world);
  }
  return last;
}

}  // namespace verification
