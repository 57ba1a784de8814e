#include "runtime/drillstring/drill_file.hpp"

#include "base/hdf5_file.hpp"
#include "base/text.hpp"
#include "base/version.hpp"

namespace runtime {

namespace {

constexpr const char* format_name = "bitrock-drill";
constexpr long long format_version = 1;

void write_series(base::Hdf5Writer& file, const DrillSeries& s) {
  file.array("/series/time_s", s.time_s, "s", "instant of the sample");
  file.array("/series/bit_rotation_rad_per_s", s.bit_rotation_rad_per_s, "rad/s", "of the bit");
  file.array("/series/table_rotation_rad_per_s", s.table_rotation_rad_per_s, "rad/s", "of the top drive");
  file.array("/series/weight_on_bit_N", s.weight_on_bit_N, "N", "of the rock's spring and damper");
  file.array("/series/source_force_N", s.source_force_N, "N", "axial force of the source on the bit, upwards");
  file.array("/series/rop_m_per_s", s.rop_m_per_s, "m/s", "rate of penetration: speed of the rock face");
  file.array("/series/torque_on_bit_N_m", s.torque_on_bit_N_m, "N m", "friction and fracture, against rotation");
  file.array("/series/fracture_torque_N_m", s.fracture_torque_N_m, "N m", "part of the torque on the bit");
  file.array("/series/drive_torque_N_m", s.drive_torque_N_m, "N m", "of the top drive on the string");
  file.array("/series/bit_depth_m", s.bit_depth_m, "m", "below the rock face of the beginning");
  file.array("/series/face_depth_m", s.face_depth_m, "m", "of the rock face");
  file.array("/series/progression_angle_rad", s.progression_angle_rad, "rad", "turned forward while cutting");
}

}  // namespace

void write_drill_run(const DrillRun& run, const DrillCase& drill, const std::string& model,
                     const std::filesystem::path& path) {
  base::Hdf5Writer file;
  const std::string config = resolved_toml(drill);
  file.attribute("format", format_name);
  file.attribute("format_version", format_version);
  file.attribute("version", base::version);
  file.attribute("git_commit", base::git_commit);
  file.attribute("config_toml", config);
  file.attribute("config_hash", base::fingerprint_text(config + model));
  file.attribute("model_fingerprint", model);
  file.attribute("step_s", run.step);
  file.attribute("steps", run.steps);
  const DrillSummary& summary = run.summary;
  file.attribute("static_weight_on_bit_N", summary.static_weight_on_bit);
  file.attribute("severity", summary.severity);
  file.attribute("share_at_rest", summary.share_at_rest);
  file.attribute("share_backwards", summary.share_backwards);
  file.attribute("share_off_bottom", summary.share_off_bottom);
  file.attribute("energy_residual_fraction", summary.energy_residual);
  file.attribute("clamped", static_cast<long long>(summary.clamps.clamped()));
  file.attribute("wall_s", run.wall_time);
  write_series(file, run.series);
  file.attribute("status", "complete");
  file.save(path);
}

}  // namespace runtime
