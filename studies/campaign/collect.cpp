#include "studies/campaign/collect.hpp"

#include <fmt/format.h>

#include "studies/campaign/accepted.hpp"
#include "studies/campaign/folder.hpp"

namespace bitrock::studies {

namespace {

std::string differing(const Job& job, const FeatureRow& run, const FeatureRow& accepted) {
  return fmt::format(
      "case {} seed {} (hash {}): the run file and the accepted row differ, x_amax_N_per_m {} and {}, "
      "x_mean_N_per_m {} and {}; the run file counts",
      job.case_number, job.seed, run.hash, run.x.amax, accepted.x.amax, run.mean_force_x, accepted.mean_force_x);
}

}  // namespace

Collection collect(const Study& study, const std::filesystem::path& folder) {
  require_folder(study, folder);
  const Accepted accepted = accepted_rows(study, folder);
  Collection collection{.warnings = accepted.warnings};
  for_each_job(study, [&](const Job& job) {
    const auto row = accepted.rows.empty() ? accepted.rows.end() : accepted.rows.find(job_hash(job));
    if (const auto file = finished_run(folder, job)) {
      collection.rows.push_back(row_of(job, file->run));
      const bool differs = row != accepted.rows.end() && !same_result(collection.rows.back(), row->second);
      if (differs) collection.warnings.push_back(differing(job, collection.rows.back(), row->second));
    } else if (row != accepted.rows.end()) {
      collection.rows.push_back(row->second);
    }
  });
  return collection;
}

}  // namespace bitrock::studies
