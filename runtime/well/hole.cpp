#include "runtime/well/hole.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace bitrock::runtime {

namespace {

void require_sections(const std::vector<HoleSection>& sections) {
  if (sections.empty()) throw base::InputError("hole: no section (needs at least one)");
  double above = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const HoleSection& section = sections[i];
    const auto refuse = [&](const std::string& what) {
      throw base::InputError(fmt::format("hole section {}: {}", i + 1, what));
    };
    if (!(section.to_depth > above)) refuse(fmt::format("ends at {:g} m, not below the one before", section.to_depth));
    if (!(section.diameter > 0.0 && std::isfinite(section.diameter)))
      refuse(fmt::format("diameter {:g} m (must be above 0)", section.diameter));
    if (!(section.friction >= 0.0 && std::isfinite(section.friction)))
      refuse(fmt::format("coefficient of friction {:g} (must be 0 or more)", section.friction));
    if (section.resting_friction != 0.0 &&
        !(section.resting_friction >= section.friction && std::isfinite(section.resting_friction)))
      refuse(fmt::format("friction {:g} at rest and {:g} when it slips (must be no less at rest)",
                         section.resting_friction, section.friction));
    if (!(section.slip_speed > 0.0 && std::isfinite(section.slip_speed)))
      refuse(fmt::format("slip speed of friction {:g} m/s (must be above 0)", section.slip_speed));
    above = section.to_depth;
  }
}

/// The part of an arc from one measured depth to another.
WellArc part_of(const WellPath& path, std::size_t arc, double from, double to) {
  WellArc part = path.arcs[arc];
  if (from > part.begin) {
    const double angle = part.curvature * (from - part.begin);
    const WellPoint point = point_at(path, from, arc);
    part.normal = std::cos(angle) * part.normal - std::sin(angle) * part.tangent;
    part.start = point.position;
    part.tangent = point.tangent;
    part.begin = from;
  }
  part.length = to - part.begin;
  return part;
}

}  // namespace

std::vector<HolePiece> hole_pieces(const WellPath& path, const std::vector<HoleSection>& sections) {
  require_sections(sections);
  std::vector<HolePiece> pieces;
  std::size_t section = 0;
  for (std::size_t arc = 0; arc < path.arcs.size(); ++arc) {
    const double end = path.arcs[arc].begin + path.arcs[arc].length;
    for (double from = path.arcs[arc].begin; from < end;) {
      while (section + 1 < sections.size() && sections[section].to_depth <= from) ++section;
      const bool last = section + 1 == sections.size();
      const double to = last ? end : std::min(end, sections[section].to_depth);
      std::size_t at = arc;
      const WellPoint lower = point_at(path, to, at);
      HolePiece piece{.arc = part_of(path, arc, from, to),
                      .radius = 0.5 * sections[section].diameter,
                      .friction = sections[section].friction,
                      .more_at_rest = std::max(0.0, sections[section].resting_friction - sections[section].friction),
                      .slip_speed = sections[section].slip_speed};
      piece.end_tangent = lower.tangent;
      piece.end_reach = dot(lower.tangent, lower.position);
      pieces.push_back(piece);
      from = to;
    }
  }
  pieces.back().end_reach = std::numeric_limits<double>::infinity();
  return pieces;
}

}  // namespace bitrock::runtime
