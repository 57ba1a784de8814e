// bitrock.peaks: a force history reduced to the five numbers the networks learn.
#include "python/peaks.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/input.hpp"

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

/// What counts as a peak, lengths in samples.
struct Wish {
  double smoothing, min_prominence, min_distance;

  peaks::PeakDefinition definition() const {
    require_within("smoothing", smoothing, base::between(0.0, 1e6));
    require_within("min_prominence", min_prominence, base::between(0.0, 1.0));
    require_within("min_distance", min_distance, base::between(0.0, 1e9));
    return {.smoothing = smoothing, .min_prominence = min_prominence, .min_distance = min_distance};
  }
};

PeakStatistics statistics(const py::object& force, double smoothing, double min_prominence, double min_distance) {
  const auto samples = series_of(force, "force");
  const peaks::PeakDefinition definition = Wish{smoothing, min_prominence, min_distance}.definition();
  const py::gil_scoped_release free;
  return peaks::peak_statistics(span_of(samples), 1.0, definition);
}

py::array_t<std::int64_t> counted(const py::object& force, double smoothing, double min_prominence,
                                  double min_distance) {
  const auto samples = series_of(force, "force");
  const peaks::PeakDefinition definition = Wish{smoothing, min_prominence, min_distance}.definition();
  std::vector<std::int64_t> places;
  {
    const py::gil_scoped_release free;
    const peaks::PeakSearch search = peaks::prepared(span_of(samples), 1.0, definition);
    for (const std::size_t place : peaks::counted_peaks(search.signal, search.selection))
      places.push_back(static_cast<std::int64_t>(place));
  }
  return given(std::move(places));
}

py::dict moments(const py::object& force, double spacing) {
  const auto samples = series_of(force, "force");
  require_within("spacing", spacing, base::positive());
  peaks::Moments found;
  {
    const py::gil_scoped_release free;
    found = peaks::moments(span_of(samples), spacing);
  }
  py::dict dict;
  dict["mean"] = found.mean;
  dict["sd"] = found.sd;
  dict["correlation_length"] = found.correlation_length;
  dict["short_correlation_length"] = found.short_correlation_length;
  dict["low_share"] = found.low_share;
  return dict;
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
      "peaks_statistics", &statistics, py::arg("force"), py::arg("smoothing") = 0.0, py::arg("min_prominence") = 0.0,
      py::arg("min_distance") = 0.0,
      "Peak statistics of a force history (PeakStatistics).\n\n"
      "force: array of shape (n,), evenly spaced samples in any unit; a contiguous array of float64 is read in\n"
      "place. Peaks are local maxima higher than 1 % of the highest sample. A NaN is a missing sample: neither it\n"
      "nor its neighbours are peaks. Infinite samples are no peaks.\n"
      "smoothing: a moving mean over so many samples is taken twice before. min_prominence: least height above the\n"
      "higher of the two valleys, as a share of the highest sample. min_distance: of peaks at most so many samples\n"
      "apart only the highest counts. The converging definition is smoothing = 0.08 D / sampling distance and\n"
      "min_prominence = 0.02, D being the mean diameter of the grains.");
  module.def("peaks_counted", &counted, py::arg("force"), py::arg("smoothing") = 0.0, py::arg("min_prominence") = 0.0,
             py::arg("min_distance") = 0.0,
             "Places of the peaks that the statistics count: indices into force, in order, shape (count,).");
  module.def(
      "peaks_moments", &moments, py::arg("force"), py::arg("spacing"),
      "Mean, standard deviation, two correlation lengths and low-force share of a force history (dict).\n\n"
      "force: array of shape (n,), finite, evenly spaced. spacing: of the samples; correlation lengths have its\n"
      "unit. The lags at which the autocorrelation has fallen to 1/e and to 3/4; low_share: samples at most a\n"
      "tenth of the mean.");
}

}  // namespace bitrock::python
