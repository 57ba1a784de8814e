#pragma once
/// Worlds to measure and to compare: bonded rock at rest, and rock that is being cut. Made of the shipped article rock,
/// the same for everybody who asks for the same size. Tests use them too.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/random.hpp"
#include "dem2d/cut/run_cut.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

using namespace bitrock;

namespace bench {

/// Reads a rock that was made before from `folder`, or makes it and keeps it there.
inline dem2d::Specimen kept_specimen(const dem2d::Rock& rock, double width, double height, std::uint64_t seed,
                                     const std::filesystem::path& folder) {
  const std::filesystem::path file =
      folder / fmt::format("{:.0f}_discs_seed_{}.h5", dem2d::expected_discs(rock, width, height), seed);
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
inline dem2d::World trembling_slab(const dem2d::Specimen& specimen, int threads, bool in_columns = true) {
  dem2d::World world = dem2d::bonded_world(specimen, threads);
  if (in_columns) dem2d::order_in_columns(world);
  world.domain = {-1.0, -1.0, specimen.width + 1.0, specimen.height + 1.0};
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    base::Random random(base::mix(static_cast<std::uint64_t>(world.discs.id[i])));  // the same in any order
    world.discs.velocity_x[i] = base::uniform(random, -1e-3, 1e-3);
    world.discs.velocity_y[i] = base::uniform(random, -1e-3, 1e-3);
  }
  dem2d::prepare(world);
  world.step = dem2d::critical_step(world);
  return world;
}

/// The slab under a cutter, 2 m/s and 2 mm deep, after two depths of travel: broken rock, loose chips.
inline dem2d::World slab_being_cut(const dem2d::Specimen& specimen, int threads) {
  dem2d::CutCase cut{.rock = specimen.rock,
                     .cutter_speed = 2.0,
                     .depth_of_cut = 2e-3,
                     .back_rake = 0.26,  // 15 degrees
                     .bed_length = specimen.width,
                     .bed_height = specimen.height};
  dem2d::World world = dem2d::make_cut_world(cut, specimen, {.threads = threads, .measure_energy = false});
  while (world.time * cut.cutter_speed < 2.0 * cut.depth_of_cut) dem2d::advance(world);
  return world;
}

}  // namespace bench
