#pragma once
/// From a specimen (discs and joined pairs) to a world: gives every disc its mass and every pair its flat joint, with
/// the type and strength that the rock prescribes.
///
/// **Types** [Potyondy2012]: of n joints, round(n gapped_fraction) are gapped and round(n slit_fraction) slit, the rest
/// bonded; which ones is a shuffle, so the microstructure is a random field without direction.
///
/// **Strengths**: tensile strength and cohesion of a joint are drawn from normal distributions (mean, standard
/// deviation), each drawn again until positive. With a standard deviation of at most half the mean, which the reader of
/// rock files enforces, the redrawing raises the mean by at most 2.8 % (of a normal distribution cut at -2 sd:
/// mean + sd phi(2)/Phi(2)).
///
/// Both are addressed by the seed of the specimen: the same specimen always has the same weak spots, and rocks with the
/// same standard deviation over mean have them in the same places.

#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Discs at rest and their joints, ready for boundaries; contact parameters and threads set, `prepare` not yet called.
World bonded_world(const Specimen& specimen, int threads);

}  // namespace bitrock::dem2d
