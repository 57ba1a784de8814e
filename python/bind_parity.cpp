// Networks against the data, with the scatter of the data beside them.
#include "surrogate/train/parity.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/columns.hpp"
#include "python/computing.hpp"
#include "surrogate/train/data_warnings.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using surrogate::OutputParity, surrogate::Parity, surrogate::ParityPoint, surrogate::ParitySummary;

const char* name_of(surrogate::CaseRole role) {
  switch (role) {
    case surrogate::CaseRole::train:
      return "train";
    case surrogate::CaseRole::validation:
      return "validation";
    case surrogate::CaseRole::test:
      return "test";
    case surrogate::CaseRole::unseen:
      break;
  }
  return "unseen";
}

const char* name_of(surrogate::Verdict verdict) {
  switch (verdict) {
    case surrogate::Verdict::too_noisy:
      return "too_noisy";
    case surrogate::Verdict::at_noise_floor:
      return "at_noise_floor";
    case surrogate::Verdict::above_in_places:
      return "above_in_places";
    case surrogate::Verdict::above_noise_floor:
      return "above_noise_floor";
    case surrogate::Verdict::no_scatter_known:
      break;
  }
  return "no_scatter_known";
}

py::object as_dict(const std::optional<surrogate::NoiseAlone>& noise) {
  if (!noise) return py::none();
  py::dict dict;
  dict["mean"] = noise->mean;
  dict["max"] = noise->max;
  dict["max_95"] = noise->high_max;
  return dict;
}

py::object as_dict(const std::optional<surrogate::NetworkError>& error) {
  if (!error) return py::none();
  py::dict dict;
  dict["rms"] = error->rms;
  dict["rms_high"] = error->rms_high;
  dict["bias"] = error->bias;
  dict["bias_chance"] = error->bias_chance;
  return dict;
}

/// By the names of `bitrock parity --json`.
py::dict as_dict(const ParitySummary& s) {
  py::dict dict;
  dict["cases"] = s.cases;
  dict["zero_cases"] = s.zero_cases;
  dict["mean_deviation"] = s.mean_deviation;
  dict["max_deviation"] = s.max_deviation;
  dict["noise_alone"] = as_dict(s.noise_alone);
  dict["mean_bias"] = s.mean_bias;
  dict["mean_of_range"] = s.mean_of_range;
  dict["max_of_range"] = s.max_of_range;
  dict["noise_alone_of_range"] = as_dict(s.noise_of_range);
  dict["rmse"] = s.rmse;
  dict["r2"] = s.r2;
  dict["dem_standard_error"] = s.dem_standard_error;
  dict["dem_standard_error_by_law"] = s.noise;
  dict["rmse_over_standard_error"] = s.rmse_over_noise;
  return dict;
}

template <class Get>
auto column(const OutputParity& output, const Get& get) {
  std::vector<decltype(get(output.points.front()))> values;
  for (const ParityPoint& point : output.points) values.push_back(get(point));
  return given(std::move(values));
}

py::object roles(const OutputParity& output) {
  py::list names;
  for (const ParityPoint& point : output.points) names.append(name_of(point.role));
  return py::module_::import("numpy").attr("array")(names);
}

Parity parity(const surrogate::Model& model, const py::object& source, bool unseen) {
  const surrogate::TrainingData data = training_data(source);
  warn(surrogate::warnings(data));
  const py::gil_scoped_release free;
  return surrogate::parity(model, data,
                           unseen ? surrogate::CaseNumbers::of_another_study : surrogate::CaseNumbers::as_in_training);
}

void bind_output(py::module_& module) {
  const auto summary = [](auto member) { return [member](const OutputParity& self) { return as_dict(self.*member); }; };
  py::class_<OutputParity>(module, "OutputParity",
                           "One output. Arrays have one entry a case, shape (cases,), in the unit of the output.")
      .def_readonly("name", &OutputParity::name, "such as x_amax_N_per_m")
      .def_readonly("unit", &OutputParity::unit, "N/m, or 1/m for counts")
      .def_property_readonly(
          "case",
          [](const OutputParity& self) { return column(self, [](const ParityPoint& p) { return p.case_number; }); },
          "numbers of the cases")
      .def_property_readonly("role", &roles, "what the case was in the training: train, validation, test or unseen")
      .def_property_readonly(
          "cuts", [](const OutputParity& self) { return column(self, [](const ParityPoint& p) { return p.cuts; }); },
          "averaged")
      .def_property_readonly(
          "dem_mean",
          [](const OutputParity& self) { return column(self, [](const ParityPoint& p) { return p.dem_mean; }); },
          "mean of the data over the cuts of the case")
      .def_property_readonly(
          "dem_standard_error",
          [](const OutputParity& self) { return column(self, [](const ParityPoint& p) { return p.noise; }); },
          "of that mean, by the law of scatter of all cases; 0 when not known")
      .def_property_readonly(
          "prediction",
          [](const OutputParity& self) { return column(self, [](const ParityPoint& p) { return p.prediction; }); },
          "of the networks")
      .def_property_readonly(
          "all", summary(&OutputParity::all),
          "deviations over all cases, by the names of `bitrock parity --json`; None for what cannot be\n"
          "said")
      .def_property_readonly("train", summary(&OutputParity::train), "the same over the cases learnt from")
      .def_property_readonly("validation", summary(&OutputParity::validation), "the same over those of validation")
      .def_property_readonly("held_out", summary(&OutputParity::held_out), "the same over the cases held out")
      .def_property_readonly(
          "verdict", [](const OutputParity& self) { return name_of(self.judged.verdict); },
          "at_noise_floor, above_noise_floor, above_in_places, too_noisy or no_scatter_known")
      .def_property_readonly(
          "network_error", [](const OutputParity& self) { return as_dict(self.error); },
          "of the networks alone over the cases held out, the scatter of the data taken out: rms, rms_high, bias,\n"
          "bias_chance [1]; None when not known")
      .def_property_readonly(
          "times_noise", [](const OutputParity& self) { return self.judged.ratio; },
          "error over the standard error of the data; None when not known")
      .def("__repr__", [](const OutputParity& self) {
        return fmt::format("<bitrock.OutputParity: {}, {} cases, {}>", self.name, self.points.size(),
                           name_of(self.judged.verdict));
      });
}

}  // namespace

void bind_parity(py::module_& module) {
  bind_output(module);
  py::class_<Parity>(module, "Parity", "Networks against data, output by output.")
      .def_property_readonly(
          "outputs",
          [](const Parity& self) {
            py::dict outputs;
            for (const OutputParity& output : self.outputs) outputs[output.name.c_str()] = output;
            return outputs;
          },
          "dict of OutputParity by name, x_amax_N_per_m first")
      .def_readonly("same_data", &Parity::same_data, "whether the data are those of the training, byte for byte")
      .def_readonly("has_held_out", &Parity::has_held_out, "whether verdicts rest on cases held out")
      .def_readonly("outside_training_range", &Parity::outside_training_range,
                    "cases held out where the networks extrapolate");
  module.def(
      "parity", &parity, py::arg("model"), py::arg("data"), py::kw_only(), py::arg("unseen") = false,
      "Compare a model with data, beside the scatter of the data (Parity).\n\n"
      "data: as of train. unseen: the data are of another study; whatever their case numbers, the model has seen\n"
      "none of them.");
}

}  // namespace bitrock::python
