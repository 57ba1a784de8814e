#pragma once
/// The folder of a campaign, and what it says about each job:
///
///     DIR/study.toml                        what the folder belongs to; another study is refused
///     DIR/specimens/<l>x<h>mm_seed_<s>.h5   one rock a size of bed [mm] and seed, made once
///     DIR/runs/case_<c>_seed_<s>.h5         a finished cut; written whole or not at all
///     DIR/running/case_<c>_seed_<s>.toml    a cut under way: who, since when, how far; only true while it is locked
///     DIR/failed/case_<c>_seed_<s>.txt      why a cut failed; tried again by the next run
///     DIR/accepted.csv                      rows of cuts made elsewhere or earlier (accepted.hpp)
///
/// A job is done when its run file has its final name, opens, has the right checksum, is complete and carries the hash
/// of exactly this case, rock and seed; or when a row with that hash has been accepted.

#include <filesystem>
#include <optional>
#include <string>
#include <unordered_set>

#include "dem2d/files/run_file.hpp"
#include "studies/campaign/study.hpp"

namespace bitrock::studies {

/// Throws `base::InputError` when the folder is none of a campaign, or belongs to another study.
void require_folder(const Study& study, const std::filesystem::path& folder);

/// The study that a folder of a campaign holds, where no other is named. Throws `InputError` when there is none
/// (`folder` may be empty).
std::filesystem::path study_in(const std::filesystem::path& folder);

/// Makes what is missing. Throws `base::InputError` when the folder belongs to another study or cannot be written.
void open_folder(const Study& study, const std::filesystem::path& folder);

std::string job_name(const Job& job);  ///< "case_007_seed_1"
std::string job_hash(const Job& job);  ///< of case, rock, seed and physics (`dem2d::cut_hash`)
/// The files of a job, whether or not they are there: its run, its record while it is under way, why it failed, the
/// rock it is cut in.
std::filesystem::path run_path(const std::filesystem::path& folder, const Job& job);
std::filesystem::path running_path(const std::filesystem::path& folder, const Job& job);  ///< of a `RunningRecord`
std::filesystem::path failure_path(const std::filesystem::path& folder, const Job& job);  ///< of a reason in words
std::filesystem::path rock_path(const std::filesystem::path& folder, const Job& job);     ///< of a specimen

/// What a folder holds, read at once: a study may have a million jobs, of which hardly any has left something in it.
std::unordered_set<std::string> file_names(const std::filesystem::path& folder);

/// The run of a job when there is a good one, otherwise empty.
std::optional<dem2d::RunFile> finished_run(const std::filesystem::path& folder, const Job& job);

/// A cut under way, as its runner tells it.
struct RunningRecord {
  std::string host;         ///< name of the machine
  int pid = 0;              ///< of the process on it
  double started = 0.0;     ///< since 1970 [s]
  double share_done = 0.0;  ///< [1]
};

/// Written whole, in place of the one before. Throws `OutputError`.
void write_record(const RunningRecord& record, const std::filesystem::path& path);

/// The record of a job that somebody holds now; empty otherwise, whatever a killed runner has left there.
std::optional<RunningRecord> running_record(const std::filesystem::path& folder, const Job& job);

/// The clock of the records: since 1970 [s].
double now();

}  // namespace bitrock::studies
