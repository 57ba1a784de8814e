#pragma once
/// A specimen as an HDF5 file (docs/reference/formats.md, "specimen.h5"): discs, joined pairs, and the rock it is made
/// of.

#include <filesystem>

#include "dem2d/specimen/specimen.hpp"

namespace bitrock::dem2d {

/// The same specimen always gives the same bytes.
void write_specimen(const Specimen& specimen, const std::filesystem::path& path);

/// Throws `base::InputError` when the file is not a whole specimen.
Specimen read_specimen(const std::filesystem::path& path);

}  // namespace bitrock::dem2d
