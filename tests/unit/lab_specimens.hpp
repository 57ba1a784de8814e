#pragma once
/// Specimens for laboratory tests, made in one line: triangular lattices with known elastic constants, and small cores
/// of coarse grains.

#include <cmath>
#include <numbers>

#include "dem2d/lab/lab_test.hpp"
#include "dem2d/specimen/genesis.hpp"

using namespace bitrock;

namespace lab_specimens {

inline constexpr double lattice_modulus = 1e9;  // E* [Pa]

/// Equal discs, joints so weak that they break at strains of a thousandth: displacements stay small.
inline dem2d::Rock lattice_rock(double radius, double stiffness_ratio) {
  dem2d::Rock rock;
  rock.radius_min = rock.radius_max = radius;
  rock.joint_modulus = rock.contact_modulus = lattice_modulus;
  rock.joint_stiffness_ratio = stiffness_ratio;
  rock.tensile_strength = 1e6;
  rock.cohesion = 5e6;
  return rock;
}

/// E / E* and nu of the wholly bonded triangular lattice (uniform strain, lambda = 1): with C11 = sqrt(3)/4 E*(3 +
/// 1/kappa) and C12 = sqrt(3)/4 E* (1 - 1/kappa), nu = C12 / C11 and E = C11 - C12^2 / C11.
struct LatticeElasticity {
  double modulus, ratio;
};
inline LatticeElasticity lattice_elasticity(double stiffness_ratio) {
  const double c11 = std::numbers::sqrt3 / 4.0 * lattice_modulus * (3.0 + 1.0 / stiffness_ratio);
  const double c12 = std::numbers::sqrt3 / 4.0 * lattice_modulus * (1.0 - 1.0 / stiffness_ratio);
  return {c11 - c12 * c12 / c11, c12 / c11};
}

/// Rows along x, every other one shifted by half a disc; each touches its neighbours and is joined to them. Each row
/// has `columns` discs; the box is as wide as all of them.
inline dem2d::Specimen lattice(int columns, int rows, double radius, double stiffness_ratio) {
  dem2d::Specimen specimen{.rock = lattice_rock(radius, stiffness_ratio)};
  specimen.width = (2.0 * columns + 1.0) * radius;
  specimen.height = (2.0 + std::numbers::sqrt3 * (rows - 1)) * radius;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      specimen.x.push_back(radius * (1.0 + 2.0 * column + row % 2));
      specimen.y.push_back(radius * (1.0 + std::numbers::sqrt3 * row));
      specimen.radius.push_back(radius);
    }
  }
  specimen.rock.installation_gap = 0.01 * radius;
  dem2d::join_neighbours(specimen);
  return specimen;
}

/// The article's rock in grains of twice the size.
inline dem2d::Rock coarse_rock() {
  dem2d::Rock rock;
  rock.radius_min = 1e-3;
  rock.radius_max = 1.5e-3;
  rock.installation_gap = 0.1e-3;
  return rock;
}

/// Of a core as it is.
inline dem2d::LabSettings settings_for(const dem2d::Specimen& core) {
  return {.width = core.width, .height = core.height};
}

/// About 220 grains.
inline dem2d::Specimen coarse_core(std::uint64_t seed, double width = 24e-3, double height = 48e-3) {
  return dem2d::make_specimen(coarse_rock(), width, height, seed, 1);
}

}  // namespace lab_specimens
