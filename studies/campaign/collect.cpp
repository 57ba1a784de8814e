#include "studies/campaign/collect.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
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

std::string otherwise_defined(const Job& job, const FeatureRow& row) {
  return fmt::format(
      "case {} seed {} is left out: its accepted row counts peaks by another definition (smoothing {:g} um, prominence "
      "{:g}), and its forces are not known",
      job.case_number, job.seed, base::in_units(row.definition.smoothing, base::um), row.definition.min_prominence);
}

/// A warning, and no forces, when they are more than one file can hold.
void keep_within_a_file(Collection& collection) {
  double samples = 0.0;
  for (const CutForces& cut : collection.forces.cuts) samples += static_cast<double>(cut.x.size());
  if (samples <= most_samples) return;
  collection.forces.cuts.clear();
  collection.warnings.push_back(fmt::format(
      "the force histories have {:.2g} samples (at most {:.0e} in one file): no forces.h5", samples, most_samples));
}

}  // namespace

Collection collect(const Study& study, const std::filesystem::path& folder, const peaks::PeakDefinition& definition) {
  require_folder(study, folder);
  Accepted accepted = accepted_rows(study, folder);
  Collection collection{.forces = {.mean_diameter = mean_diameter(study)}, .warnings = accepted.warnings};
  std::vector<CutForces>& forces = collection.forces.cuts;
  for_each_job(study, [&](const Job& job) {
    const bool nothing_accepted = is_empty(accepted);
    const std::string hash = nothing_accepted ? std::string() : job_hash(job);
    const auto row = accepted.rows.find(hash);
    const auto cut = accepted.forces.find(hash);
    if (const auto file = finished_run(folder, job)) {
      collection.rows.push_back(row_of(job, file->run, definition));
      const bool differs = row != accepted.rows.end() && peaks::same(row->second.definition, definition) &&
                           !same_result(collection.rows.back(), row->second);
      if (differs) collection.warnings.push_back(differing(job, collection.rows.back(), row->second));
      forces.push_back(forces_of(job, file->run));
    } else if (cut != accepted.forces.end()) {
      collection.rows.push_back(row_of(cut->second, definition));
      forces.push_back(std::move(cut->second));
    } else if (row != accepted.rows.end() && peaks::same(row->second.definition, definition)) {
      collection.rows.push_back(row->second);
    } else if (row != accepted.rows.end()) {
      collection.warnings.push_back(otherwise_defined(job, row->second));
    }
  });
  for (std::string& warning : warnings(collection.rows)) collection.warnings.push_back(std::move(warning));
  keep_within_a_file(collection);
  return collection;
}

}  // namespace bitrock::studies
