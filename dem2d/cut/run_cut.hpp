#pragma once
/// One cut from start to end: puts the cutter to a bed of rock that is held at its sides, drives the cutter through it
/// at constant speed and depth, and records what the rock does to the cutter.
///
/// The bed is the specimen in its packing box, its surface at y = height. It is held as if glued in: the outermost
/// column of discs, two largest radii wide, stands still at the bottom, at the right, and at the left up to two columns
/// below the tip, so that the cutter can enter and the edge can break away. The bed starts stress-free. No gravity:
/// what is broken off drifts away, as if washed by the mud [BitRock2026, sec. 3.1].
///
/// With `moving_ahead` or `moving_behind` only the neighbourhood of the cutter moves (window.hpp).

#include <functional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "dem2d/cut/cut_case.hpp"
#include "dem2d/cut/frame.hpp"
#include "dem2d/cut/settle.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/step/energy.hpp"

namespace bitrock::dem2d {

/// What a cut gave.
struct CutRun {
  // Force history after the run-in. Each sample is the mean over the sampling interval that ends at `time` (since the
  // start of the cut), so impulses are kept.
  std::vector<double> time;  ///< [s]
  // Under mud it is the net force: of contacts, and of the mud where the face is sealed.
  std::vector<double> force_x;  ///< resistance to cutting, positive [N/m]
  std::vector<double> force_y;  ///< push out of the rock, positive [N/m]
  std::vector<Energies>
      energies;               ///< since the start, at the last step of each sampling interval; empty if not measured
  std::vector<Crack> cracks;  ///< of the whole cut, the run-in included, in the order of time
  std::vector<Frame> frames;  ///< as requested, and always the last instant

  std::string bed_origin;                         ///< how the discs of the bed were packed (Specimen::origin)
  int discs = 0, joints = 0;                      ///< at the start
  double step = 0.0;                              ///< [s]
  long long steps = 0;                            ///< of the cut, the run-in included; settling under mud is not
  double cut_length = 0.0;                        ///< after the run-in [m]
  double duration = 0.0;                          ///< after the run-in [s]
  double mean_force_x = 0.0, mean_force_y = 0.0;  ///< over the cut after the run-in [N/m]
  double specific_energy = 0.0;                   ///< mean_force_x / depth of cut [Pa]
  int cracks_tensile = 0, cracks_shear = 0;       ///< of `cracks`: broken in tension, in shear
  int removed_discs = 0;  ///< that left the domain, as cuttings do; rock that the window left behind is not among them
  double energy_residual_fraction = 0.0;  ///< what the ledger cannot find, over the cutter's work [1]
  double energy_injected_fraction = 0.0;  ///< what the scheme gave to the rock (Energies), over the cutter's work [1]
  Settled settled;                        ///< before the cut, under mud
  int forced_entries = 0;                 ///< times that rock entered over rock out of place, under mud
  double wall_time = 0.0;                 ///< [s]
  double core_time = 0.0;  ///< time on cores: less than wall time on one thread when others use the machine [s]
  double nanoseconds_per_disc_step = 0.0;  ///< on the clock (one thread: on its core), settling included [ns]
};

/// What does not change the forces of a cut.
struct CutOptions {
  int threads = 1;                    ///< of the step, 1 or more
  int frames = 0;                     ///< extra snapshots, evenly spaced
  base::ProgressCallback settling{};  ///< of the bed under mud, before the cut
  bool measure_energy = true;         ///< costs a sixth of the time (docs/results/validation.md); no force
};

/// The bed, held at its sides, with the cutter (boundary 0), prepared, with its critical step.
World make_cut_world(const CutCase& cut, const Specimen& bed, const CutOptions& options = {});

/// Throws `InputError` when so many frames of so many discs do not fit into the memory of an ordinary machine.
void check_frames(int frames, double discs);

/// How the steps of a cut are laid out.
struct CutSchedule {
  double step;               ///< [s], a whole number of steps fills one sampling interval
  int steps_per_sample;      ///< 1 or more
  long long samples;         ///< in all
  long long run_in_samples;  ///< of these at the start, not recorded

  long long steps() const { return samples * steps_per_sample; }  ///< in all, the run-in included
};
/// Throws `InputError` when the cut would take more than 1e9 steps, or years of one core, or the cutter would move more
/// than a hundredth of the smallest grain in one step.
CutSchedule plan_steps(const CutCase& cut, double critical_step);

/// What the forces may not be trusted for, in words: energy that contacts and joints brought in, where it was measured.
std::vector<std::string> warnings(const CutRun& run);

/// Throws `SimulationError` or, when stopped by the user, `Interrupted`.
CutRun run_cut(const CutCase& cut, const Specimen& bed, const CutOptions& options = {},
               const base::ProgressCallback& progress = {});

}  // namespace bitrock::dem2d
