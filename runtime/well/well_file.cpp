#include "runtime/well/well_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/hdf5_file.hpp"

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

}  // namespace

void write_well_run(const WellRun& run, const std::string& config_toml, const std::string& model, double settling,
                    const std::filesystem::path& path) {
  base::Hdf5Writer file;
  file.head(well_format, well_format_version);
  file.attribute("config_toml", config_toml);
  file.attribute("model_fingerprint", model);
  file.attribute("step_s", run.step);
  file.attribute("steps", run.steps);
  file.attribute("wall_s", run.wall_time);
  file.attribute("axial_pass_band_Hz", run.summary.axial_pass_band);
  file.attribute("torsional_pass_band_Hz", run.summary.torsional_pass_band);
  for (const SeriesEntry& entry : series_entries)
    file.array(entry.path, run.series.*entry.values, entry.units, entry.meaning);
  file.attribute("settling_s", settling);
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
  write_joints(run.joints, file);
  file.attribute("status", "complete");
  file.save(path);
}

}  // namespace bitrock::runtime
