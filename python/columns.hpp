#pragma once
/// Tables of numbers as a dict of arrays, a column each.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <optional>

#include "surrogate/train/data.hpp"

namespace bitrock::python {

/// Training data of a table (its file, or a dict of columns), or of a list of tables.
surrogate::TrainingData training_data(const pybind11::object& data);

}  // namespace bitrock::python
