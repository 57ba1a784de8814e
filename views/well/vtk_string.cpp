#include "views/well/vtk_string.hpp"

#include <algorithm>
#include <numeric>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "views/well/string_space.hpp"

namespace bitrock::views {

namespace {

using runtime::StringFrames;

void make_one_line(VtkPolyData& data) {
  data.cells = VtkCells::lines;
  data.connectivity.resize(data.x.size());
  std::iota(data.connectivity.begin(), data.connectivity.end(), 0);
  data.offsets = {static_cast<int>(data.x.size())};
}

/// [m] at a measured depth; the last section goes on.
double hole_radius(const runtime::WellCase& well, double depth) {
  for (const runtime::HoleSection& hole : well.hole)
    if (depth <= hole.to_depth) return 0.5 * hole.diameter;
  return 0.5 * well.hole.back().diameter;
}

}  // namespace

VtkPolyData vtk_string(const StringFrames& frames, std::size_t first, std::size_t nodes) {
  const auto column = [&](const std::vector<float>& values) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first);
    return std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(nodes));
  };
  VtkPolyData data{.x = column(frames.north_m), .y = column(frames.east_m), .z = column(frames.down_m)};
  make_one_line(data);
  VtkArray offset{"offset_m", 3, {}};
  for (std::size_t i = first; i < first + nodes; ++i)
    for (const std::vector<float>* axis : {&frames.offset_north_m, &frames.offset_east_m, &frames.offset_down_m})
      offset.values.push_back((*axis)[i]);
  data.point_arrays = {std::move(offset),
                       {"measured_depth_m", 1, column(frames.measured_depth_m)},
                       {"side_force_N", 1, column(frames.side_force_N)},
                       {"tension_N", 1, column(frames.tension_N)},
                       {"torque_N_m", 1, column(frames.torque_N_m)},
                       {"bending_moment_N_m", 1, column(frames.bending_moment_N_m)},
                       {"von_mises_Pa", 1, column(frames.von_mises_Pa)}};
  return data;
}

VtkPolyData vtk_hole(const runtime::WellFile& run) {
  constexpr double below_bit = 1.03;  // so much more of the hole is shown
  const std::vector<float>& depths = run.frames.measured_depth_m;
  HoleLine hole = hole_line(run, below_bit * static_cast<double>(*std::max_element(depths.begin(), depths.end())));
  VtkPolyData data{.x = std::move(hole.line.x), .y = std::move(hole.line.y), .z = std::move(hole.line.z)};
  make_one_line(data);
  VtkArray radius{"radius_m", 1, {}};
  for (const double depth : hole.measured_depth) radius.values.push_back(hole_radius(run.well, depth));
  data.point_arrays = {std::move(radius), {"measured_depth_m", 1, std::move(hole.measured_depth)}};
  return data;
}

std::vector<VtkSeries> write_well_vtk(const runtime::WellFile& run, const std::filesystem::path& folder,
                                      const std::string& name, const base::ProgressCallback& progress) {
  const StringFrames& frames = run.frames;
  if (frames.nodes.empty())
    throw base::InputError(name + ": the run has no instants of the whole string (give the case well.frames above 0)");
  base::require_writable_folder(folder / "frames");
  base::Unfinished written;
  VtkSeriesWriter string("string", folder), hole("hole", folder);
  hole.add(frames.time_s.front(), vtk_hole(run), written);
  std::size_t first = 0;
  for (std::size_t k = 0; k < frames.nodes.size(); ++k) {
    base::throw_if_stopped();
    const auto nodes = static_cast<std::size_t>(frames.nodes[k]);
    string.add(frames.time_s[k], vtk_string(frames, first, nodes), written);
    first += nodes;
    if (progress) progress(static_cast<double>(k + 1), static_cast<double>(frames.nodes.size()));
  }
  std::vector<VtkSeries> shown{string.finish(), hole.finish()};
  written.keep();
  return shown;
}

}  // namespace bitrock::views
