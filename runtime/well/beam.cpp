#include "runtime/well/beam.hpp"

namespace bitrock::runtime {

Beam beam_of(const PipeSection& pipe) {
  const double ratio = pipe.inner_diameter / pipe.outer_diameter, m = ratio * ratio;
  const double nu = pipe.youngs_modulus / (2.0 * pipe.shear_modulus) - 1.0;
  const double ring = (1.0 + m) * (1.0 + m);
  const double kappa = 6.0 * (1.0 + nu) * ring / ((7.0 + 6.0 * nu) * ring + (20.0 + 12.0 * nu) * m);
  const double j = polar_moment(pipe);
  return {.axial = pipe.youngs_modulus * area(pipe),
          .shear = kappa * pipe.shear_modulus * area(pipe),
          .torsion = pipe.shear_modulus * j,
          .bending = 0.5 * pipe.youngs_modulus * j,
          .mass = mass_per_length(pipe),
          .polar_inertia = pipe.density * j,
          .transverse_inertia = 0.5 * pipe.density * j};
}

}  // namespace bitrock::runtime
