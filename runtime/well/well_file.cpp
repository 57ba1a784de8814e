#include "runtime/well/well_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "base/text.hpp"
#include "runtime/drillstring/series_file.hpp"

namespace bitrock::runtime {

namespace {

struct SeriesEntry {
  const char* path;
  std::vector<double> WellSeries::*values;
  const char *units, *meaning;
};
constexpr std::array<SeriesEntry, 12> series_entries{
    {{"/series/time_s", &WellSeries::time_s, "s", "instant of the sample"},
     {"/series/hook_load_N", &WellSeries::hook_load_N, "N", "of the hoist on the string, upwards"},
     {"/series/drive_torque_N_m", &WellSeries::drive_torque_N_m, "N m", "of the top drive on the string"},
     {"/series/drive_rotation_rad_per_s", &WellSeries::drive_rotation_rad_per_s, "rad/s", "of the top drive"},
     {"/series/bit_rotation_rad_per_s", &WellSeries::bit_rotation_rad_per_s, "rad/s", "of the bit"},
     {"/series/weight_on_bit_N", &WellSeries::weight_on_bit_N, "N", "of the rock's spring and damper"},
     {"/series/source_force_N", &WellSeries::source_force_N, "N", "axial force of the source on the bit, upwards"},
     {"/series/torque_on_bit_N_m", &WellSeries::torque_on_bit_N_m, "N m", "friction and fracture, against rotation"},
     {"/series/rop_m_per_s", &WellSeries::rop_m_per_s, "m/s", "rate of penetration: speed of the rock face"},
     {"/series/bit_depth_m", &WellSeries::bit_depth_m, "m", "measured depth of the bit"},
     {"/series/fed_m", &WellSeries::fed_m, "m", "pipe that came through the table"},
     {"/series/bit_side_force_N", &WellSeries::bit_side_force_N, "N", "of the hole on the bit, across it"}}};

struct FrameEntry {
  const char* path;
  std::vector<float> StringFrames::*values;
  const char *units, *meaning;
};
constexpr std::array<FrameEntry, 12> frame_entries{
    {{"/string/measured_depth_m", &StringFrames::measured_depth_m, "m", "of the node, along the hole"},
     {"/string/north_m", &StringFrames::north_m, "m", "of the node, from the rotary table"},
     {"/string/east_m", &StringFrames::east_m, "m", "of the node, from the rotary table"},
     {"/string/down_m", &StringFrames::down_m, "m", "of the node, from the rotary table"},
     {"/string/offset_north_m", &StringFrames::offset_north_m, "m", "of the node from the middle of the hole"},
     {"/string/offset_east_m", &StringFrames::offset_east_m, "m", "of the node from the middle of the hole"},
     {"/string/offset_down_m", &StringFrames::offset_down_m, "m", "of the node from the middle of the hole"},
     {"/string/side_force_N", &StringFrames::side_force_N, "N", "of the wall on the node"},
     {"/string/tension_N", &StringFrames::tension_N, "N", "effective tension at the node"},
     {"/string/torque_N_m", &StringFrames::torque_N_m, "N m",
      "torque at the node, positive as the drive winds the string up"},
     {"/string/bending_moment_N_m", &StringFrames::bending_moment_N_m, "N m", "bending moment at the node"},
     {"/string/von_mises_Pa", &StringFrames::von_mises_Pa, "Pa",
      "largest von Mises stress around the pipe at the node, without the peak at a tool joint"}}};

void write_frames(base::Hdf5Writer& file, const StringFrames& frames) {
  if (frames.time_s.empty()) return;
  file.array("/string/time_s", frames.time_s, "s", "instant");
  file.array("/string/nodes", frames.nodes, "1",
             "of this instant: bit, joints from the bit up, table; the other arrays have one instant after the other");
  for (const FrameEntry& entry : frame_entries)
    file.array(entry.path, frames.*entry.values, entry.units, entry.meaning);
}

StringFrames read_frames(const base::Hdf5Reader& file) {
  StringFrames frames;
  if (!file.has("/string/time_s")) return frames;
  frames.nodes = file.ints("/string/nodes");
  std::size_t all = 0;
  for (const int nodes : frames.nodes) {
    if (nodes < 2) throw base::InputError(fmt::format("{}: /string/nodes has {} (at least 2)", file.name(), nodes));
    all += static_cast<std::size_t>(nodes);
  }
  frames.time_s = finite_array(file, "/string/time_s", frames.nodes.size());
  for (const FrameEntry& entry : frame_entries) {
    const std::vector<double> values = finite_array(file, entry.path, all);
    (frames.*entry.values).assign(values.begin(), values.end());
  }
  return frames;
}

std::string orbit_path(std::size_t point, const char* side) {
  return fmt::format("/orbit/point_{}_{}_m", point + 1, side);
}

void write_orbits(base::Hdf5Writer& file, const WellRun& run) {
  std::vector<double> clearance, depth;
  for (std::size_t p = 0; p < run.orbits.size(); ++p) {
    const Orbit& orbit = run.orbits[p];
    const std::string whose =
        "where the joint nearest to " + run.stresses[p].point.name + " is, from the middle of the hole ";
    file.array(orbit_path(p, "up"), orbit.up_m, "m", whose + "towards the high side (below 3 degrees: north)");
    file.array(orbit_path(p, "right"), orbit.right_m, "m", whose + "to the right, looking down");
    clearance.push_back(orbit.clearance);
    depth.push_back(orbit.measured_depth);
  }
  if (clearance.empty()) return;
  file.array("/orbit/clearance_m", clearance, "m", "of the joints: between pipe and wall when it is in the middle");
  file.array("/orbit/measured_depth_m", depth, "m", "where the joints were at the end");
}

std::vector<Orbit> read_orbits(const base::Hdf5Reader& file, std::size_t points, std::size_t samples) {
  std::vector<Orbit> orbits;
  if (points == 0 || !file.has("/orbit/clearance_m")) return orbits;
  const std::vector<double> clearance = finite_array(file, "/orbit/clearance_m", points);
  const std::vector<double> depth = finite_array(file, "/orbit/measured_depth_m", points);
  for (std::size_t p = 0; p < points; ++p) {
    const std::vector<double> up = finite_array(file, orbit_path(p, "up"), samples);
    const std::vector<double> right = finite_array(file, orbit_path(p, "right"), samples);
    orbits.push_back({.up_m = {up.begin(), up.end()},
                      .right_m = {right.begin(), right.end()},
                      .clearance = clearance[p],
                      .measured_depth = depth[p]});
  }
  return orbits;
}

/// The path and the hole, which a survey file of the case would otherwise keep to itself.
void write_profile(base::Hdf5Writer& file, const WellCase& well) {
  std::vector<double> depth, inclination, azimuth;
  for (const SurveyStation& station : well.stations) {
    depth.push_back(station.measured_depth);
    inclination.push_back(station.inclination);
    azimuth.push_back(station.azimuth);
  }
  file.array("/well/measured_depth_m", depth, "m", "of the stations of the survey");
  file.array("/well/inclination_rad", inclination, "rad", "of the stations, from the vertical");
  file.array("/well/azimuth_rad", azimuth, "rad", "of the stations, from north to east");
}

}  // namespace

void write_well_run(const WellRun& run, const WellCase& well, const std::string& model,
                    const std::filesystem::path& path) {
  base::Hdf5Writer file;
  WellCase without_path = well, with_path = well;  // the networks count by what they are, not by where they lie
  without_path.drill.source.model_file.clear();
  std::string& networks = with_path.drill.source.model_file;
  if (!networks.empty()) networks = std::filesystem::absolute(networks).lexically_normal().string();
  file.head(well_format, well_format_version);
  file.attribute("config_toml", resolved_toml(with_path));
  file.attribute("config_hash", base::fingerprint_text(resolved_toml(without_path) + model));
  file.attribute("model_fingerprint", model);
  file.attribute("step_s", run.step);
  file.attribute("steps", run.steps);
  file.attribute("wall_s", run.wall_time);
  file.attribute("axial_pass_band_Hz", run.summary.axial_pass_band);
  file.attribute("torsional_pass_band_Hz", run.summary.torsional_pass_band);
  for (const SeriesEntry& entry : series_entries)
    file.array(entry.path, run.series.*entry.values, entry.units, entry.meaning);
  file.attribute("settling_s", well.drill.run.settling);
  std::string names;  // a line each
  std::vector<double> depths;
  for (std::size_t p = 0; p < run.stresses.size(); ++p) {
    file.array(fmt::format("/stress/point_{}_Pa", p + 1), run.series.stress_Pa[p], "Pa",
               "tension and bending of a point that turns with the pipe: " + run.stresses[p].point.name);
    std::string name = run.stresses[p].point.name;
    std::replace(name.begin(), name.end(), '\n', ' ');
    names += name + "\n";
    depths.push_back(run.stresses[p].stress.measured_depth);
  }
  file.attribute("stress_points", names);
  if (!depths.empty()) file.array("/stress/measured_depth_m", depths, "m", "where the points were at the end");
  write_orbits(file, run);
  write_frames(file, run.frames);
  write_profile(file, well);
  write_joints(run.joints, file);
  file.attribute("status", "complete");
  file.save(path);
}

WellFile read_well_run(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  file.require_format(well_format, well_format_version);
  WellFile result{.well = recorded_well_case(file.text_attribute("config_toml"), file.name() + " (config_toml)"),
                  .model = file.text_attribute("model_fingerprint"),
                  .stress = read_stress_histories(file),
                  .step = file.number_attribute("step_s"),
                  .wall_time = file.number_attribute("wall_s"),
                  .axial_pass_band = file.number_attribute("axial_pass_band_Hz"),
                  .torsional_pass_band = file.number_attribute("torsional_pass_band_Hz")};
  const std::vector<double>& time = result.stress.time;
  for (const SeriesEntry& entry : series_entries)
    result.series.*entry.values = finite_array(file, entry.path, time.size());
  const auto settled =
      static_cast<std::size_t>(time.end() - std::upper_bound(time.begin(), time.end(), result.stress.settling));
  result.orbits = read_orbits(file, result.stress.points.size(), settled);
  result.frames = read_frames(file);
  return result;
}

bool holds_well_run(const std::filesystem::path& path) {
  return base::Hdf5Reader(path).text_attribute("format") == well_format;
}

}  // namespace bitrock::runtime
