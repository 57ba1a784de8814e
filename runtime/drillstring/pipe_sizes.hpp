#pragma once
/// Pipe that people ask for by its name: drill pipe, heavy-weight drill pipe and collars of common sizes.

#include <span>
#include <string_view>

namespace bitrock::runtime {

struct PipeSize {
  std::string_view name;             ///< as a case names it, "DP 5 19.5"
  double outer_diameter = 0.0;       ///< [m] of the body
  double inner_diameter = 0.0;       ///< [m] of the body
  double tool_joint_diameter = 0.0;  ///< [m] outer; that of the body where there are none
  double linear_mass = 0.0;          ///< [kg/m] with tool joints; 0: of the body alone
};

/// All that have a name.
std::span<const PipeSize> pipe_sizes();

/// The pipe of that name; none where there is no such name.
const PipeSize* find_pipe_size(std::string_view name);

}  // namespace bitrock::runtime
