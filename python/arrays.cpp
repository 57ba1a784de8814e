#include "python/arrays.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"

namespace py = pybind11;

namespace bitrock::python {

Doubles doubles_of(const py::object& numbers, const std::string& name) {
  const py::array array = py::module_::import("numpy").attr("asarray")(numbers);
  const char kind = array.dtype().kind();
  const bool real = kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b';
  if (!real) {
    throw base::InputError(
        fmt::format("{}: values of type {} (must be real numbers)", name, std::string(py::str(array.dtype()))));
  }
  return Doubles(array);
}

Doubles series_of(const py::object& numbers, const std::string& name) {
  Doubles array = doubles_of(numbers, name);
  if (array.ndim() == 1) return array;
  throw base::InputError(fmt::format("{}: an array of shape {} (must have one dimension)", name,
                                     std::string(py::str(array.attr("shape")))));
}

}  // namespace bitrock::python
