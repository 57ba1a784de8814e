#include "studies/campaign/rocks.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/errors.hpp"
#include "base/file_lock.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "studies/campaign/folder.hpp"

namespace bitrock::studies {

namespace {

std::uint64_t seed_of(const Job& job) {
  return static_cast<std::uint64_t>(job.seed);
}

/// The rock of the file when it is the one asked for.
std::optional<dem2d::Specimen> kept_rock(const std::filesystem::path& file, const Job& job) {
  if (!base::is_there(file)) return std::nullopt;
  try {
    dem2d::Specimen kept = dem2d::read_specimen(file);
    const std::string why = dem2d::mismatch(kept, job.cut.rock, job.cut.bed_length, job.cut.bed_height, seed_of(job));
    if (why.empty() && !kept.packed_elsewhere()) return kept;
  } catch (const base::InputError&) {
    // a damaged rock is simply made again
  }
  return std::nullopt;
}

}  // namespace

std::shared_ptr<const dem2d::Specimen> RockStore::get(const Job& job) {
  const std::filesystem::path file = rock_path(folder_, job);
  Rock& rock = [&]() -> Rock& {
    const std::lock_guard lock(mutex_);
    return rocks_[file];
  }();
  const std::lock_guard lock(rock.mutex);
  if (auto specimen = rock.specimen.lock()) return specimen;
  const base::FileLock file_lock = base::FileLock::wait_for(file);
  base::remove_parts(file);
  std::optional<dem2d::Specimen> specimen = kept_rock(file, job);
  if (!specimen) {
    if (on_stage_) {
      on_stage_(fmt::format("making the rock of seed {}, {} x {} mm", job.seed,
                            base::in_units(job.cut.bed_length, base::mm),
                            base::in_units(job.cut.bed_height, base::mm)));
    }
    specimen = dem2d::make_specimen(job.cut.rock, job.cut.bed_length, job.cut.bed_height, seed_of(job), 1);
    dem2d::write_specimen(*specimen, file);
  }
  auto shared = std::make_shared<const dem2d::Specimen>(*std::move(specimen));
  rock.specimen = shared;
  return shared;
}

bool has_rock(const std::filesystem::path& folder, const Job& job) {
  return kept_rock(rock_path(folder, job), job).has_value();
}

}  // namespace bitrock::studies
