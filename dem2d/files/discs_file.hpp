#pragma once
/// A specimen from a packing made elsewhere: a table of discs (columns x_m, y_m, radius_m, in any order; others are
/// passed over), so that two codes can be compared on the same discs. Nothing is packed and no disc is moved against
/// another; pairs are joined by the gap rule of the rock, stress-free as after genesis. The radii of the table count,
/// not those of the rock.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dem2d/specimen/specimen.hpp"

namespace bitrock::dem2d {

/// Size of the box that discs lie in.
struct BoxSize {
  double width, height;  ///< [m]
};

/// With a box, the discs stay where the table has them, and every centre must lie in the box from (0, 0) to
/// (width, height). Without one, the box is the smallest that holds the discs, and they are shifted as a whole so that
/// its lower left corner is at (0, 0). `seed` draws what is random in the joints.
///
/// Throws `InputError` naming the line (or the two lines) for a radius that is not positive, a disc outside the box,
/// two discs with the same centre, an overlap above half of the smaller radius, less than ten discs, an installation
/// gap above the smallest radius, or radii so far from those of the rock that they are in another unit (its name is
/// then in the message).
Specimen specimen_from_discs(const std::filesystem::path& table, const Rock& rock, std::uint64_t seed,
                             const std::optional<BoxSize>& box = {});

/// What to look at in such a specimen although it can be used: radii that are not those of the rock.
std::vector<std::string> discs_warnings(const Specimen& specimen);

}  // namespace bitrock::dem2d
