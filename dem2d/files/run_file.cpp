#include "dem2d/files/run_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/text.hpp"
#include "dem2d/files/frame_file.hpp"
#include "dem2d/step/physics_version.hpp"

namespace bitrock::dem2d {

namespace {

constexpr const char* format_name = "bitrock-run";
constexpr long long format_version = 2;

template <class Value, class Get>
std::vector<Value> collect(const std::vector<Crack>& cracks, const Get& get) {
  std::vector<Value> values;
  values.reserve(cracks.size());
  for (const Crack& crack : cracks) values.push_back(get(crack));
  return values;
}

void write_cracks(base::Hdf5Writer& file, const std::vector<Crack>& cracks) {
  const auto real = [&](const char* path, double Crack::*member, const char* units, const char* meaning) {
    file.array(path, collect<double>(cracks, [member](const Crack& crack) { return crack.*member; }), units, meaning);
  };
  const auto whole = [&](const char* path, int Crack::*member, const char* meaning) {
    file.array(path, collect<int>(cracks, [member](const Crack& crack) { return crack.*member; }), "1", meaning);
  };
  real("/cracks/time_s", &Crack::time, "s", "when the element broke");
  real("/cracks/x_m", &Crack::x, "m", "middle of the interface when it broke");
  real("/cracks/y_m", &Crack::y, "m", "middle of the interface when it broke");
  real("/cracks/normal_angle_rad", &Crack::normal_angle, "rad", "of the interface normal, from x");
  real("/cracks/length_m", &Crack::length, "m", "of the element");
  file.array("/cracks/mode", collect<int>(cracks, [](const Crack& crack) { return static_cast<int>(crack.mode); }), "1",
             "1 tension, 2 shear");
  whole("/cracks/disc_1", &Crack::disc1, "id of the first disc");
  whole("/cracks/disc_2", &Crack::disc2, "id of the second disc");
}

void write_energies(base::Hdf5Writer& file, const std::vector<Energies>& energies, bool under_mud) {
  if (energies.empty()) return;
  for (const EnergyEntry& entry : energy_entries) {
    if (entry.only_under_mud && !under_mud) continue;
    std::vector<double> values;
    values.reserve(energies.size());
    for (const Energies& instant : energies) values.push_back(instant.*entry.value);
    file.array(fmt::format("/energy/{}_J_per_m", entry.name), values, "J/m", entry.meaning);
  }
}

/// What the mud did; nothing without mud.
void write_settled(base::Hdf5Writer& file, const CutRun& run) {
  if (run.settled.steps == 0) return;
  file.attribute("surface_drop_m", run.settled.surface_drop);
  file.attribute("shortening_m", run.settled.shortening);
  file.attribute("broken_elements", static_cast<long long>(run.settled.cracks));
  file.attribute("settling_steps", run.settled.steps);
  file.attribute("forced_entries", static_cast<long long>(run.forced_entries));
}

}  // namespace

std::string cut_hash(const CutCase& cut, std::uint64_t seed) {
  return base::fingerprint_text(
      fmt::format("genesis {}\nphysics {}\nseed {}\n{}", genesis_version, physics_version, seed, resolved_toml(cut)));
}

void write_run(const CutRun& run, const CutCase& cut, std::uint64_t seed, const std::filesystem::path& path) {
  base::Hdf5Writer file;
  file.head(format_name, format_version);
  file.attribute("config_toml", exact_toml(cut));
  file.attribute("config_hash", cut_hash(cut, seed));
  file.attribute("seed", static_cast<long long>(seed));
  file.attribute("bed_origin", run.bed_origin);
  file.attribute("discs", static_cast<long long>(run.discs));
  file.attribute("joints", static_cast<long long>(run.joints));
  file.attribute("step_s", run.step);
  file.attribute("steps", run.steps);
  file.attribute("cut_length_m", run.cut_length);
  file.attribute("duration_s", run.duration);
  file.attribute("mean_force_x_N_per_m", run.mean_force_x);
  file.attribute("mean_force_y_N_per_m", run.mean_force_y);
  file.attribute("specific_energy_Pa", run.specific_energy);
  file.attribute("removed_discs", static_cast<long long>(run.removed_discs));
  if (!run.energies.empty()) {
    file.attribute("energy_residual_fraction", run.energy_residual_fraction);
    file.attribute("energy_injected_fraction", run.energy_injected_fraction);
  }
  write_settled(file, run);
  file.attribute("wall_s", run.wall_time);
  file.attribute("core_s", run.core_time);
  file.attribute("ns_per_disc_step", run.nanoseconds_per_disc_step);

  file.array("/force/time_s", run.time, "s", "end of the sampling interval");
  file.array("/force/x_N_per_m", run.force_x, "N/m", "resistance to cutting, mean over the sampling interval");
  file.array("/force/y_N_per_m", run.force_y, "N/m", "push out of the rock, mean over the sampling interval");
  write_energies(file, run.energies, cut.mud_pressure > 0.0);
  write_cracks(file, run.cracks);
  write_frames(file, run.frames);
  file.attribute("status", "complete");
  file.save(path);
}

namespace {

constexpr long long most_whole = std::numeric_limits<long long>::max();

double positive_attribute(const base::Hdf5Reader& file, const char* name) {
  const double value = file.number_attribute(name);
  if (value > 0.0) return value;
  throw base::InputError(fmt::format("{}: attribute {} = {} (must be above 0)", file.name(), name, value));
}

void read_settled(const base::Hdf5Reader& file, CutRun& run) {
  if (!file.has_attribute("settling_steps")) return;
  constexpr long long most_count = std::numeric_limits<int>::max();
  run.settled.surface_drop = file.number_attribute("surface_drop_m");
  run.settled.shortening = file.number_attribute("shortening_m");
  run.settled.cracks = static_cast<int>(file.integer_attribute("broken_elements", 0, most_count));
  run.settled.steps = file.integer_attribute("settling_steps", 1, most_whole);
  run.forced_entries = static_cast<int>(file.integer_attribute("forced_entries", 0, most_count));
}

/// Throws unless the crack can be counted and drawn.
void check_crack(const Crack& crack, int born, const std::string& where) {
  const auto refuse = [&where](const std::string& why) { throw base::InputError(where + why); };
  for (const double value : {crack.time, crack.x, crack.y, crack.normal_angle, crack.length}) {
    if (!std::isfinite(value)) refuse("a time, place, angle or length is not a finite number");
  }
  for (const int disc : {crack.disc1, crack.disc2}) {
    if (disc < 0 || disc >= born) refuse(fmt::format("names disc {} (must be from 0 to {})", disc, born - 1));
  }
}

std::vector<Crack> read_cracks(const base::Hdf5Reader& file) {
  const auto time = file.doubles("/cracks/time_s"), x = file.doubles("/cracks/x_m"), y = file.doubles("/cracks/y_m"),
             angle = file.doubles("/cracks/normal_angle_rad"), length = file.doubles("/cracks/length_m");
  const auto mode = file.ints("/cracks/mode"), disc1 = file.ints("/cracks/disc_1"), disc2 = file.ints("/cracks/disc_2");
  for (const std::size_t size :
       {x.size(), y.size(), angle.size(), length.size(), mode.size(), disc1.size(), disc2.size()}) {
    if (size != time.size()) throw base::InputError(file.name() + ": crack arrays differ in length");
  }
  const int born = born_discs(file);
  std::vector<Crack> cracks;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const std::string where = fmt::format("{}: crack {}: ", file.name(), k);
    if (mode[k] != 1 && mode[k] != 2) throw base::InputError(fmt::format("{}mode {} (must be 1 or 2)", where, mode[k]));
    cracks.push_back(
        {time[k], x[k], y[k], angle[k], length[k], static_cast<ElementState>(mode[k]), disc1[k], disc2[k]});
    check_crack(cracks.back(), born, where);
  }
  return cracks;
}

void read_forces(const base::Hdf5Reader& file, CutRun& run) {
  run.time = file.doubles("/force/time_s");
  run.force_x = file.doubles("/force/x_N_per_m");
  run.force_y = file.doubles("/force/y_N_per_m");
  if (run.time.size() != run.force_x.size() || run.time.size() != run.force_y.size())
    throw base::InputError(file.name() + ": force arrays differ in length");
  if (run.time.empty()) throw base::InputError(file.name() + ": no force samples");
  for (const std::vector<double>* values : {&run.time, &run.force_x, &run.force_y}) {
    if (!std::all_of(values->begin(), values->end(), [](double value) { return std::isfinite(value); }))
      throw base::InputError(file.name() + ": a force or time is not a finite number");
  }
  if (!std::is_sorted(run.time.begin(), run.time.end()))
    throw base::InputError(file.name() + ": the times of the force samples do not go up");
}

}  // namespace

RunFile read_run(const std::filesystem::path& path) {
  return read_run(base::Hdf5Reader(path));
}

RunFile read_run(const base::Hdf5Reader& file) {
  file.require_format(format_name, format_version);
  RunFile result;
  result.status = file.text_attribute("status");
  if (result.status != "complete") throw base::InputError(file.name() + ": the run is not complete (make it again)");
  result.config_toml = file.text_attribute("config_toml");
  result.config_hash = file.text_attribute("config_hash");
  result.seed = static_cast<std::uint64_t>(file.integer_attribute("seed", 0, most_whole));
  result.cut = parse_resolved(result.config_toml, file.name() + " (config_toml)");
  result.frame_count = count_frames(file);

  CutRun& run = result.run;
  run.bed_origin = file.text_attribute("bed_origin");
  run.discs = born_discs(file);
  run.joints = static_cast<int>(file.integer_attribute("joints", 0, std::numeric_limits<int>::max()));
  run.step = positive_attribute(file, "step_s");
  run.steps = file.integer_attribute("steps", 1, most_whole);
  run.cut_length = positive_attribute(file, "cut_length_m");
  run.duration = positive_attribute(file, "duration_s");
  run.mean_force_x = file.number_attribute("mean_force_x_N_per_m");
  run.mean_force_y = file.number_attribute("mean_force_y_N_per_m");
  run.specific_energy = file.number_attribute("specific_energy_Pa");
  const bool measured = file.has_attribute("energy_residual_fraction");
  if (measured) run.energy_residual_fraction = file.number_attribute("energy_residual_fraction");
  if (file.has_attribute("energy_injected_fraction"))  // since physics version 5
    run.energy_injected_fraction = file.number_attribute("energy_injected_fraction");
  read_settled(file, run);
  run.wall_time = file.number_attribute("wall_s");
  run.core_time = file.has_attribute("core_s") ? file.number_attribute("core_s") : run.wall_time;
  run.nanoseconds_per_disc_step = file.number_attribute("ns_per_disc_step");
  read_forces(file, run);
  run.cracks = read_cracks(file);
  for (const Crack& crack : run.cracks)
    (crack.mode == ElementState::broken_in_tension ? run.cracks_tensile : run.cracks_shear) += 1;
  run.frames.push_back(read_frame(file, result.frame_count - 1));
  return result;
}

std::optional<RunFile> read_complete_run(const std::filesystem::path& path, const std::string& hash) {
  if (!base::is_there(path)) return std::nullopt;
  try {
    RunFile file = read_run(path);
    if (file.config_hash == hash && file.run.bed_origin == origin_genesis) return file;
  } catch (const base::InputError&) {
    // damaged or foreign: to be made again
  }
  return std::nullopt;
}

}  // namespace bitrock::dem2d
