#pragma once
/// A case with a well from beginning to end: at rest in the hole, tripped in, drilling. It writes no files.

#include "base/progress.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "runtime/well/joint_histories.hpp"
#include "runtime/well/orbit.hpp"
#include "runtime/well/string_frames.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::runtime {

/// One entry a sample; values of that instant.
struct WellSeries {
  std::vector<double> time_s;                    ///< instant
  std::vector<double> hook_load_N;               ///< of the hoist on the string, upwards
  std::vector<double> drive_torque_N_m;          ///< of the top drive on the string
  std::vector<double> drive_rotation_rad_per_s;  ///< of the top drive
  std::vector<double> bit_rotation_rad_per_s;    ///< of the bit
  std::vector<double> weight_on_bit_N;           ///< of the rock's spring
  std::vector<double> source_force_N;            ///< axial, of the source
  std::vector<double> torque_on_bit_N_m;         ///< friction and fracture, against rotation
  std::vector<double> rop_m_per_s;               ///< speed of the rock face
  std::vector<double> bit_depth_m;               ///< measured depth
  std::vector<double> fed_m;                     ///< pipe through the table
  std::vector<double> bit_side_force_N;          ///< of the hole on the bit, across it
  std::vector<std::vector<double>> stress_Pa;    ///< of each stress point: tension and bending at its angle
};

/// Over all steps of the time after `settling`, and at the end.
struct WellSummary {
  Spread hook_load, drive_torque, bit_rotation;             ///< [N], [N m], [rad/s]
  Spread weight_on_bit, source_force, rop;                  ///< [N], [N], [m/s]
  Spread source_torque;                                     ///< [N m] of the source: limit of the breaking rock
  double bit_depth = 0.0;                                   ///< [m] measured depth at the end
  double fed = 0.0;                                         ///< [m]
  double drilled = 0.0;                                     ///< [m] of rock
  int segments = 0;                                         ///< at the end
  double friction_work = 0.0;                               ///< [J] at the wall
  double energy_residual = 0.0;                             ///< [1] of that
  double longest_bar = 0.0;                                 ///< [m]
  double axial_pass_band = 0.0, torsional_pass_band = 0.0;  ///< [Hz] of the usual segments at the bit: c / (pi h)
  ClampTally clamps;                                        ///< questions to the networks outside their range
  DrawTally draws;                                          ///< of peaks
};

/// A stress point of the case, and what it felt.
struct StressAtEnd {
  StressPoint point;  ///< of the case
  Stress stress;      ///< at the end
  Spread normal;      ///< [Pa] over the time after `settling`, as sampled
};

/// All that a run gave.
struct WellRun {
  WellSeries series;                  ///< samples
  WellSummary summary;                ///< means and extremes
  std::vector<StressAtEnd> stresses;  ///< in the order of the case
  std::vector<Orbit> orbits;          ///< of the joints nearest to these points, after `settling`
  StringFrames frames;                ///< the whole string at the beginning, and so often as the case asks
  std::vector<JointHistory> joints;   ///< from the bit up, where the case keeps them
  double step = 0.0;                  ///< [s]
  long long steps = 0;                ///< taken
  double wall_time = 0.0;             ///< [s] on the clock
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

/// The string of the case as a run begins: at rest, without friction, off bottom.
WellStringState brought_to_rest(const WellCase& well, const WellString& string);

/// Throws `InputError` when the step is too long.
WellStatics statics(const WellCase& well, const WellString& string);

/// What `WellSummary` sees, step by step.
struct SeenAfterSettling {
  RunningSpread hook, torque, rotation, weight, source, source_torque, rop;  ///< as in `WellSummary`

  /// The next step.
  void add(const WellStringState& state);
};

/// A run under way. A copy goes on by itself, to the same bits: runs that differ at the bit alone share their trip.
struct WellUnderWay {
  WellRun run;                        ///< so far
  WellStringState state;              ///< now
  RigState rig;                       ///< now
  SeenAfterSettling seen;             ///< so far
  std::vector<RunningSpread> stress;  ///< of the stress points, so far
  double initial = 0.0;               ///< [J] stored at the beginning
  long long samples = 0;              ///< taken
};

/// At rest in the hole. Throws `InputError` when the step is too long.
WellUnderWay begun_run(const WellCase& well, const WellString& string);

/// Samples of a whole run.
long long samples_of(const WellCase& well);

/// Goes on for one sample. Throws `SimulationError` when a number is no longer finite.
void take_sample(const WellCase& well, const WellString& string, const DrillSource& source, WellUnderWay& way);

/// Goes on to the end. Throws as `take_sample` does.
WellRun finished_run(const WellCase& well, const WellString& string, const DrillSource& source, WellUnderWay way,
                     const base::ProgressCallback& progress = {});

/// From beginning to end. Throws `InputError` when the step is too long, `SimulationError` when a number is no longer
/// finite.
WellRun run_well(const WellCase& well, const WellString& string, const DrillSource& source,
                 const base::ProgressCallback& progress = {});

}  // namespace bitrock::runtime
