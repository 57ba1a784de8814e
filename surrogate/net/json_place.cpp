#include "surrogate/net/json_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace bitrock::surrogate {

JsonPlace::JsonPlace(const nlohmann::json& value, const std::string& file, std::string path)
    : value_(value), file_(file), path_(std::move(path)) {}

JsonPlace JsonPlace::at(const std::string& key) const {
  require_object();
  const std::string path = path_.empty() ? key : path_ + "." + key;
  const auto found = value_.find(key);
  if (found == value_.end()) throw base::InputError(fmt::format("{}: {} is missing", file_, path));
  return {*found, file_, path};
}

JsonPlace JsonPlace::at(std::size_t index) const {
  return {value_[index], file_, fmt::format("{}[{}]", path_, index)};
}

bool JsonPlace::has(const std::string& key) const {
  require_object();
  return value_.contains(key);
}

void JsonPlace::only(const std::vector<std::string>& keys) const {
  require_object();
  for (const auto& [key, ignored] : value_.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string nearest = base::nearest_name(key, keys);
    throw base::InputError(fmt::format("{}: {}{} is unknown ({})", file_, path_.empty() ? "" : path_ + ".", key,
                                       nearest.empty() ? "no such key" : "did you mean " + nearest + "?"));
  }
}

std::size_t JsonPlace::list() const {
  if (!value_.is_array()) refuse("must be a list");
  return value_.size();
}

void JsonPlace::list_of(std::size_t count) const {
  if (list() != count) refuse(fmt::format("must have {} entries", count));
}

double JsonPlace::number() const {
  if (!value_.is_number() || !std::isfinite(value_.get<double>())) refuse("must be a finite number");
  return value_.get<double>();
}

double JsonPlace::number_from(double low, double high) const {
  const double value = number();
  if (value < low || value > high) refuse(fmt::format("must be at least {:g} and at most {:g}", low, high));
  return value;
}

std::uint64_t JsonPlace::whole_up_to(std::uint64_t high) const {
  if (!value_.is_number_unsigned()) refuse("must be a whole number, 0 or above");
  const auto value = value_.get<std::uint64_t>();
  if (value > high) refuse(fmt::format("must be at most {}", high));
  return value;
}

std::string JsonPlace::text() const {
  if (!value_.is_string()) refuse("must be a text");
  return value_.get<std::string>();
}

bool JsonPlace::flag() const {
  if (!value_.is_boolean()) refuse("must be true or false");
  return value_.get<bool>();
}

std::vector<int> JsonPlace::whole_numbers() const {
  std::vector<int> values;
  const std::size_t count = list();
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(static_cast<int>(at(i).whole_up_to(std::numeric_limits<int>::max())));
  }
  return values;
}

void JsonPlace::refuse(std::string_view allowed) const {
  throw base::InputError(fmt::format("{}: {} = {} ({})", file_, path_.empty() ? "the file" : path_, seen(), allowed));
}

void JsonPlace::require_object() const {
  if (!value_.is_object()) refuse("must be an object {...}");
}

std::string JsonPlace::seen() const {
  if (value_.is_array()) return fmt::format("a list of {}", value_.size());
  if (value_.is_object()) return "an object";
  constexpr std::size_t longest = 60;  // enough to recognise a text, short enough for a message
  const std::string text = value_.dump();
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace bitrock::surrogate
