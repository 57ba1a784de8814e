// bitrock._native: what the package `bitrock` is made of. The package gives its names to the world (python/bitrock).
#include <pybind11/stl/filesystem.h>

#include "base/errors.hpp"
#include "base/version.hpp"
#include "python/bindings.hpp"
#include "python/input.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_native, module) {
  using namespace bitrock;
  module.doc() = "the C++ side of the package bitrock";
  module.attr("__version__") = base::version;
  module.def(
      "data_dir",
      [] {
        const auto folder = python::data_folder();
        if (!folder) throw base::InputError("no shipped files beside this package (its folder data is missing)");
        return *folder;
      },
      "Folder (pathlib.Path) that holds the shipped files, campaigns/... Wherever a file is read, campaigns/... that "
      "is\n"
      "not in the current folder means the shipped one.");
  python::bind_errors(module);
  python::bind_peaks(module);
  python::bind_specimen(module);
  python::bind_cut(module);
  python::bind_lab(module);
  python::bind_features(module);
  python::bind_model(module);
  python::bind_train(module);
  python::bind_parity(module);
  python::bind_bit(module);
  python::bind_drill(module);
  // In help texts and messages the names are those of the package.
  for (const auto& [name, value] : py::dict(module.attr("__dict__"))) {
    if (PyType_Check(value.ptr())) value.attr("__module__") = "bitrock";
  }
}
