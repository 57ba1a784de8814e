#pragma once
/// A drilling case from beginning to end: many steps, a history of what a rig would like to see, and a summary that
/// sees every step. It writes no files.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/drillstring/spread.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::runtime {

/// Every list has one entry a sample; values of that instant, not means.
struct DrillSeries {
  std::vector<double> time_s;                    ///< of the sample
  std::vector<double> bit_rotation_rad_per_s;    ///< of the bit
  std::vector<double> table_rotation_rad_per_s;  ///< of the top drive
  std::vector<double> weight_on_bit_N;           ///< of the rock spring and damper
  std::vector<double> source_force_N;            ///< axial, of the source, upwards on the bit
  std::vector<double> rop_m_per_s;               ///< speed of the rock face
  std::vector<double> torque_on_bit_N_m;         ///< friction and fracture
  std::vector<double> fracture_torque_N_m;       ///< part of it
  std::vector<double> drive_torque_N_m;          ///< of the top drive on the string
  std::vector<double> bit_depth_m;               ///< below where the rock face was at the beginning
  std::vector<double> face_depth_m;              ///< below where the rock face was at the beginning
  std::vector<double> progression_angle_rad;     ///< turned forward while cutting
  std::vector<double> hook_load_N;               ///< of the hoist on the string; empty where it is imposed
  std::vector<double> block_speed_m_per_s;       ///< of the block, downwards; empty where it is not fed
};

/// Over all steps after the settling time.
struct DrillSummary {
  Spread bit_rotation;                ///< [rad/s]
  Spread weight_on_bit;               ///< [N]
  Spread total_force;                 ///< [N] weight on bit plus the source's axial force: all that the rock does
  Spread torque;                      ///< [N m] on the bit
  Spread source_force;                ///< [N] axial, of the source
  Spread source_torque;               ///< [N m] of the source: limit of the breaking rock
  Spread rop;                         ///< [m/s]
  std::optional<Spread> hook_load;    ///< [N] of a hoist that is fed
  double static_weight_on_bit = 0.0;  ///< [N] weight less hook load and jets; what `total_force` is in the mean
  double severity = 0.0;              ///< [1] (highest - lowest) / (2 mean) of the bit's rotation; 0 for a mean of 0
  double share_at_rest = 0.0;         ///< [1] of the time, bit slower than `at_rest`
  double share_backwards = 0.0;       ///< [1] of the time, bit turning back
  double share_off_bottom = 0.0;      ///< [1] of the time, no weight on bit
  double longest_stop = 0.0;          ///< [s] without a break at rest or turning back
  double longest_flight = 0.0;        ///< [s] without a break off bottom
  double drilled = 0.0;               ///< [m] of rock since the beginning; a lift at the beginning is not drilled
  double energy_residual = 0.0;       ///< [1] energy the solver lost over the work that went through the string
  ClampTally clamps;                  ///< of the networks; all 0 without
  DrawTally draws;                    ///< windows that could not have what was asked
};

/// A bit slower than 1 rpm counts as at rest.
inline constexpr double at_rest = 0.10471975511965977;  ///< [rad/s]

/// What a case gave.
struct DrillRun {
  DrillSeries series;      ///< of the samples
  DrillSummary summary;    ///< of the steps
  double step = 0.0;       ///< [s] at most that of the case, so that a sample is a whole number of steps
  long long steps = 0;     ///< taken in all
  double wall_time = 0.0;  ///< [s] on the clock
};

/// Seed of the draws of the source: of the case, or else of its bit, or else 1.
std::uint64_t seed_of(const DrillCase& drill);

/// The bit of the case with that seed.
Bit seeded_bit(const DrillCase& drill);

/// Throws `InputError` when the source needs a model, and there is none.
void require_model(const DrillCase& drill, const std::optional<surrogate::Model>& model);

/// The source of the case, and the bit behind it where there is one. Throws `InputError` when the model is missing.
struct DrillSource {
  std::shared_ptr<BitForce> bit;  ///< empty for the simple sources
  BitRockSource load;             ///< what the string feels
};
/// Throws `InputError` when the model is missing.
DrillSource make_source(const DrillCase& drill, const std::optional<surrogate::Model>& model);

/// In words, when the case is about another rock than the model; empty otherwise.
std::string other_rock(const DrillCase& drill, const surrogate::Model& model);

/// Throws `InputError` when the step is too long, `SimulationError` with the time when a number is no longer finite.
DrillRun run_drill(const DrillCase& drill, const DrillString& string, const DrillSource& source,
                   const base::ProgressCallback& progress = {});

/// Step that is run: the longest not above that of the case of which `sample` is a whole number.
double step_of(const DrillSchedule& run);

}  // namespace bitrock::runtime
