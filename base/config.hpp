#pragma once
/// Input tables. A reader describes each table once, as a list of fields: name (with its unit), where the value goes,
/// the factor to SI, what is allowed, what it means. That one list drives the reading, the checking (unknown, missing
/// and out-of-range keys, each reported with file and line), the resolved copy kept beside the results, and the docs.
/// Files carry the units of the field (`depth_of_cut_mm`); everything behind this door is SI.

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bitrock::base {

/// Allowed values, in the unit of the file.
struct Range {
  /// The least allowed value.
  double low = -std::numeric_limits<double>::infinity();
  /// The greatest allowed value.
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   ///< true: `low` itself is not allowed
  bool high_open = false;  ///< true: `high` itself is not allowed
  bool or_zero = false;    ///< true: 0 is allowed too, and means none or the default

  bool contains(double value) const;  ///< false for NaN and infinities
  std::string text() const;           ///< "> 0", "from 0 to 90", ...
};

/// Every finite number.
inline Range any() {
  return {};
}
/// Above 0.
inline Range positive() {
  return {.low = 0.0, .low_open = true};
}
/// From `low` on.
inline Range at_least(double low) {
  return {.low = low};
}
/// From `low` to `high`, both included.
inline Range between(double low, double high) {
  return {.low = low, .high = high};
}

/// 0, or from `low` to `high`.
inline Range zero_or(double low, double high) {
  return {.low = low, .high = high, .or_zero = true};
}

/// What a key can hold: a number, a whole number, a truth, a text, or a list of numbers. Points to a variable that
/// outlives its use.
using FieldTarget = std::variant<double*, int*, bool*, std::string*, std::vector<double>*, std::vector<int>*>;

/// One key of a table and where its value goes.
struct Field {
  std::string name;               ///< key, ends in its unit
  FieldTarget target;             ///< read into, and written out from
  double si_per_unit;             ///< SI value = file value * si_per_unit; 1 where there is no unit
  Range range;                    ///< of a number, or of each entry of a list
  std::string meaning;            ///< one line for people
  bool required = false;          ///< otherwise the value already in the target is the default
  bool oilfield = false;          ///< may also be given in the unit of the oil field (`also_in_oilfield_units`)
  bool left_out_at_zero = false;  ///< not written where it is 0 (`left_out_at_zero`)
};

/// A number that texts do not show where it is 0. For keys that came later, of which 0 means what there was before
/// them: texts of then, and what is named by their hashes, stay valid.
Field left_out_at_zero(Field field);

/// One table of a file: its name and its keys.
struct Section {
  std::string name;           ///< TOML table; empty for the top level
  std::vector<Field> fields;  ///< in the order of the file
};

/// Sections of which these keys may also be given in feet, inches, pounds (base/oilfield_key.hpp). A key that no
/// section has, or that has no such unit, is a fault of the program: throws `std::logic_error`.
std::vector<Section> also_in_oilfield_units(std::vector<Section> sections, const std::vector<std::string>& keys);

/// A value in the unit of its key need not lead back to the very bits of the SI value it was written from. Where no
/// number does, the table `[exact]` of a text that a program wrote (`to_exact_toml`) says it in SI: "bed.length_mm" =
/// 0.06...
inline constexpr const char* exact_section = "exact";

/// A parsed TOML file that remembers its source lines and which of its keys have been read.
class ConfigFile {
 public:
  /// Throws `InputError` with file, line and column when the text is not TOML.
  static ConfigFile read(const std::filesystem::path& path);
  /// Throws `InputError` when the text is no TOML; `name` stands in the messages.
  static ConfigFile from_text(std::string_view text, const std::string& name);
  ~ConfigFile();
  /// The source may then only be destroyed.
  ConfigFile(ConfigFile&&) noexcept;

  /// Fills the fields of one section. A missing section counts as empty. A number whose range lacks a limit is a fault
  /// of the program: throws `std::logic_error`. One value under both its keys, `length_m` and `length_ft`, is refused.
  void fill(const Section& section);
  /// Whether the file has this section, or this key of it; once it is filled, also under the key of its other unit.
  bool has(const std::string& section, const std::string& key = "") const;
  /// Whether the name is a table here, not a single value: `[rock]`, not `rock = "file"`.
  bool has_table(const std::string& name) const;
  /// Number of entries of an array of tables `[[name]]` (0 when absent).
  int count(const std::string& name) const;
  /// Fills the fields of entry `index` (0-based) of an array of tables.
  void fill_entry(const Section& section, int index);
  /// Throws `InputError` for the first key or table that nobody read, naming the nearest known one.
  void refuse_unknown() const;

  /// "file.toml:12: key = value (allowed: ...)": for checks that concern several keys at once. Shows the key that the
  /// file has, when it has the other one.
  [[noreturn]] void refuse(const std::string& section, const std::string& key, const std::string& why) const;

  /// A path written in the file, taken relative to the file's own folder.
  std::filesystem::path resolve(const std::string& path) const;
  /// The file, for messages.
  const std::string& name() const;

 private:
  struct State;
  explicit ConfigFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The sections as TOML text with every value in file units, to 15 digits: what a person reads, and what is compared.
std::string to_toml(const std::vector<Section>& sections);

/// The same with as many digits as give the same bits when the text is read: the resolved input kept beside results,
/// from which they can be made again.
std::string to_exact_toml(const std::vector<Section>& sections);

}  // namespace bitrock::base
