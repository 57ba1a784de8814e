#include "python/cracks.hpp"

namespace py = pybind11;

namespace bitrock::python {

namespace {

struct Row {
  double time_s, x_m, y_m, normal_angle_rad, length_m;
  int mode, disc_1, disc_2;
};

}  // namespace

py::array cracks_array(const std::vector<dem2d::Crack>& cracks) {
  [[maybe_unused]] static const bool known_to_numpy = [] {  // numpy refuses to be told twice
    PYBIND11_NUMPY_DTYPE(Row, time_s, x_m, y_m, normal_angle_rad, length_m, mode, disc_1, disc_2);
    return true;
  }();
  py::array_t<Row> rows(static_cast<py::ssize_t>(cracks.size()));
  Row* row = rows.mutable_data();
  for (const dem2d::Crack& c : cracks)
    *row++ = {c.time, c.x, c.y, c.normal_angle, c.length, static_cast<int>(c.mode), c.disc1, c.disc2};
  return rows;
}

}  // namespace bitrock::python
