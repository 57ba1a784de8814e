#include "studies/drill/plan.hpp"

#include "runtime/drillstring/drill_run.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/well_modes.hpp"

namespace bitrock::studies {

StringOutlook outlook(const runtime::DrillCase& drill, const runtime::DrillString& string) {
  return {.modes = runtime::drill_modes(string),
          .forms = runtime::closed_forms(drill),
          .steady = runtime::steadiness(string),
          .control = string.drive.control,
          .longest_stable_step = runtime::longest_stable_step(string)};
}

WellOutlook outlook(const runtime::WellCase& well, const runtime::WellString& string) {
  return {.beginning = runtime::modes_of(string, 0.0),
          .drilling = runtime::modes_of(string, well.plan.run_in),
          .control = string.control,
          .longest_stable_step = runtime::longest_stable_step(string)};
}

DrillPlan plan(const runtime::DrillCase& drill, const runtime::DrillString& string) {
  const double step = runtime::step_of(drill.run);
  return {.static_weight = runtime::static_weight_on_bit(string),
          .step = step,
          .longest_stable_step = runtime::longest_stable_step(string),
          .steps = drill.run.duration / step};
}

}  // namespace bitrock::studies
