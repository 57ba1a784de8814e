// A drilling case from beginning to end: run here, or read from a drill file.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <array>
#include <optional>
#include <variant>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/text.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/computing.hpp"
#include "python/input.hpp"
#include "python/tallies.hpp"
#include "runtime/drillstring/drill_file.hpp"
#include "surrogate/net/model_file.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using runtime::DrillCase, runtime::DrillSeries, runtime::DrillSummary, surrogate::Model;

struct Run {
  runtime::DrillFile file;
  std::string read_from;  ///< empty: made here
};

py::dict as_dict(const runtime::Spread& spread) {
  py::dict dict;
  dict["mean"] = spread.mean;
  dict["sd"] = spread.deviation;
  dict["min"] = spread.lowest;
  dict["max"] = spread.highest;
  return dict;
}

/// By the names of the drill file, SI.
py::dict summary(const Run& run) {
  const DrillSummary& s = run.file.run.summary;
  py::dict dict;
  dict["bit_rotation_rad_per_s"] = as_dict(s.bit_rotation);
  dict["weight_on_bit_N"] = as_dict(s.weight_on_bit);
  dict["total_force_N"] = as_dict(s.total_force);
  dict["torque_on_bit_N_m"] = as_dict(s.torque);
  dict["source_force_N"] = as_dict(s.source_force);
  dict["source_torque_N_m"] = as_dict(s.source_torque);
  dict["rop_m_per_s"] = as_dict(s.rop);
  if (s.hook_load) dict["hook_load_N"] = as_dict(*s.hook_load);
  dict["static_weight_on_bit_N"] = s.static_weight_on_bit;
  dict["severity"] = s.severity;
  dict["share_at_rest"] = s.share_at_rest;
  dict["share_backwards"] = s.share_backwards;
  dict["share_off_bottom"] = s.share_off_bottom;
  dict["drilled_m"] = s.drilled;
  dict["energy_residual_fraction"] = s.energy_residual;
  return dict;
}

py::dict modes(const Run& run) {
  py::dict dict;
  dict["axial_Hz"] = given(run.file.modes.axial);
  dict["axial_off_bottom_Hz"] = given(run.file.modes.axial_off_bottom);
  dict["torsional_Hz"] = given(run.file.modes.torsional);
  return dict;
}

/// The networks of a run, and the fingerprint of their file.
struct Networks {
  std::optional<Model> model;
  std::string fingerprint;
};

Networks networks_of(DrillCase& drill, const py::object& asked) {
  if (drill.source.kind != runtime::SourceKind::bit) {
    if (!asked.is_none()) warn({"the source of the case is not 'bit': the model is not used"});
    drill.source.model_file.clear();
    return {};
  }
  Networks networks;
  if (py::isinstance<Model>(asked)) {
    networks.model = asked.cast<Model>();
    drill.source.model_file.clear();
    networks.fingerprint = base::fingerprint_text(surrogate::model_text(*networks.model));
  } else {
    if (!asked.is_none()) drill.source.model_file = input_path(asked).string();
    if (drill.source.model_file.empty()) return {};
    const std::string text = base::read_whole(drill.source.model_file);
    networks.model = surrogate::model_from_text(text, drill.source.model_file);
    networks.fingerprint = base::fingerprint_text(text);
  }
  const std::string other = runtime::other_rock(drill, *networks.model);
  if (!other.empty()) warn({other});
  return networks;
}

Run drill_run(const py::object& source, const py::object& model, std::optional<int> seed, const py::object& progress) {
  if (seed) require_within("seed", *seed, base::between(0, 2147483647));
  Run result;
  result.file.drill = read_input(
      source, "case", [](const std::filesystem::path& path) { return runtime::read_drill_case(path); },
      [](const std::string& text, const char* name) {
        base::ConfigFile file = base::ConfigFile::from_text(text, name);
        return runtime::read_drill_case(file);
      });
  DrillCase& drill = result.file.drill;
  if (seed) drill.source.seed = *seed;
  const runtime::DrillString string = runtime::assemble(drill);
  warn(runtime::warnings(drill, string));
  const Networks networks = networks_of(drill, model);
  const runtime::DrillSource load = runtime::make_source(drill, networks.model);
  const runtime::DrillSource tried = runtime::make_source(drill, networks.model);
  warn(runtime::warnings_of_load(string, tried.load));
  result.file.run = computed(progress, {"drilling", "s"}, [&](const base::ProgressCallback& listener) {
    return runtime::run_drill(drill, string, load, listener);
  });
  result.file.model = networks.fingerprint;
  result.file.modes = runtime::drill_modes(string);
  return result;
}

Run read_drill(const py::object& path) {
  const std::filesystem::path file = input_path(path);
  return {.file = runtime::read_drill_run(file), .read_from = file.string()};
}

void save(const Run& run, const py::object& path) {
  if (!run.read_from.empty())
    throw base::InputError(fmt::format("this run was read from {} (copy that file instead)", run.read_from));
  runtime::write_drill_run(run.file.run, run.file.drill, run.file.model, output_path(path));
}

auto series(std::vector<double> DrillSeries::*member) {
  return [member](const py::object& self) { return view(self.cast<const Run&>().file.run.series.*member, self); };
}

}  // namespace

void bind_drill(py::module_& module) {
  py::class_<Run>(
      module, "DrillRun",
      "A drill string on rock over time. Arrays have one value an instant, shape (samples,), and are read-only\n"
      "views of what the run holds; names are those of the drill file (docs/reference/formats.md).")
      .def_property_readonly("time_s", series(&DrillSeries::time_s), "[s]")
      .def_property_readonly("bit_rotation_rad_per_s", series(&DrillSeries::bit_rotation_rad_per_s), "[rad/s]")
      .def_property_readonly("table_rotation_rad_per_s", series(&DrillSeries::table_rotation_rad_per_s),
                             "of the top drive [rad/s]")
      .def_property_readonly("weight_on_bit_N", series(&DrillSeries::weight_on_bit_N),
                             "of the rock's spring and damper [N]")
      .def_property_readonly("source_force_N", series(&DrillSeries::source_force_N),
                             "axial force of the source on the bit, upwards [N]")
      .def_property_readonly("rop_m_per_s", series(&DrillSeries::rop_m_per_s), "rate of penetration [m/s]")
      .def_property_readonly("torque_on_bit_N_m", series(&DrillSeries::torque_on_bit_N_m),
                             "friction and fracture, against rotation [N m]")
      .def_property_readonly("fracture_torque_N_m", series(&DrillSeries::fracture_torque_N_m),
                             "part of the torque on the bit [N m]")
      .def_property_readonly("drive_torque_N_m", series(&DrillSeries::drive_torque_N_m),
                             "of the top drive on the string [N m]")
      .def_property_readonly("bit_depth_m", series(&DrillSeries::bit_depth_m),
                             "below the rock face of the beginning [m]")
      .def_property_readonly("face_depth_m", series(&DrillSeries::face_depth_m), "of the rock face [m]")
      .def_property_readonly("progression_angle_rad", series(&DrillSeries::progression_angle_rad),
                             "turned forward while cutting [rad]")
      .def_property_readonly("hook_load_N", series(&DrillSeries::hook_load_N),
                             "of a hoist that is fed, on the string, upwards [N]; otherwise empty")
      .def_property_readonly("block_speed_m_per_s", series(&DrillSeries::block_speed_m_per_s),
                             "of its block, downwards [m/s]; otherwise empty")
      .def_property_readonly(
          "summary", &summary,
          "dict over all steps after the settling time: of bit_rotation_rad_per_s, weight_on_bit_N,\n"
          "total_force_N, torque_on_bit_N_m, source_force_N, source_torque_N_m and rop_m_per_s (and hook_load_N\n"
          "where the hoist is fed) a dict with mean, sd, min, max; and numbers such as severity and share_at_rest")
      .def_property_readonly("modes", &modes,
                             "natural frequencies [Hz]: dict of arrays axial_Hz, axial_off_bottom_Hz, torsional_Hz")
      .def_property_readonly(
          "clamps", [](const Run& self) { return python::as_dict(self.file.run.summary.clamps); }, "as of BitForce")
      .def_property_readonly(
          "draws", [](const Run& self) { return python::as_dict(self.file.run.summary.draws); }, "as of BitForce")
      .def_property_readonly(
          "name", [](const Run& self) { return self.file.drill.name; }, "of the case")
      .def_property_readonly(
          "step_s", [](const Run& self) { return self.file.run.step; }, "[s]")
      .def_property_readonly(
          "steps", [](const Run& self) { return self.file.run.steps; }, "of time")
      .def_property_readonly(
          "wall_s", [](const Run& self) { return self.file.run.wall_time; }, "[s] on the clock")
      .def_property_readonly(
          "model_fingerprint", [](const Run& self) { return self.file.model; },
          "of the model file; empty without networks")
      .def("save", &save, py::arg("path"), "Write the drill file (.h5), as the program does.")
      .def("__repr__", [](const Run& self) {
        return fmt::format("<bitrock.DrillRun: {}, {} samples>", self.file.drill.name,
                           self.file.run.series.time_s.size());
      });
  module.def("read_drill", &read_drill, py::arg("path"), "Read a drill file (.h5).");
  module.def("drill_run", &drill_run, py::arg("case"), py::kw_only(), py::arg("model") = py::none(),
             py::arg("seed") = py::none(), py::arg("progress") = py::none(),
             "Run a drilling case (DrillRun).\n\n"
             "case: a case file (str or path), or a dict with its tables. model: a Model or a model file, in place of\n"
             "that of the case. seed: of the excitation, in place of that of the case. progress: True for a line on\n"
             "sys.stderr, or a function of (done, total), in seconds drilled.");
}

}  // namespace bitrock::python
