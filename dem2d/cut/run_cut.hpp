#pragma once
/// One cut from start to end: puts cutter and walls around a bed of rock, drives the cutter through it at constant
/// speed and depth, and records what the rock does to the cutter.
///
/// The bed is the specimen in its packing box, its surface at y = height. Bottom, left and right are walls with the
/// friction of the rock's loose discs; the left one ends at the height of the tip so that the cutter can enter and
/// the edge can break away. Discs that overlap a wall at the start do so without force (reference overlap), so the bed
/// starts stress-free. No gravity: what is broken off drifts away, as if washed by the mud [BitRock2026, sec. 3.1].

#include <functional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/energy.hpp"

namespace dem2d {

/// All discs at one instant.
struct Frame {
  double time = 0.0;                 ///< [s]
  double tip_x = 0.0;                ///< of the cutter [m]
  std::vector<double> x, y, radius;  ///< [m]
  std::vector<int> id;
  std::vector<int> fragment;  ///< discs with the same number hang together by bonded joints; 0 is the largest

  // only when frames were asked for, because they double the size
  std::vector<double> velocity_x, velocity_y;  ///< half a step before `time` [m/s]
  std::vector<int> joint_disc1, joint_disc2;   ///< ids of the discs that bonded joints hold together
};

struct CutRun {
  // Force history. Each sample is the mean over the sampling interval that ends at `time`, so impulses are kept.
  std::vector<double> time;     ///< [s]
  std::vector<double> force_x;  ///< resistance to cutting, positive [N/m]
  std::vector<double> force_y;  ///< push out of the rock, positive [N/m]
  std::vector<Energies>
      energies;  ///< since the start, at the last step of each sampling interval; empty if not measured
  std::vector<Crack> cracks;
  std::vector<Frame> frames;  ///< as requested, and always the last instant

  std::string bed_origin;     ///< how the discs of the bed were packed (Specimen::origin)
  int discs = 0, joints = 0;  ///< at the start
  double step = 0.0;          ///< [s]
  long long steps = 0;
  double cut_length = 0.0;                        ///< [m]
  double duration = 0.0;                          ///< [s]
  double mean_force_x = 0.0, mean_force_y = 0.0;  ///< over the whole cut [N/m]
  double specific_energy = 0.0;                   ///< mean_force_x / depth of cut [Pa]
  int cracks_tensile = 0, cracks_shear = 0;
  int removed_discs = 0;
  double energy_residual_fraction = 0.0;  ///< what the ledger cannot find, over the cutter's work [1]
  double wall_time = 0.0;                 ///< [s]
  double nanoseconds_per_disc_step = 0.0;
};

struct CutOptions {
  int threads = 1;
  int frames = 0;              ///< extra snapshots, evenly spaced
  bool measure_energy = true;  ///< costs a few percent of time; changes no force
};

/// The bed with cutter (boundary 0) and walls, prepared, with its critical step.
World make_cut_world(const CutCase& cut, const Specimen& bed, const CutOptions& options = {});

/// How the steps of a cut are laid out.
struct CutSchedule {
  double step;  ///< [s], a whole number of steps fills one sampling interval
  int steps_per_sample;
  long long samples;
};
/// Throws `InputError` when the cut would take more than 1e9 steps, or the cutter would move more than a hundredth of
/// the smallest grain in one.
CutSchedule plan_steps(const CutCase& cut, double critical_step);

/// Throws `SimulationError` or, when stopped by the user, `Interrupted`.
CutRun run_cut(const CutCase& cut, const Specimen& bed, const CutOptions& options = {},
               const base::ProgressCallback& progress = {});

}  // namespace dem2d
