// A cantilever of bonded discs: a row of n + 1 equal discs, the first clamped, the last pushed sideways.
//
// With a = 2R, Kb = kn a^3/12 (bending) and Ks = ks a (shear) of each of the n joints, the joint between discs j and
// j + 1 carries the shear F and the moment F a (n - j - 1/2). Its rotation is that moment over Kb, its slip F/Ks, and
// disc j + 1 is higher than disc j by a (theta_j + theta_{j+1})/2 + F/Ks. Summing,
//
//     theta_k = F a/Kb (k n - k^2/2)       deflection of the last disc = F a^2/Kb (n^3/3 - n/12) + n F/Ks
//
// The beam of [Timoshenko1921] with EI = a Kb, kGA = a Ks and length L = n a bends by F L^3/(3 EI) + F L/(kGA): the row
// of discs is stiffer in bending by the share 1/(4 n^2), so it comes near the beam with the square of n.
#include <gtest/gtest.h>

#include <cmath>

#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "tests/unit/small_worlds.hpp"
#include "tests/verification/joint_paths.hpp"

using namespace bitrock;

namespace {

using small_worlds::radius;

constexpr double length = 2.0 * radius;                                         // a [m]
constexpr double normal_stiffness = small_worlds::modulus / length;             // kn [Pa/m]
constexpr double bending = normal_stiffness * length * length * length / 12.0;  // Kb [N]
constexpr double shear = normal_stiffness / 2.0 * length;                       // Ks [Pa]
constexpr double deflection = 1e-7;  // of the last disc [m]: small enough for a linear beam, (1e-7/1e-2)^2 = 1e-10

class Cantilever : public verification::JointPaths {
 protected:
  struct AtRest {
    double force;  // that holds the last disc at `deflection` [N/m]
    dem2d::World world;
  };

  /// Moves the last disc up to `deflection` in 100 steps, then lets local damping bring the row to rest.
  AtRest bent(int joints) const {
    dem2d::World world = on_path(small_worlds::chain(joints + 1));
    world.materials.local_damping = 0.7;
    dem2d::prepare(world);
    world.step = dem2d::critical_step(world);
    dem2d::Discs& d = world.discs;
    const auto last = static_cast<std::size_t>(joints);
    double unbalanced = 1.0, force = 0.0;
    for (int step = 1; step <= 100 || unbalanced > 1e-11 * std::fabs(force); ++step) {
      const double previous = d.y[last];
      d.y[last] = deflection * std::fmin(1.0, 0.01 * step);
      d.velocity_y[last] = (d.y[last] - previous) / world.step;
      const double held = d.y[last];
      dem2d::advance(world);
      d.x[0] = d.y[0] = d.angle[0] = d.velocity_x[0] = d.velocity_y[0] = d.spin[0] = 0.0;
      d.y[last] = held;
      force = -d.force_y[last];
      unbalanced = std::fabs(d.moment[last]) / radius;
      for (std::size_t i = 1; i < last; ++i) {
        unbalanced = std::fmax(unbalanced, std::fmax(std::fabs(d.force_y[i]), std::fabs(d.moment[i]) / radius));
      }
      if (step > 200000) break;  // the deflection then disagrees
    }
    return {force, world};
  }
};

TEST_P(Cantilever, BendsAsTheChainOfJoints) {
  for (const int n : {1, 4, 15}) {
    const AtRest rest = bent(n);
    const double flexibility = length * length / bending * (n * n * n / 3.0 - n / 12.0) + n / shear;
    EXPECT_NEAR(rest.force * flexibility, deflection, 1e-9 * deflection) << n;  // at rest to 1e-11 of the force
    for (int k = 0; k <= n; ++k) {
      const double slope = rest.force * length / bending * (k * n - 0.5 * k * k);
      EXPECT_NEAR(rest.world.discs.angle[static_cast<std::size_t>(k)], slope, 1e-8 * deflection / length)
          << n << " " << k;
    }
  }
}

TEST_P(Cantilever, ConvergesToTimoshenkoWithTheSquareOfTheNumberOfDiscs) {
  double previous = 0.0;
  for (const int n : {4, 8, 16}) {
    const double beam_length = n * length;
    const double bends = beam_length * beam_length * beam_length / (3.0 * length * bending);
    const double slides = beam_length / (length * shear);
    const double error = 1.0 - (deflection / bent(n).force - slides) / bends;
    EXPECT_NEAR(error, 1.0 / (4.0 * n * n), 1e-8) << n;
    if (previous != 0.0) {
      EXPECT_NEAR(previous / error, 4.0, 1e-4) << n;
    }
    previous = error;
  }
}

INSTANTIATE_TEST_SUITE_P(Paths, Cantilever, testing::Bool(), verification::path_name);

}  // namespace
