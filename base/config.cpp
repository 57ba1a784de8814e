#include "base/config.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "base/encoding.hpp"
#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/number.hpp"
#include "base/oilfield_key.hpp"
#include "base/text.hpp"
#include "base/unit_hint.hpp"

namespace bitrock::base {

bool Range::contains(double value) const {
  if (!std::isfinite(value)) return false;
  if (or_zero && value == 0.0) return true;
  if (low_open ? value <= low : value < low) return false;
  return high_open ? value < high : value <= high;
}

std::string Range::text() const {
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && has_high) {
    return fmt::format("{}{} {} and {} {}", or_zero ? "0, or " : "", low_open ? "above" : "at least", low,
                       high_open ? "below" : "at most", high);
  }
  if (has_low) return fmt::format("{} {}", low_open ? "above" : "at least", low);
  if (has_high) return fmt::format("{} {}", high_open ? "below" : "at most", high);
  return "any finite number";
}

struct ConfigFile::State {
  toml::table root;
  std::string name;
  std::filesystem::path folder;
  std::set<std::string> known_tables{""};
  std::set<std::string> known_keys;               // "section.key"; entries of an array of tables share theirs
  std::map<std::string, std::string> written_as;  // "section.length_m" -> "length_ft", where the file has that

  [[noreturn]] void refuse(const toml::node& node, const std::string& what, const std::string& why) const {
    throw InputError(fmt::format("{}:{}: {} ({})", name, node.source().begin.line, what, why));
  }
};

namespace {

std::string source_text(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) { text << value; });
  return text.str();
}

std::string qualified(const std::string& section, const std::string& key) {
  return section.empty() ? key : section + "." + key;
}

/// Copies one TOML value into its field, checked; `refuse` reports what was seen and why it is not allowed.
template <class Refuse>
void assign(const toml::node& node, const Field& field, const Refuse& refuse) {
  const auto number = [&](const toml::node& entry) {
    const auto value = entry.is_number() ? entry.value<double>() : std::nullopt;
    if (!value) refuse(entry, "must be a number");
    if (!field.range.contains(*value)) refuse(entry, out_of_range(field.name, *value, field.range));
    if (!std::isfinite(*value * field.si_per_unit)) refuse(entry, "is too large");
    return *value;
  };
  const auto integer = [&](const toml::node& entry) {
    if (!entry.is_integer()) refuse(entry, "must be a whole number");
    const double value = number(entry);
    if (std::abs(value) > std::numeric_limits<int>::max()) refuse(entry, "is too large for a whole number here");
    return static_cast<int>(value);
  };
  const auto list = [&](auto* target, const auto& convert, const char* kind) {
    const toml::array* entries = node.as_array();
    if (entries == nullptr || entries->empty()) refuse(node, std::string("must be a list of ") + kind);
    target->clear();
    for (const toml::node& entry : *entries) target->push_back(convert(entry));
  };

  if (auto* real = std::get_if<double*>(&field.target)) {
    **real = number(node) * field.si_per_unit;
  } else if (auto* whole = std::get_if<int*>(&field.target)) {
    **whole = integer(node);
  } else if (auto* flag = std::get_if<bool*>(&field.target)) {
    if (!node.is_boolean()) refuse(node, "must be true or false");
    **flag = *node.value<bool>();
  } else if (auto* text = std::get_if<std::string*>(&field.target)) {
    if (!node.is_string()) refuse(node, "must be a text in quotes");
    **text = *node.value<std::string>();
  } else if (auto* reals = std::get_if<std::vector<double>*>(&field.target)) {
    list(
        *reals, [&](const toml::node& entry) { return number(entry) * field.si_per_unit; }, "numbers");
  } else {
    list(std::get<std::vector<int>*>(field.target), integer, "whole numbers");
  }
}

/// The shortest text that is read back as this SI value; empty when there is none.
std::string exact_text(double value, double si_per_unit) {
  const double in_file = value / si_per_unit;
  for (const int digits : {15, 16, 17}) {
    std::string text = fmt::format("{:.{}g}", in_file, digits);
    if (number_in(text).value() * si_per_unit == value) return text;
  }
  for (const double towards : {-HUGE_VAL, HUGE_VAL}) {  // division and multiplication round once each
    const double beside = std::nextafter(in_file, towards);
    if (beside * si_per_unit == value) return fmt::format("{:.17g}", beside);
  }
  return "";
}

using RealText = std::string(double value, double si_per_unit);

std::string short_real(double value, double si_per_unit) {
  return fmt::format("{:.15g}", value / si_per_unit);
}

/// The exact text, or the nearest short one where [exact] says the rest.
std::string exact_real(double value, double si_per_unit) {
  const std::string exact = exact_text(value, si_per_unit);
  return exact.empty() ? short_real(value, si_per_unit) : exact;
}

/// How many values of a list stand in a line; those beyond begin a new one, as a line may not be of any length.
constexpr std::size_t all_in_a_line = std::numeric_limits<std::size_t>::max(), some_in_a_line = 20;

std::string value_text(const Field& field, RealText* real_text, std::size_t in_a_line) {
  const auto real = [&](double value) { return real_text(value, field.si_per_unit); };
  const auto joined = [in_a_line](const auto& values, const auto& convert) {
    std::string text;
    std::size_t count = 0;
    for (const auto& value : values) {
      if (count > 0) text += count % in_a_line == 0 ? ",\n  " : ", ";
      text += convert(value);
      ++count;
    }
    return "[" + text + "]";
  };
  if (auto* number = std::get_if<double*>(&field.target)) return real(**number);
  if (auto* whole = std::get_if<int*>(&field.target)) return std::to_string(**whole);
  if (auto* flag = std::get_if<bool*>(&field.target)) return **flag ? "true" : "false";
  if (auto* text = std::get_if<std::string*>(&field.target)) {
    std::ostringstream quoted;
    quoted << toml::value<std::string>(**text);
    return quoted.str();
  }
  if (auto* reals = std::get_if<std::vector<double>*>(&field.target)) return joined(**reals, real);
  return joined(*std::get<std::vector<int>*>(field.target), [](int value) { return std::to_string(value); });
}

}  // namespace

ConfigFile::ConfigFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
ConfigFile::~ConfigFile() = default;
ConfigFile::ConfigFile(ConfigFile&&) noexcept = default;

namespace {

// The parser recurses once for each dot of a key; a line this long is no input of ours but could overflow its stack.
constexpr std::size_t longest_line = 10000;

void refuse_long_lines(std::string_view text, const std::string& name) {
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    if (length > longest_line) {
      throw InputError(
          fmt::format("{}:{}: a line of {} characters (at most {} are allowed)", name, line, length, longest_line));
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
}

}  // namespace

ConfigFile ConfigFile::from_text(std::string_view text, const std::string& name) {
  require_utf8(text, name);
  refuse_long_lines(text, name);
  auto state = std::make_unique<State>();
  state->name = name;
  try {
    state->root = toml::parse(text, std::string_view(name));
  } catch (const toml::parse_error& error) {
    throw InputError(
        fmt::format("{}:{}:{}: {}", name, error.source().begin.line, error.source().begin.column, error.description()));
  }
  return ConfigFile(std::move(state));
}

ConfigFile ConfigFile::read(const std::filesystem::path& path) {
  ConfigFile file = from_text(read_whole(path), path.string());
  file.state_->folder = path.parent_path();
  return file;
}

namespace {

/// What may stand there, for the message that it does not.
std::string allowed_text(const Field& field) {
  return std::holds_alternative<std::string*>(field.target) ? "; a text in quotes" : "; " + field.range.text();
}

/// Names a key of the table that nobody knows and that looks like the missing one.
std::string misspelt(const Field& field, const toml::table& table, const Section& section) {
  std::vector<std::string> strangers;
  for (const auto& [key, node] : table) {
    const auto known = [&key = key](const Field& other) {
      const std::optional<Field> oilfield = in_oilfield_unit(other);
      return other.name == key.str() || (oilfield && oilfield->name == key.str());
    };
    if (std::none_of(section.fields.begin(), section.fields.end(), known)) strangers.emplace_back(key.str());
  }
  const std::string nearest = nearest_name(field.name, strangers);
  return nearest.empty() ? "" : "; is it the unknown key " + nearest + "?";
}

/// A key without both limits takes a slipped unit, or 1e308, without a word: every number has a lowest and a highest.
void require_limits(const Field& field) {
  const bool number =
      !std::holds_alternative<bool*>(field.target) && !std::holds_alternative<std::string*>(field.target);
  if (number && !(std::isfinite(field.range.low) && std::isfinite(field.range.high)))
    throw std::logic_error("the key " + field.name + " has no limits");
}

template <class State, class Refuse>
void fill_table(State& state, const toml::table& table, const Section& section, int line, const Refuse& refuse) {
  for (const Field& field : section.fields) {
    require_limits(field);
    const std::optional<Field> other = in_oilfield_unit(field);
    const bool other_written = other && table.contains(other->name);
    const Field& written = other_written ? *other : field;
    state.known_keys.insert(qualified(section.name, field.name));
    if (other) state.known_keys.insert(qualified(section.name, other->name));
    if (other_written) state.written_as[qualified(section.name, field.name)] = other->name;
    const auto refuse_value = [&](const toml::node& at, const std::string& why) {
      refuse(at, qualified(section.name, written.name) + " = " + source_text(at), why);
    };
    const toml::node* node = table.get(written.name);
    if (other_written && table.contains(field.name))
      refuse_value(*node, field.name + " is there too; give one of the two");
    if (node != nullptr) {
      assign(*node, written, refuse_value);
    } else if (field.required) {
      throw InputError(fmt::format("{}:{}: {}{} is missing ({}{}){}", state.name, line,
                                   qualified(section.name, field.name), other ? " or " + other->name : "",
                                   field.meaning, allowed_text(field), misspelt(field, table, section)));
    }
  }
}

}  // namespace

namespace {

/// Takes the SI value that [exact] says of a field, when it is that of the key to all digits a person would write.
template <class Refuse>
void take_exact(const toml::table& exact, const Section& section, const Refuse& refuse) {
  constexpr double last_digit = 1e-14;  // of 15; the unit costs another bit
  for (const Field& field : section.fields) {
    auto* const* real = std::get_if<double*>(&field.target);
    const toml::node* node = real == nullptr ? nullptr : exact.get(qualified(section.name, field.name));
    if (node == nullptr) continue;
    const double value = node->is_floating_point() ? *node->value<double>() : std::numeric_limits<double>::quiet_NaN();
    if (!(std::abs(value - **real) <= last_digit * std::abs(**real))) {
      refuse(*node, "[exact] " + qualified(section.name, field.name) + " = " + source_text(*node),
             fmt::format("must be the value of that key in SI, {}; remove the line to use the key alone", **real));
    }
    **real = value;
  }
}

}  // namespace

void ConfigFile::fill(const Section& section) {
  State& state = *state_;
  state.known_tables.insert(section.name);
  const auto refuse = [&state](const toml::node& node, const std::string& what, const std::string& why) {
    state.refuse(node, what, why);
  };
  static const toml::table nothing;
  const toml::table* table = &state.root;
  int line = 1;
  if (!section.name.empty()) {
    const toml::node* node = state.root.get(section.name);
    if (node != nullptr && !node->is_table())
      state.refuse(*node, section.name, "must be a table [" + section.name + "]");
    table = node == nullptr ? &nothing : node->as_table();
    if (node != nullptr) line = static_cast<int>(node->source().begin.line);
  }
  fill_table(state, *table, section, line, refuse);
  if (const toml::table* exact = state.root[exact_section].as_table()) {
    state.known_tables.insert(exact_section);
    for (const Field& field : section.fields)
      state.known_keys.insert(qualified(exact_section, qualified(section.name, field.name)));
    take_exact(*exact, section, refuse);
  }
}

bool ConfigFile::has(const std::string& section, const std::string& key) const {
  if (section.empty()) return state_->root.contains(key);
  if (key.empty()) return state_->root.contains(section);
  return static_cast<bool>(state_->root[section][key]) || state_->written_as.contains(qualified(section, key));
}

bool ConfigFile::has_table(const std::string& name) const {
  const toml::node* node = state_->root.get(name);
  return node != nullptr && node->is_table();
}

int ConfigFile::count(const std::string& name) const {
  state_->known_tables.insert(name);
  const toml::node* node = state_->root.get(name);
  if (node == nullptr) return 0;
  if (!node->is_array_of_tables()) state_->refuse(*node, name, "must be a list of tables [[" + name + "]]");
  return static_cast<int>(node->as_array()->size());
}

void ConfigFile::fill_entry(const Section& section, int index) {
  State& state = *state_;
  const toml::table& table =
      *state.root.get(section.name)->as_array()->get(static_cast<std::size_t>(index))->as_table();
  fill_table(state, table, section, static_cast<int>(table.source().begin.line),
             [&](const toml::node& node, const std::string& what, const std::string& why) {
               state.refuse(node, what, fmt::format("{}; entry {} of [[{}]]", why, index + 1, section.name));
             });
}

void ConfigFile::refuse_unknown() const {
  const State& state = *state_;
  const auto suggest = [](const std::string& name, const std::vector<std::string>& candidates) {
    const std::string nearest = nearest_name(name, candidates);
    return nearest.empty() ? std::string("no such key; see docs/reference/formats.md")
                           : "no such key; did you mean " + nearest + "?";
  };
  const auto check_keys = [&](const std::string& section, const toml::table& table) {
    std::vector<std::string> candidates;
    for (const std::string& known : state.known_keys) {
      const std::string prefix = section.empty() ? "" : section + ".";
      if (known.compare(0, prefix.size(), prefix) == 0) candidates.push_back(known.substr(prefix.size()));
    }
    for (const auto& [key, node] : table) {
      const std::string text(key.str());
      const bool subtable = section.empty() && (node.is_table() || node.is_array_of_tables());
      if (subtable) continue;
      if (!state.known_keys.contains(qualified(section, text))) {
        state.refuse(node, qualified(section, text) + " is unknown", suggest(text, candidates));
      }
    }
  };
  check_keys("", state.root);
  for (const auto& [key, node] : state.root) {
    const std::string name(key.str());
    if (!node.is_table() && !node.is_array_of_tables()) continue;
    if (!state.known_tables.contains(name)) {
      state.refuse(node, "table [" + name + "] is unknown",
                   suggest(name, {state.known_tables.begin(), state.known_tables.end()}));
    }
    if (const toml::table* table = node.as_table()) check_keys(name, *table);
    if (node.is_array_of_tables()) {
      for (const toml::node& entry : *node.as_array()) check_keys(name, *entry.as_table());
    }
  }
}

void ConfigFile::refuse(const std::string& section, const std::string& key, const std::string& why) const {
  const toml::node_view<const toml::node> table = section.empty()
                                                      ? toml::node_view<const toml::node>(state_->root)
                                                      : toml::node_view<const toml::node>(state_->root.get(section));
  const auto other = state_->written_as.find(qualified(section, key));
  const std::string& written = other == state_->written_as.end() ? key : other->second;
  const toml::node* node = table ? table[written].node() : nullptr;
  if (node != nullptr) state_->refuse(*node, qualified(section, written) + " = " + source_text(*node), why);
  throw InputError(fmt::format("{}: {} ({})", state_->name, qualified(section, key), why));
}

std::filesystem::path ConfigFile::resolve(const std::string& path) const {
  const std::filesystem::path written(path);
  return (written.is_absolute() ? written : state_->folder / written).lexically_normal();
}

const std::string& ConfigFile::name() const {
  return state_->name;
}

Field left_out_at_zero(Field field) {
  field.left_out_at_zero = true;
  return field;
}

namespace {

bool is_left_out(const Field& field) {
  const auto* const* real = std::get_if<double*>(&field.target);
  return field.left_out_at_zero && real != nullptr && **real == 0.0;
}

std::string toml_text(const std::vector<Section>& sections, RealText* real_text, std::size_t in_a_line) {
  std::string text;
  for (const Section& section : sections) {
    if (!section.name.empty()) text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section.name);
    for (const Field& field : section.fields) {
      if (!is_left_out(field)) text += fmt::format("{} = {}\n", field.name, value_text(field, real_text, in_a_line));
    }
  }
  return text;
}

}  // namespace

std::string to_toml(const std::vector<Section>& sections) {
  return toml_text(sections, short_real, all_in_a_line);
}

std::string to_exact_toml(const std::vector<Section>& sections) {
  std::string rest;
  for (const Section& section : sections) {
    for (const Field& field : section.fields) {
      auto* const* real = std::get_if<double*>(&field.target);
      if (real == nullptr || !exact_text(**real, field.si_per_unit).empty()) continue;
      rest += fmt::format("\"{}\" = {:.17e}\n", qualified(section.name, field.name), **real);
    }
  }
  const std::string text = toml_text(sections, exact_real, some_in_a_line);
  return rest.empty() ? text : fmt::format("{}\n[{}]\n{}", text, exact_section, rest);
}

}  // namespace bitrock::base
