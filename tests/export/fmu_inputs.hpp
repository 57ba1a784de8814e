#pragma once
/// Inputs of a bit that tests of its FMU share.

#include <cmath>
#include <limits>

#include "tests/export/fmu_fixture.hpp"

namespace fmu_test {

inline constexpr double turning = 12.5, advancing = 4e-3, pushing = 1e5;  // [rad/s], [m/s], [N]
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Inputs that change all the time, with the bit off the rock and turning backwards now and then.
inline double rotation_at(double t) {
  return 10.0 + 12.0 * std::sin(3.0 * t);
}
inline double rop_at(double t) {
  return 3e-3 * (1.0 + 0.9 * std::sin(5.0 * t));
}
inline double weight_at(double t) {
  return 5e4 + 8e4 * std::sin(2.0 * t);
}

/// `steps` steps from `first` of this length with these inputs.
inline std::vector<importer::Outputs> run(importer::Instance& instance, int first, int steps, double length) {
  std::vector<importer::Outputs> history;
  for (int i = first; i < first + steps; ++i) {
    const double t = length * i;
    EXPECT_EQ(instance.set(rotation_at(t), rop_at(t), weight_at(t)), importer::ok) << instance.log;
    EXPECT_EQ(instance.step(t, length * (i + 1)), importer::ok) << instance.log;
    history.push_back(instance.get());
  }
  return history;
}

}  // namespace fmu_test
