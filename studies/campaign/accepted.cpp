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

bool is_empty(const Accepted& accepted) {
  return accepted.rows.empty() && accepted.forces.empty();
}

const FeatureRow* find(const Accepted& accepted, const std::string& hash) {
  const auto forces = accepted.forces.find(hash);
  if (forces != accepted.forces.end()) return &forces->second.cut;
  const auto row = accepted.rows.find(hash);
  return row != accepted.rows.end() ? &row->second : nullptr;
}

namespace {

std::map<std::string, Job> jobs_by_hash(const Study& study) {
  std::map<std::string, Job> by_hash;
  for_each_job(study, [&by_hash](const Job& job) { by_hash.emplace(job_hash(job), job); });
  return by_hash;
}

void accept_table(Accepted& accepted, const Study& study, const std::filesystem::path& table) {
  const std::map<std::string, Job> by_hash = jobs_by_hash(study);
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

void accept_forces(Accepted& accepted, const Study& study, const std::filesystem::path& path) {
  const std::map<std::string, Job> by_hash = jobs_by_hash(study);
  ForcesFile read = read_forces(path);
  for (std::size_t i = 0; i < read.cuts.size(); ++i) {
    CutForces& forces = read.cuts[i];
    const auto job = by_hash.find(forces.cut.hash);
    if (job == by_hash.end()) {
      ++accepted.strangers;
      continue;
    }
    const std::string where = fmt::format("{}: cut {}", path.string(), i), hash = forces.cut.hash;
    require_same_cut(forces.cut, job->second, where);
    forces.cut.case_number = job->second.case_number;
    const auto kept = accepted.forces.find(hash);
    if (kept == accepted.forces.end()) {
      accepted.forces.emplace(hash, std::move(forces));
    } else if (kept->second.x != forces.x || kept->second.y != forces.y) {
      accepted.warnings.push_back(
          fmt::format("{}: another cut with the hash {} has other forces; the other stays", where, hash));
    }
  }
}

bool holds_forces(const std::filesystem::path& path) {
  return path.extension() == ".h5";
}

std::filesystem::path rows_file(const std::filesystem::path& folder) {
  return folder / "accepted.csv";
}

std::filesystem::path forces_file(const std::filesystem::path& folder) {
  return folder / "accepted.h5";
}

}  // namespace

void accept(Accepted& accepted, const Study& study, const std::filesystem::path& file) {
  holds_forces(file) ? accept_forces(accepted, study, file) : accept_table(accepted, study, file);
}

Accepted accepted_rows(const Study& study, const std::filesystem::path& folder) {
  Accepted accepted;
  for (const std::filesystem::path& file : {rows_file(folder), forces_file(folder)}) {
    if (!base::is_there(file)) continue;
    try {
      accept(accepted, study, file);
    } catch (const base::InputError& error) {
      throw base::InputError(fmt::format(
          "{} (mend or remove that line: the other rows are kept; or remove the file, and accept its tables "
          "again with --accept; finished runs stay whatever becomes of it)",
          error.what()));
    }
  }
  return accepted;
}

Acceptance keep_accepted(const Study& study, const std::filesystem::path& folder, const std::filesystem::path& from) {
  const base::FileLock lock = base::FileLock::wait_for(rows_file(folder));  // meanwhile nobody else adds any
  Acceptance result{.all = accepted_rows(study, folder)};
  const auto count = [&result] { return static_cast<int>(result.all.rows.size() + result.all.forces.size()); };
  const int before = count();
  result.all.strangers = 0;
  result.all.warnings.clear();
  accept(result.all, study, from);
  result.added = count() - before;
  if (result.added == 0) return result;
  std::vector<FeatureRow> rows;
  ForcesFile forces{.mean_diameter = mean_diameter(study)};
  for_each_job(study, [&](const Job& job) {
    const std::string hash = job_hash(job);
    const auto row = result.all.rows.find(hash);
    if (row != result.all.rows.end()) rows.push_back(row->second);
    const auto cut = result.all.forces.find(hash);
    if (cut != result.all.forces.end()) forces.cuts.push_back(cut->second);
  });
  holds_forces(from) ? write_forces(forces, forces_file(folder))
                     : base::write_whole(rows_file(folder), features_csv(rows));
  return result;
}

}  // namespace bitrock::studies
