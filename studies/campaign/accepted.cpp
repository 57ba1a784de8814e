#include "studies/campaign/accepted.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "studies/campaign/folder.hpp"

namespace bitrock::studies {

namespace {

// Two numbers that differ by less than this share were the same before they were written with 12 digits.
constexpr double digits_kept = 1e-11;

bool agree(double a, double b) {
  return std::abs(a - b) <= digits_kept * std::abs(b);
}

/// Throws when a row that carries the hash of a job tells of another cut.
void require_same_cut(const FeatureRow& row, const Job& job, const std::string& where) {
  const auto require = [&](const char* name, double seen, double wanted, double unit, bool same) {
    if (same) return;
    throw base::InputError(
        fmt::format("{}: {} = {} (the job with the hash {}, case {} seed {}, has {}: the row was changed)", where, name,
                    base::in_units(seen, unit), row.hash, job.case_number, job.seed, base::in_units(wanted, unit)));
  };
  const dem2d::CutCase& cut = job.cut;
  require("seed", row.seed, job.seed, 1.0, row.seed == job.seed);
  require("cutter_speed_m_per_s", row.cutter_speed, cut.cutter_speed, 1.0, agree(row.cutter_speed, cut.cutter_speed));
  require("depth_of_cut_mm", row.depth_of_cut, cut.depth_of_cut, base::mm, agree(row.depth_of_cut, cut.depth_of_cut));
  require("back_rake_deg", row.back_rake, cut.back_rake, base::deg, agree(row.back_rake, cut.back_rake));
  const bool whole_cut = std::abs(row.cut_length - cut.cut_length) <= cut.sampling_distance;
  require("cut_length_m", row.cut_length, cut.cut_length, 1.0, whole_cut);
}

}  // namespace

void accept(Accepted& accepted, const Study& study, const std::filesystem::path& table) {
  std::map<std::string, Job> by_hash;
  for_each_job(study, [&by_hash](const Job& job) { by_hash.emplace(job_hash(job), job); });
  FeatureTable read = read_features(table);
  for (std::size_t i = 0; i < read.rows.size(); ++i) {
    FeatureRow& row = read.rows[i];
    const std::string where = fmt::format("{}:{}", table.string(), read.lines[i]);
    const auto job = by_hash.find(row.hash);
    if (job == by_hash.end()) {
      ++accepted.strangers;
      continue;
    }
    require_same_cut(row, job->second, where);
    row.case_number = job->second.case_number;
    const auto [kept, is_new] = accepted.rows.emplace(row.hash, row);
    if (!is_new && !same_result(kept->second, row)) {
      accepted.warnings.push_back(
          fmt::format("{}: another row with the hash {} has other numbers (x_amax_N_per_m {} there, {} here); the "
                      "other stays",
                      where, row.hash, kept->second.x.amax, row.x.amax));
    }
  }
}

Accepted accepted_rows(const Study& study, const std::filesystem::path& folder) {
  Accepted accepted;
  const std::filesystem::path file = folder / "accepted.csv";
  if (!base::is_there(file)) return accepted;
  try {
    accept(accepted, study, file);
  } catch (const base::InputError& error) {
    throw base::InputError(
        fmt::format("{} (mend or remove that line: the other rows are kept; or remove the file, and accept its tables "
                    "again with --accept; finished runs stay whatever becomes of it)",
                    error.what()));
  }
  return accepted;
}

Acceptance keep_accepted(const Study& study, const std::filesystem::path& folder, const std::filesystem::path& table) {
  const std::filesystem::path file = folder / "accepted.csv";
  const base::FileLock lock = base::FileLock::wait_for(file);  // between reading and writing nobody else adds rows
  Acceptance result{.all = accepted_rows(study, folder)};
  const auto before = static_cast<int>(result.all.rows.size());
  result.all.strangers = 0;
  result.all.warnings.clear();
  accept(result.all, study, table);
  result.added = static_cast<int>(result.all.rows.size()) - before;
  if (result.added == 0) return result;
  std::vector<FeatureRow> rows;
  for_each_job(study, [&](const Job& job) {
    const auto row = result.all.rows.find(job_hash(job));
    if (row != result.all.rows.end()) rows.push_back(row->second);
  });
  base::write_whole(file, features_csv(rows));
  return result;
}

}  // namespace bitrock::studies
