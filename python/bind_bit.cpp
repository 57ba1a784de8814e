// A whole bit: its cutters, the force of the rock on it, step by step or at steady speed.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include "base/errors.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/computing.hpp"
#include "python/input.hpp"
#include "python/tallies.hpp"
#include "runtime/bit/bit.hpp"
#include "runtime/bit/bit_force.hpp"
#include "runtime/bit/constant_speed.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using runtime::Bit, runtime::BitForce, runtime::BitLoad, runtime::Cutter, runtime::Signal;

Bit load(const py::object& source) {
  Bit bit = read_input(
      source, "bit", [](const std::filesystem::path& path) { return runtime::read_bit(path); },
      [](const std::string& text, const char* name) {
        base::ConfigFile file = base::ConfigFile::from_text(text, name);
        return runtime::read_bit(file);
      });
  warn(runtime::warnings(bit));
  return bit;
}

auto cutters(double Cutter::*member) {
  return [member](const Bit& bit) {
    std::vector<double> values;
    for (const Cutter& cutter : bit.cutters) values.push_back(cutter.*member);
    return given(std::move(values));
  };
}

std::pair<double, double> at(BitForce& force, double angle, double rotation, double rop) {
  const BitLoad load = force.at({.angle = angle, .rotation = rotation, .rate_of_penetration = rop});
  return {load.axial_force, load.torque};
}

py::tuple along(BitForce& force, const py::object& angles, double rotation, double rop) {
  const Doubles angle = series_of(angles, "angle_rad");
  std::vector<double> axial(static_cast<std::size_t>(angle.size())), torque(axial.size());
  {
    const py::gil_scoped_release free;
    force.along(span_of(angle), {.rotation = rotation, .rate_of_penetration = rop}, axial, torque);
  }
  return py::make_tuple(given(std::move(axial)), given(std::move(torque)));
}

py::bytes save(const BitForce& force) {
  std::string state(force.state_size(), '\0');
  force.save(std::as_writable_bytes(std::span(state.data(), state.size())));
  return {state};
}

void restore(BitForce& force, const py::bytes& bytes) {
  const std::string_view state = bytes;
  force.restore(std::as_bytes(std::span(state.data(), state.size())));
}

Signal signal(const Bit& bit, const surrogate::Model& model, double rotation, double rop, double duration, double rate,
              const py::object& progress) {
  const runtime::ConstantSpeed drive{
      .rotation = rotation, .rate_of_penetration = rop, .duration = duration, .rate = rate};
  return computed(progress, {"drilling", "s"}, [&](const base::ProgressCallback& listener) {
    return runtime::constant_speed_signal(bit, model, drive, listener);
  });
}

void bind_bit_force(py::module_& module) {
  py::class_<BitForce>(
      module, "BitForce",
      "Force and torque of the rock on a bit that somebody moves: the sum of its cutters, each rebuilt\n"
      "from what the networks say about its own speed, depth and rake. One object for one thread; a\n"
      "copy (copy.copy) goes on from where the original is.")
      .def(py::init<const Bit&, const surrogate::Model&>(), py::arg("bit"), py::arg("model"))
      .def("at", &at, py::arg("angle_rad"), py::arg("rotation_rad_per_s"), py::arg("rop_m_per_s"),
           "(axial_force_N, torque_N_m) at an angle that the bit has turned forward while cutting, at this rotation\n"
           "[rad/s] and rate of penetration [m/s]; resistance to drilling is positive.")
      .def("along", &along, py::arg("angle_rad"), py::arg("rotation_rad_per_s"), py::arg("rop_m_per_s"),
           "(axial_force_N, torque_N_m), arrays of shape (n,), at many angles [rad] in a row, shape (n,), at steady\n"
           "rates: what `at` gives for each of them.")
      .def("save", &save, "The whole state as bytes.")
      .def("restore", &restore, py::arg("state"),
           "Back to a state of save, of the same bit and model: the same forces again, to the last bit.")
      .def_property_readonly(
          "clamps", [](const BitForce& self) { return as_dict(self.clamps()); },
          "dict: questions asked of the networks, and how many were moved to the edge of their training range and why")
      .def_property_readonly(
          "draws", [](const BitForce& self) { return as_dict(self.draws()); },
          "dict: windows drawn, and how many could not have all that the networks say")
      .def("__copy__", [](const BitForce& self) { return BitForce(self); })
      .def(
          "__deepcopy__", [](const BitForce& self, const py::dict&) { return BitForce(self); }, py::arg("memo"));
}

void bind_signal(py::module_& module) {
  const auto numbers = [](auto member) {
    return [member](const py::object& self) { return view(self.cast<const Signal&>().*member, self); };
  };
  py::class_<Signal>(module, "Signal", "The load on a bit at steady speed; arrays of shape (samples,).")
      .def_property_readonly("time_s", numbers(&Signal::time_s), "[s]")
      .def_property_readonly("angle_rad", numbers(&Signal::angle_rad), "[rad]")
      .def_property_readonly("axial_force_N", numbers(&Signal::axial_force_N), "pushes the bit off the rock [N]")
      .def_property_readonly("torque_N_m", numbers(&Signal::torque_N_m), "resists its rotation [N m]")
      .def_property_readonly(
          "depth_of_cut_m", [](const Signal& self) { return self.summary.depth_of_cut_m; },
          "a turn, of each cutter [m]")
      .def_property_readonly(
          "clamps", [](const Signal& self) { return as_dict(self.summary.clamps); }, "as of BitForce")
      .def_property_readonly(
          "draws", [](const Signal& self) { return as_dict(self.summary.draws); }, "as of BitForce");
  module.def("signal", &signal, py::arg("bit"), py::arg("model"), py::kw_only(), py::arg("rotation_rad_per_s"),
             py::arg("rop_m_per_s"), py::arg("duration_s") = 10.0, py::arg("rate_Hz") = 5000.0,
             py::arg("progress") = py::none(), "Force and torque on a bit that turns and advances steadily (Signal).");
}

}  // namespace

void bind_bit(py::module_& module) {
  py::class_<Bit>(module, "Bit", "A bit as a list of cutters; arrays of shape (cutters,).")
      .def_static("load", &load, py::arg("source"),
                  "Read a bit file (.toml), or take a dict with its keys: bit and a list cutter.")
      .def_readonly("name", &Bit::name, "of the bit")
      .def_readonly("diameter_m", &Bit::diameter, "[m]")
      .def_property_readonly("radius_m", cutters(&Cutter::radius), "from the axis to the middle of each cutter [m]")
      .def_property_readonly("width_m", cutters(&Cutter::width), "width of the ring of rock that each cutter takes [m]")
      .def_property_readonly("back_rake_rad", cutters(&Cutter::back_rake), "of each cutter [rad]")
      .def("__len__", [](const Bit& self) { return self.cutters.size(); })
      .def("__repr__", [](const Bit& self) {
        return fmt::format("<bitrock.Bit: {}, {:.4g} mm, {} cutters>", self.name, self.diameter * 1e3,
                           self.cutters.size());
      });
  bind_bit_force(module);
  bind_signal(module);
}

}  // namespace bitrock::python
