// What must fit together before a string in a well can be stepped.
#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

void require_consistent(const WellString& string) {
  const auto refuse = [](const std::string& what) { throw base::InputError("string in a well: " + what); };
  if (string.sections.empty()) refuse("no section (needs at least one)");
  for (std::size_t i = 0; i < string.sections.size(); ++i) {
    const StringSection& section = string.sections[i];
    const auto named = [&](const std::string& what) { refuse(fmt::format("section {}: {}", i + 1, what)); };
    if (!(section.length > 0.0 && std::isfinite(section.length))) named("length must be above 0");
    if (section.segments < 1) named("needs at least one segment");
    const Beam& beam = section.beam;
    for (const double value :
         {beam.axial, beam.shear, beam.torsion, beam.bending, beam.mass, beam.polar_inertia, beam.transverse_inertia})
      if (!(value > 0.0 && std::isfinite(value))) named("stiffness, mass and inertia must be above 0");
    for (const double value : {section.added_mass, section.drag_along, section.drag_across, section.drag_spinning})
      if (!(value >= 0.0 && std::isfinite(value))) named("drag and added mass must be 0 or more");
    if (!std::isfinite(section.weight)) named("weight is not a number");
    for (const HolePiece& piece : string.hole) {
      if (!(section.contact_radius < piece.radius))
        named(fmt::format("radius {:g} m in a hole of radius {:g} m from {:g} m down (must be less)",
                          section.contact_radius, piece.radius, piece.arc.begin));
      const double bar = section.length / section.segments;
      if (!(bar * piece.arc.curvature < 2.0))
        named(fmt::format("segments of {:g} m in a bend of radius {:g} m (shorter than twice the radius)", bar,
                          1.0 / piece.arc.curvature));
    }
  }
  if (!(string.wall.stiffness > 0.0 && string.wall.damping >= 0.0)) refuse("the wall's spring must be above 0");
  if (!(string.drive_inertia > 0.0 && string.block_mass > 0.0)) refuse("drive and block must have inertia and mass");
  if (string.guided && string.hole.empty()) refuse("the bit is guided, but there is no hole");
  if (string.on_rock && string.hole.empty()) refuse("the bit is on rock, but there is no hole");
  if (string.upper_end != UpperEnd::table && string.longest_grown > 0.0) refuse("only a string at a table grows");
  if (!(string.longest_grown >= 0.0 && std::isfinite(string.longest_grown))) refuse("grows by less than 0");
}

}  // namespace bitrock::runtime
