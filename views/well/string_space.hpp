#pragma once
/// The string in its well as a line in space that moves (report/space_view.hpp).

#include <filesystem>

#include "report/space_view.hpp"
#include "runtime/well/well_file.hpp"

namespace bitrock::views {

/// At most `instants` of the frames of the run, the last one among them. The guide is the middle of the hole down to
/// somewhat below the bit. The run must have frames.
report::SpaceView string_space(const runtime::WellFile& run, std::size_t instants = 61);

/// The middle of the hole at evenly spaced measured depths [m] down to `depth`: the path of the survey, or where the
/// run has none the middle of the hole at the nodes of the last frame.
struct HoleLine {
  report::SpaceLine line;
  std::vector<double> measured_depth;
};
HoleLine hole_line(const runtime::WellFile& run, double depth);

}  // namespace bitrock::views
