#pragma once
/// Everything bitrock reads from files, as functions that take bytes. Whoever looks for faults calls them with bytes
/// that nobody has foreseen: `./run fuzz` with those that libFuzzer finds, fuzz_test.cpp with seeds changed a little. A
/// reader may take the bytes or throw `base::InputError`; everything else is a fault.

#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"

using namespace bitrock;

namespace fuzz {

struct Target {
  std::string name;
  std::function<void(std::string_view)> read;  ///< throws `InputError`, or takes it
  std::vector<std::string> seeds;              ///< what the reader must take
};

inline void PrintTo(const Target& target, std::ostream* out) {
  *out << target.name;
}

std::vector<Target> config_targets();   ///< input files of people
std::vector<Target> table_targets();    ///< CSV, model file, flags
std::vector<Target> hdf5_targets();     ///< our results, with the checksum made anew
std::vector<Target> runtime_targets();  ///< state of a bit, resource of an FMU, with the checksum made anew

std::vector<Target> all_targets();

/// The file of the repository.
std::string shipped(const std::string& path);

/// Has `reader` read a file of these bytes, in a folder that also holds `rock.toml`, `bit.toml` and `table.csv` for the
/// files that name others.
void read_as_file(std::string_view bytes, const std::string& name,
                  const std::function<void(const std::string& path)>& reader);

/// `text` with the first `from` replaced by `to`.
std::string with(std::string text, const std::string& from, const std::string& to);

}  // namespace fuzz
