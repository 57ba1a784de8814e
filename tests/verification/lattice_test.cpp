// A bonded triangular lattice of equal discs under uniform strain: its moduli are known in closed form.
//
// Every disc has six joints of length a = 2R at 60 degrees with Kn = kn a = E*, Ks = E*/kappa. Under the strain e the
// joint along n opens by a n.e.n and slides by a t.e.n; the stress is the sum of force times branch over the cell's
// area 2 sqrt(3) R^2. With s = sqrt(3)/4 E*:
//
//     C11 = s (3 + 1/kappa)   C12 = s (1 - 1/kappa)   G = (C11 - C12)/2 = s (1 + 1/kappa)
//     nu = C12/C11            E = C11 - C12^2/C11     (no stress out of the plane)
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::modulus;
using small_worlds::radius;

struct Tensor {
  double xx, yy, xy;  // symmetric
};

class Lattice : public verification::JointPaths {
 protected:
  /// Seven rows of nine discs about the origin, turned by `angle`; the middle disc is number 31.
  dem2d::World lattice(const dem2d::JointProperties& properties, double angle = 0.0) const {
    dem2d::World world = on_path(small_worlds::empty());
    for (int row = -3; row <= 3; ++row) {
      for (int column = -4; column <= 4; ++column) {
        const double x = 2.0 * radius * column + (row % 2 == 0 ? 0.0 : radius), y = std::sqrt(3.0) * radius * row;
        dem2d::add_disc(world.discs, std::cos(angle) * x - std::sin(angle) * y,
                        std::sin(angle) * x + std::cos(angle) * y, radius, small_worlds::density);
      }
    }
    const dem2d::Pairs pairs = dem2d::pairs_within(world.discs, 1e-9);
    for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
      dem2d::add_joint(world, pairs.disc1[k], pairs.disc2[k], properties);
    }
    dem2d::prepare(world);
    return world;
  }

  /// One step of uniform strain without rotation.
  static void strain_by(dem2d::World& world, const Tensor& increment) {
    dem2d::Discs& d = world.discs;
    for (std::size_t i = 0; i < d.x.size(); ++i) {
      const double ux = increment.xx * d.x[i] + increment.xy * d.y[i];
      const double uy = increment.xy * d.x[i] + increment.yy * d.y[i];
      d.x[i] += ux;
      d.y[i] += uy;
      d.velocity_x[i] = ux / world.step;
      d.velocity_y[i] = uy / world.step;
      d.spin[i] = 0.0;
    }
    small_worlds::joint_forces(world);
  }

  /// Stress of the middle disc's cell [Pa]: each of its six joints belongs to it by half.
  static Tensor middle_stress(const dem2d::World& world) {
    Tensor stress{0.0, 0.0, 0.0};
    const std::size_t middle = 31;
    const dem2d::Discs& d = world.discs;
    for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {
      const auto a = static_cast<std::size_t>(world.joints.disc1[k]),
                 b = static_cast<std::size_t>(world.joints.disc2[k]);
      if (a != middle && b != middle) continue;
      stress.xx += world.room.joint_forces[k].x * (d.x[b] - d.x[a]);
      stress.yy += world.room.joint_forces[k].y * (d.y[b] - d.y[a]);
      stress.xy += world.room.joint_forces[k].x * (d.y[b] - d.y[a]);
    }
    const double twice_cell = 4.0 * std::sqrt(3.0) * radius * radius;
    return {stress.xx / twice_cell, stress.yy / twice_cell, stress.xy / twice_cell};
  }

  /// Stress per unit of a small strain, from the strain and its opposite: what is quadratic in the strain cancels.
  Tensor stiffness(double stiffness_ratio, const Tensor& direction, double angle = 0.0) const {
    dem2d::JointProperties properties = small_worlds::properties();
    properties.stiffness_ratio = stiffness_ratio;
    const double strain = 1e-6;
    Tensor sum{0.0, 0.0, 0.0};
    for (const double sign : {1.0, -1.0}) {
      dem2d::World world = lattice(properties, angle);
      world.step = 1e-3;
      const double e = sign * strain;
      strain_by(world, {e * direction.xx, e * direction.yy, e * direction.xy});
      const Tensor stress = middle_stress(world);
      sum.xx += 0.5 * sign / strain * stress.xx;
      sum.yy += 0.5 * sign / strain * stress.yy;
      sum.xy += 0.5 * sign / strain * stress.xy;
    }
    return sum;
  }
};

// Round-off of positions, 1e-18 m, in openings of 1e-9 m; what is cubic in the strain is smaller.
constexpr double tolerance = 1e-8;
constexpr double scale = 0.43301270189221932 * modulus;  // sqrt(3)/4 E*

struct Moduli {
  double kappa, youngs, poisson;  // kn/ks, E/E*, nu
};
constexpr std::array<Moduli, 5> table = {{{1.0, 1.732, 0.0},
                                          {1.5, 1.575, 1.0 / 11.0},
                                          {2.0, 1.485, 1.0 / 7.0},
                                          {2.5, 1.426, 3.0 / 17.0},
                                          {3.0, 1.386, 0.2}}};

TEST_P(Lattice, ModuliEqualTheClosedFormAlongBothAxes) {
  for (const Moduli& m : table) {
    const double c11 = scale * (3.0 + 1.0 / m.kappa), c12 = scale * (1.0 - 1.0 / m.kappa);
    const Tensor along_x = stiffness(m.kappa, {1.0, 0.0, 0.0}), along_y = stiffness(m.kappa, {0.0, 1.0, 0.0});
    EXPECT_NEAR(along_x.xx, c11, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_x.yy, c12, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_y.yy, c11, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_y.xx, c12, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_x.xy, 0.0, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_y.xy, 0.0, tolerance * c11) << m.kappa;
    EXPECT_NEAR(along_x.yy / along_x.xx, m.poisson, 1e-7) << m.kappa;
    EXPECT_NEAR((along_x.xx - along_x.yy * along_x.yy / along_x.xx) / modulus, m.youngs, 5e-4) << "table, 3 decimals";
  }
}

TEST_P(Lattice, UniaxialStressShowsYoungsModulusDirectly) {
  for (const Moduli& m : table) {
    const Tensor pulled = stiffness(m.kappa, {1.0, -m.poisson, 0.0}),
                 other = stiffness(m.kappa, {-m.poisson, 1.0, 0.0});
    const double youngs = scale * (3.0 + 1.0 / m.kappa) * (1.0 - m.poisson * m.poisson);
    EXPECT_NEAR(pulled.xx, youngs, tolerance * youngs) << m.kappa;
    EXPECT_NEAR(pulled.yy, 0.0, tolerance * youngs) << m.kappa;
    EXPECT_NEAR(other.yy, youngs, tolerance * youngs) << m.kappa;
    EXPECT_NEAR(other.xx, 0.0, tolerance * youngs) << m.kappa;
  }
}

TEST_P(Lattice, IsIsotropic) {
  // shear modulus G = (C11 - C12)/2, and the same constants when the lattice is turned by any angle
  for (const Moduli& m : table) {
    const double c11 = scale * (3.0 + 1.0 / m.kappa), c12 = scale * (1.0 - 1.0 / m.kappa);
    for (const double angle : {0.0, 0.3, 1.0}) {
      const Tensor sheared = stiffness(m.kappa, {0.0, 0.0, 1.0}, angle);
      EXPECT_NEAR(sheared.xy, c11 - c12, tolerance * c11) << m.kappa << " " << angle;  // 2 G e_xy
      EXPECT_NEAR(sheared.xx, 0.0, tolerance * c11) << m.kappa << " " << angle;
      EXPECT_NEAR(sheared.yy, 0.0, tolerance * c11) << m.kappa << " " << angle;
      const Tensor pulled = stiffness(m.kappa, {1.0, 0.0, 0.0}, angle);
      EXPECT_NEAR(pulled.xx, c11, tolerance * c11) << m.kappa << " " << angle;
      EXPECT_NEAR(pulled.yy, c12, tolerance * c11) << m.kappa << " " << angle;
      EXPECT_NEAR(pulled.xy, 0.0, tolerance * c11) << m.kappa << " " << angle;
    }
  }
}

/// A rock that can bear next to no tension and almost as little shear.
dem2d::JointProperties weak(double friction_angle) {
  dem2d::JointProperties properties = small_worlds::properties(1.0);
  properties.cohesion = 1e3;
  properties.friction_angle = friction_angle;
  return properties;
}

TEST_P(Lattice, IsotropicCompressionBreaksNothing) {
  dem2d::World world = lattice(weak(0.0));
  world.step = 1e-3;
  for (int step = 0; step < 100; ++step) strain_by(world, {-1e-4, -1e-4, 0.0});
  EXPECT_NEAR(middle_stress(world).xx, -4.0 * scale * 1e-2, 0.02 * 4.0 * scale * 1e-2) << "C11 + C12 = 4 s, 1 % strain";
  for (const int bonded : world.joints.bonded) EXPECT_EQ(bonded, world.joints.elements);
}

TEST_P(Lattice, CompressionAlongOneAxisBreaksOnlyInShearAndOnlyBelowTheFrictionAngle) {
  // Under e_yy = -e alone the joints at 60 degrees are pressed by (3/4) kn a e and sheared by (sqrt(3)/4) ks a e: they
  // break at e = c / (a (sqrt(3)/4 ks - 3/4 kn tan(phi))), and never when tan(phi) > 1/(sqrt(3) kappa). Joints along x
  // stay unloaded. To first order in the strain, which is small beside the 1 % between the two friction angles.
  const double kn = modulus / (2.0 * radius), ks = kn / 2.0, limit = 1.0 / (2.0 * std::sqrt(3.0));
  dem2d::World holds = lattice(weak(std::atan(1.01 * limit)));
  holds.step = 1e-3;
  for (int step = 0; step < 100; ++step) strain_by(holds, {0.0, -1e-5, 0.0});
  for (const int bonded : holds.joints.bonded) EXPECT_EQ(bonded, holds.joints.elements);

  for (const double share : {0.0, 0.9}) {
    dem2d::World breaks = lattice(weak(std::atan(share * limit)));
    breaks.step = 1e-3;
    const double failure = 1e3 / (2.0 * radius * std::sqrt(3.0) / 4.0 * ks * (1.0 - share));
    for (int step = 0; step < 100; ++step) strain_by(breaks, {0.0, -failure / 100.5, 0.0});
    for (const int bonded : breaks.joints.bonded) ASSERT_EQ(bonded, breaks.joints.elements) << share;
    strain_by(breaks, {0.0, -failure / 100.5, 0.0});
    for (std::size_t k = 0; k < breaks.joints.disc1.size(); ++k) {
      const bool along_x = breaks.joints.disc2[k] == breaks.joints.disc1[k] + 1 &&
                           breaks.discs.y[static_cast<std::size_t>(breaks.joints.disc1[k])] ==
                               breaks.discs.y[static_cast<std::size_t>(breaks.joints.disc2[k])];
      EXPECT_EQ(breaks.joints.bonded[k], along_x ? breaks.joints.elements : 0) << share << " joint " << k;
    }
    for (const dem2d::ElementState state : breaks.joints.state) {
      EXPECT_NE(state, dem2d::ElementState::broken_in_tension);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Lattice, testing::Bool(), verification::path_name);

}  // namespace
