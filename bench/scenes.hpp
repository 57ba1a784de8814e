#pragma once
/// Worlds to measure and to compare: bonded rock at rest, and rock that is being cut. Made of the shipped article rock,
/// the same for everybody who asks for the same size.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/random.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/specimen/specimen_file.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace bench {

/// Reads a rock that was made before from `folder`, or makes it and keeps it there.
inline dem2d::Specimen kept_specimen(const dem2d::Rock& rock, double width, double height, std::uint64_t seed,
                                     const std::filesystem::path& folder) {
  const double discs = dem2d::expected_discs(rock, width, height);
  const std::filesystem::path file = folder / fmt::format("{}_{:.0f}_{}.h5", rock.name, discs, seed);
  if (std::filesystem::exists(file)) {
    dem2d::Specimen kept = dem2d::read_specimen(file);
    if (dem2d::mismatch(kept, rock, width, height, seed).empty()) return kept;
  }
  dem2d::Specimen made = dem2d::make_specimen(rock, width, height, seed, 2);
  dem2d::write_specimen(made, file);
  return made;
}

/// About so many discs in a bed three times as long as high.
inline dem2d::Specimen slab(const dem2d::Rock& rock, int discs, const std::filesystem::path& folder) {
  const double height = std::sqrt(discs / dem2d::expected_discs(rock, 1.0, 1.0) / 3.0);
  return kept_specimen(rock, 3.0 * height, height, 1, folder);
}

/// A bonded slab without boundaries whose discs tremble at 1 mm/s, so that no force is zero and nothing breaks.
inline dem2d::World trembling_slab(const dem2d::Specimen& specimen, int threads) {
  dem2d::World world = dem2d::bonded_world(specimen, threads);
  dem2d::order_in_columns(world);
  world.domain = {-1.0, -1.0, specimen.width + 1.0, specimen.height + 1.0};
  base::Random random(1);
  for (double& v : world.discs.velocity_x) v = base::uniform(random, -1e-3, 1e-3);
  for (double& v : world.discs.velocity_y) v = base::uniform(random, -1e-3, 1e-3);
  dem2d::prepare(world);
  world.step = dem2d::critical_step(world);
  return world;
}

}  // namespace bench
