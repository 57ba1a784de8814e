#pragma once
/// A run made by hand for tests of what is written and drawn: nothing of it was computed.

#include "dem2d/files/run_file.hpp"

using namespace bitrock;

namespace output_fixtures {

/// Two discs of the bed side by side and a chip of two above them, at an instant; five discs were born.
inline dem2d::Frame frame_at(double time, double tip_x) {
  return {.time = time,
          .tip_x = tip_x,
          .x = {6e-3, 7e-3, 8e-3, 9e-3},
          .y = {1e-3, 1e-3, 3e-3, 3e-3},
          .radius = {0.5e-3, 0.5e-3, 0.5e-3, 0.5e-3},
          .id = {0, 1, 2, 4},
          .fragment = {0, 0, 1, 1},
          .velocity_x = {0.0, 0.25, 0.5, -0.5},  // exact in single precision
          .velocity_y = {0.0, 0.0, 1.0, 2.0},
          .joint_disc1 = {0, 2},
          .joint_disc2 = {1, 4}};
}

/// 4 mm of cut at 1 m/s, four samples of the force; cracks within the bed (1 ms), between bed and chip, which have
/// parted (1.5 ms), and within the chip (3 ms).
inline dem2d::RunFile run() {
  dem2d::RunFile file;
  file.cut.rock.name = "rock of a test";
  file.cut.cutter_speed = 1.0;
  file.cut.depth_of_cut = 1e-3;
  file.cut.cut_length = 4e-3;
  file.cut.cutter_diameter = 3e-3;
  file.cut.cutter_thickness = 1e-3;
  file.cut.bed_length = 10e-3;
  file.cut.bed_height = 4e-3;
  file.cut.domain_margin = 2e-3;
  dem2d::CutRun& run = file.run;
  run.discs = 5;
  run.cut_length = 4e-3;
  run.duration = 4e-3;
  run.time = {1e-3, 2e-3, 3e-3, 4e-3};
  run.force_x = {1000.0, 2000.0, 3000.0, 4000.0};
  run.force_y = {100.0, -200.0, 300.0, 200.0};
  constexpr auto tension = dem2d::ElementState::broken_in_tension, shear = dem2d::ElementState::broken_in_shear;
  run.cracks = {{1e-3, 6.5e-3, 1e-3, 0.0, 0.5e-3, tension, 0, 1},
                {1.5e-3, 6.6e-3, 1.5e-3, 0.0, 0.5e-3, tension, 0, 2},
                {3e-3, 8.5e-3, 3e-3, 0.0, 0.5e-3, shear, 2, 4}};
  run.frames = {frame_at(4e-3, 4e-3)};
  return file;
}

}  // namespace output_fixtures
