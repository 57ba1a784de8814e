#pragma once
#include <pybind11/pybind11.h>

#include "peaks/definition.hpp"
#include "peaks/moments.hpp"

namespace bitrock::python {

/// amax, amean, np1, np23, np4.
pybind11::dict as_dict(const peaks::PeakStatistics& statistics);

}  // namespace bitrock::python
