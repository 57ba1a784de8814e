#pragma once
/// The customary simple excitations beside the networks, on equal terms: a sine or white noise with the mean and the
/// standard deviation, and so the RMS, of force and torque that the networks' run had. What then differs between two
/// runs is the shape of the excitation, not its size.

#include <functional>

#include "runtime/drillstring/drill_run.hpp"

namespace bitrock::runtime {

/// A run under a simple source, and how well it met what was asked.
struct MatchedRun {
  DrillCase drill;        ///< as it was run: source, mean and deviation
  DrillRun run;           ///< with the source that was found
  double mismatch = 0.0;  ///< [1] largest error of mean and RMS of force and torque, over those of the target
};

/// A run that misses mean or RMS by less than this is good enough.
inline constexpr double good_match = 0.005;  // [1]

/// What a source did over the steps that a summary sees.
struct SourceLoad {
  Spread force, torque;  ///< [N], [N m]
};

/// **What** Finds the parameters of a simple source (sinusoidal or noise) that has, over the steps that a summary sees,
/// the means and deviations of `target`: by trial, see `run_matched`. `attempt` runs with a source and says what acted;
/// `keep` hears that this attempt is the best so far. Returns the mismatch of that one.
double match_source(SourceCase source, SourceKind kind, const SourceLoad& target,
                    const std::function<SourceLoad(const SourceCase&)>& attempt, const std::function<void()>& keep);

/// **What** Runs `drill` with the source `kind` so that force and torque of the source have, over the steps that the
/// summary sees, the means and deviations of `target`.
/// **Why by trial** A source is given over the angle of the bit, the summary is over time, and a lifted bit fades it:
/// what acts differs from what is given by some per cent. Each trial corrects that: mean' = mean + (target - seen),
/// deviation' = deviation target / seen. At most five; the best is returned with its `mismatch`.
/// **Symbols** `kind` sinusoidal or noise; waves a turn, piece and seed as in the case.
MatchedRun run_matched(const DrillCase& drill, SourceKind kind, const DrillSummary& target,
                       const base::ProgressCallback& progress = {});

}  // namespace bitrock::runtime
