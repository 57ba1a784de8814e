#pragma once
/// Makes one synthetic rock from a seed: a box full of discs, calm, touching, joined stress-free.
///
/// 1. **Cloud**: radii drawn uniformly from [radius_min, radius_max] until the discs would fill 1 - porosity of the
///    box, overlaps not counted; centres drawn uniformly in the box, overlapping as they fall.
/// 2. **Calm**: frictionless linear contacts push the discs apart; all velocities are zeroed every few steps until no
///    overlap is larger than a quarter of a diameter.
/// 3. **Equilibrate** with strong local damping until the mean unbalanced force is `equilibrium_ratio` of the mean
///    contact force.
/// 4. **Join** every pair whose surfaces are closer than the installation gap. A flat joint is stress-free at the
///    distance at which it is installed, so the rock starts without locked-in stress, whatever the overlaps.
///
/// Source: [PotyondyCundall2004] for the sequence; calm and overlap limit as in the material-genesis procedure
/// of [Potyondy2015]. Differences: no pressure target and no growing of discs with few contacts (they are counted and
/// reported as floaters). 2D discs cannot fill a plane beyond 0.91, and randomly beyond about 0.84: a porosity of 0.10
/// is therefore over-full on purpose, and gives overlaps of a few percent that make the packing dense.

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "dem2d/specimen/rock.hpp"
#include "dem2d/step/world.hpp"

namespace dem2d {

/// Raised by hand whenever the same rock and seed would give other discs or joints: kept specimens then count no more.
inline constexpr int genesis_version = 1;

struct Specimen {
  Rock rock;
  double width = 0.0, height = 0.0;  ///< of the box, its lower left corner at the origin [m]
  std::uint64_t seed = 0;
  std::vector<double> x, y, radius;  ///< discs [m]
  std::vector<int> disc1, disc2;     ///< joined pairs
  double equilibrium_ratio = 0.0;    ///< reached by the packing [1]
};

/// Mean number of discs that fill such a box.
double expected_discs(const Rock& rock, double width, double height);

/// Throws `InputError` beginning with `source` when the box is too small for the discs (less than four largest
/// diameters each way) or would hold more than ten million.
void check_specimen_size(const Rock& rock, double width, double height, const std::string& source);

/// Checks the size. Throws `SimulationError` when the packing does not come to rest.
Specimen make_specimen(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
                       const base::ProgressCallback& progress = {});

/// Why a kept specimen is not the one asked for (box, rock or seed), in words; empty when it is.
std::string mismatch(const Specimen& kept, const Rock& rock, double width, double height, std::uint64_t seed);

/// Share of the box not covered, with the overlap of each pair counted once [1].
double porosity(const Specimen& specimen);

/// Mean number of joints of a disc [1].
double coordination_number(const Specimen& specimen);

/// Discs with fewer than two joints: they carry nothing.
int floaters(const Specimen& specimen);

/// Discs at rest and their joints, ready for boundaries; contact parameters and threads set, `prepare` not yet called.
World bonded_world(const Specimen& specimen, int threads);

}  // namespace dem2d
