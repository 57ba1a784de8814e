#include "dem2d/specimen/summary.hpp"

#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

double critical_step_of(const Specimen& specimen) {
  World world = bonded_world(specimen, 1);
  world.domain = {0.0, 0.0, specimen.width, specimen.height};
  prepare(world);
  return critical_step(world);
}

}  // namespace

SpecimenSummary summary_of(const Specimen& specimen) {
  return {.porosity = porosity(specimen),
          .coordination_number = coordination_number(specimen),
          .floaters = floaters(specimen),
          .pieces = pieces(specimen),
          .critical_step = critical_step_of(specimen)};
}

}  // namespace bitrock::dem2d
