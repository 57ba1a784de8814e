#pragma once
/// A graded specimen: grains as large as the rock file says from the surface down to `Rock::fine_depth`, and
/// `Rock::coarse_ratio` times as large below, where nothing is cut and a disc more is only a disc more to compute.
///
/// Stiffness and strength of a joint go by the size of its discs (E* / (R1 + R2), stresses), so modulus and strength of
/// the coarse rock are those of the fine rock. What differs is toughness, which grows as the root of the grain size
/// [PotyondyCundall2004]: a crack that runs down into coarse rock finds it 1.4 times as tough at a ratio of 2, and
/// fewer joints to break. So the fine layer must hold what breaks; docs/decisions/0011 says how deep cracks run.

#include <vector>

#include "dem2d/specimen/rock.hpp"

namespace bitrock::dem2d {

/// Rock between two heights above the bottom, all of one size of grains.
struct Layer {
  double low = 0.0, high = 0.0;  ///< [m]
  double size = 1.0;             ///< radii over those of the rock file [1]
};

/// From the bottom up: one, or two when the rock is graded and the specimen higher than its fine layer.
std::vector<Layer> layers(const Rock& rock, double height);

/// Of the grains that the rock file says [m].
inline double mean_diameter(const Rock& rock) {
  return rock.radius_min + rock.radius_max;
}

/// Of the discs of such a specimen, before they grow [m].
double largest_radius(const Rock& rock, double height);

}  // namespace bitrock::dem2d
