#include "runtime/drillstring/closed_forms.hpp"

#include <cmath>

#include "runtime/drillstring/modes.hpp"

namespace bitrock::runtime {

std::optional<ClosedForms> closed_forms(const DrillCase& drill) {
  if (drill.pipes.size() != 1) return std::nullopt;
  const PipeSection& pipe = drill.pipes.front();
  const double axial_speed = std::sqrt(pipe.youngs_modulus * area(pipe) / mass_per_length(pipe));
  const double torsional_speed = std::sqrt(pipe.shear_modulus / pipe.density);
  ClosedForms forms{.axial_continuous = continuous_frequency(axial_speed, pipe.length, 1),
                    .torsional_continuous = continuous_frequency(torsional_speed, pipe.length, 1)};
  const Chain equal = torsional_chain(drill.pipes, drill.torsional_lumps, Lumping::end, drill.torsional_damping_ratio);
  for (int k = 1; k <= drill.torsional_lumps; ++k)
    forms.equal_lumps.push_back(equal_lumps_frequency(equal.stiffness[0], equal.inertia[0], drill.torsional_lumps, k));
  return forms;
}

}  // namespace bitrock::runtime
