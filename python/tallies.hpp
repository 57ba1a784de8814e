#pragma once
#include <pybind11/pybind11.h>

#include "runtime/core/conditions.hpp"
#include "runtime/signal/cutter_force.hpp"

namespace bitrock::python {

/// By the names of `clamped` and `windows` of `bitrock signal --json`.
pybind11::dict as_dict(const runtime::ClampTally& clamps);
pybind11::dict as_dict(const runtime::DrawTally& draws);

}  // namespace bitrock::python
