#pragma once
/// A place in a JSON document that knows its own path, so that each wrong value is reported as
/// `file: outputs[2].scale = 0 (must be above 0)`. Only for readers inside surrogate/net: it is not a general layer,
/// and it is kept out of public headers together with the JSON library.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace bitrock::surrogate {

class JsonPlace {
 public:
  /// `file` must outlive the place.
  JsonPlace(const nlohmann::json& value, const std::string& file, std::string path = "");

  bool has(const std::string& key) const;                 ///< for keys that older files do not have
  JsonPlace at(const std::string& key) const;             ///< "is missing" when it is
  JsonPlace at(std::size_t index) const;                  ///< checked by `list` before
  void only(const std::vector<std::string>& keys) const;  ///< every other key is unknown

  std::size_t list() const;               ///< length of a list
  void list_of(std::size_t count) const;  ///< a list of just that length
  double number() const;                  ///< finite
  /// Within these; else an error with the place.
  double number_from(double low, double high) const;
  /// From 0 on; else an error with the place.
  std::uint64_t whole_up_to(std::uint64_t high) const;
  /// Any text.
  std::string text() const;
  /// True or false.
  bool flag() const;
  /// A list of them.
  std::vector<int> whole_numbers() const;

  /// Throws `base::InputError`.
  [[noreturn]] void refuse(std::string_view allowed) const;

 private:
  void require_object() const;
  std::string seen() const;
  const nlohmann::json& value_;
  const std::string& file_;
  std::string path_;
};

}  // namespace bitrock::surrogate
