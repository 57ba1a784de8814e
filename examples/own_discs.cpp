// My own assembly of discs: a core of equal discs in a triangular lattice, made by a loop, joined and squeezed between
// platens. The stiffness of such a lattice is known in closed form, so the engine can be held against it.
//
//   cmake -S examples -B build/examples -DCMAKE_PREFIX_PATH=PREFIX -DEXAMPLES=own_discs && cmake --build build/examples
//   build/examples/own_discs
//
// Prints Young's modulus and Poisson's ratio of the endless lattice and of the core before its first crack, and how the
// core breaks.
#include <cmath>
#include <cstdio>
#include <exception>

#include "dem2d/lab/lab_test.hpp"

using namespace bitrock;

namespace {

/// Rows of touching discs, each row set off by a radius against the one below; box from (0, 0) to (width, height).
dem2d::Specimen lattice(const dem2d::Rock& rock, int columns, int rows) {
  const double radius = rock.radius_max;  // [m]
  dem2d::Specimen core;
  core.rock = rock;
  core.origin = "a lattice of my own";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      core.x.push_back(radius * (1.0 + 2.0 * column + row % 2));
      core.y.push_back(radius * (1.0 + std::sqrt(3.0) * row));
      core.radius.push_back(radius);
    }
  }
  core.width = radius * (2.0 * columns + 1.0);
  core.height = radius * (2.0 + std::sqrt(3.0) * (rows - 1));
  dem2d::join_neighbours(core);
  return core;
}

void squeeze() {
  dem2d::Rock rock;  // a material of my own; what is not said here stays at its default (dem2d/specimen/rock.hpp)
  rock.radius_min = rock.radius_max = 0.5e-3;  // [m]
  rock.joint_modulus = 2e9;                    // [Pa]
  rock.joint_stiffness_ratio = 2.5;            // normal over shear
  rock.tensile_strength = 10e6;                // [Pa]
  rock.cohesion = 40e6;                        // [Pa]
  rock.tensile_strength_deviation = 2e6;       // [Pa] or all joints break at once
  const dem2d::Specimen core = lattice(rock, 20, 46);

  dem2d::LabSettings settings;
  settings.width = core.width;
  settings.height = core.height;
  const dem2d::LabRun run = dem2d::run_lab_test(dem2d::LabTest::ucs, core, settings);

  // C11 = s (3 + 1/kappa), C12 = s (1 - 1/kappa) with s = sqrt(3)/4 E* of the joints
  const double s = std::sqrt(3.0) / 4.0 * rock.joint_modulus, soft = 1.0 / rock.joint_stiffness_ratio;
  const double c11 = s * (3.0 + soft), c12 = s * (1.0 - soft);
  std::printf("core             %d discs, %d joints\n", run.discs, run.joints);
  std::printf("Young's modulus  lattice %.3f GPa, core %.3f GPa\n", (c11 - c12 * c12 / c11) / 1e9,
              run.uncracked_modulus / 1e9);
  std::printf("Poisson's ratio  lattice %.3f, core %.3f\n", c12 / c11, run.uncracked_ratio);
  std::printf("strength         %.1f MPa, cracks: %d in tension, %d in shear\n", run.peak_stress / 1e6,
              run.cracks_tensile, run.cracks_shear);
}

}  // namespace

int main() {
  try {
    squeeze();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "own_discs: %s\n", error.what());
    return 1;
  }
}
