#pragma once
/// Strings in a well that the tests share, and a solver for their rest that is not the one of the program.

#include <Eigen/Dense>

#include <numbers>
#include <vector>

#include "runtime/well/energy.hpp"
#include "runtime/well/equilibrium.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/top_end.hpp"
#include "runtime/well/well_string.hpp"

namespace well_test {

using namespace bitrock;
using namespace bitrock::runtime;

inline constexpr double degree = std::numbers::pi / 180.0;
inline constexpr double rpm = 2.0 * std::numbers::pi / 60.0;  // [rad/s]

/// 5 in 19.5 lb/ft drill pipe, 127.0 x 108.61 mm.
inline PipeSection drill_pipe() {
  return {.outer_diameter = 0.127, .inner_diameter = 0.10861};
}
/// 6.5 x 2.8125 in drill collar, 165.1 x 71.4375 mm.
inline PipeSection drill_collar() {
  return {.outer_diameter = 0.1651, .inner_diameter = 0.0714375};
}

/// Of plain pipe, in air.
inline StringSection section(const PipeSection& pipe, double length, int segments) {
  const Beam beam = beam_of(pipe);
  return {.beam = beam,
          .length = length,
          .segments = segments,
          .contact_radius = 0.5 * pipe.outer_diameter,
          .weight = gravity * beam.mass};
}

/// A beam of our own without weight; all in units of its bending stiffness and length 1.
inline StringSection bare(double stiffness, int segments, double length = 1.0) {
  return {.beam = {.axial = stiffness,
                   .shear = stiffness,
                   .torsion = 1.0,
                   .bending = 1.0,
                   .mass = 1.0,
                   .polar_inertia = 0.01,
                   .transverse_inertia = 0.01},
          .length = length,
          .segments = segments};
}

inline WellString without_damping(WellString string) {
  string.damping = {0.0, 0.0, 0.0, 0.0};
  string.wall.damping = 0.0;
  return string;
}

inline const BitRockSource nothing = no_excitation();

/// Forces and torques on all segments at rest at their positions: a step too short to move anything.
inline Eigen::VectorXd loads_at_rest(const WellString& string, const WellStringState& state) {
  WellStringState still = state;
  forget_motion(still);
  constexpr double h = 1e-12;
  advance(string, still, {}, nothing, h);
  Eigen::VectorXd loads(6 * static_cast<Eigen::Index>(state.count));
  for (std::size_t i = 0; i < state.count; ++i) {
    const Vector3 f = (1.0 / (h * still.columns.at(inverse_mass, i))) * vector_at(still.columns, velocity, i);
    const Vector3 t = (1.0 / h) * vector_at(still.columns, momentum, i);
    loads.segment<6>(6 * static_cast<Eigen::Index>(i)) << f.x, f.y, f.z, t.x, t.y, t.z;
  }
  return loads;
}

inline void displace(WellStringState& state, const Eigen::VectorXd& by) {
  for (std::size_t i = 0; i < state.count; ++i) {
    const auto d = by.segment<6>(6 * static_cast<Eigen::Index>(i));
    Columns& columns = state.columns;
    set_vector(columns, position, i, vector_at(columns, position, i) + Vector3{d[0], d[1], d[2]});
    Rotation q;
    take(columns, frame, columns.place_of(i), q);
    put(columns, frame, columns.place_of(i), normalised(rotation_by_twice(0.5 * Vector3{d[3], d[4], d[5]}) * q));
    renew_derived(columns, columns.place_of(i));
  }
}

/// Newton's method on the loads, their slopes by differences. Returns the largest load that is left.
inline double come_to_rest(const WellString& string, WellStringState& state, int rounds = 60, double good = 1e-10) {
  Eigen::VectorXd loads = loads_at_rest(string, state);
  for (int round = 0; round < rounds && loads.cwiseAbs().maxCoeff() > good; ++round) {
    const Eigen::Index n = loads.size();
    Eigen::MatrixXd slopes(n, n);
    constexpr double step = 1e-7;
    for (Eigen::Index k = 0; k < n; ++k) {
      WellStringState moved = state;
      Eigen::VectorXd by = Eigen::VectorXd::Zero(n);
      by[k] = step;
      displace(moved, by);
      const Eigen::VectorXd forth = loads_at_rest(string, moved);
      moved = state;
      by[k] = -step;
      displace(moved, by);
      slopes.col(k) = (forth - loads_at_rest(string, moved)) / (2.0 * step);
    }
    Eigen::VectorXd by = -slopes.partialPivLu().solve(loads);
    const double largest = by.cwiseAbs().maxCoeff();
    if (largest > 0.2) by *= 0.2 / largest;
    displace(state, by);
    loads = loads_at_rest(string, state);
  }
  return loads.cwiseAbs().maxCoeff();
}

/// Straight hole without curvature from the table, or wherever, along a direction.
inline std::vector<HolePiece> straight_hole(double inclination, double length, double diameter, double friction) {
  return hole_pieces(well_path({{0.0, inclination, 0.0}, {length, inclination, 0.0}}), {{length, diameter, friction}});
}

/// The well of the article's section 4.2: kick-off at 1205 m, 10 degrees per 30 m to the horizontal, 8.5 in.
inline std::vector<HolePiece> quarter_hole(double friction, double azimuth = 0.0) {
  return hole_pieces(well_path({{0.0, 0.0, azimuth},
                                {1205.0, 0.0, azimuth},
                                {1475.0, 90.0 * degree, azimuth},
                                {1700.0, 90.0 * degree, azimuth}}),
                     {{1700.0, 0.2159, friction}});
}

}  // namespace well_test
