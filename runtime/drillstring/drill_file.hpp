#pragma once
/// A finished drill run as an HDF5 file (docs/reference/formats.md, "drill.h5").

#include <filesystem>
#include <string>

#include "runtime/drillstring/drill_run.hpp"

namespace bitrock::runtime {

/// The same run always gives the same bytes, but for the attribute wall_s. `model` is the fingerprint of the model
/// file; empty where there is none.
void write_drill_run(const DrillRun& run, const DrillCase& drill, const std::string& model,
                     const std::filesystem::path& path);

struct DrillFile {
  DrillRun run;       ///< read back
  DrillCase drill;    ///< as `recorded_drill_case` gives it: the file of the bit is named, not read
  DrillModes modes;   ///< of its string
  std::string model;  ///< fingerprint of the model file, empty where there was none
};

/// Throws `InputError` naming the file and what is wrong with it: not such a file, of another version, cut short,
/// changed, a series missing, shorter than the others or with values that are not finite, times that do not go up.
DrillFile read_drill_run(const std::filesystem::path& path);

}  // namespace bitrock::runtime
