#pragma once
/// The force of the DEM beside the force that the runtime rebuilds, for each case of cutting conditions: from the
/// statistics of the cuts themselves, which shows what the way of rebuilding loses, and from those of networks, which
/// adds what these miss.

#include <cstdint>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "runtime/signal/settings.hpp"
#include "runtime/signal/tallies.hpp"
#include "studies/rebuild/known_cuts.hpp"
#include "studies/rebuild/likeness.hpp"
#include "surrogate/net/model.hpp"

namespace bitrock::studies {

/// How forces are rebuilt.
struct RebuildOptions {
  std::vector<runtime::SignalMode> modes{runtime::SignalMode::sawtooth};  ///< those a model cannot do are left out
  int draws = 64;          ///< pieces as long as the cut that are rebuilt of each case
  std::uint64_t seed = 1;  ///< of all draws
  int jobs = 1;            ///< cases side by side
};

/// A force along the way of one cutter of width 1 m.
struct RebuiltForce {
  std::vector<double> x, y;  ///< [N/m]
  double spacing = 0.0;      ///< [m]
};

/// One case, rebuilt in one way.
struct RebuiltCut {
  std::size_t known = 0;              ///< number of the case among those known
  bool from_model = false;            ///< or from the statistics of the cuts
  runtime::SignalMode mode{};         ///< in which it was rebuilt, never `automatic`
  Portrait rebuilt;                   ///< mean over the draws
  Likeness likeness;                  ///< of `rebuilt` to the DEM
  runtime::DrawTally draws;           ///< what the statistics asked for and could not be had
  bool inside_training_range = true;  ///< of the model
};

/// All cases that were compared.
struct Rebuilding {
  std::vector<KnownCase> known;         ///< those that have a force to rebuild
  std::vector<Portrait> dem;            ///< of each case, mean over its cuts
  std::vector<RebuiltCut> comparisons;  ///< by case, then statistics, then mode
  std::vector<std::string> left_out;    ///< cases without a force to rebuild, in words
};

/// The statistics of a case as the outputs of a model: counts per metre, lengths the means of both components.
surrogate::OutputValues own_statistics(const Portrait& dem, const KnownCase& known);

/// **What** The force that a model makes under constant conditions, `pieces` times as long as the cut.
/// **Differences and validity** By the core of the runtime, for a bit of one cutter on a circle of 0.1 m: the
/// conditions of the cut are those of its rotation and rate of penetration. Each sample is the mean of two points, as a
/// sample of the DEM is the mean over its distance. Networks that ask for the pressure of the mud get that of the case.
RebuiltForce rebuilt_force(const surrogate::Model& model, runtime::SignalMode mode, const KnownCase& known, int pieces,
                           std::uint64_t seed, runtime::DrawTally& draws);

/// All cases, from their own statistics and, when there is one, from a model. Peaks are counted as new data sets count
/// them (`peaks::converging`). The same for any number of jobs.
Rebuilding rebuild(std::vector<KnownCase> known, const surrogate::Model* model, const RebuildOptions& options,
                   const base::ProgressCallback& progress = {});

/// What to look at in forces that were rebuilt from a model too, whose file this is: conditions it has not learnt,
/// modes it cannot do.
std::vector<std::string> warnings(const Rebuilding& rebuilding, const RebuildOptions& options,
                                  const surrogate::Model& model, const std::string& model_file);

/// How far one number of the rebuilt forces is from the DEM's, over many cases.
struct Measure {
  std::string name;      ///< "mean", "sd", ...
  std::string unit;      ///< of rms and worst: "%", "dB" or "1"
  char component = 'x';  ///< x, y, or b: of both
  int count = 0;         ///< numbers compared
  double rms = 0.0;      ///< root mean square of the deviations
  double worst = 0.0;    ///< the deviation farthest from 0, with its sign
  double within = 0.0;   ///< share of the numbers whose deviation is within the bar [1]
  double bar = 0.0;      ///< that is asked for, in the unit
  double asked = 1.0;    ///< share that must be within it [1]
};

/// Of the comparisons of one way; `deepest`, `shallowest` [m] choose some depths.
std::vector<Measure> measures(const Rebuilding& rebuilding, bool from_model, runtime::SignalMode mode,
                              double shallowest = 0.0, double deepest = 1e9);

}  // namespace bitrock::studies
