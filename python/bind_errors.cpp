#include "base/errors.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace bitrock::python {

void bind_errors(py::module_& module) {
  py::register_exception<base::InputError>(module, "InputError", PyExc_ValueError).attr("__doc__") =
      "The input is wrong: a file, a key, an argument. The message says what was seen and what is allowed.";
  py::register_exception<base::SimulationError>(module, "SimulationError", PyExc_RuntimeError).attr("__doc__") =
      "The computation failed although the input was acceptable, or a result could not be written.";
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const base::Interrupted& stopped) {
      PyErr_SetString(PyExc_KeyboardInterrupt, stopped.what());
    }
  });
}

}  // namespace bitrock::python
