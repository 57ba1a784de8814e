#pragma once
/// What people are told of the keys of an input file. The rows come from the very fields that the reader fills, so a
/// page made of them cannot fall behind the program.

#include <string>
#include <vector>

#include "base/config.hpp"

namespace bitrock::base {

struct KeyRow {
  std::string table;     ///< empty for the top level
  std::string key;       ///< ends in its unit
  std::string other;     ///< key of the same value in the unit of the oil field; empty where there is none
  std::string standard;  ///< value of a key that is left out, in the unit of the key; "required"; "none"
  std::string allowed;   ///< empty for what is no number
  std::string meaning;   ///< as in the list of the reader
};

/// A row a field. The targets of the fields must hold their defaults. A default out of its own range means none.
std::vector<KeyRow> key_rows(const std::vector<Section>& sections);

}  // namespace bitrock::base
