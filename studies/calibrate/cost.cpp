#include "studies/calibrate/cost.hpp"

#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/cost.hpp"
#include "studies/calibrate/laboratory.hpp"

namespace bitrock::studies {

namespace {

constexpr double load_after_expected = 1.3;  // a test goes on until the stress has fallen again

}  // namespace

CalibrationCost cost_of(const CalibrationTarget& target) {
  const dem2d::LabSettings lab = lab_settings_of(target);
  CalibrationCost cost{.discs = dem2d::expected_discs(target.start, lab.width, lab.height)};
  const double step = dem2d::expected_step(target.start);
  for (const LaboratoryTest& test : tests_of(target)) {
    const double duration = load_after_expected * dem2d::expected_strain(test.kind, target.start, test.pressure) /
                            dem2d::default_strain_rate(test.kind, target.start, lab);
    cost.core_seconds_per_specimen += dem2d::expected_core_seconds(duration / step, cost.discs);
  }
  const int specimens =
      usual_coarse_evaluations * target.settings.scouting_seeds + usual_fine_evaluations * target.settings.seeds;
  cost.core_seconds = specimens * cost.core_seconds_per_specimen;
  return cost;
}

double expected_minutes(const CalibrationCost& cost, int cores) {
  return cost.core_seconds / cores / 60.0;
}

}  // namespace bitrock::studies
