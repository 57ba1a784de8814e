#pragma once
/// An FMU as the ZIP archive that the standard asks for [Fmi2, sec. 2.3]: description, libraries, one resource.

#include <functional>
#include <string>
#include <vector>

#include "runtime/fmu/libraries.hpp"

namespace bitrock::fmu {

struct FmuFile {
  std::string bytes;                   ///< of the ZIP archive
  std::string guid;                    ///< ties description and block together
  std::vector<std::string> platforms;  ///< it has libraries for: "linux64", "win64"
};

/// The archive of a description, the libraries that this program carries, and a resource of that name. `identifier`
/// names the libraries. Block and description are made twice: once to find the guid of all of it, once with it. Throws
/// `InputError` when this program carries no library.
FmuFile packed(Inside inside, const char* identifier, const char* resource,
               const std::function<std::string(const std::string&)>& block_with,
               const std::function<std::string(const std::string&)>& description_with);

}  // namespace bitrock::fmu
