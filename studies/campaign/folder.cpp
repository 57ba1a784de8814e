#include "studies/campaign/folder.hpp"

#include <fmt/format.h>

#include <chrono>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/files.hpp"
#include "base/stop.hpp"
#include "base/units.hpp"

namespace bitrock::studies {

namespace {

using Path = std::filesystem::path;

void refuse_other_study(const Study& study, const Path& folder) {
  const Path file = folder / "study.toml";
  const std::string text = base::read_whole(file);
  if (text == exact_toml(study) || text == resolved_toml(study)) return;
  const auto kept = [&] {
    try {
      return resolved_toml(read_study(file));  // written in another way
    } catch (const base::InputError& error) {
      throw base::InputError(fmt::format(
          "{} (the folder holds runs of another study, or its study.toml is damaged: choose another --dir; "
          "or, when its runs are of the study asked for, remove that file, and `bitrock campaign run` writes "
          "it again and keeps them)",
          error.what()));
    }
  };
  if (kept() == resolved_toml(study)) return;
  throw base::InputError(
      fmt::format("{} holds runs of another study (its study.toml differs from the one asked for); "
                  "choose another --dir, or remove that folder",
                  folder.string()));
}

base::Section describe(RunningRecord& record) {
  const base::Range time = base::between(0.0, 1e12), process = base::between(0, 2147483647);
  return {"",
          {{"host", &record.host, 1.0, base::any(), "machine", true},
           {"pid", &record.pid, 1.0, process, "process", true},
           {"started_s", &record.started, 1.0, time, "since 1970", true},
           {"share_done", &record.share_done, 1.0, base::between(0.0, 1.0), "of the cut", true}}};
}

}  // namespace

void require_folder(const Study& study, const Path& folder) {
  std::error_code no_folder;
  if (!std::filesystem::is_directory(folder, no_folder)) {
    throw base::InputError(
        fmt::format("{}: there is no such folder (bitrock campaign run makes and fills it)", folder.string()));
  }
  if (!base::is_there(folder / "study.toml")) {
    throw base::InputError(fmt::format(
        "{} is no campaign's folder: it has no study.toml (bitrock campaign run makes one)", folder.string()));
  }
  refuse_other_study(study, folder);
}

std::filesystem::path study_in(const std::filesystem::path& folder) {
  if (folder.empty())
    throw base::InputError("a study is needed (a file, or with --dir the folder of a campaign that has begun)");
  const std::filesystem::path kept = folder / "study.toml";
  if (std::filesystem::exists(kept)) return kept;
  throw base::InputError(
      fmt::format("{} has no study.toml yet, so a study must be named (bitrock campaign run STUDY.toml --dir {})",
                  folder.string(), folder.string()));
}

void open_folder(const Study& study, const Path& folder) {
  base::require_writable_folder(folder);
  const bool is_new = !base::is_there(folder / "study.toml");
  if (!is_new) refuse_other_study(study, folder);
  for (const char* part : {"runs", "running", "specimens", "failed"}) base::require_writable_folder(folder / part);
  if (is_new) base::write_whole(folder / "study.toml", exact_toml(study));
}

std::string job_name(const Job& job) {
  return fmt::format("case_{:03d}_seed_{}", job.case_number, job.seed);
}

std::string job_hash(const Job& job) {
  return dem2d::cut_hash(job.cut, static_cast<std::uint64_t>(job.seed));
}

Path run_path(const Path& folder, const Job& job) {
  return folder / "runs" / (job_name(job) + ".h5");
}

Path running_path(const Path& folder, const Job& job) {
  return folder / "running" / (job_name(job) + ".toml");
}

Path failure_path(const Path& folder, const Job& job) {
  return folder / "failed" / (job_name(job) + ".txt");
}

Path rock_path(const Path& folder, const Job& job) {
  return folder / "specimens" /
         fmt::format("{}x{}mm_seed_{}.h5", base::in_units(job.cut.bed_length, base::mm),
                     base::in_units(job.cut.bed_height, base::mm), job.seed);
}

std::unordered_set<std::string> file_names(const Path& folder) {
  std::unordered_set<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    base::throw_if_stopped();
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::optional<dem2d::RunFile> finished_run(const Path& folder, const Job& job) {
  const Path path = run_path(folder, job);
  if (!std::filesystem::exists(path)) return std::nullopt;  // the hash of a job takes longer than to look
  return dem2d::read_complete_run(path, job_hash(job));
}

void write_record(const RunningRecord& record, const Path& path) {
  RunningRecord copy = record;
  base::write_whole(path, base::to_toml({describe(copy)}));
}

std::optional<RunningRecord> running_record(const Path& folder, const Job& job) {
  const Path path = running_path(folder, job);
  if (!base::FileLock::is_held(path)) return std::nullopt;
  RunningRecord record;
  try {
    base::ConfigFile::read(path).fill(describe(record));
  } catch (const base::InputError&) {
    record.started = now();  // locked this instant, and not yet told
  }
  return record;
}

double now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace bitrock::studies
