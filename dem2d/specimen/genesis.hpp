#pragma once
/// Makes one synthetic rock from a seed: a box full of discs, calm, touching, joined stress-free.
///
/// 1. **Cloud**: radii drawn uniformly from [radius_min, radius_max] until the discs would fill 1 - porosity of the
///    box, overlaps not counted; centres drawn uniformly in the box, overlapping as they fall. In a graded rock
///    (grading.hpp) each layer is filled in this way, with radii of its own, as if it were a box; from then on the
///    discs are one packing.
/// 2. **Calm**: frictionless linear contacts push the discs apart; all velocities are zeroed every few steps until no
///    overlap is larger than a quarter of a diameter.
/// 3. **Equilibrate** with strong local damping, roughly.
/// 4. **Pressure**: all radii grow (or shrink) by one factor, and the packing comes to rest again, until its mean
///    stress is within 1 % of the wanted pressure (packing_stress.hpp). Then it equilibrates until the mean unbalanced
///    force is `equilibrium_ratio` of the mean contact force, and the pressure is looked at again.
/// 5. **Join** every pair whose surfaces are closer than the installation gap. A flat joint is stress-free at the
///    distance at which it is installed, so the rock starts without locked-in stress, whatever the overlaps.
///
/// The packing that results depends on pressure over packing modulus, which sets overlaps and coordination, and hardly
/// on the porosity of the cloud; what the porosity decides is how far the radii must grow to get there. Of the pairs
/// with a factor near 1, the default (porosity 0.10, 30 MPa at 1 GPa) is what a cloud of that porosity comes to by
/// itself, as in the rock-testing example of [ItascaPFC]; porosity 0.145 and a pressure of 1 % of the modulus have the
/// smaller overlaps of the material-genesis procedure that goes with [Potyondy2015].
///
// clang-format off
///     pressure / modulus   joints a disc   floaters   mean overlap / diameter   porosity   cloud with factor 1
///     0.03                 4.94            0.6 %      0.026                     0.113      0.10
///     0.01                 4.66            1.2 %      0.010                     0.144      0.145
// clang-format on
/// (grains and installation gap of campaigns/rocks/start.toml, about 3600 discs, mean of three seeds; the shipped rocks
/// use 60 MPa, see docs/decisions/0007)
///
/// Source: [PotyondyCundall2004] for the sequence; calm, overlap limit and grain scaling as in the material-genesis
/// procedure of [Potyondy2015]. Difference: no growing of discs with few joints (they are reported as floaters).

#include "base/progress.hpp"
#include "dem2d/specimen/specimen.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Raised by hand whenever the same rock and seed would give other discs or joints: kept specimens then count no more.
inline constexpr int genesis_version = 3;

/// Mean number of discs that fill such a box.
double expected_discs(const Rock& rock, double width, double height);

/// Throws `InputError` beginning with `source` when the box is too small for the discs (less than four largest
/// diameters each way) or would hold more than ten million.
void check_specimen_size(const Rock& rock, double width, double height, const std::string& source);

/// Discs under pressure in their box, at rest but not yet joined: walls are the boundaries.
struct Packing {
  World world;                     ///< the packed discs, without joints
  double equilibrium_ratio = 0.0;  ///< [1]
  double pressure = 0.0;           ///< [Pa]
  double radius_factor = 1.0;      ///< [1]
};

/// Steps 1 to 4. Throws `SimulationError` when the packing does not come to rest.
Packing pack(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
             const base::ProgressCallback& progress = {});

/// Checks the size, packs, joins.
Specimen make_specimen(const Rock& rock, double width, double height, std::uint64_t seed, int threads,
                       const base::ProgressCallback& progress = {});

}  // namespace bitrock::dem2d
