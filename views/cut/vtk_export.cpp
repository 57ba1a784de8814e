#include "views/cut/vtk_export.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "dem2d/tool/cutter.hpp"
#include "views/cut/crack_faces.hpp"

namespace bitrock::views {

namespace {

/// Cells of `points` points each, which use all points in order.
void number_cells(VtkPolyData& data, int points) {
  data.connectivity.resize(data.x.size());
  std::iota(data.connectivity.begin(), data.connectivity.end(), 0);
  for (int end = points; end <= static_cast<int>(data.x.size()); end += points) data.offsets.push_back(end);
}

void add_line(VtkPolyData& data, const Segment& line) {
  data.x.insert(data.x.end(), {line.x1, line.x2});
  data.y.insert(data.y.end(), {line.y1, line.y2});
}

/// The face of the joint as it was when the crack opened.
Segment face_at_breaking(const dem2d::Crack& crack, int elements) {
  const double half = 0.5 * crack.length * elements;
  const double along_x = -std::sin(crack.normal_angle) * half, along_y = std::cos(crack.normal_angle) * half;
  return {crack.x - along_x, crack.y - along_y, crack.x + along_x, crack.y + along_y};
}

/// The sample of the force history that ends nearest to `time`.
std::size_t nearest_sample(const std::vector<double>& times, double time) {
  const auto after = std::lower_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return 0;
  const auto k = static_cast<std::size_t>(after - times.begin());
  return k == times.size() || time - times[k - 1] < times[k] - time ? k - 1 : k;
}

}  // namespace

VtkPolyData vtk_discs(const dem2d::Frame& frame) {
  VtkPolyData data{.x = frame.x, .y = frame.y, .cells = VtkCells::vertices};
  number_cells(data, 1);
  data.point_arrays.push_back({"radius_m", 1, frame.radius});
  if (!frame.velocity_x.empty()) {
    std::vector<double> velocity;
    for (std::size_t i = 0; i < frame.x.size(); ++i)
      velocity.insert(velocity.end(), {frame.velocity_x[i], frame.velocity_y[i], 0.0});
    data.point_arrays.push_back({"velocity_m_per_s", 3, std::move(velocity)});
  }
  data.point_integers.push_back({"id", frame.id});
  data.point_integers.push_back({"fragment", frame.fragment});
  return data;
}

VtkPolyData vtk_joints(const dem2d::Frame& frame) {
  VtkPolyData data{.x = frame.x, .y = frame.y, .cells = VtkCells::lines};
  if (frame.id.empty()) return data;
  std::vector<int> place(static_cast<std::size_t>(*std::max_element(frame.id.begin(), frame.id.end())) + 1, -1);
  for (std::size_t i = 0; i < frame.id.size(); ++i) place[static_cast<std::size_t>(frame.id[i])] = static_cast<int>(i);
  for (std::size_t k = 0; k < frame.joint_disc1.size(); ++k) {
    const int first = place[static_cast<std::size_t>(frame.joint_disc1[k])],
              second = place[static_cast<std::size_t>(frame.joint_disc2[k])];
    data.connectivity.insert(data.connectivity.end(), {first, second});
    data.offsets.push_back(static_cast<int>(data.connectivity.size()));
  }
  return data;
}

VtkPolyData vtk_cracks(const dem2d::RunFile& run, const dem2d::Frame& frame) {
  const std::vector<dem2d::Crack> cracks = cracks_until(run.run.cracks, frame.time);
  const DrawnDiscs discs{frame.x, frame.y, frame.radius, frame.id, frame.fragment, run.run.discs};
  const std::vector<std::optional<Segment>> faces = crack_faces(discs, cracks);
  VtkPolyData data{.cells = VtkCells::lines};
  VtkArray time{"time_s", 1, {}}, length{"length_m", 1, {}};
  VtkIntegers mode{"mode", {}}, parted{"parted", {}};
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    add_line(data, faces[k] ? *faces[k] : face_at_breaking(cracks[k], run.cut.rock.elements));
    time.values.push_back(cracks[k].time);
    length.values.push_back(cracks[k].length);
    mode.values.push_back(static_cast<int>(cracks[k].mode));
    parted.values.push_back(faces[k] ? 0 : 1);
  }
  number_cells(data, 2);
  data.cell_arrays = {std::move(time), std::move(length)};
  data.cell_integers = {std::move(mode), std::move(parted)};
  return data;
}

VtkPolyData vtk_cutter(const dem2d::RunFile& run, const dem2d::Frame& frame) {
  const dem2d::CutCase& cut = run.cut;
  dem2d::ConvexPolygon outline =
      dem2d::cutter_outline(dem2d::cutter_shape(cut), frame.tip_x, cut.bed_height - cut.depth_of_cut);
  VtkPolyData data{.x = std::move(outline.x), .y = std::move(outline.y), .cells = VtkCells::polygons};
  number_cells(data, static_cast<int>(data.x.size()));
  const std::size_t sample = nearest_sample(run.run.time, frame.time);
  data.cell_arrays = {{"force_x_N_per_m", 1, {run.run.force_x[sample]}},
                      {"force_y_N_per_m", 1, {run.run.force_y[sample]}}};
  return data;
}

}  // namespace bitrock::views
