#include "dem2d/specimen/grading.hpp"

namespace bitrock::dem2d {

std::vector<Layer> layers(const Rock& rock, double height) {
  if (rock.fine_depth == 0.0 || rock.fine_depth >= height) return {{0.0, height, 1.0}};
  const double border = height - rock.fine_depth;
  return {{0.0, border, rock.coarse_ratio}, {border, height, 1.0}};
}

double largest_radius(const Rock& rock, double height) {
  return rock.radius_max * layers(rock, height).front().size;
}

}  // namespace bitrock::dem2d
