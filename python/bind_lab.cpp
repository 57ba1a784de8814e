// Strength tests in the laboratory.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/parallel.hpp"
#include "base/units.hpp"
#include "base/value_lists.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/computing.hpp"
#include "python/cracks.hpp"
#include "python/input.hpp"
#include "studies/lab/envelope.hpp"
#include "studies/lab/series.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

using dem2d::LabRun, dem2d::LabSample, dem2d::LabTest, studies::LabResults, studies::LabSeries;

std::vector<std::uint64_t> seeds_of(const py::object& seeds) {
  std::vector<std::uint64_t> list;
  if (py::isinstance<py::str>(seeds)) {
    for (const int seed : base::seeds_in("seeds", seeds.cast<std::string>()))
      list.push_back(static_cast<std::uint64_t>(seed));
    return list;
  }
  const bool single = PyIndex_Check(seeds.ptr()) != 0 && !py::isinstance<py::array>(seeds);
  const py::object all = single ? py::object(py::make_tuple(seeds)) : seeds;
  for (const py::handle& seed : all) {
    if (PyIndex_Check(seed.ptr()) == 0)
      throw py::type_error(fmt::format("seeds: {} (must be whole numbers)", std::string(py::repr(seed))));
    require_within("seeds", seed.cast<double>(), base::between(0, 2147483647));
    list.push_back(seed.cast<std::uint64_t>());
  }
  if (list.empty()) throw base::InputError("seeds: none (must be at least one)");
  return list;
}

template <class Number>
py::array curve_column(const LabRun& run, Number LabSample::*member) {
  std::vector<Number> values;
  for (const LabSample& sample : run.curve) values.push_back(sample.*member);
  return given(std::move(values));
}

py::dict curve(const LabRun& run) {
  py::dict columns;
  columns["strain"] = curve_column(run, &LabSample::strain);
  columns["lateral_strain"] = curve_column(run, &LabSample::lateral_strain);
  columns["stress_Pa"] = curve_column(run, &LabSample::stress);
  columns["cracks_tensile"] = curve_column(run, &LabSample::cracks_tensile);
  columns["cracks_shear"] = curve_column(run, &LabSample::cracks_shear);
  return columns;
}

/// `of`: mean or standard deviation; not known where there are too few runs.
py::dict summary(const LabResults& results, double base::Summary::*of, int fewest) {
  py::dict dict;
  for (const studies::LabQuantity& quantity : studies::lab_quantities()) {
    const base::Summary summary = studies::summary_of(quantity, results.runs);
    dict[quantity.key] = static_cast<int>(summary.count) < fewest ? std::nan("") : summary.*of;
  }
  return dict;
}

py::object envelope(const LabResults& results) {
  const studies::EnvelopeOfSeeds lines = studies::envelope_of(results.runs);
  if (lines.empty()) return py::none();
  py::dict dict;
  for (const studies::EnvelopeQuantity& quantity : studies::envelope_quantities) {
    const base::Summary s = lines.of(quantity.value);
    dict[quantity.key] = s.mean / quantity.unit;
    dict[py::str(std::string("sd_") + quantity.key)] =
        s.count > 1 ? s.standard_deviation / quantity.unit : std::nan("");
  }
  return dict;
}

py::object rate_check(const LabResults& results) {
  if (results.half_rate.empty()) return py::none();
  const studies::RateCheck check = studies::rate_check_of(results);
  py::dict dict;
  dict["mean_at_half_rate_Pa"] = check.mean_at_half_rate;
  dict["change_fraction"] = check.change;
  dict["allowed_fraction"] = studies::allowed_rate_change;
  dict["slow_enough"] = check.slow_enough;
  return dict;
}

void take_list(const char* name, const std::optional<std::vector<double>>& given, const base::Range& allowed,
               double unit, std::vector<double>& values) {
  if (!given) return;
  if (given->empty()) throw base::InputError(fmt::format("{}: none (must be at least one)", name));
  values.clear();
  for (const double value : *given) {
    require_within(name, value, allowed);
    values.push_back(value * unit);
  }
}

LabResults lab(const std::string& test, const py::object& rock, const py::object& seeds, const py::object& specimen,
               std::optional<double> width_mm, std::optional<double> height_mm, double strain_rate_per_s,
               double local_damping, std::optional<double> platen_friction,
               const std::optional<std::vector<double>>& confining_pressures_MPa,
               const std::optional<std::vector<double>>& notch_lengths_mm, bool check_rate, std::optional<int> jobs,
               const py::object& progress) {
  LabSeries series{.test = dem2d::lab_test_named(test),
                   .rock = read_input(rock, "rock", dem2d::read_rock, dem2d::parse_rock),
                   .rate_check = check_rate};
  if (series.test == LabTest::brazilian && height_mm)
    throw base::InputError("height_mm: a Brazilian disc has its diameter only (width_mm)");
  if (dem2d::pulls(series.test) && platen_friction)
    throw base::InputError(fmt::format("platen_friction: there are no platens in a {} test", test));
  if ((series.test == LabTest::triaxial) != confining_pressures_MPa.has_value())
    throw base::InputError("confining_pressures_MPa: a list for a triaxial test, None for the others");
  if (series.test != LabTest::toughness && notch_lengths_mm)
    throw base::InputError("notch_lengths_mm: a list for a toughness test, None for the others");
  take_list("confining_pressures_MPa", confining_pressures_MPa, dem2d::confining_pressure_MPa, base::MPa,
            series.pressures);
  take_list("notch_lengths_mm", notch_lengths_mm, dem2d::specimen_length_mm, base::mm, series.notches);
  if (width_mm) require_within("width_mm", *width_mm, dem2d::specimen_length_mm);
  if (height_mm) require_within("height_mm", *height_mm, dem2d::specimen_length_mm);
  if (jobs) require_within("jobs", *jobs, base::between(1, 256));
  series.settings.width = width_mm ? *width_mm * 1e-3 : series.rock.specimen_width;
  series.settings.height = height_mm ? *height_mm * 1e-3 : series.rock.specimen_height;
  series.settings.strain_rate = strain_rate_per_s;
  series.settings.local_damping = local_damping;
  series.settings.platen_friction = platen_friction.value_or(series.settings.platen_friction);
  if (specimen.is_none()) {
    series.seeds = seeds_of(seeds.is_none() ? py::object(py::int_(1)) : seeds);
  } else {
    if (!seeds.is_none() || width_mm || height_mm)
      throw base::InputError("specimen: it has its own seed and size (leave out seeds, width_mm, height_mm)");
    studies::take_given(series, specimen.cast<dem2d::Specimen>());
    warn(dem2d::warnings(*series.given));
  }
  studies::complete(series, is_content(rock) ? "rock" : input_path(rock).string());
  warn(dem2d::warnings(series.test, series.rock, series.settings));
  LabResults results = computed(progress, {"tests", "specimens"}, [&](const base::ProgressCallback& listener) {
    return studies::run_series(series, jobs.value_or(base::available_cores()), listener, [](const LabRun&) {});
  });
  if (results.ended_by) std::rethrow_exception(results.ended_by);
  if (results.runs.empty()) throw base::SimulationError("no test gave a result: " + results.failures.front().second);
  for (const auto& [seed, reason] : results.failures) warn({reason});
  for (const LabRun& run : results.runs) warn(dem2d::warnings(run));
  return results;
}

void bind_run(py::module_& module) {
  py::class_<LabRun>(
      module, "LabRun",
      "One test of one core. Stress and strains are positive in compression (tension, toughness: in extension).\n"
      "What the test does not give is NaN.")
      .def_property_readonly(
          "test", [](const LabRun& self) { return dem2d::name_of(self.test); }, "its name")
      .def_readonly("seed", &LabRun::seed, "of the core")
      .def_readonly("confining_pressure_Pa", &LabRun::confining_pressure, "triaxial; stresses are above it [Pa]")
      .def_readonly("notch_length_m", &LabRun::notch_length, "toughness; of the saw cut [m]")
      .def_readonly("fracture_toughness_Pa_sqrt_m", &LabRun::fracture_toughness, "toughness; K_Ic [Pa sqrt(m)]")
      .def_readonly("discs", &LabRun::discs, "of the core")
      .def_readonly("joints", &LabRun::joints, "of the core")
      .def_readonly("peak_stress_Pa", &LabRun::peak_stress, "the strength [Pa]")
      .def_readonly("strain_at_peak", &LabRun::strain_at_peak, "[1]")
      .def_readonly("youngs_modulus_Pa", &LabRun::youngs_modulus, "secant from 0 to half the strength [Pa]")
      .def_readonly("poissons_ratio", &LabRun::poissons_ratio, "secant from 0 to half the strength [1]")
      .def_readonly("youngs_modulus_uncracked_Pa", &LabRun::uncracked_modulus, "before the first crack [Pa]")
      .def_readonly("poissons_ratio_uncracked", &LabRun::uncracked_ratio, "before the first crack [1]")
      .def_readonly("cracks_at_half_strength", &LabRun::cracks_at_half, "elements broken at half the strength")
      .def_readonly("crack_initiation_stress_Pa", &LabRun::crack_initiation_stress,
                    "when 1 % of the cracks at the peak exist [Pa]")
      .def_readonly("cracks_tensile", &LabRun::cracks_tensile, "elements broken in tension")
      .def_readonly("cracks_shear", &LabRun::cracks_shear, "elements broken in shear")
      .def_readonly("cracks_at_peak", &LabRun::cracks_at_peak, "elements broken at the peak")
      .def_readonly("fracture_height_fraction", &LabRun::fracture_height,
                    "tension, toughness: median height of the cracks over that of the core [1]")
      .def_readonly("imbalance_fraction", &LabRun::imbalance, "of the forces at the two ends [1]")
      .def_readonly("strain_rate_per_s", &LabRun::strain_rate, "[1/s]")
      .def_readonly("step_s", &LabRun::step, "[s]")
      .def_readonly("steps", &LabRun::steps, "of time")
      .def_readonly("wall_s", &LabRun::wall_time, "[s] on the clock")
      .def_property_readonly("curve", &curve,
                             "dict of arrays of shape (samples,): strain, lateral_strain, stress_Pa, cracks_tensile,\n"
                             "cracks_shear")
      .def_property_readonly(
          "cracks", [](const LabRun& self) { return cracks_array(self.cracks); },
          "structured array, as of Run, one row an element that broke")
      .def("__repr__", [](const LabRun& self) {
        return fmt::format("<bitrock.LabRun: {}, seed {}, strength {:.4g} MPa>", dem2d::name_of(self.test), self.seed,
                           self.peak_stress * 1e-6);
      });
}

}  // namespace

void bind_lab(py::module_& module) {
  bind_run(module);
  py::class_<LabResults>(module, "LabResults", "The tests of a series, in the order of the seeds.")
      .def_property_readonly(
          "runs", [](const LabResults& self) { return self.runs; }, "list of LabRun")
      .def_property_readonly(
          "failures", [](const LabResults& self) { return self.failures; }, "list of (seed, reason)")
      .def_property_readonly(
          "mean", [](const LabResults& self) { return summary(self, &base::Summary::mean, 1); },
          "means over the runs, by the names of LabRun; of triaxial tests over all pressures,\n"
          "of toughness tests over all notches")
      .def_property_readonly(
          "sd", [](const LabResults& self) { return summary(self, &base::Summary::standard_deviation, 2); },
          "standard deviations over the runs; NaN of a single one")
      .def_property_readonly(
          "envelope", &envelope,
          "dict: the Mohr-Coulomb line of triaxial tests, mean and sd over the seeds; None of others")
      .def_property_readonly("rate_check", &rate_check,
                             "dict: how halving the rate changes the mean strength; None unless asked for")
      .def("__repr__", [](const LabResults& self) {
        return fmt::format("<bitrock.LabResults: {} runs, {} failures>", self.runs.size(), self.failures.size());
      });
  const dem2d::LabSettings usual;
  module.def(
      "lab", &lab, py::arg("test"), py::arg("rock"), py::kw_only(), py::arg("seeds") = py::none(),
      py::arg("specimen") = py::none(), py::arg("width_mm") = py::none(), py::arg("height_mm") = py::none(),
      py::arg("strain_rate_per_s") = usual.strain_rate, py::arg("local_damping") = usual.local_damping,
      py::arg("platen_friction") = py::none(), py::arg("confining_pressures_MPa") = py::none(),
      py::arg("notch_lengths_mm") = py::none(), py::arg("rate_check") = false, py::arg("jobs") = py::none(),
      py::arg("progress") = py::none(),
      "Strength tests on synthetic cores, one a seed (LabResults).\n\n"
      "test: 'ucs' (uniaxial compression), 'tension', 'brazilian', 'triaxial' (compression under each of\n"
      "confining_pressures_MPa, a list) or 'toughness' (tension with a cut of each of notch_lengths_mm, a list;\n"
      "None for 0.4 of the width). rock: a rock file (str or path), or a dict\n"
      "with its tables. seeds: a number, a list, or text as '1,2,5:10'; None for 1.\n"
      "specimen: a Specimen whose discs are tested, with the joints of the rock. width_mm, height_mm: in place of\n"
      "[specimen] of the rock. strain_rate_per_s: 0 for that chosen for the rock. rate_check: also test at half\n"
      "the rate. jobs: cores tested side by side; None for all cores of the machine. progress: True for a line on\n"
      "sys.stderr, or a function of (done, total), in cores.\n"
      "A test that fails is a warning and stands in failures; when none gives a result, SimulationError.");
}

}  // namespace bitrock::python
