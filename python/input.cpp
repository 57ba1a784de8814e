#include "python/input.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl/filesystem.h>

#include "base/errors.hpp"
#include "base/shipped.hpp"
#include "base/unit_hint.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

void set(const base::Field& field, const std::string& keyword, const py::handle& value) {
  const auto wrong = [&](const char* wanted) {
    return py::type_error(fmt::format("{} = {} (must be {})", keyword, std::string(py::repr(value)), wanted));
  };
  if (auto* const* number = std::get_if<double*>(&field.target)) {
    const double given = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw wrong("a number");
    }
    require_within(keyword, given, field.range);
    **number = given * field.si_per_unit;
  } else if (auto* const* text = std::get_if<std::string*>(&field.target)) {
    if (!py::isinstance<py::str>(value)) throw wrong("a str");
    **text = value.cast<std::string>();
  } else {
    throw std::logic_error("keyword " + keyword + ": fields of this type have no keyword");
  }
}

}  // namespace

std::optional<std::filesystem::path> data_folder() {
  Dl_info place{};
  if (::dladdr(reinterpret_cast<const void*>(&data_folder), &place) == 0) return std::nullopt;
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::absolute(place.dli_fname, error).parent_path() / "data";
  if (!std::filesystem::is_directory(folder / base::shipped_folder, error)) return std::nullopt;
  return folder;
}

std::filesystem::path input_path(const py::object& path) {
  return base::or_shipped(output_path(path), data_folder());
}

std::filesystem::path output_path(const py::object& path) {
  return py::module_::import("os").attr("fsdecode")(path).cast<std::string>();
}

bool is_content(const py::object& source) {
  return py::isinstance<py::dict>(source);
}

std::string toml_text(const py::object& content) {
  return py::module_::import("bitrock._toml").attr("text")(content).cast<std::string>();
}

void set_by_keyword(const std::vector<base::Section>& sections, const py::dict& keywords) {
  for (const auto& [key, value] : keywords) {
    const std::string keyword = key.cast<std::string>();
    const base::Field* found = nullptr;
    std::vector<std::string> names;
    for (const base::Section& section : sections) {
      for (const base::Field& field : section.fields) {
        names.push_back(section.name == "cut" ? field.name : section.name + "_" + field.name);
        if (names.back() == keyword) found = &field;
      }
    }
    if (found == nullptr) {
      throw base::InputError(fmt::format("unknown keyword '{}' (there are: {})", keyword, fmt::join(names, ", ")));
    }
    set(*found, keyword, value);
  }
}

void require_within(std::string_view name, double value, const base::Range& allowed) {
  if (allowed.contains(value)) return;
  throw base::InputError(fmt::format("{} = {:.6g} ({})", name, value, base::out_of_range(name, value, allowed)));
}

}  // namespace bitrock::python
