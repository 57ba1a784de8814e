#pragma once
/// What a study will cost, before anything is cut: discs from the size of each bed, steps from the critical step of a
/// small sample of the rock, time from a speed that was measured elsewhere.
///
///     core time = sum over the cuts of steps x discs x time for a disc and step
///
/// Valid within some 10 % for discs and steps; the speed depends on the machine and on how much of the rock breaks.

#include <filesystem>
#include <optional>
#include <vector>

#include "dem2d/step/cost.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// In proportion to steps times discs, for comparing jobs of one study [s m2].
double work(const Job& job);

/// The cuts of one depth, which share cut length and bed.
struct PlanPart {
  double depth_of_cut = 0.0;                                    ///< [m]
  double cut_length = 0.0, bed_length = 0.0, bed_height = 0.0;  ///< [m]
  int jobs = 0;                                                 ///< not done yet
  double discs = 0.0;                                           ///< of each
  double steps = 0.0;                                           ///< of all together
  double core_time = 0.0;                                       ///< [s]
};

/// What is done, what is left to do, and what that will cost.
struct Plan {
  int cases = 0, jobs = 0;    ///< jobs: cases times seeds
  int done = 0;               ///< of the jobs: finished or accepted in the folder
  int failed = 0;             ///< in the folder; they will be tried again
  int rocks = 0;              ///< in all
  int rocks_to_make = 0;      ///< that jobs which are not done need and the folder lacks
  double core_seconds = 0.0;  ///< spent on the jobs that are done [s]

  // of the jobs that are not done
  double most_discs = 0.0;      ///< in one bed
  double steps = 0.0;           ///< of all cuts together
  double disc_steps = 0.0;      ///< sum over the cuts of steps times discs
  double core_time = 0.0;       ///< [s]
  double longest_cut = 0.0;     ///< core time of the one that takes longest [s]
  std::vector<PlanPart> parts;  ///< by depth
};

/// With an empty folder, or one that does not exist, everything is still to be done. Throws `base::InputError` when the
/// folder belongs to another study, or a cut would take too many or too large steps (`dem2d::plan_steps`).
Plan plan(const Study& study, const std::filesystem::path& folder,
          double ns_per_disc_step = dem2d::typical_ns_per_disc_step);

}  // namespace bitrock::studies
