// A synthetic rock: discs and the pairs that are joined.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/computing.hpp"
#include "python/input.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using dem2d::Specimen;

Specimen make(const py::object& rock_source, int seed, std::optional<double> width_mm, std::optional<double> height_mm,
              int threads, const py::object& progress) {
  require_within("seed", seed, base::between(0, 2147483647));
  require_within("threads", threads, base::between(1, 256));
  if (width_mm) require_within("width_mm", *width_mm, dem2d::specimen_length_mm);
  if (height_mm) require_within("height_mm", *height_mm, dem2d::specimen_length_mm);
  const dem2d::Rock rock = read_input(rock_source, "rock", dem2d::read_rock, dem2d::parse_rock);
  const double width = width_mm ? *width_mm * 1e-3 : rock.specimen_width;
  const double height = height_mm ? *height_mm * 1e-3 : rock.specimen_height;
  Specimen specimen = computed(progress, {"packing", ""}, [&](const base::ProgressCallback& listener) {
    return dem2d::make_specimen(rock, width, height, static_cast<std::uint64_t>(seed), threads, listener);
  });
  warn(dem2d::warnings(specimen));
  return specimen;
}

}  // namespace

void bind_specimen(py::module_& module) {
  const auto numbers = [](auto member) {
    return [member](const py::object& self) { return view(self.cast<const Specimen&>().*member, self); };
  };
  py::class_<Specimen>(module, "Specimen", "One synthetic rock: packed discs, joined stress-free in a box from (0, 0).")
      .def_property_readonly("x_m", numbers(&Specimen::x), "centres [m], shape (discs,)")
      .def_property_readonly("y_m", numbers(&Specimen::y), "centres [m], shape (discs,)")
      .def_property_readonly("radius_m", numbers(&Specimen::radius), "[m], shape (discs,)")
      .def_property_readonly("joint_disc_1", numbers(&Specimen::disc1),
                             "joined pairs: index of a disc, shape (joints,)")
      .def_property_readonly("joint_disc_2", numbers(&Specimen::disc2), "and of the other, shape (joints,)")
      .def_readonly("width_m", &Specimen::width, "of the box [m]")
      .def_readonly("height_m", &Specimen::height, "of the box [m]")
      .def_readonly("seed", &Specimen::seed, "of the packing")
      .def_readonly("origin", &Specimen::origin, "'genesis', or the table the discs came from")
      .def_property_readonly(
          "rock", [](const Specimen& self) { return self.rock.name; }, "name of the rock")
      .def_property_readonly("porosity", &dem2d::porosity, "share of the box not covered")
      .def_property_readonly("coordination_number", &dem2d::coordination_number, "mean number of joints of a disc")
      .def_property_readonly("floaters", &dem2d::floaters, "discs with less than three joints")
      .def_readonly("pressure_Pa", &Specimen::pressure, "of the packing before it was joined [Pa]")
      .def(
          "save", [](const Specimen& self, const py::object& path) { dem2d::write_specimen(self, output_path(path)); },
          py::arg("path"), "Write the specimen file (.h5), as the program does.")
      .def("__repr__", [](const Specimen& self) {
        return fmt::format("<bitrock.Specimen: {}, {:.4g} x {:.4g} mm, {} discs, {} joints, seed {}>", self.rock.name,
                           self.width * 1e3, self.height * 1e3, self.x.size(), self.disc1.size(), self.seed);
      });
  module.def(
      "read_specimen", [](const py::object& path) { return dem2d::read_specimen(input_path(path)); }, py::arg("path"),
      "Read a specimen file (.h5).");
  module.def(
      "specimen", &make, py::arg("rock"), py::kw_only(), py::arg("seed") = 1, py::arg("width_mm") = py::none(),
      py::arg("height_mm") = py::none(), py::arg("threads") = 1, py::arg("progress") = py::none(),
      "Make one synthetic rock (Specimen). Another seed, another rock.\n\n"
      "rock: a rock file (str or path), or a dict with its tables. width_mm, height_mm: in place of [specimen] of\n"
      "the rock. progress: as of cut.");
}

}  // namespace bitrock::python
