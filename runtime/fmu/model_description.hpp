#pragma once
/// modelDescription.xml: what an importer reads before it loads the library [Fmi2, sec. 2.2 and 4.3].

#include <string>
#include <vector>

#include "runtime/fmu/variable.hpp"

namespace bitrock::fmu {

/// A variable and what only the description says of it.
struct DescribedVariable {
  unsigned reference = 0;       ///< its value reference
  Variable variable;            ///< causality, type and unit
  std::string name;             ///< that of the variable, or a number of its own
  std::string description;      ///< for people
  std::string start;            ///< value at the start of what the host sets
  std::string bounds;           ///< attributes ` min="0"` and ` max="2"`; may be reached
  bool in_display_unit = true;  ///< shown in the other unit of its unit, where there is one
  bool known_at_start = true;   ///< an output: what is set before the start has no influence on its first value
};

/// The reference, the table's entry, and its texts.
DescribedVariable described(unsigned reference, const Variable& variable, const std::string& start,
                            const std::string& bounds);

/// What an FMU says of itself.
struct ModelDescription {
  std::string name;                          ///< of the model
  std::string about;                         ///< for people
  std::string identifier;                    ///< name of the libraries inside
  std::string guid;                          ///< ties description and resource together
  std::string lists;                         ///< elements SimpleType of the enumerations
  double stop_time = 0.0;                    ///< [s] of an experiment that makes sense
  double step = 0.0;                         ///< [s] between communication points of that
  std::vector<DescribedVariable> variables;  ///< in the order of their indices
};

/// The text of the file.
std::string text_of(const ModelDescription& description);

}  // namespace bitrock::fmu
