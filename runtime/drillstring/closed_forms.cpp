#include "runtime/drillstring/closed_forms.hpp"

#include <cmath>

#include "runtime/drillstring/modes.hpp"

namespace bitrock::runtime {

namespace {

/// Of the pipe off bottom: on the line of a block, or free at both ends, where its lowest wave is half as long as it.
double axial_frequency(const DrillCase& drill, const PipeSection& pipe) {
  const double stretching = pipe.youngs_modulus * area(pipe);  // [N]
  const double speed = std::sqrt(stretching / mass_per_length(pipe));
  if (is_fed(drill.hoist)) return hung_frequency(speed, pipe.length, drill.hoist.stiffness * pipe.length / stretching);
  return 2.0 * continuous_frequency(speed, pipe.length, 1);
}

}  // namespace

std::optional<ClosedForms> closed_forms(const DrillCase& drill) {
  if (drill.pipes.size() != 1) return std::nullopt;
  const PipeSection& pipe = drill.pipes.front();
  const double torsional_speed = std::sqrt(pipe.shear_modulus / pipe.density);
  ClosedForms forms{.axial_continuous = axial_frequency(drill, pipe),
                    .torsional_continuous = continuous_frequency(torsional_speed, pipe.length, 1)};
  const Chain equal = torsional_chain(drill.pipes, drill.torsional_lumps, Lumping::end, drill.torsional_damping_ratio);
  for (int k = 1; k <= drill.torsional_lumps; ++k)
    forms.equal_lumps.push_back(equal_lumps_frequency(equal.stiffness[0], equal.inertia[0], drill.torsional_lumps, k));
  return forms;
}

}  // namespace bitrock::runtime
