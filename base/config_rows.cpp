#include "base/config_rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <type_traits>

#include "base/oilfield_key.hpp"
#include "base/units.hpp"

namespace bitrock::base {

namespace {

template <class T>
std::string list_text(const std::vector<T>& list, double unit) {
  std::vector<double> numbers;
  numbers.reserve(list.size());
  for (const T value : list) numbers.push_back(in_units(static_cast<double>(value), unit));
  return fmt::format("[{}]", fmt::join(numbers, ", "));
}

struct DefaultText {
  const Field& field;

  std::string operator()(const double* value) const { return number(*value); }
  std::string operator()(const int* value) const { return number(*value); }
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const std::string* value) const { return value->empty() ? "none" : *value; }
  template <class T>
  std::string operator()(const std::vector<T>* list) const {
    return list->empty() ? "none" : list_text(*list, field.si_per_unit);
  }

  std::string number(double si) const {
    const double value = in_units(si, field.si_per_unit);
    return field.range.contains(value) ? fmt::format("{}", value) : "none";
  }
};

struct IsNumber {
  bool operator()(const bool*) const { return false; }
  bool operator()(const std::string*) const { return false; }
  template <class T>
  bool operator()(const T*) const {
    return true;
  }
};

}  // namespace

std::vector<KeyRow> key_rows(const std::vector<Section>& sections) {
  std::vector<KeyRow> rows;
  for (const Section& section : sections) {
    for (const Field& field : section.fields) {
      const std::optional<Field> other = in_oilfield_unit(field);
      rows.push_back({.table = section.name,
                      .key = field.name,
                      .other = other ? other->name : "",
                      .standard = field.required ? "required" : std::visit(DefaultText{field}, field.target),
                      .allowed = std::visit(IsNumber{}, field.target) ? field.range.text() : "",
                      .meaning = field.meaning});
    }
  }
  return rows;
}

}  // namespace bitrock::base
