#pragma once
/// The parts of the module, one file a topic.

#include <pybind11/pybind11.h>

namespace bitrock::python {

void bind_bit(pybind11::module_& module);
void bind_cut(pybind11::module_& module);
void bind_drill(pybind11::module_& module);
void bind_errors(pybind11::module_& module);
void bind_features(pybind11::module_& module);
void bind_lab(pybind11::module_& module);
void bind_model(pybind11::module_& module);
void bind_parity(pybind11::module_& module);
void bind_peaks(pybind11::module_& module);
void bind_specimen(pybind11::module_& module);
void bind_train(pybind11::module_& module);

}  // namespace bitrock::python
