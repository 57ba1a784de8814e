#include "runtime/drillstring/matched_source.hpp"

#include <algorithm>
#include <cmath>

namespace bitrock::runtime {

namespace {

constexpr int most_trials = 5;

double root_mean_square(const Spread& spread) {
  return std::hypot(spread.mean, spread.deviation);
}

double share(double seen, double target) {
  return target != 0.0 ? std::abs(seen / target - 1.0) : std::abs(seen);
}

double mismatch(const Spread& seen, const Spread& target) {
  return std::max(share(seen.mean, target.mean), share(root_mean_square(seen), root_mean_square(target)));
}

double mismatch(const DrillSummary& seen, const DrillSummary& target) {
  return std::max(mismatch(seen.source_force, target.source_force), mismatch(seen.source_torque, target.source_torque));
}

void correct(Excitation& given, const Spread& seen, const Spread& target) {
  given.mean += target.mean - seen.mean;
  if (seen.deviation > 0.0) given.deviation *= target.deviation / seen.deviation;
}

Excitation as_asked(const Spread& target) {
  return {.mean = target.mean, .deviation = target.deviation};
}

}  // namespace

MatchedRun run_matched(const DrillCase& drill, SourceKind kind, const DrillSummary& target,
                       const base::ProgressCallback& progress) {
  DrillCase trial = drill;
  trial.source.kind = kind;
  trial.source.model_file.clear();
  trial.source.force = as_asked(target.source_force);
  trial.source.torque = as_asked(target.source_torque);
  const DrillString string = assemble(trial);
  MatchedRun best;
  for (int i = 0; i < most_trials; ++i) {
    DrillRun run = run_drill(trial, string, make_source(trial, std::nullopt), progress);
    const DrillSummary seen = run.summary;
    const double missed = mismatch(seen, target);
    if (i == 0 || missed < best.mismatch) best = {.drill = trial, .run = std::move(run), .mismatch = missed};
    if (best.mismatch < good_match) break;
    correct(trial.source.force, seen.source_force, target.source_force);
    correct(trial.source.torque, seen.source_torque, target.source_torque);
  }
  return best;
}

}  // namespace bitrock::runtime
