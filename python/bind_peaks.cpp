// bitrock.peaks: a force history reduced to the five numbers the networks learn.
#include "python/peaks.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "python/arrays.hpp"
#include "python/bindings.hpp"

namespace py = pybind11;

namespace bitrock::python {

py::dict as_dict(const peaks::PeakStatistics& s) {
  py::dict dict;
  dict["amax"] = s.amax;
  dict["amean"] = s.amean;
  dict["np1"] = s.np1;
  dict["np23"] = s.np23;
  dict["np4"] = s.np4;
  return dict;
}

namespace {

using peaks::PeakStatistics;

PeakStatistics statistics(const py::object& force) {
  const auto samples = series_of(force, "force");
  const py::gil_scoped_release free;
  return peaks::peak_statistics(span_of(samples));
}

py::array_t<std::int64_t> counted(const py::object& force) {
  const auto samples = series_of(force, "force");
  std::vector<std::int64_t> places;
  {
    const py::gil_scoped_release free;
    for (const std::size_t place : peaks::counted_peaks(span_of(samples)))
      places.push_back(static_cast<std::int64_t>(place));
  }
  return given(std::move(places));
}

}  // namespace

void bind_peaks(py::module_& module) {
  py::class_<PeakStatistics>(module, "PeakStatistics", "Five numbers of a force history; heights in its unit.")
      .def_readonly("amax", &PeakStatistics::amax, "height of the highest peak [unit of the force]")
      .def_readonly("amean", &PeakStatistics::amean, "mean height of all peaks [unit of the force]")
      .def_readonly("np1", &PeakStatistics::np1, "peaks higher than 75 % of amax")
      .def_readonly("np23", &PeakStatistics::np23, "peaks from 25 % (without) to 75 % of amax")
      .def_readonly("np4", &PeakStatistics::np4, "peaks up to 25 % of amax")
      .def_property_readonly("count", &PeakStatistics::count, "peaks in all")
      .def("as_dict", &as_dict, "amax, amean, np1, np23, np4")
      .def("__repr__", [](const PeakStatistics& s) {
        return fmt::format("PeakStatistics(amax={}, amean={}, np1={}, np23={}, np4={})", s.amax, s.amean, s.np1, s.np23,
                           s.np4);
      });
  module.def(
      "peaks_statistics", &statistics, py::arg("force"),
      "Peak statistics of a force history (PeakStatistics).\n\n"
      "force: array of shape (n,), evenly spaced samples in any unit; a contiguous array of float64 is read in\n"
      "place. Peaks are local maxima higher than 1 % of the highest sample. A NaN is a missing sample: neither it\n"
      "nor its neighbours are peaks. Infinite samples are no peaks.");
  module.def("peaks_counted", &counted, py::arg("force"),
             "Places of the peaks that the statistics count: indices into force, in order, shape (count,).");
}

}  // namespace bitrock::python
