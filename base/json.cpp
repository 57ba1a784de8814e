#include "base/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "base/encoding.hpp"
#include "base/errors.hpp"

namespace bitrock::base {

namespace {

constexpr std::size_t deepest = 64;  // nothing of ours is deeper than 8

/// Goes through a text without keeping it, and throws where something is wrong.
class Check : public nlohmann::json_sax<nlohmann::json> {
 public:
  Check(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  bool null() override { return value(); }
  bool boolean(bool) override { return value(); }
  bool number_integer(number_integer_t) override { return value(); }
  bool number_unsigned(number_unsigned_t) override { return value(); }
  bool number_float(number_float_t, const string_t&) override { return value(); }
  bool string(string_t&) override { return value(); }
  bool binary(binary_t&) override { return value(); }

  bool start_object(std::size_t) override { return open(true); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(false); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    Level& level = levels_.back();
    level.name = name;
    if (!level.names.insert(name).second) {
      throw InputError(fmt::format("{}: {} stands there twice (keep the one that is meant)", file_, place()));
    }
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& error) override {
    const std::size_t end = std::min(position, text_.size());
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    constexpr int too_large = 406;  // out_of_range of the library
    if (error.id == too_large) {
      throw InputError(
          fmt::format("{}:{}: {} = {} is beyond what a number can be (1e308 at most)", file_, line, place(), token));
    }
    const std::string_view all = error.what();  // "[json.exception.parse_error.101] parse error at line 3, ..."
    const std::size_t prefix = all.find("] ");
    throw InputError(fmt::format("{}: not a whole JSON file: {} (was it cut short, or changed by hand?)", file_,
                                 prefix == std::string_view::npos ? all : all.substr(prefix + 2)));
  }

 private:
  struct Level {
    bool object = false;
    std::string name;             ///< of the value that is being read, in an object
    std::size_t index = 0;        ///< of that value, in a list
    std::set<std::string> names;  ///< so far
  };

  bool value() {
    if (!levels_.empty()) ++levels_.back().index;
    return true;
  }

  bool open(bool object) {
    if (levels_.size() == deepest) {
      throw InputError(fmt::format("{}: nested deeper than {} levels at {}", file_, deepest, place().substr(0, 60)));
    }
    levels_.push_back({.object = object});
    return true;
  }

  bool close() {
    levels_.pop_back();
    return value();
  }

  /// As in `outputs[2].scale`.
  std::string place() const {
    std::string path;
    for (const Level& level : levels_) {
      if (level.object) path += (path.empty() ? "" : ".") + level.name;
      if (!level.object) path += fmt::format("[{}]", level.index);
    }
    return path.empty() ? "the file" : path;
  }

  std::string_view text_;
  const std::string& file_;
  std::vector<Level> levels_;
};

}  // namespace

nlohmann::json json_from_text(std::string_view text, const std::string& file) {
  require_utf8(text, file);
  Check check(text, file);
  nlohmann::json::sax_parse(text, &check);
  return nlohmann::json::parse(text);
}

}  // namespace bitrock::base
