// The networks: a model file, and what it predicts.
#include "surrogate/net/model.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/input.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using surrogate::Model, surrogate::OutputModel, surrogate::Variable;

py::dict range_of(const Variable& variable) {
  py::dict dict;
  dict["name"] = variable.name;
  dict["unit"] = variable.unit;
  dict["low"] = variable.low;
  dict["high"] = variable.high;
  return dict;
}

py::list inputs(const Model& model) {
  py::list list;
  for (const Variable& variable : model.inputs) list.append(range_of(variable));
  return list;
}

py::list outputs(const Model& model) {
  py::list list;
  for (const OutputModel& output : model.outputs) {
    py::dict dict = range_of(output.variable);
    dict["layers"] = output.network.layers;
    dict["output_activation"] = std::string(surrogate::name_of(output.network.output));
    dict["best_epoch"] = output.best_epoch;
    dict["restarts"] = output.restarts;
    list.append(dict);
  }
  return list;
}

py::dict learning_curves(const Model& model) {
  py::dict curves;
  for (const OutputModel& output : model.outputs) {
    std::vector<int> epoch;
    std::vector<double> train, validation, test;
    for (const surrogate::LearningPoint& point : output.learning_curve) {
      epoch.push_back(point.epoch);
      train.push_back(point.train_mse);
      validation.push_back(point.validation_mse);
      test.push_back(point.test_mse);
    }
    py::dict curve;
    curve["epoch"] = given(std::move(epoch));
    curve["train_mse"] = given(std::move(train));
    curve["validation_mse"] = given(std::move(validation));
    curve["test_mse"] = given(std::move(test));
    curves[output.variable.name.c_str()] = curve;
  }
  return curves;
}

py::dict provenance(const Model& model) {
  const surrogate::Provenance& p = model.provenance;
  py::dict dict;
  dict["data_file"] = p.data_file;
  dict["data_fingerprint"] = p.data_fingerprint;
  dict["seed"] = p.seed;
  dict["split"] = p.split;
  dict["epochs"] = p.epochs;
  dict["batch"] = p.batch;
  dict["learning_rate"] = p.learning_rate;
  dict["train_cases"] = p.train_cases;
  dict["validation_cases"] = p.validation_cases;
  dict["test_cases"] = p.test_cases;
  dict["bitrock_version"] = p.bitrock_version;
  return dict;
}

/// The three conditions brought to one shape, and a column for each output.
py::dict predict(const Model& model, const py::object& speed, const py::object& depth_mm, const py::object& rake_deg) {
  surrogate::require_no_further_inputs(model, "the model");
  const py::module_ numpy = py::module_::import("numpy");
  const py::sequence together = numpy.attr("broadcast_arrays")(
      doubles_of(speed, "speed_m_per_s"), doubles_of(depth_mm, "depth_mm"), doubles_of(rake_deg, "rake_deg"));
  const Doubles v(together[0]), d(together[1]), rake(together[2]);
  const std::vector<py::ssize_t> shape(v.shape(), v.shape() + v.ndim());
  std::vector<py::array_t<double>> columns;
  for (std::size_t k = 0; k < model.outputs.size(); ++k) columns.emplace_back(shape);
  py::array_t<bool> inside(shape);
  std::vector<double*> to;
  for (py::array_t<double>& column : columns) to.push_back(column.mutable_data());
  bool* const is_inside = inside.mutable_data();
  const double *const from_v = v.data(), *const from_d = d.data(), *const from_rake = rake.data();
  const py::ssize_t count = v.size();
  {
    const py::gil_scoped_release free;
    for (py::ssize_t i = 0; i < count; ++i) {
      const surrogate::Prediction answer =
          surrogate::predict(model, {.cutter_speed = from_v[i] * surrogate::input_names[0].si_per_unit,
                                     .depth_of_cut = from_d[i] * surrogate::input_names[1].si_per_unit,
                                     .back_rake = from_rake[i] * surrogate::input_names[2].si_per_unit});
      const auto numbers = surrogate::listed(answer);
      for (std::size_t k = 0; k < numbers.size(); ++k) to[k][i] = numbers[k];
      is_inside[i] = answer.inside_training_range;
    }
  }
  // An array without dimensions becomes a number, as numpy has it.
  const auto plain = [&shape](const py::array& array) {
    return shape.empty() ? array.attr("item")() : py::object(array);
  };
  py::dict result;
  for (std::size_t k = 0; k < columns.size(); ++k)
    result[std::string(surrogate::output_names[k].name).c_str()] = plain(columns[k]);
  result["inside_training_range"] = plain(inside);
  return result;
}

Model held_at(const Model& model, const py::kwargs& values) {
  std::vector<surrogate::HeldInput> held;
  for (const auto& [name, value] : values)
    held.push_back({.name = py::cast<std::string>(name), .value = py::cast<double>(value)});
  return surrogate::held(model, held);
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<Model>(module, "Model", "Small networks, one an output: statistics of the force on a cutter in one rock.")
      .def_static(
          "load", [](const py::object& path) { return surrogate::read_model(input_path(path)); }, py::arg("path"),
          "Read a model file (model.json).")
      .def(
          "save", [](const Model& self, const py::object& path) { surrogate::write_model(output_path(path), self); },
          py::arg("path"), "Write the model file; it reads back bit for bit.")
      .def("predict", &predict, py::kw_only(), py::arg("speed_m_per_s"), py::arg("depth_mm"), py::arg("rake_deg"),
           "Peak statistics for cutting conditions: numbers or arrays, which are broadcast.\n\n"
           "A dict of arrays of their common shape (numbers for numbers): x_amax_N_per_m, x_amean_N_per_m [N/m per "
           "metre\n"
           "of cutter width], x_np1_per_m, x_np23_per_m, x_np4_per_m [peaks per metre of cut], the same of y (axial), "
           "and\n"
           "where the model has them x_mean_N_per_m, x_sd_N_per_m, y_mean_N_per_m, y_sd_N_per_m,\n"
           "correlation_length_m, short_correlation_length_m, xy_correlation; and\n"
           "inside_training_range [bool]: where it is False the networks extrapolate.")
      .def("hold", &held_at,
           "The networks at fixed values of further inputs: model.hold(fluid_pressure_MPa=20) asks for speed, depth "
           "and\n"
           "rake alone.")
      .def_readonly("rock", &Model::rock, "which rock, in words")
      .def_property_readonly("inputs", &inputs,
                             "three or more dicts: name, unit, low, high (training range, in that unit)")
      .def_property_readonly(
          "outputs", &outputs,
          "ten or seventeen dicts: name, unit, low, high, layers, output_activation, best_epoch, restarts")
      .def_property_readonly("learning_curves", &learning_curves,
                             "by output: dict of arrays epoch, train_mse, validation_mse, test_mse (scaled units)")
      .def_property_readonly("provenance", &provenance, "dict: data, seeds and cases of the training")
      .def(
          "__eq__",
          [](const Model& self, const Model& other) {
            return surrogate::model_text(self) == surrogate::model_text(other);
          },
          "whether their files would be the same")
      .def("__repr__", [](const Model& self) {
        return fmt::format("<bitrock.Model: {}, learnt from {} cases of {}>",
                           self.rock.empty() ? "rock not said" : self.rock, self.provenance.train_cases.size(),
                           self.provenance.data_file);
      });
}

}  // namespace bitrock::python
