#include "base/even_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"

namespace bitrock::base {

namespace {

constexpr std::array<int, most_dimensions> primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53};

double mirrored(std::int64_t index, int digits_base) {
  double value = 0.0, place = 1.0;
  for (; index > 0; index /= digits_base) {
    place /= digits_base;
    value += place * static_cast<double>(index % digits_base);
  }
  return value;
}

}  // namespace

EvenPoints::EvenPoints(int dimensions, std::uint64_t seed) {
  Random random(seed);
  for (int k = 0; k < dimensions; ++k) shifts_.push_back(seed == 0 ? 0.0 : uniform(random));
}

std::vector<double> EvenPoints::point(std::int64_t index) const {
  std::vector<double> coordinates;
  coordinates.reserve(shifts_.size());
  for (std::size_t k = 0; k < shifts_.size(); ++k) {
    const double along = shifts_[k] + mirrored(index, primes[k]);
    coordinates.push_back(along - std::floor(along));
  }
  return coordinates;
}

double with_ends(double evenly) {
  constexpr double share = 0.04;
  return std::clamp((evenly - share) / (1.0 - 2.0 * share), 0.0, 1.0);
}

}  // namespace bitrock::base
