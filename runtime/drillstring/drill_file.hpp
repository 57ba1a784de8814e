#pragma once
/// A finished drill run as an HDF5 file (docs/formats.md, "drill.h5").

#include <filesystem>

#include "runtime/drillstring/drill_run.hpp"

namespace runtime {

/// The same run always gives the same bytes, but for the attribute wall_s. `model` is the fingerprint of the model
/// file; empty where there is none.
void write_drill_run(const DrillRun& run, const DrillCase& drill, const std::string& model,
                     const std::filesystem::path& path);

}  // namespace runtime
