#include "runtime/drillstring/matched_source.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

double mismatch(const SourceLoad& seen, const SourceLoad& target) {
  return std::max(mismatch(seen.force, target.force), mismatch(seen.torque, target.torque));
}

void correct(Excitation& given, const Spread& seen, const Spread& target) {
  given.mean += target.mean - seen.mean;
  if (seen.deviation > 0.0) given.deviation *= target.deviation / seen.deviation;
}

Excitation as_asked(const Spread& target) {
  return {.mean = target.mean, .deviation = target.deviation};
}

}  // namespace

double match_source(SourceCase source, SourceKind kind, const SourceLoad& target,
                    const std::function<SourceLoad(const SourceCase&)>& attempt, const std::function<void()>& keep) {
  source.kind = kind;
  source.model_file.clear();
  source.force = as_asked(target.force);
  source.torque = as_asked(target.torque);
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_trials && !(best < good_match); ++i) {
    const SourceLoad seen = attempt(source);
    const double missed = mismatch(seen, target);
    if (i == 0 || missed < best) {
      best = missed;
      keep();
    }
    correct(source.force, seen.force, target.force);
    correct(source.torque, seen.torque, target.torque);
  }
  return best;
}

MatchedRun run_matched(const DrillCase& drill, SourceKind kind, const DrillSummary& target,
                       const base::ProgressCallback& progress) {
  const DrillString string = assemble(drill);
  MatchedRun trial, best;
  trial.drill = drill;
  const auto attempt = [&](const SourceCase& source) -> SourceLoad {
    trial.drill.source = source;
    trial.run = run_drill(trial.drill, string, make_source(trial.drill, std::nullopt), progress);
    return {trial.run.summary.source_force, trial.run.summary.source_torque};
  };
  const double missed =
      match_source(drill.source, kind, {target.source_force, target.source_torque}, attempt, [&] { best = trial; });
  best.mismatch = missed;
  return best;
}

}  // namespace bitrock::runtime
