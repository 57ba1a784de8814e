#include "python/tallies.hpp"

namespace py = pybind11;

namespace bitrock::python {

py::dict as_dict(const runtime::ClampTally& clamps) {
  py::dict dict;
  dict["asked"] = clamps.asked;
  dict["speed_below"] = clamps.speed_below;
  dict["speed_above"] = clamps.speed_above;
  dict["depth_below"] = clamps.depth_below;
  dict["depth_above"] = clamps.depth_above;
  dict["rake_below"] = clamps.rake_below;
  dict["rake_above"] = clamps.rake_above;
  return dict;
}

py::dict as_dict(const runtime::DrawTally& draws) {
  py::dict dict;
  dict["drawn"] = draws.drawn;
  dict["mean_missed"] = draws.mean_missed;
  dict["band_left"] = draws.band_left;
  dict["narrowed"] = draws.narrowed;
  dict["capped"] = draws.capped;
  dict["length_clamped"] = draws.length_clamped;
  dict["correlation_clamped"] = draws.correlation_clamped;
  return dict;
}

}  // namespace bitrock::python
