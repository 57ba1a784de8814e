#pragma once
/// A variable of an FMU, as its model description says it and its library answers by it. What an FMU holds has one
/// table of them; a value reference is a place in it.

namespace bitrock::fmu {

/// What the host does with a variable.
enum class Causality {
  input,     ///< sets it before a step
  output,    ///< reads it after a step
  parameter  ///< sets it before the first step
};
/// What a value is.
enum class Type {
  real,        ///< fmi2Real
  integer,     ///< fmi2Integer
  enumeration  ///< fmi2Integer: a place in a list of words
};

/// One variable of the description.
struct Variable {
  const char* name;         ///< with its unit
  Causality causality;      ///< input, output or parameter
  Type type;                ///< of the value
  const char* unit;         ///< of `units` in model_description.cpp; empty: a plain number
  const char* description;  ///< for people
  const char* list = "";    ///< the name of an enumeration's list
};

/// Values of enumerations begin at 1, as some importers count their items.
inline constexpr int first_item = 1;

}  // namespace bitrock::fmu
