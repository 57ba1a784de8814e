#pragma once
/// The compiled library of the FMU, for each system it was built for, carried inside the program.

#include <string_view>
#include <vector>

namespace bitrock::fmu {

/// The library for one system.
struct Library {
  std::string_view platform;   ///< folder below `binaries`, as the standard names it
  std::string_view extension;  ///< of the file
  std::string_view bytes;      ///< the whole file, within this program
};

/// What a library computes.
enum class Inside {
  bit,    ///< a bit alone
  string  ///< a drill string with its bit
};

/// linux64 where bitrock was built on such a machine, win64 where the compiler for it was found. Throws `InputError`
/// when there is neither.
std::vector<Library> libraries(Inside inside);

}  // namespace bitrock::fmu
