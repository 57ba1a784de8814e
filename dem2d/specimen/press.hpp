#pragma once
/// Rock under the pressure of mud on all its sides, at rest: as it lies in a well before it is cut, or in the cell of a
/// confined compression test before it is loaded.
///
/// The rock floats in the mud (fluid/mud.hpp), free on all sides, and the pressure rises slowly over so many transits
/// of a wave that it follows at rest, under strong local damping. So the stress is the same in all directions, whatever
/// the rock: between sides that stand still it would carry nu / (1 - nu) of the pressure along them.

#include <string>

#include "base/progress.hpp"
#include "dem2d/specimen/rock.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// What it took to come to rest.
struct Pressed {
  int cracks = 0;       ///< elements that broke under the pressure alone
  long long steps = 0;  ///< that it took
};

/// Brings a prepared world without held discs and boundaries, whose `mud` says what seals, to rest under `pressure`
/// [Pa]. Velocities, cracks, losses, work and time begin at 0 then; its local damping stays. `key`: what the pressure
/// is called in messages. Throws `SimulationError` when the pressure breaks more than a hundredth of the elements, or
/// the rock does not come to rest; `Interrupted` when stopped by the user.
Pressed press(World& world, const Rock& rock, double pressure, const std::string& key,
              const base::ProgressCallback& progress = {});

}  // namespace bitrock::dem2d
