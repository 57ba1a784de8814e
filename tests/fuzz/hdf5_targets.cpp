// Results in HDF5, as somebody who knows the checksum could make them.
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/text.hpp"
#include "dem2d/files/frame_file.hpp"
#include "dem2d/files/run_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "runtime/drillstring/drill_run.hpp"
#include "runtime/well/well_file.hpp"
#include "studies/campaign/forces_file.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/scratch.hpp"
#include "tests/unit/output_fixtures.hpp"

using namespace bitrock;

namespace fuzz {

namespace {

constexpr std::string_view mark = "BITROCK:";
constexpr std::size_t seal_length = 24;

/// The file that `write` writes, without its seal.
std::string unsealed(const std::function<void(const std::string& path)>& write) {
  const scratch::Folder folder("fuzz_seed");
  const std::string path = folder / "seed.h5";
  write(path);
  const std::string bytes = base::read_whole(path);
  return bytes.substr(0, bytes.size() - seal_length);
}

/// With the seal that `Hdf5Writer` would give these bytes.
std::string sealed(std::string_view bytes) {
  return std::string(bytes) + std::string(mark) + base::fingerprint_text(bytes);
}

std::string specimen_seed() {
  dem2d::Specimen specimen{.width = 5e-3, .height = 5e-3};
  for (int k = 0; k < 16; ++k) {
    specimen.x.push_back(1e-3 * (k % 4 + 1));
    specimen.y.push_back(1e-3 * (k / 4 + 1));
    specimen.radius.push_back(0.5e-3);
  }
  dem2d::join_neighbours(specimen);
  return unsealed([&](const std::string& path) { dem2d::write_specimen(specimen, path); });
}

std::string run_seed(int frames) {
  dem2d::RunFile run = output_fixtures::run();
  run.cut.bed_length = run.cut.bed_height = 20e-3;
  run.run.step = 1e-7;
  run.run.steps = 50000;
  run.run.cut_length = 10e-3;
  run.run.duration = 5e-3;
  if (frames > 1) run.run.frames.insert(run.run.frames.begin(), output_fixtures::frame_at(2e-3, 2e-3));
  return unsealed([&](const std::string& path) { dem2d::write_run(run.run, run.cut, 1, path); });
}

std::string drill_seed() {
  base::ConfigFile file = base::ConfigFile::from_text(R"(name = "string"
rock = "limestone"
[[pipe]]
length_m = 150
outer_diameter_mm = 127
inner_diameter_mm = 108.61
[top_drive]
rotation_rpm = 60
hook_load_kN = 25
[bit]
friction_radius_mm = 80
[excitation]
source = "sinusoidal"
force_mean_kN = 2
force_deviation_kN = 0.5
[run]
duration_s = 1
sample_ms = 10
settling_s = 0.2
)",
                                                      "case.toml");
  const runtime::DrillCase drill = runtime::read_drill_case(file);
  const runtime::DrillRun run = runtime::run_drill(drill, runtime::assemble(drill), runtime::make_source(drill, {}));
  return unsealed([&](const std::string& path) { runtime::write_drill_run(run, drill, "", path); });
}

std::string well_seed() {
  const scratch::Folder folder("fuzz_well");
  base::write_whole(folder / "case.toml", R"(name = "well"
[well]
measured_depth_m = [0, 20, 60]
inclination_deg = [0, 0, 50]
azimuth_deg = [0, 0, 0]
frames = 3
[[hole]]
to_depth_m = 60
diameter_mm = 215.9
friction = 0.2
[[pipe]]
length_m = 40
outer_diameter_mm = 127
inner_diameter_mm = 108.61
segment_length_m = 10
[friction]
law = "none"
[run]
duration_s = 0.2
step_ms = 0.5
sample_ms = 10
settling_s = 0.1
[[stress_point]]
name = "middle"
above_bit_m = 15
)");
  const runtime::WellCase well = runtime::read_well_case(folder / "case.toml");
  const runtime::WellRun run = run_well(well, runtime::assemble(well), runtime::make_source(well.drill, {}));
  return unsealed([&](const std::string& path) { runtime::write_well_run(run, well, "", path); });
}

std::string forces_seed() {
  studies::ForcesFile forces{.study = "small.toml", .mean_diameter = 0.5e-3};
  for (int seed = 1; seed < 3; ++seed) {
    studies::CutForces cut{.cut = {.case_number = 1,
                                   .seed = seed,
                                   .cutter_speed = 0.5,
                                   .depth_of_cut = 2e-3,
                                   .back_rake = 0.35,
                                   .cut_length = 1e-3,
                                   .duration = 2e-3,
                                   .cracks_tensile = 9,
                                   .discs = 100,
                                   .step = 1e-7,
                                   .core_time = 1.0,
                                   .hash = "d9a1d7e96dd519d" + std::to_string(seed)}};
    for (int i = 0; i < 50; ++i) {
      cut.x.push_back(static_cast<float>(i % 7) * 1e3F);
      cut.y.push_back(static_cast<float>(i % 5) * 1e3F);
    }
    forces.cuts.push_back(cut);
  }
  return unsealed([&forces](const std::string& path) { studies::write_forces(forces, path); });
}

}  // namespace

std::vector<Target> hdf5_targets() {
  return {
      {.name = "specimen_h5",
       .read =
           [](std::string_view bytes) {
             read_as_file(sealed(bytes), "specimen.h5", [](const std::string& path) { dem2d::read_specimen(path); });
           },
       .seeds = {specimen_seed()}},
      {.name = "run_h5",
       .read =
           [](std::string_view bytes) {
             read_as_file(sealed(bytes), "run.h5", [](const std::string& path) {
               dem2d::read_run(path);
               const base::Hdf5Reader file(path);
               for (int frame = 0; frame < dem2d::count_frames(file) && frame < 4; ++frame) {
                 dem2d::read_frame(file, frame);
               }
             });
           },
       .seeds = {run_seed(1), run_seed(2)}},
      {.name = "drill_h5",
       .read =
           [](std::string_view bytes) {
             read_as_file(sealed(bytes), "drill.h5", [](const std::string& path) { runtime::read_drill_run(path); });
           },
       .seeds = {drill_seed()}},
      {.name = "well_h5",
       .read =
           [](std::string_view bytes) {
             read_as_file(sealed(bytes), "well.h5", [](const std::string& path) { runtime::read_well_run(path); });
           },
       .seeds = {well_seed()}},
      {.name = "forces_h5",
       .read =
           [](std::string_view bytes) {
             read_as_file(sealed(bytes), "forces.h5", [](const std::string& path) {
               for (const studies::CutForces& cut : studies::read_forces(path).cuts)
                 studies::row_of(cut, peaks::converging(0.5e-3));
             });
           },
       .seeds = {forces_seed()}},
  };
}

}  // namespace fuzz
