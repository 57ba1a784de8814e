#pragma once
/// The load history of a bit that turns and advances steadily: what a user feeds to another simulation, and the
/// simplest way to look at a bit. No drill string, hence no vibration.

#include <vector>

#include "base/progress.hpp"
#include "runtime/bit/bit_force.hpp"

namespace bitrock::runtime {

/// No bit turns slower or faster while it drills, and none advances faster: soft sand takes some 150 m/h. The limits
/// keep angles and depths within what numbers can hold.
inline constexpr double slowest_rpm = 0.01, fastest_rpm = 1e4, fastest_m_per_h = 2000.0;

/// How the bit turns and drills.
struct ConstantSpeed {
  double rotation = 0.0;             ///< [rad/s] `slowest_rpm` to `fastest_rpm`
  double rate_of_penetration = 0.0;  ///< [m/s] 0 to `fastest_m_per_h`; up to `slowest_advance` the load is 0
  double duration = 0.0;             ///< [s] above 0
  double rate = 0.0;                 ///< [Hz] samples a second, above 0
};

/// What a record says in a few numbers.
struct SignalSummary {
  double mean_force_N = 0.0;     ///< axial
  double max_force_N = 0.0;      ///< axial
  double mean_torque_N_m = 0.0;  ///< over the record
  double max_torque_N_m = 0.0;   ///< over the record
  double depth_of_cut_m = 0.0;   ///< of every cutter, before any clamping to the training range
  ClampTally clamps;             ///< questions outside the training range
  DrawTally draws;               ///< windows that could not have what was asked
};

/// Sample i is taken at i / rate, i = 0, 1, ... while that is before `duration`.
struct Signal {
  std::vector<double> time_s;         ///< of each sample
  std::vector<double> angle_rad;      ///< the bit has turned
  std::vector<double> axial_force_N;  ///< of the rock on the bit, pushing it off
  std::vector<double> torque_N_m;     ///< of the rock on the bit, resisting rotation
  SignalSummary summary;              ///< of the whole record
};

/// Most samples of one signal: 640 MB.
inline constexpr double most_samples = 2e7;

/// Throws `InputError` when a number of `run` is not finite, out of range, or together they ask for more than
/// `most_samples`.
Signal constant_speed_signal(const Bit& bit, const surrogate::Model& model, const ConstantSpeed& run,
                             const base::ProgressCallback& progress = {});

}  // namespace bitrock::runtime
