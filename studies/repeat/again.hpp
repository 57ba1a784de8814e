#pragma once
/// How a result is made again from the input that its file holds.

#include <string>

#include "base/hdf5_file.hpp"

namespace bitrock::studies {

/// The command; `{}` stands for the file with the input.
struct Again {
  std::string command;  ///< such as "bitrock cut {} --seed 1"
  std::string besides;  ///< what the input does not hold
};

/// Throws `InputError` for a file that is no cut, specimen or drill run.
Again again(const base::Hdf5Reader& file);

/// Says so when the file was made by another program than this one, which may pack, cut and draw in another way; empty
/// when it was not.
std::string made_by_another_program(const base::Hdf5Reader& file);

}  // namespace bitrock::studies
