#pragma once
/// What the FMU of a drill string says of itself.

#include <string>
#include <vector>

#include "runtime/fmu/string_block.hpp"

namespace bitrock::fmu {

/// What is for people, and not in the content.
struct StringNames {
  std::string name;                        ///< of the case
  double duration = 0.0, sample = 0.0;     ///< [s] of its run and between two rows of that
  std::vector<std::string> stress_points;  ///< in their order
};

/// The text of `modelDescription.xml`.
std::string string_description(const StringContent& content, const StringNames& names, const std::string& guid);

}  // namespace bitrock::fmu
