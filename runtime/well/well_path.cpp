#include "runtime/well/well_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"

namespace bitrock::runtime {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;  // [1/rad]

/// sin(x) / x.
double sinc(double x) {
  return x == 0.0 ? 1.0 : std::sin(x) / x;
}

/// Position at length s along an arc: P0 + t sin(ks)/k + n (1 - cos(ks))/k.
Vector3 along(const WellArc& arc, double s) {
  const double half = 0.5 * arc.curvature * s;
  return arc.start + (s * sinc(2.0 * half)) * arc.tangent + (s * std::sin(half) * sinc(half)) * arc.normal;
}

Vector3 tangent_along(const WellArc& arc, double s) {
  const double angle = arc.curvature * s;
  return std::cos(angle) * arc.tangent + std::sin(angle) * arc.normal;
}

WellArc straight_arc(double begin, double length, const Vector3& start, const Vector3& tangent) {
  const Vector3 normal = any_across(tangent);
  return {.begin = begin,
          .length = length,
          .start = start,
          .tangent = tangent,
          .normal = normal,
          .binormal = cross(tangent, normal)};
}

WellArc arc_between(double begin, double length, const Vector3& start, const Vector3& from, const Vector3& to) {
  WellArc arc = straight_arc(begin, length, start, from);
  const Vector3 turned = across(to, from);
  if (dot(turned, turned) == 0.0) return arc;
  arc.normal = unit(across(unit(turned), from));  // twice: a small turn leaves few digits
  arc.binormal = cross(from, arc.normal);
  arc.curvature = angle_between(from, to) / length;
  return arc;
}

void require_station(const SurveyStation& station, std::size_t row) {
  const auto refuse = [&](const std::string& what) {
    throw base::InputError(fmt::format("survey station {}: {}", row + 1, what));
  };
  if (!std::isfinite(station.measured_depth)) refuse("measured depth is not a number");
  if (!std::isfinite(station.azimuth)) refuse("azimuth is not a number");
  if (!(station.inclination >= 0.0 && station.inclination <= std::numbers::pi))
    refuse(fmt::format("inclination {:g} degrees (0 to 180, from the vertical)", station.inclination * degrees));
}

}  // namespace

Vector3 tangent_of(const SurveyStation& station) {
  const double across = std::sin(station.inclination);
  return {across * std::cos(station.azimuth), across * std::sin(station.azimuth), std::cos(station.inclination)};
}

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

WellPath well_path(const std::vector<SurveyStation>& stations, const Vector3& tie_in) {
  if (stations.size() < 2)
    throw base::InputError(fmt::format("survey: {} station(s) (a path needs at least two)", stations.size()));
  require_station(stations[0], 0);
  WellPath path;
  Vector3 position = tie_in;
  for (std::size_t i = 1; i < stations.size(); ++i) {
    const SurveyStation &above = stations[i - 1], &below = stations[i];
    require_station(below, i);
    const double step = below.measured_depth - above.measured_depth;
    if (!(step > 0.0))
      throw base::InputError(fmt::format("survey station {}: measured depth {:g} m after {:g} m (depths must grow)",
                                         i + 1, below.measured_depth, above.measured_depth));
    const Vector3 from = tangent_of(above), to = tangent_of(below);
    const double beta = angle_between(from, to);
    if (beta > 0.999 * std::numbers::pi)
      throw base::InputError(fmt::format("survey station {}: a dogleg of {:.1f} degrees (below 180; has no plane)",
                                         i + 1, beta * degrees));
    path.arcs.push_back(arc_between(above.measured_depth, step, position, from, to));
    position += (0.5 * step * sinc(0.5 * beta) / std::cos(0.5 * beta)) * (from + to);
  }
  return path;
}

double end_depth(const WellPath& path) {
  return path.arcs.back().begin + path.arcs.back().length;
}

void extend_straight(WellPath& path, double to) {
  const double end = end_depth(path);
  if (!(to > end)) return;
  const WellArc& last = path.arcs.back();
  path.arcs.push_back(straight_arc(end, to - end, along(last, last.length), unit(tangent_along(last, last.length))));
}

void extend_along_last_arc(WellPath& path, double to) {
  if (!(to > end_depth(path))) return;
  WellArc& last = path.arcs.back();
  const double turned = (to - last.begin) * last.curvature;
  if (!(turned < std::numbers::pi))
    throw base::InputError(fmt::format(
        "the last arc of the well would turn by {:.1f} degrees to reach {:g} m (below 180)", turned * degrees, to));
  last.length = to - last.begin;
}

WellPoint point_at(const WellPath& path, double measured_depth, std::size_t& arc) {
  arc = std::min(arc, path.arcs.size() - 1);
  while (arc > 0 && measured_depth < path.arcs[arc].begin) --arc;
  while (arc + 1 < path.arcs.size() && measured_depth >= path.arcs[arc + 1].begin) ++arc;
  const WellArc& found = path.arcs[arc];
  const double s = measured_depth - found.begin, angle = found.curvature * s;
  return {.position = along(found, s),
          .tangent = tangent_along(found, s),
          .curvature = found.curvature * (std::cos(angle) * found.normal - std::sin(angle) * found.tangent)};
}

WellPoint point_at(const WellPath& path, double measured_depth) {
  std::size_t arc = 0;
  return point_at(path, measured_depth, arc);
}

void move_to_arc(const WellPath& path, const Vector3& position, std::size_t& arc) {
  const auto below_start = [&](std::size_t i) {
    return dot(position - path.arcs[i].start, path.arcs[i].tangent) >= 0.0;
  };
  arc = std::min(arc, path.arcs.size() - 1);
  while (arc > 0 && !below_start(arc)) --arc;
  while (arc + 1 < path.arcs.size() && below_start(arc + 1)) ++arc;
}

std::size_t nearest_arc(const WellPath& path, const Vector3& position) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.arcs.size(); ++i) {
    const WellArc& arc = path.arcs[i];
    const double s = std::clamp(foot_on(arc, position).measured_depth - arc.begin, 0.0, arc.length);
    const Vector3 away = position - along(arc, s);
    if (dot(away, away) >= least) continue;
    least = dot(away, away);
    best = i;
  }
  return best;
}

}  // namespace bitrock::runtime
