#include "runtime/fmu/libraries.hpp"

#include "base/embed.hpp"
#include "base/errors.hpp"

// runtime/CMakeLists.txt builds and names the files, and rebuilds this one when they change.
#ifdef BITROCK_FMU_LINUX64
BITROCK_EMBED(fmu_linux64, BITROCK_FMU_LINUX64)
BITROCK_EMBED(string_fmu_linux64, BITROCK_STRING_FMU_LINUX64)
#endif
#ifdef BITROCK_FMU_WIN64
BITROCK_EMBED(fmu_win64, BITROCK_FMU_WIN64)
BITROCK_EMBED(string_fmu_win64, BITROCK_STRING_FMU_WIN64)
#endif

namespace bitrock::fmu {

std::vector<Library> libraries([[maybe_unused]] Inside inside) {
  std::vector<Library> found;
#ifdef BITROCK_FMU_LINUX64
  found.push_back({"linux64", ".so", inside == Inside::bit ? fmu_linux64_bytes() : string_fmu_linux64_bytes()});
#endif
#ifdef BITROCK_FMU_WIN64
  found.push_back({"win64", ".dll", inside == Inside::bit ? fmu_win64_bytes() : string_fmu_win64_bytes()});
#endif
  if (found.empty()) {
    throw base::InputError(
        "this bitrock carries no library for an FMU (it was built on another machine than linux64, without Debian's "
        "g++-mingw-w64-x86-64-posix for win64)");
  }
  return found;
}

}  // namespace bitrock::fmu
