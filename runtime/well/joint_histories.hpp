#pragma once
/// The loads of every joint over a run in a well: what its steel bears, sample after sample, for the damage over depth.

#include <vector>

#include "base/hdf5_file.hpp"
#include "runtime/well/well_case.hpp"

namespace bitrock::runtime {

/// A joint between two segments, and what it bore.
struct JointHistory {
  double above_bit = 0.0;                             ///< [m] along the string
  double measured_depth = 0.0;                        ///< [m] where it was at the end
  double outer_diameter = 0.0, inner_diameter = 0.0;  ///< [m] of the weaker of the two pipes that meet there
  double bending_stiffness = 0.0;                     ///< [N m^2] of that pipe
  double tool_joint_distance = 0.0;                   ///< [m] of that pipe; 0: no tool joints that stand out
  double stand_off = 0.0;                             ///< [m] how far they stand out of its body
  std::vector<float> tension;   ///< [N] in the mud, the effective one, a value a sample after settling
  std::vector<float> axial;     ///< [Pa] of the true tension
  std::vector<float> moment_2;  ///< [N m] of bending about the second axis of the frame that turns with the pipe
  std::vector<float> moment_3;  ///< [N m] about the third
};

/// All joints of the string as it is now, from the bit up, without a value yet. Joints that come later are not kept.
std::vector<JointHistory> joints_of(const WellCase& well, const WellStringState& state);

/// One more value each, of this instant; where they are now.
void record_joints(const WellString& string, const WellStringState& state, double fluid_density,
                   std::vector<JointHistory>& joints);

/// Into the file of a run, under /joints: one list for each number of a joint, and one for each history, joint after
/// joint. Nothing without joints.
void write_joints(const std::vector<JointHistory>& joints, base::Hdf5Writer& file);

/// What `write_joints` wrote, `rows` values each; nothing where there is none. Throws `base::InputError` where the
/// lists do not fit together.
std::vector<JointHistory> read_joints(const base::Hdf5Reader& file, std::size_t rows);

}  // namespace bitrock::runtime
