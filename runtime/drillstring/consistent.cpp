// What must fit together before a drill string can be stepped.
#include <fmt/format.h>

#include "base/errors.hpp"
#include "runtime/drillstring/drill_string.hpp"

namespace bitrock::runtime {

void require_consistent(const DrillString& string) {
  const auto refuse = [](const std::string& what) { throw base::InputError("drill string: " + what); };
  if (string.torsional.size() == 0) refuse("no torsional lump (needs at least one)");
  for (const Chain* chain : {&string.axial, &string.torsional}) {
    const std::size_t n = chain->size();
    if (chain->stiffness.size() != n || chain->damping.size() != n || chain->wall_damping.size() != n)
      refuse("lists of inertias, stiffnesses and dampings differ in length");
    for (std::size_t i = 0; i < n; ++i) {
      if (!(chain->inertia[i] > 0.0))
        refuse(fmt::format("lump {} has inertia {} (must be above 0)", i, chain->inertia[i]));
      if (i > 0 && !(chain->stiffness[i] > 0.0))
        refuse(fmt::format("the spring above lump {} has stiffness {} (must be above 0)", i, chain->stiffness[i]));
    }
  }
  if (string.weights.size() != string.axial.size()) refuse("one weight an axial lump is needed");
  if (is_fed(string.hoist) && (string.axial.size() == 0 || !(string.hoist.stiffness > 0.0)))
    refuse("a hoist that is fed needs an axial chain and a line of stiffness above 0");
  if (!string.wall_moment.empty() && string.wall_moment.size() != string.torsional.size())
    refuse("one wall moment a torsional lump is needed");
  if (!(string.bit.fracture_stiffness > 0.0)) refuse("the fracture stiffness must be above 0");
  if (string.axial.size() > 0 && !(string.bit.contact.stiffness > 0.0)) refuse("the rock's stiffness must be above 0");
}

}  // namespace bitrock::runtime
