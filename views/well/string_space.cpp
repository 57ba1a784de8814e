#include "views/well/string_space.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "runtime/well/well_path.hpp"

namespace bitrock::views {

namespace {

using runtime::StringFrames;

/// What the string may be coloured by.
struct Colouring {
  const char* name;
  double unit;
  std::vector<float> StringFrames::*values;
};
constexpr Colouring colourings[] = {{"von Mises stress [MPa]", base::MPa, &StringFrames::von_mises_Pa},
                                    {"side force [kN]", base::kN, &StringFrames::side_force_N},
                                    {"effective tension [kN]", base::kN, &StringFrames::tension_N},
                                    {"bending moment [kN m]", base::kN, &StringFrames::bending_moment_N_m}};

std::vector<double> part(const std::vector<float>& values, std::size_t first, std::size_t count, double unit = 1.0) {
  std::vector<double> taken;
  taken.reserve(count);
  for (std::size_t i = first; i < first + count; ++i) taken.push_back(static_cast<double>(values[i]) / unit);
  return taken;
}

report::SpaceFrame frame_of(const StringFrames& frames, std::size_t k, std::size_t first) {
  const auto count = static_cast<std::size_t>(frames.nodes[k]);
  report::SpaceFrame frame{
      .label = fmt::format("{:.1f} s, bit at {:.1f} m", frames.time_s[k], frames.measured_depth_m[first]),
      .line = {part(frames.north_m, first, count), part(frames.east_m, first, count),
               part(frames.down_m, first, count)},
      .shift = {part(frames.offset_north_m, first, count), part(frames.offset_east_m, first, count),
                part(frames.offset_down_m, first, count)},
      .values = {}};
  for (const Colouring& what : colourings) frame.values.push_back(part(frames.*what.values, first, count, what.unit));
  return frame;
}

}  // namespace

HoleLine hole_line(const runtime::WellFile& run, double depth) {
  HoleLine hole;
  if (run.well.stations.empty()) {
    const StringFrames& frames = run.frames;
    for (std::size_t n = 0; n < static_cast<std::size_t>(frames.nodes.back()); ++n) {
      const std::size_t k = frames.north_m.size() - 1 - n;
      hole.line.x.push_back(static_cast<double>(frames.north_m[k]) - static_cast<double>(frames.offset_north_m[k]));
      hole.line.y.push_back(static_cast<double>(frames.east_m[k]) - static_cast<double>(frames.offset_east_m[k]));
      hole.line.z.push_back(static_cast<double>(frames.down_m[k]) - static_cast<double>(frames.offset_down_m[k]));
      hole.measured_depth.push_back(frames.measured_depth_m[k]);
    }
    return hole;
  }
  constexpr int pieces = 300;
  const runtime::WellPath path = runtime::well_path(run.well.stations);
  std::size_t arc = 0;
  for (int k = 0; k <= pieces; ++k) {
    const double at = depth * k / pieces;
    const runtime::Vector3 place = runtime::point_at(path, at, arc).position;
    hole.line.x.push_back(place.x);
    hole.line.y.push_back(place.y);
    hole.line.z.push_back(place.z);
    hole.measured_depth.push_back(at);
  }
  return hole;
}

report::SpaceView string_space(const runtime::WellFile& run, std::size_t instants) {
  const StringFrames& frames = run.frames;
  constexpr double below_bit = 1.03;  // so much more of the hole is shown
  const double deepest =
      static_cast<double>(*std::max_element(frames.measured_depth_m.begin(), frames.measured_depth_m.end()));
  HoleLine hole = hole_line(run, below_bit * deepest);
  report::SpaceView view{.title = "Over time, coloured by what it bears",
                         .caption =
                             "Drag the picture to turn it. The string is drawn off the middle of the hole "
                             "(grey, with measured depths) by its offset times the magnification, so it may stand "
                             "metres beside it; lengths along the hole are true.",
                         .x_label = "north",
                         .y_label = "east",
                         .z_label = "depth",
                         .unit = "m",
                         .shift_label = "offset",
                         .guide = std::move(hole.line),
                         .guide_marks = std::move(hole.measured_depth),
                         .marks_label = "measured depth",
                         .values = {},
                         .frames = {},
                         .magnification = 500.0};
  for (const Colouring& what : colourings) view.values.push_back({what.name});
  std::size_t first = 0;
  const std::size_t count = frames.nodes.size(), kept = std::min(count, instants);
  for (std::size_t k = 0; k < count; ++k) {
    // the last frame is kept, and as many before it as are wanted, evenly
    if ((k + 1) * kept / count > k * kept / count) view.frames.push_back(frame_of(frames, k, first));
    first += static_cast<std::size_t>(frames.nodes[k]);
  }
  return view;
}

}  // namespace bitrock::views
