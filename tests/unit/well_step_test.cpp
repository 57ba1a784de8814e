// What a caller of one step may rely on: it takes no memory.
#include <gtest/gtest.h>

#include <numbers>

#include "runtime/well/step.hpp"
#include "tests/allocations.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

TEST(WellStep, TakesNoMemory) {
  const Beam beam = beam_of({.outer_diameter = 0.127, .inner_diameter = 0.10861});
  WellString string{
      .sections =
          {{.beam = beam, .length = 200.0, .segments = 20, .contact_radius = 0.0635, .weight = gravity * beam.mass}},
      .hole = hole_pieces(well_path({{0, 0, 0}, {100, 0, 0}, {400, 1.2, 0}}), {{400, 0.2159, 0.25}}),
      .upper_end = UpperEnd::table,
      .longest_grown = 40.0,
      .guided = true,
      .gauge_radius = 0.1,
      .on_rock = true};
  string.bit.advance_law = AdvanceLaw::imposed;
  string.bit.friction.law = FrictionLaw::stribeck;
  string.bit.friction_radius = 0.08;
  WellStringState state = hung_in_hole(string);
  const BitRockSource source = sinusoidal_excitation({.mean = 8e3}, {.mean = 900.0}, 5.0);
  const std::size_t count = state.count;
  const long before = allocations::so_far();
  for (int k = 0; k < 60000; ++k) advance(string, state, {.feed_speed = 0.5, .drive_speed = 6.0}, source, 5e-4);
  EXPECT_EQ(allocations::so_far(), before);
  EXPECT_GT(state.count, count);  // segments were split off meanwhile
}

}  // namespace
