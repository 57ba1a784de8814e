#include "views/cut/crack_faces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bitrock::views {

namespace {

constexpr double farthest_together = 1.25;  // distance of two discs that have not parted, over the sum of their radii

/// For each disc born its place in `discs`, -1 when it has left.
std::vector<int> places_by_id(const DrawnDiscs& discs) {
  std::vector<int> place(static_cast<std::size_t>(discs.born), -1);
  for (std::size_t i = 0; i < discs.id.size(); ++i) {
    if (discs.id[i] >= 0 && discs.id[i] < discs.born)
      place[static_cast<std::size_t>(discs.id[i])] = static_cast<int>(i);
  }
  return place;
}

std::optional<Segment> face_between(const DrawnDiscs& discs, std::size_t a, std::size_t b) {
  const double dx = discs.x[b] - discs.x[a], dy = discs.y[b] - discs.y[a], distance = std::hypot(dx, dy);
  const double sum = discs.radius[a] + discs.radius[b];
  if (!(distance > 0.0) || distance > farthest_together * sum) return std::nullopt;
  const double share = discs.radius[a] / sum, half = std::min(discs.radius[a], discs.radius[b]);
  const double x = discs.x[a] + share * dx, y = discs.y[a] + share * dy;
  const double along_x = -dy / distance * half, along_y = dx / distance * half;
  return Segment{x - along_x, y - along_y, x + along_x, y + along_y};
}

}  // namespace

std::vector<std::optional<Segment>> crack_faces(const DrawnDiscs& discs, std::span<const dem2d::Crack> cracks) {
  const std::vector<int> place = places_by_id(discs);
  const auto find = [&](int id) { return id >= 0 && id < discs.born ? place[static_cast<std::size_t>(id)] : -1; };
  std::vector<std::optional<Segment>> faces;
  faces.reserve(cracks.size());
  for (const dem2d::Crack& crack : cracks) {
    const int first = find(crack.disc1), second = find(crack.disc2);
    const bool both = first >= 0 && second >= 0;
    faces.push_back(both ? face_between(discs, static_cast<std::size_t>(first), static_cast<std::size_t>(second))
                         : std::nullopt);
  }
  return faces;
}

std::vector<dem2d::Crack> cracks_until(std::span<const dem2d::Crack> cracks, double time) {
  std::vector<dem2d::Crack> so_far;
  std::copy_if(cracks.begin(), cracks.end(), std::back_inserter(so_far),
               [time](const dem2d::Crack& crack) { return crack.time <= time; });
  return so_far;
}

}  // namespace bitrock::views
