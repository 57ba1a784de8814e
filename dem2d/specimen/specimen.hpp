#pragma once
/// A specimen: discs, which of them are joined, and the rock they are made of. It comes from genesis (genesis.hpp) or
/// from a packing made elsewhere (discs_file.hpp), is kept in a file (specimen_file.hpp), and becomes a world that can
/// be loaded (bonded_world.hpp).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/config.hpp"
#include "dem2d/specimen/rock.hpp"

namespace bitrock::dem2d {

/// What `Specimen::origin` says of one that this program has packed.
inline constexpr const char* origin_genesis = "genesis";

inline constexpr double most_discs = 1e7;  ///< of one specimen or bed; they need some 10 GB

struct Specimen {
  Rock rock;                            ///< that it is made of
  double width = 0.0, height = 0.0;     ///< of the box, its lower left corner at the origin [m]
  std::uint64_t seed = 0;               ///< of the packing, and of what is random in the joints
  std::string origin = origin_genesis;  ///< how the discs were packed
  std::vector<double> x, y, radius;     ///< discs [m]
  std::vector<int> disc1, disc2;        ///< joined pairs

  // Of the packing just before it was joined; all are 0 when the discs were packed elsewhere.
  double equilibrium_ratio = 0.0;  ///< unbalanced over contact force [1]
  double pressure = 0.0;           ///< mean, compression positive [Pa]
  double radius_factor = 0.0;      ///< all radii have grown by this to reach the pressure [1]

  /// Whether the discs came from a table.
  bool packed_elsewhere() const { return origin != origin_genesis; }
};

// What a disc can be. The same radii as in a rock file; farther out, a disc is more likely a slip of units than rock.
inline constexpr base::Range allowed_radius{.low = 1e-6, .high = 1.0};  // [m]
inline constexpr base::Range allowed_place{.low = -1e3, .high = 1e3};   // [m]
inline constexpr double largest_overlap = 0.5;  // over the smaller radius; genesis leaves at most about 0.25 [1]

/// Two discs that lie in each other.
struct Overlap {
  std::size_t disc1 = 0, disc2 = 0;  ///< places of the two discs
  double share = 0.0;                ///< of the smaller radius [1]
  bool same_centre = false;          ///< both lie on one point
};

/// The first two discs that overlap by more than `largest_overlap`; empty when there are none.
std::optional<Overlap> absurd_overlap(const Specimen& specimen);

/// Joins every pair of discs whose surfaces are not farther apart than the installation gap of the rock.
void join_neighbours(Specimen& specimen);

/// Why a kept specimen is not the one asked for (box, rock or seed), in words; empty when it is. Discs packed elsewhere
/// have no seed: theirs is not compared.
std::string mismatch(const Specimen& kept, const Rock& rock, double width, double height, std::uint64_t seed);

/// Share of the box not covered, with the overlap of each joined pair counted once [1].
double porosity(const Specimen& specimen);

/// Mean number of joints of a disc [1].
double coordination_number(const Specimen& specimen);

/// Discs with fewer than three joints, too few to be held firmly [PotyondyCundall2004].
int floaters(const Specimen& specimen);

/// Discs that joints hold together, however far apart they are along them.
struct Pieces {
  int count = 0;            ///< of two discs and more
  std::size_t largest = 0;  ///< discs in the largest
  int unjoined = 0;         ///< discs without any joint
};

/// Under the joints of the specimen.
Pieces pieces(const Specimen& specimen);

/// What is allowed but hardly wanted, in words: discs that hang together in pieces.
std::vector<std::string> warnings(const Specimen& specimen);

}  // namespace bitrock::dem2d
