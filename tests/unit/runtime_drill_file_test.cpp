// The file of a drill run: everything comes back as it was; what is not whole is refused in words.
#include "runtime/drillstring/drill_file.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <map>
#include <string>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace {

const std::string text = R"(name = "short \"string\""
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
)";

runtime::DrillCase example_case() {
  base::ConfigFile file = base::ConfigFile::from_text(text, "case.toml");
  return runtime::read_drill_case(file);
}

runtime::DrillRun example_run() {
  const runtime::DrillCase drill = example_case();
  runtime::DrillRun run = runtime::run_drill(drill, runtime::assemble(drill), runtime::make_source(drill, {}));
  run.summary.clamps = {.asked = 15'000'000'000, .depth_below = 7};  // as after a long run with networks
  run.summary.draws = {.drawn = 900, .capped = 3};
  return run;
}

void expect_same(const runtime::Spread& seen, const runtime::Spread& given) {
  EXPECT_EQ(seen.mean, given.mean);
  EXPECT_EQ(seen.deviation, given.deviation);
  EXPECT_EQ(seen.lowest, given.lowest);
  EXPECT_EQ(seen.highest, given.highest);
}

TEST(DrillFile, EverythingComesBackAsItWas) {
  const scratch::Folder folder("drill_file");
  const runtime::DrillRun run = example_run();
  runtime::write_drill_run(run, example_case(), "0123", folder / "run.h5");
  const runtime::DrillFile file = runtime::read_drill_run(folder / "run.h5");
  EXPECT_EQ(file.model, "0123");
  EXPECT_EQ(runtime::resolved_toml(file.drill), runtime::resolved_toml(example_case()));
  EXPECT_EQ(file.drill.name, "short \"string\"");
  EXPECT_EQ(file.drill.source.kind, runtime::SourceKind::sinusoidal);
  EXPECT_EQ(file.run.series.time_s, run.series.time_s);
  EXPECT_EQ(file.run.series.weight_on_bit_N, run.series.weight_on_bit_N);
  EXPECT_EQ(file.run.series.progression_angle_rad, run.series.progression_angle_rad);
  EXPECT_EQ(file.run.step, run.step);
  EXPECT_EQ(file.run.steps, run.steps);
  const runtime::DrillSummary &seen = file.run.summary, &given = run.summary;
  expect_same(seen.bit_rotation, given.bit_rotation);
  expect_same(seen.total_force, given.total_force);
  expect_same(seen.source_torque, given.source_torque);
  expect_same(seen.rop, given.rop);
  EXPECT_EQ(seen.severity, given.severity);
  EXPECT_EQ(seen.drilled, given.drilled);
  EXPECT_EQ(seen.energy_residual, given.energy_residual);
  EXPECT_EQ(seen.clamps.asked, 15'000'000'000);
  EXPECT_EQ(seen.clamps.clamped(), 7);
  EXPECT_EQ(seen.draws.drawn, 900);
  EXPECT_EQ(seen.draws.capped, 3);
  const runtime::DrillModes modes = runtime::drill_modes(runtime::assemble(example_case()));
  EXPECT_EQ(file.modes.axial, modes.axial);
  EXPECT_EQ(file.modes.axial_off_bottom, modes.axial_off_bottom);
  EXPECT_EQ(file.modes.torsional, modes.torsional);
}

TEST(DrillFile, TheBitFileNeedNotBeThereAnyMore) {
  runtime::DrillCase drill = example_case();
  drill.bit_file = "/gone/bit.toml";
  const runtime::DrillCase back = runtime::recorded_drill_case(runtime::resolved_toml(drill), "here");
  EXPECT_EQ(back.bit_file, "/gone/bit.toml");
}

void expect_refused(const std::filesystem::path& path, const std::string& words) {
  try {
    runtime::read_drill_run(path);
    ADD_FAILURE() << "taken, although: " << words;
  } catch (const base::InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find(words), std::string::npos) << said;
    EXPECT_NE(said.find(path.filename().string()), std::string::npos) << said;
  }
}

TEST(DrillFile, CutShortChangedOrForeignBytesAreRefused) {
  const scratch::Folder folder("drill_file_bytes");
  runtime::write_drill_run(example_run(), example_case(), "", folder / "run.h5");
  const std::string whole = base::read_whole(folder / "run.h5");
  base::write_whole(folder / "short.h5", whole.substr(0, whole.size() / 2));
  expect_refused(folder / "short.h5", "truncated");
  base::write_whole(folder / "unsealed.h5", whole.substr(0, whole.size() - 24));
  expect_refused(folder / "unsealed.h5", "no checksum");
  std::string changed = whole;
  changed[whole.size() / 2] ^= 1;
  base::write_whole(folder / "changed.h5", changed);
  expect_refused(folder / "changed.h5", "its checksum does not fit");
  base::write_whole(folder / "text.h5", text);
  expect_refused(folder / "text.h5", "not an HDF5 file");
  base::Hdf5Writer cut;
  cut.attribute("format", "bitrock-run");
  cut.attribute("format_version", 2LL);
  cut.save(folder / "cut.h5");
  expect_refused(folder / "cut.h5", "not a bitrock-drill file");
  base::Hdf5Writer old;
  old.attribute("format", "bitrock-drill");
  old.attribute("format_version", 1LL);
  old.save(folder / "old.h5");
  expect_refused(folder / "old.h5", "bitrock-drill format 1 (this program reads 2)");
  expect_refused(folder / "nowhere.h5", "nowhere.h5");
}

TEST(DrillFile, AHoistThatIsFedHasItsHookLoadInTheFile) {
  const scratch::Folder folder("drill_file_hoist");
  std::string fed = text;
  const std::string load = "hook_load_kN = 25";
  fed.replace(fed.find(load), load.size(),
              "hoist = \"autodriller\"\nline_stiffness_N_per_m = 8e6\nweight_on_bit_kN = 14");
  base::ConfigFile config = base::ConfigFile::from_text(fed, "case.toml");
  const runtime::DrillCase drill = runtime::read_drill_case(config);
  const runtime::DrillRun run = runtime::run_drill(drill, runtime::assemble(drill), runtime::make_source(drill, {}));
  ASSERT_EQ(run.series.hook_load_N.size(), 101u);
  ASSERT_TRUE(run.summary.hook_load.has_value());
  EXPECT_NEAR(run.summary.hook_load->mean + run.summary.total_force.mean, 39.31e3, 200.0) << "the weight of the pipe";
  runtime::write_drill_run(run, drill, "", folder / "fed.h5");
  const runtime::DrillFile file = runtime::read_drill_run(folder / "fed.h5");
  EXPECT_EQ(file.run.series.hook_load_N, run.series.hook_load_N);
  EXPECT_EQ(file.run.series.block_speed_m_per_s, run.series.block_speed_m_per_s);
  ASSERT_TRUE(file.run.summary.hook_load.has_value());
  expect_same(*file.run.summary.hook_load, *run.summary.hook_load);
  EXPECT_EQ(file.drill.hoist.rule, runtime::HoistRule::autodriller);
  // a hook load that is imposed is no result
  runtime::write_drill_run(example_run(), example_case(), "", folder / "load.h5");
  EXPECT_FALSE(base::Hdf5Reader(folder / "load.h5").has("/series/hook_load_N"));
  EXPECT_FALSE(runtime::read_drill_run(folder / "load.h5").run.summary.hook_load.has_value());
}

/// The arrays of a good file, to be written again with one of them changed.
using Arrays = std::map<std::string, std::vector<double>>;

void write_changed(const std::filesystem::path& from, const std::filesystem::path& to,
                   const std::function<void(Arrays&)>& change) {
  const base::Hdf5Reader good(from);
  Arrays arrays;
  for (const char* name : {"series/time_s",
                           "series/bit_rotation_rad_per_s",
                           "series/table_rotation_rad_per_s",
                           "series/weight_on_bit_N",
                           "series/source_force_N",
                           "series/rop_m_per_s",
                           "series/torque_on_bit_N_m",
                           "series/fracture_torque_N_m",
                           "series/drive_torque_N_m",
                           "series/bit_depth_m",
                           "series/face_depth_m",
                           "series/progression_angle_rad",
                           "summary/bit_rotation_rad_per_s",
                           "summary/weight_on_bit_N",
                           "summary/total_force_N",
                           "summary/torque_on_bit_N_m",
                           "summary/source_force_N",
                           "summary/source_torque_N_m",
                           "summary/rop_m_per_s",
                           "summary/questions",
                           "summary/windows",
                           "modes/axial_Hz",
                           "modes/axial_off_bottom_Hz",
                           "modes/torsional_Hz"}) {
    arrays[name] = good.doubles(std::string("/") + name);
  }
  change(arrays);
  base::Hdf5Writer file;
  for (const auto& [name, values] : arrays) file.array("/" + name, values, "1", "");
  for (const char* name : {"format", "version", "git_commit", "config_toml", "model_fingerprint", "status"})
    file.attribute(name, good.text_attribute(name));
  for (const char* name : {"step_s", "wall_s", "steps", "static_weight_on_bit_N", "severity", "share_at_rest",
                           "share_backwards", "share_off_bottom", "drilled_m", "energy_residual_fraction"})
    file.attribute(name, good.number_attribute(name));
  file.attribute("format_version", 2LL);
  file.save(to);
}

TEST(DrillFile, AnArrayThatIsMissingShortOrSenselessIsNamed) {
  const scratch::Folder folder("drill_file_arrays");
  const auto good = folder / "good.h5", bad = folder / "bad.h5";
  runtime::write_drill_run(example_run(), example_case(), "", good);
  write_changed(good, bad, [](Arrays&) {});
  EXPECT_EQ(runtime::read_drill_run(bad).run.series.time_s.size(), 101u) << "unchanged, it is taken";
  const auto refused = [&](const std::function<void(Arrays&)>& change, const std::string& words) {
    write_changed(good, bad, change);
    expect_refused(bad, words);
  };
  refused([](Arrays& arrays) { arrays.erase("series/rop_m_per_s"); }, "/series/rop_m_per_s is missing");
  refused([](Arrays& arrays) { arrays.erase("modes/axial_Hz"); }, "/modes/axial_Hz is missing");
  refused([](Arrays& arrays) { arrays["series/weight_on_bit_N"].pop_back(); },
          "/series/weight_on_bit_N has 100 values (must have 101)");
  refused([](Arrays& arrays) { arrays["series/rop_m_per_s"][3] = std::numeric_limits<double>::quiet_NaN(); },
          "/series/rop_m_per_s[3] = nan (must be finite)");
  refused([](Arrays& arrays) { arrays["series/time_s"][7] = 0.01; }, "/series/time_s goes from");
  refused([](Arrays& arrays) { arrays["summary/rop_m_per_s"].resize(3); }, "has 3 values (must have 4)");
  refused(
      [](Arrays& arrays) {
        for (auto& [name, values] : arrays) values.resize(name.rfind("series/", 0) == 0 ? 1 : values.size());
      },
      "1 samples (a run has at least 2)");
}

}  // namespace
