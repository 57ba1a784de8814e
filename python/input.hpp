#pragma once
/// What a caller may give in place of a file: its name, or its content as a dict.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/config.hpp"

namespace bitrock::python {

/// The folder that holds the shipped `campaigns/`, beside this module; empty when there is none.
std::optional<std::filesystem::path> data_folder();

/// A file to read, given as str or os.PathLike. `campaigns/...` that is not here is the shipped one.
std::filesystem::path input_path(const pybind11::object& path);
std::filesystem::path output_path(const pybind11::object& path);

/// Whether the content itself is given: a dict with the tables and keys of the file.
bool is_content(const pybind11::object& source);
/// That content as the text of a TOML file.
std::string toml_text(const pybind11::object& content);

/// Of a file by `read`, or of a content by `parse`, to which `name` is the name of the file.
template <class Read, class Parse>
auto read_input(const pybind11::object& source, const char* name, const Read& read, const Parse& parse) {
  return is_content(source) ? parse(toml_text(source), name) : read(input_path(source));
}

/// Sets fields by keyword: those of the table `cut` by their name, others with the name of their table before it
/// (`bed_length_mm`). Throws `InputError` for a name that is not there and TypeError for a value of another type.
void set_by_keyword(const std::vector<base::Section>& sections, const pybind11::dict& keywords);

/// Throws `InputError` when the value is not allowed, in the words of the program.
void require_within(std::string_view name, double value, const base::Range& allowed);

}  // namespace bitrock::python
