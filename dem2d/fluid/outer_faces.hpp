#pragma once
/// Where a fluid meets rock that it cannot enter: the outer faces of connected pieces of discs.
///
/// Discs are the nodes of a graph, and what keeps the fluid out between two of them is an edge: a bond, a closed crack,
/// closed debris. The outer face of a piece is walked counter-clockwise, the piece on the left hand: from its lowest
/// disc to the east, and at each disc on to the neighbour that comes first when one turns counter-clockwise from where
/// one came. What hangs on a piece by a single edge is walked there and back. Holes inside a piece hold no fluid. A
/// piece that encloses nothing (a disc, two, a row) has no face.
///
/// **Source.** The boundary walk of a plane graph by turning is common knowledge of computational geometry; that a mud
/// presses on a chain of exposed discs which is found again and again while rock is cut is the way of [Ledgerwood2007].
/// **Validity.** For edges that do not cross: neighbours in a packing, with gaps small against the radii. Where a walk
/// does not come back, or comes back clockwise, edges do cross; such a piece is left out and counted.

#include <span>
#include <vector>

namespace bitrock::dem2d {

/// One stop of a walk: a disc, the one before and the one after. A disc may be passed more than once.
struct FaceStop {
  int before, disc, after;  ///< places of the discs in the arrays that `find_outer_faces` is given
};

/// The faces of all pieces, one after the other.
struct OuterFaces {
  std::vector<FaceStop> stops;  ///< piece after piece, each in the order of its walk
  std::vector<int> pieces;      ///< where in `stops` each piece begins; one more at the end
  int crossing = 0;             ///< pieces left out because their edges cross
  int crossing_stops = 0;       ///< stops of their walks

  int count() const { return static_cast<int>(pieces.size()) - 1; }  ///< pieces with a face; -1 before the first search
};

/// Room for the search, so that it allocates only when it grows.
struct FaceSearch {
  std::vector<int> parent;      ///< forest of union-find, one entry a disc
  std::vector<int> lowest;      ///< of the piece whose root the disc is, or -1
  std::vector<int> first;       ///< where the neighbours of a disc begin; one more at the end
  std::vector<int> neighbours;  ///< of all discs
  std::vector<int> path;        ///< of one walk
};

/// Finds the outer faces of the graph with discs at x, y [m] and an edge between disc1[k] and disc2[k]. Pieces come in
/// the order of their lowest-numbered discs; discs without an edge have no face.
void find_outer_faces(std::span<const double> x, std::span<const double> y, std::span<const int> disc1,
                      std::span<const int> disc2, FaceSearch& search, OuterFaces& faces);

}  // namespace bitrock::dem2d
