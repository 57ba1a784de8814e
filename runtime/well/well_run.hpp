#pragma once
/// A case with a well from beginning to end: at rest in the hole, tripped in, drilling. It writes no files.

#include "base/progress.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::runtime {

/// One entry a sample; values of that instant.
struct WellSeries {
  std::vector<double> time_s;
  std::vector<double> hook_load_N;
  std::vector<double> drive_torque_N_m;
  std::vector<double> drive_rotation_rad_per_s;
  std::vector<double> bit_rotation_rad_per_s;
  std::vector<double> weight_on_bit_N;  ///< of the rock's spring
  std::vector<double> source_force_N;   ///< axial, of the source
  std::vector<double> torque_on_bit_N_m;
  std::vector<double> rop_m_per_s;
  std::vector<double> bit_depth_m;  ///< measured depth
  std::vector<double> fed_m;        ///< pipe through the table
  std::vector<double> bit_side_force_N;
  std::vector<std::vector<double>> stress_Pa;  ///< of each stress point: tension and bending at its angle
};

/// Over all steps of the time after `settling`, and at the end.
struct WellSummary {
  Spread hook_load, drive_torque, bit_rotation;             ///< [N], [N m], [rad/s]
  Spread weight_on_bit, source_force, rop;                  ///< [N], [N], [m/s]
  double bit_depth = 0.0;                                   ///< [m] measured depth at the end
  double fed = 0.0;                                         ///< [m]
  double drilled = 0.0;                                     ///< [m] of rock
  int segments = 0;                                         ///< at the end
  double friction_work = 0.0;                               ///< [J] at the wall
  double energy_residual = 0.0;                             ///< [1] of that
  double longest_bar = 0.0;                                 ///< [m]
  double axial_pass_band = 0.0, torsional_pass_band = 0.0;  ///< [Hz] of the usual segments at the bit: c / (pi h)
  ClampTally clamps;
  DrawTally draws;
};

struct StressAtEnd {
  StressPoint point;
  Stress stress;
  Spread normal;  ///< [Pa] over the time after `settling`, as sampled
};

struct WellRun {
  WellSeries series;
  WellSummary summary;
  std::vector<StressAtEnd> stresses;
  double step = 0.0;
  long long steps = 0;
  double wall_time = 0.0;
};

/// One joint of a string at rest.
struct JointAtRest {
  double measured_depth = 0.0, side_force = 0.0, tension = 0.0, moment = 0.0;  ///< [m], [N], [N], [N m]
};

/// Equilibrium without friction.
struct WellStatics {
  double hook_load = 0.0, bit_depth = 0.0;  ///< [N], [m]
  std::vector<JointAtRest> joints;          ///< from top to bottom
};

/// Throws `InputError` when the step is too long.
WellStatics statics(const WellCase& well, const WellString& string);

/// Throws `InputError` when the step is too long, `SimulationError` when a number is no longer finite.
WellRun run_well(const WellCase& well, const WellString& string, const DrillSource& source,
                 const base::ProgressCallback& progress = {});

}  // namespace bitrock::runtime
