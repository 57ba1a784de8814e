#include "dem2d/cut/settle.hpp"

#include <algorithm>

#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/specimen/press.hpp"
#include "dem2d/step/neighbours.hpp"

namespace bitrock::dem2d {

namespace {

/// Of a set of discs.
struct Places {
  std::vector<std::size_t> discs;

  double mean(const std::vector<double>& values) const {
    double sum = 0.0;
    for (const std::size_t i : discs) sum += values[i];
    return sum / static_cast<double>(discs.size());
  }
};

struct Rims {
  Places left, right, bottom, top;  ///< outermost discs, one column or layer each
};

Rims rims_of(const Discs& discs) {
  const double column = column_width(discs);
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  Rims rims;
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    if (discs.x[i] < *x_low + column) rims.left.discs.push_back(i);
    if (discs.x[i] > *x_high - column) rims.right.discs.push_back(i);
    if (discs.y[i] < *y_low + column) rims.bottom.discs.push_back(i);
    if (discs.y[i] > *y_high - column) rims.top.discs.push_back(i);
  }
  return rims;
}

void shift(World& world, double dx, double dy) {
  for (double& x : world.discs.x) x += dx;
  for (double& y : world.discs.y) y += dy;
}

}  // namespace

Settled settle_under_mud(World& world, const CutCase& cut, const base::ProgressCallback& progress) {
  Settled settled;
  const std::vector<double> x = world.discs.x, y = world.discs.y, held = world.discs.inverse_mass;
  const Rims rims = rims_of(world.discs);
  std::vector<Boundary> boundaries = std::move(world.boundaries);
  world.boundaries.clear();
  for (std::size_t i = 0; i < held.size(); ++i) release(world.discs, i);
  world.mud.seal_gap = cut.seal_gap_over_radius * cut.rock.radius_min;
  world.mud.debris_seals = cut.debris == debris_sealed;
  prepare(world);
  const Pressed pressed = press(world, cut.rock, cut.mud_pressure, "fluid.pressure_MPa", progress);
  settled.cracks = pressed.cracks;
  settled.steps = pressed.steps;

  const double left = rims.left.mean(world.discs.x) - rims.left.mean(x);
  const double bottom = rims.bottom.mean(world.discs.y) - rims.bottom.mean(y);
  shift(world, -left, -bottom);
  settled.shortening = rims.right.mean(x) - rims.right.mean(world.discs.x);
  settled.surface_drop = rims.top.mean(y) - rims.top.mean(world.discs.y);
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] == 0.0) hold(world.discs, i);
  }
  world.boundaries = std::move(boundaries);
  Boundary& cutter = world.boundaries.front();
  cutter.seals = cut.cutter_face == face_sealed;
  translate(cutter.shape, 0.0, -settled.surface_drop);
  forgive_overlaps(cutter, world.discs);
  prepare(world);
  return settled;
}

}  // namespace bitrock::dem2d
