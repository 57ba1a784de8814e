#pragma once
/// Numbers between C++ and numpy. What C++ holds is seen from Python without a copy, read-only, and kept alive by the
/// array; what Python gives is taken without a copy when it is a contiguous array of float64.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace bitrock::python {

using Doubles = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// `owner`: the Python object in which the numbers lie.
template <class Number>
pybind11::array_t<Number> view(const std::vector<Number>& numbers, const pybind11::handle& owner) {
  pybind11::array_t<Number> array(static_cast<pybind11::ssize_t>(numbers.size()), numbers.data(), owner);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// Numbers that from now on belong to Python.
template <class Number>
pybind11::array_t<Number> given(std::vector<Number> numbers) {
  auto kept = std::make_unique<std::vector<Number>>(std::move(numbers));
  const std::vector<Number>& values = *kept;
  const pybind11::capsule owner(kept.release(), [](void* vector) { delete static_cast<std::vector<Number>*>(vector); });
  return pybind11::array_t<Number>(static_cast<pybind11::ssize_t>(values.size()), values.data(), owner);
}

/// Real numbers of any shape as float64. Throws `InputError` that begins with `name` for anything else.
Doubles doubles_of(const pybind11::object& numbers, const std::string& name);

/// The same, of one dimension.
Doubles series_of(const pybind11::object& numbers, const std::string& name);

inline std::span<const double> span_of(const Doubles& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

}  // namespace bitrock::python
