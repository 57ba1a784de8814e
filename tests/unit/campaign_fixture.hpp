#pragma once
/// A study of cuts that are never made, and run files as if they had been.

#include <cmath>
#include <numbers>
#include <string>

#include "base/files.hpp"
#include "dem2d/files/run_file.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/study.hpp"
#include "tests/scratch.hpp"

using namespace bitrock;

namespace campaign_fixture {

inline const std::string head = "rock = \"" BITROCK_SOURCE_DIR "/campaigns/rocks/article.toml\"\n";
inline const std::string grid =
    "[grid]\ncutter_speeds_m_per_s = [0.5, 2]\ndepths_of_cut_mm = [2, 4]\nback_rakes_deg = [10]\n";

/// 4 cases, 2 seeds.
inline std::string study_text() {
  return head + "seeds = [1, 5]\n" + grid + "[cut]\ncut_length_mm = 20\n[bed]\nlength_mm = 40\nheight_mm = 15\n";
}

inline studies::Study study(const scratch::Folder& dir, const std::string& text = study_text()) {
  base::write_whole(dir / "study.toml", text);
  return studies::read_study(dir / "study.toml");
}

/// Numbers that tell the job, and forces with three peaks.
inline dem2d::CutRun made_up_run(const studies::Job& job) {
  const double scale = job.case_number + 0.1 * job.seed;
  dem2d::CutRun run;
  run.bed_origin = dem2d::origin_genesis;
  for (int i = 0; i < 60; ++i) {
    run.time.push_back(1e-3 * (i + 1));
    const double wave = std::sin(2.0 * std::numbers::pi * i / 20.0);
    run.force_x.push_back(scale * (1.0 + wave));
    run.force_y.push_back(scale * (2.0 + wave));
  }
  run.cracks = {{.mode = dem2d::ElementState::broken_in_tension},
                {.mode = dem2d::ElementState::broken_in_shear},
                {.mode = dem2d::ElementState::broken_in_tension}};
  run.frames = {{.x = {0.0}, .y = {0.0}, .radius = {1e-3}, .id = {0}, .fragment = {0}}};
  run.discs = 100 + job.case_number;
  run.joints = 250;
  run.step = 4e-7;
  run.steps = 1000;
  run.cut_length = job.cut.cut_length;
  run.duration = job.cut.cut_length / job.cut.cutter_speed;
  run.mean_force_x = scale;
  run.mean_force_y = 2.0 * scale;
  run.energies = {dem2d::Energies{}};
  run.energy_residual_fraction = 1e-3 * scale;
  run.core_time = 10.0;
  run.nanoseconds_per_disc_step = 100.0;
  return run;
}

inline void finish(const studies::Job& job, const std::filesystem::path& folder) {
  dem2d::write_run(made_up_run(job), job.cut, static_cast<std::uint64_t>(job.seed), studies::run_path(folder, job));
}

/// The words of the exception, from the name of the file on.
template <class Function>
std::string message(const Function& function, const std::string& from) {
  try {
    function();
  } catch (const std::exception& error) {
    const std::string what = error.what();
    const std::size_t at = what.find(from);
    return at == std::string::npos ? what : what.substr(at);
  }
  return "accepted";
}

}  // namespace campaign_fixture
