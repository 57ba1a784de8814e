#pragma once
#include <pybind11/numpy.h>

#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::python {

/// A structured array with the names of `/cracks` of a run file.
pybind11::array cracks_array(const std::vector<dem2d::Crack>& cracks);

}  // namespace bitrock::python
