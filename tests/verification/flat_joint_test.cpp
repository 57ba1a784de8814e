// The flat-joint law on one interface: exact cases, strength envelope, and the resultants against quadrature and
// against the slopes of the stored energy.
#include "dem2d/contact/flat_joint.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.hpp"
#include "dem2d/contact/flat_joint_energy.hpp"

using namespace bitrock;

namespace {

using dem2d::ElementState;

// The two-grain case of the public flat-joint test files that go with [Potyondy2015]: R = 6.25 mm, lambda = 0.8, so the
// half-length is 5 mm.
constexpr double half_length = 5e-3;           // [m]
constexpr double normal_stiffness = 2.32e12;   // [Pa/m]
constexpr double shear_stiffness = 1.0087e12;  // [Pa/m]

struct Joint {
  dem2d::FlatJointLaw law;
  std::vector<ElementState> state;
  std::vector<double> shear_stress;
  std::uint64_t broken = 0;

  explicit Joint(int elements, ElementState start = ElementState::bonded,
                 double strength = std::numeric_limits<double>::infinity())
      : law{.elements = elements,
            .half_length = half_length,
            .normal_stiffness = normal_stiffness,
            .shear_stiffness = shear_stiffness,
            .tensile_strength = strength,
            .cohesion = std::numeric_limits<double>::infinity(),
            .tan_friction_angle = 0.0,
            .friction = 0.5},
        state(static_cast<std::size_t>(elements), start),
        shear_stress(static_cast<std::size_t>(elements), 0.0) {}

  dem2d::InterfaceForce move(double gap, double rotation, double shear_increment = 0.0) {
    return update_flat_joint(law, {gap, rotation, shear_increment}, state.data(), shear_stress.data(), broken);
  }
};

constexpr int element_counts[] = {1, 2, 3, 4, 8, 50};

TEST(FlatJoint, U1BondedOpening) {
  const auto force = Joint(4).move(1e-3, 0.0);
  EXPECT_DOUBLE_EQ(force.normal, 2.32e7);  // kn 2R g
  EXPECT_NEAR(force.moment, 0.0, 1e-9 * 2.32e7 * half_length);
}

TEST(FlatJoint, U2AndU6BondedBendingForAnyNumberOfElements) {
  const double expected = normal_stiffness * std::pow(2.0 * half_length, 3) / 12.0 * 0.4;  // kn (2R)^3 / 12 theta
  EXPECT_NEAR(expected, 7.7333e4, 5.0);
  for (const int elements : element_counts) {
    const auto force = Joint(elements).move(0.0, 0.4);
    EXPECT_NEAR(force.moment, -expected, 1e-12 * expected) << elements;  // disc 1 feels minus this: it resists
    EXPECT_NEAR(force.normal, 0.0, 1e-12 * expected / half_length) << elements;
  }
}

TEST(FlatJoint, U3AndU6UnbondedBendingForAnyNumberOfElements) {
  const double expected_force = -normal_stiffness * 0.2 * half_length * half_length / 2.0;
  const double expected_moment = normal_stiffness * 0.2 * std::pow(half_length, 3) / 3.0;  // kn theta R^3 / 3
  EXPECT_DOUBLE_EQ(expected_force, -5.80e6);
  EXPECT_NEAR(expected_moment, 1.9333e4, 1.0);
  for (const int elements : element_counts) {
    const auto force = Joint(elements, ElementState::broken_in_tension).move(0.0, 0.2);
    EXPECT_NEAR(force.normal, expected_force, 1e-12 * std::fabs(expected_force)) << elements;
    EXPECT_NEAR(force.moment, -expected_moment, 1e-12 * expected_moment) << elements;
  }
}

TEST(FlatJoint, U4EveryElementBreaksInTensionInTheSameStep) {
  Joint joint(4, ElementState::bonded, 1e-9);
  const auto force = joint.move(1e-3, 0.0);
  EXPECT_EQ(force.normal, 0.0);
  EXPECT_EQ(force.shear, 0.0);
  EXPECT_EQ(joint.broken, 0b1111u);
  for (const ElementState state : joint.state) EXPECT_EQ(state, ElementState::broken_in_tension);
}

TEST(FlatJoint, U5BondedShear) {
  Joint joint(4);
  EXPECT_DOUBLE_EQ(joint.move(0.0, 0.0, 1e-6).shear, shear_stiffness * 2.0 * half_length * 1e-6);
  EXPECT_DOUBLE_EQ(joint.move(0.0, 0.0, 2e-6).shear, shear_stiffness * 2.0 * half_length * 3e-6);  // it adds up
}

TEST(FlatJoint, BreaksInTensionAtTheStrengthAndNotBelow) {
  const double strength = 10e6, gap = strength / normal_stiffness;
  Joint below(2, ElementState::bonded, strength), at(2, ElementState::bonded, strength);
  below.move(gap * (1.0 - 1e-12), 0.0);
  at.move(gap * (1.0 + 1e-12), 0.0);
  EXPECT_EQ(below.broken, 0u);
  EXPECT_EQ(at.broken, 0b11u);
}

TEST(FlatJoint, ShearStrengthIsCohesionPlusFrictionOfTheNormalStress) {
  // compressed to -20 MPa with tan(phi) = 0.5 and c = 30 MPa: breaks at 40 MPa; afterwards Coulomb with mu = 0.5
  Joint joint(1);
  joint.law.cohesion = 30e6;
  joint.law.tan_friction_angle = 0.5;
  const double gap = -20e6 / normal_stiffness;
  const auto almost = joint.move(gap, 0.0, 40e6 / shear_stiffness * (1.0 - 1e-9));
  EXPECT_EQ(joint.broken, 0u);
  EXPECT_NEAR(almost.shear, 40e6 * 2.0 * half_length, 1.0);
  const auto after = joint.move(gap, 0.0, 40e6 / shear_stiffness * 1e-8);
  EXPECT_EQ(joint.broken, 1u);
  EXPECT_EQ(joint.state[0], ElementState::broken_in_shear);
  EXPECT_EQ(after.shear, 0.0);  // the stress drops to zero at the break
  EXPECT_DOUBLE_EQ(after.normal, -20e6 * 2.0 * half_length);
  const auto sliding = joint.move(gap, 0.0, 1.0);
  EXPECT_NEAR(sliding.shear, 10e6 * 2.0 * half_length, 1.0);  // mu sigma
}

TEST(FlatJoint, PureCompressionBreaksNothing) {
  Joint joint(4, ElementState::bonded, 1.0);
  joint.law.cohesion = 1.0;
  joint.move(-1e-3, 0.0);
  EXPECT_EQ(joint.broken, 0u);
}

TEST(FlatJoint, ABentJointBreaksFromItsOpenEdgeInward) {
  Joint joint(4, ElementState::bonded, 10e6);
  const double rotation =
      1.1 * 10e6 / normal_stiffness / (0.75 * half_length);  // outer centroid just past the strength
  joint.move(0.0, rotation);
  EXPECT_EQ(joint.broken, 0b0001u);  // gap = -rotation r: the element at negative r opens
}

TEST(FlatJoint, AnOpenBrokenElementForgetsItsShear) {
  Joint joint(1, ElementState::broken_in_shear);
  joint.move(-1e-6, 0.0, 1e-7);
  EXPECT_NE(joint.shear_stress[0], 0.0);
  joint.move(1e-6, 0.0, 1e-7);
  EXPECT_EQ(joint.shear_stress[0], 0.0);
}

/// The stress is piecewise linear, so Gauss-Legendre with 3 points on each side of the zero is exact.
dem2d::NormalResultant by_quadrature(double length, double gap_a, double gap_b, bool bonded) {
  const double nodes[] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, weights[] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
  const double slope = (gap_b - gap_a) / length;
  const double zero = gap_a * gap_b < 0.0 ? -gap_a / slope : 0.5 * length;
  dem2d::NormalResultant total{0.0, 0.0};
  for (const auto& [from, to] : {std::pair{0.0, zero}, std::pair{zero, length}}) {
    for (int k = 0; k < 3; ++k) {
      const double s = 0.5 * (from + to) + 0.5 * (to - from) * nodes[k];
      const double gap = gap_a + slope * s;
      const double stress = normal_stiffness * (bonded ? gap : std::min(gap, 0.0));
      total.force += 0.5 * (to - from) * weights[k] * stress;
      total.moment += 0.5 * (to - from) * weights[k] * stress * (s - 0.5 * length);
    }
  }
  return total;
}

TEST(FlatJoint, ResultantsEqualQuadratureForRandomGaps) {
  base::Random random(2);
  const double length = 2.5e-3, scale = normal_stiffness * length * 1e-5;
  for (int trial = 0; trial < 2000; ++trial) {
    const double gap_a = base::uniform(random, -1e-5, 1e-5), gap_b = base::uniform(random, -1e-5, 1e-5);
    const auto closed = dem2d::unbonded_resultant(normal_stiffness, length, gap_a, gap_b);
    const auto expected = by_quadrature(length, gap_a, gap_b, false);
    ASSERT_NEAR(closed.force, expected.force, 1e-12 * scale);
    ASSERT_NEAR(closed.moment, expected.moment, 1e-12 * scale * length);
    const auto whole = dem2d::bonded_resultant(normal_stiffness, length, gap_a, gap_b);
    const auto expected_whole = by_quadrature(length, gap_a, gap_b, true);
    ASSERT_NEAR(whole.force, expected_whole.force, 1e-12 * scale);
    ASSERT_NEAR(whole.moment, expected_whole.moment, 1e-12 * scale * length);
  }
}

/// A joint of 1 to 8 elements, some bonded and some not, that nothing can break and that slides without friction.
Joint random_joint(base::Random& random) {
  Joint joint(1 + static_cast<int>(base::below(random, 8)));
  joint.law.friction = 0.0;
  for (ElementState& state : joint.state) state = static_cast<ElementState>(base::below(random, 4));
  return joint;
}

TEST(FlatJoint, ForceAndMomentOfPartlyBrokenJointsEqualQuadratureForRandomProfiles) {
  // sum of element integrals about the middle of the joint: N = int sigma dr, M = int r sigma dr
  base::Random random(3);
  const double scale = normal_stiffness * 2.0 * half_length * 1e-5;
  for (int trial = 0; trial < 2000; ++trial) {
    Joint joint = random_joint(random);
    const double gap = base::uniform(random, -1e-5, 1e-5), rotation = base::uniform(random, -1e-5, 1e-5) / half_length;
    const double length = 2.0 * half_length / joint.law.elements;
    double normal = 0.0, moment = 0.0;
    for (int e = 0; e < joint.law.elements; ++e) {
      const double middle = length * (e + 0.5 - 0.5 * joint.law.elements);
      const auto expected =
          by_quadrature(length, gap - rotation * (middle - 0.5 * length), gap - rotation * (middle + 0.5 * length),
                        joint.state[static_cast<std::size_t>(e)] == ElementState::bonded);
      normal += expected.force;
      moment += middle * expected.force + expected.moment;
    }
    const auto force = joint.move(gap, rotation);
    ASSERT_NEAR(force.normal, normal, 1e-12 * scale) << trial;
    ASSERT_NEAR(force.moment, moment, 1e-12 * scale * half_length) << trial;
  }
}

TEST(FlatJoint, ForceAndMomentAreTheSlopesOfTheStoredEnergy) {
  // N = dU/d(gap), M = -dU/d(rotation), since the work of the discs on the joint is N d(gap) - M d(rotation). Central
  // differences over 1e-6 of the gaps: their error is at most that share of the scale, where an element is about to
  // open.
  base::Random random(4);
  const double scale = normal_stiffness * 2.0 * half_length * 1e-5, h = 1e-11;
  for (int trial = 0; trial < 2000; ++trial) {
    Joint joint = random_joint(random);
    const double gap = base::uniform(random, -1e-5, 1e-5), rotation = base::uniform(random, -1e-5, 1e-5) / half_length;
    const auto energy = [&joint](double at_gap, double at_rotation) {
      const double length = 2.0 * half_length / joint.law.elements;
      double sum = 0.0;
      for (int e = 0; e < joint.law.elements; ++e) {
        const double start = -half_length + length * e;
        sum += stored_energy(joint.law, length,
                             {{at_gap - at_rotation * start, at_gap - at_rotation * (start + length)},
                              joint.state[static_cast<std::size_t>(e)],
                              0.0});
      }
      return sum;
    };
    const auto force = joint.move(gap, rotation);
    const double turn = h / half_length;
    ASSERT_NEAR((energy(gap + h, rotation) - energy(gap - h, rotation)) / (2.0 * h), force.normal, 1e-6 * scale);
    ASSERT_NEAR((energy(gap, rotation + turn) - energy(gap, rotation - turn)) / (2.0 * turn), -force.moment,
                1e-6 * scale * half_length);
  }
}

TEST(FlatJoint, ShearIsTheSlopeOfTheStoredEnergy) {
  Joint joint(4);
  joint.move(0.0, 0.0, 1e-6);
  const double length = 0.5 * half_length, h = 1e-9;
  const auto energy = [&](double slip) {
    return 4.0 * stored_energy(joint.law, length, {{0.0, 0.0}, ElementState::bonded, shear_stiffness * slip});
  };
  const double slope = (energy(1e-6 + h) - energy(1e-6 - h)) / (2.0 * h);
  EXPECT_NEAR(slope, joint.move(0.0, 0.0).shear, 1e-9 * slope);  // exact for a square, but for rounding
}

}  // namespace
