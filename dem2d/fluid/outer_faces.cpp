#include "dem2d/fluid/outer_faces.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>

#include "base/union_find.hpp"

namespace bitrock::dem2d {

namespace {

struct Direction {
  double x, y;
};

double cross(const Direction& a, const Direction& b) {
  return a.x * b.y - a.y * b.x;
}

/// Which of two half turns, counter-clockwise from `from`, a direction lies in: 0 the first, 1 straight back, 2 the
/// second, 3 along `from` itself, a whole turn.
int half_turn(const Direction& from, const Direction& to) {
  const double side = cross(from, to);
  if (side > 0.0) return 0;
  if (side < 0.0) return 2;
  return from.x * to.x + from.y * to.y < 0.0 ? 1 : 3;
}

/// Whether `a` comes before `b` when one turns counter-clockwise from `from`.
bool comes_first(const Direction& from, const Direction& a, const Direction& b) {
  const int of_a = half_turn(from, a), of_b = half_turn(from, b);
  return of_a != of_b ? of_a < of_b : cross(a, b) > 0.0;
}

/// Whose neighbour is who, and which discs hang together.
void make_graph(std::size_t discs, std::span<const int> disc1, std::span<const int> disc2, FaceSearch& search) {
  base::start_pieces(search.parent, discs);
  search.first.assign(discs + 1, 0);
  for (std::size_t k = 0; k < disc1.size(); ++k) {
    ++search.first[static_cast<std::size_t>(disc1[k])];
    ++search.first[static_cast<std::size_t>(disc2[k])];
    base::unite(search.parent, disc1[k], disc2[k]);
  }
  // sums give the ends of the lists; filling from behind makes them beginnings
  std::partial_sum(search.first.begin(), search.first.end(), search.first.begin());
  search.neighbours.resize(2 * disc1.size());
  const auto enter = [&search](int disc, int other) {
    search.neighbours[static_cast<std::size_t>(--search.first[static_cast<std::size_t>(disc)])] = other;
  };
  for (std::size_t k = disc1.size(); k-- > 0;) {
    enter(disc1[k], disc2[k]);
    enter(disc2[k], disc1[k]);
  }
}

struct Graph {
  std::span<const double> x, y;
  const FaceSearch& search;

  Direction from_to(int a, int b) const {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return {x[j] - x[i], y[j] - y[i]};
  }
  bool is_lower(int a, int b) const {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    return y[i] != y[j] ? y[i] < y[j] : x[i] < x[j];
  }
  /// The neighbour of `disc` that comes first, counter-clockwise from `from`; back to `before` only where nothing else
  /// is.
  int next(int disc, int before, const Direction& from) const {
    int best = before;
    Direction to_best{};
    for (int k = search.first[static_cast<std::size_t>(disc)]; k < search.first[static_cast<std::size_t>(disc) + 1];
         ++k) {
      const int other = search.neighbours[static_cast<std::size_t>(k)];
      if (other == before) continue;
      const Direction to_other = from_to(disc, other);
      if (best != before && !comes_first(from, to_other, to_best)) continue;
      best = other;
      to_best = to_other;
    }
    return best;
  }
};

enum class Encloses { nothing, rock, crossed };

/// What a closed path goes around, by the sign of its area. From its first disc, so that the place of the whole does
/// not round.
Encloses enclosed(const Graph& graph, const std::vector<int>& path) {
  constexpr double rounding = 1e-12;
  double area = 0.0, size = 0.0;  // twice
  for (std::size_t k = 0; k < path.size(); ++k) {
    const double part = cross(graph.from_to(path[0], path[k]), graph.from_to(path[0], path[(k + 1) % path.size()]));
    area += part;
    size += std::abs(part);
  }
  if (std::abs(area) <= rounding * size) return Encloses::nothing;
  return area > 0.0 ? Encloses::rock : Encloses::crossed;
}

/// Walks around the piece whose lowest disc is `start`; false when the walk does not come back.
bool walk(const Graph& graph, int start, std::vector<int>& path) {
  const std::size_t most = graph.search.neighbours.size();  // each edge once in each direction
  path.clear();
  constexpr Direction west{-1.0, 0.0};
  const int second = graph.next(start, -1, west);
  int before = start, disc = second;
  path.push_back(start);
  while (path.size() <= most) {
    const int after = graph.next(disc, before, graph.from_to(disc, before));
    if (disc == start && after == second) return true;
    path.push_back(disc);
    before = disc;
    disc = after;
  }
  return false;
}

}  // namespace

void find_outer_faces(std::span<const double> x, std::span<const double> y, std::span<const int> disc1,
                      std::span<const int> disc2, FaceSearch& search, OuterFaces& faces) {
  make_graph(x.size(), disc1, disc2, search);
  const Graph graph{x, y, search};
  search.lowest.assign(x.size(), -1);
  for (int disc = 0; disc < static_cast<int>(x.size()); ++disc) {
    int& lowest = search.lowest[static_cast<std::size_t>(base::root(search.parent, disc))];
    if (lowest < 0 || graph.is_lower(disc, lowest)) lowest = disc;
  }
  faces.stops.clear();
  faces.pieces.assign(1, 0);
  faces.crossing = faces.crossing_stops = 0;
  for (const int start : search.lowest) {
    if (start < 0) continue;
    const auto at = static_cast<std::size_t>(start);
    if (search.first[at] == search.first[at + 1]) continue;  // a disc alone
    const Encloses encloses = walk(graph, start, search.path) ? enclosed(graph, search.path) : Encloses::crossed;
    if (encloses == Encloses::crossed) {
      ++faces.crossing;
      faces.crossing_stops += static_cast<int>(search.path.size());
    }
    if (encloses != Encloses::rock) continue;
    const std::vector<int>& path = search.path;
    for (std::size_t k = 0; k < path.size(); ++k)
      faces.stops.push_back({path[(k + path.size() - 1) % path.size()], path[k], path[(k + 1) % path.size()]});
    faces.pieces.push_back(static_cast<int>(faces.stops.size()));
  }
}

}  // namespace bitrock::dem2d
