#include "dem2d/tool/cutter.hpp"

#include <cmath>

namespace bitrock::dem2d {

ConvexPolygon cutter_outline(const CutterShape& shape, double tip_x, double tip_y) {
  const double up_x = shape.diameter * std::sin(shape.back_rake), up_y = shape.diameter * std::cos(shape.back_rake);
  const double back_x = -shape.thickness * std::cos(shape.back_rake),
               back_y = shape.thickness * std::sin(shape.back_rake);
  return {{tip_x, tip_x + up_x, tip_x + up_x + back_x, tip_x + back_x},
          {tip_y, tip_y + up_y, tip_y + up_y + back_y, tip_y + back_y}};
}

}  // namespace bitrock::dem2d
