#pragma once
/// The whole string at a few instants of a run: where it lies, how it presses on the wall, what it bears. What one
/// looks at afterwards; 32 bits are enough for that.

#include <span>
#include <vector>

#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

/// Node after node of one instant, from the bit up to the table, and one instant after the other. A node is the lower
/// end of the string, a joint, or its upper end.
struct StringFrames {
  std::vector<double> time_s;                       ///< of each instant
  std::vector<int> nodes;                           ///< of each instant, two or more
  std::vector<float> measured_depth_m;              ///< along the hole
  std::vector<float> north_m, east_m, down_m;       ///< from the rotary table
  std::vector<float> offset_north_m;                ///< from the middle of the hole, across it
  std::vector<float> offset_east_m, offset_down_m;  ///< the same
  std::vector<float> side_force_N;                  ///< of the wall
  std::vector<float> tension_N;                     ///< effective: what hook load and contact feel
  std::vector<float> torque_N_m;                    ///< positive as the drive winds the string up
  std::vector<float> bending_moment_N_m;            ///< its size
  std::vector<float> von_mises_Pa;                  ///< largest around the pipe, of the weaker one of the two
};

/// Adds the string as it is now. `pipes`: of the sections of the string. `fluid_density` [kg/m^3] around it.
void add_frame(const WellString& string, const WellStringState& state, std::span<const PipeSection> pipes,
               double fluid_density, StringFrames& frames);

/// Whether an instant of a run is kept: `wished` of `samples`, as evenly as they lie, the last one among them.
/// `sample` counts from 1.
bool is_kept(long long sample, long long samples, int wished);

}  // namespace bitrock::runtime
