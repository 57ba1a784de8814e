#pragma once
/// A finished cut as an HDF5 file (docs/reference/formats.md, "run.h5"), and back.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "dem2d/cut/run_cut.hpp"

namespace bitrock::base {
class Hdf5Reader;
}

namespace bitrock::dem2d {

/// Fingerprint of everything a run depends on: resolved case and rock, seed, and the version of the engine's physics
/// (step/physics_version.hpp).
/// A run file with this hash need not be computed again.
std::string cut_hash(const CutCase& cut, std::uint64_t seed);

/// The same run always gives the same bytes, but for the attributes wall_s, core_s and ns_per_disc_step.
void write_run(const CutRun& run, const CutCase& cut, std::uint64_t seed, const std::filesystem::path& path);

/// What the rest of the thread needs of a run: force history, cracks, last frame, and the case it belongs to.
struct RunFile {
  std::string config_toml, config_hash, status;  ///< as in the attributes of the file
  std::uint64_t seed = 0;                        ///< of the rock
  CutCase cut;                                   ///< from config_toml
  CutRun run;                                    ///< frames: the last one only
  int frame_count = 1;                           ///< in the file (frame_file.hpp reads the others)
};

/// Throws `base::InputError` when the file is not a whole run.
RunFile read_run(const std::filesystem::path& path);
/// The same of an open file, for those who go on to read its other frames.
RunFile read_run(const base::Hdf5Reader& file);

/// The run when `path` is a complete one with this hash, in a bed packed by this program; empty for anything else,
/// without an exception.
std::optional<RunFile> read_complete_run(const std::filesystem::path& path, const std::string& hash);

}  // namespace bitrock::dem2d
