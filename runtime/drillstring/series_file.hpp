#pragma once
/// What the files of runs of a drill string share, with and without a well: arrays of samples, checked when they are
/// read back.

#include <string>
#include <vector>

#include "base/hdf5_file.hpp"

namespace bitrock::runtime {

/// An array that must have `count` entries, all finite. Throws `base::InputError` naming file and array.
std::vector<double> finite_array(const base::Hdf5Reader& file, const std::string& path, std::size_t count);

/// Throws `base::InputError` unless the times of samples [s] are at least two and rise.
void require_rising(const base::Hdf5Reader& file, const std::vector<double>& time);

}  // namespace bitrock::runtime
