// How many times faster than real time a string in a well is: 1470 m of drill pipe and collars in the well of the
// article's section 4.2, turning at 60 rpm with friction, in 60 to 480 segments, off bottom and with the shipped
// networks at the bit. Each number stands beside a hash of the state at the end; the program fails when plain vectors
// give another. See docs/results/performance.md.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.hpp"
#include "base/thread_time.hpp"
#include "runtime/bit/bit.hpp"
#include "runtime/well/equilibrium.hpp"
#include "runtime/well/step.hpp"
#include "surrogate/net/model_file.hpp"

using namespace bitrock;
using namespace bitrock::runtime;

namespace {

constexpr int rounds = 7, steps_a_round = 4000;
constexpr double depth = 1470.0, collars = 200.0, degree = std::numbers::pi / 180.0;
constexpr double usual_step = 5e-4;                                // [s] with 120 segments
constexpr double rotation = 60.0 * 2.0 * std::numbers::pi / 60.0;  // [rad/s]

StringSection section(double outer, double inner, double length, int segments) {
  const Beam beam = beam_of({.outer_diameter = outer, .inner_diameter = inner});
  return {.beam = beam,
          .length = length,
          .segments = segments,
          .contact_radius = 0.5 * outer,
          .weight = gravity * beam.mass};
}

WellString string_of(int segments) {
  const int lower = std::max(1, segments / 6);
  return {.sections = {section(0.127, 0.10861, depth - collars, segments - lower),
                       section(0.1651, 0.0714375, collars, lower)},
          .hole = hole_pieces(well_path({{0, 0, 0}, {1205, 0, 0}, {1475, 90 * degree, 0}, {1700, 90 * degree, 0}}),
                              {{1700, 0.2159, 0.25}}),
          .upper_end = UpperEnd::table,
          .guided = true};
}

std::uint64_t hash_of(const WellStringState& state) {
  std::uint64_t hash = 0;
  for (const double value : state.columns.memory) hash = base::mix(hash ^ std::bit_cast<std::uint64_t>(value));
  return hash;
}

struct Row {
  double best = 0.0, median = 0.0;  // [s] a round
  std::uint64_t hash = 0;
};

Row measure(const WellString& string, const WellStringState& rest, const BitRockSource& source, double h, int count) {
  WellStringState state = rest;
  std::vector<double> times;
  for (int round = 0; round < count; ++round) {
    const double start = base::thread_time();
    for (int step = 0; step < steps_a_round; ++step) advance(string, state, {.drive_speed = rotation}, source, h);
    times.push_back(base::thread_time() - start);
  }
  std::sort(times.begin(), times.end());
  return {.best = times.front(), .median = times[times.size() / 2], .hash = hash_of(state)};
}

}  // namespace

int main() {
  const Bit bit = read_bit(BITROCK_SOURCE_DIR "/campaigns/bits/pdc15.toml");
  const surrogate::Model model = surrogate::read_model(BITROCK_SOURCE_DIR "/campaigns/paper240/model.json");
  bool same = true;
  fmt::print(
      "| segments | at the bit | step [ms] | best ns a segment and step | median | times real time, best | state |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const int segments : {60, 120, 240, 480}) {
    for (const bool networks : {false, true}) {
      WellString string = string_of(segments);
      const double h = usual_step * 120.0 / segments;
      WellStringState rest = hung_in_hole(string);
      relax(string, rest, h);
      if (networks) {
        string.on_rock = true;
        string.bit.advance_law = AdvanceLaw::imposed;
        string.bit.imposed_advance = 4e-3;
        rest.top.reference += 0.1;  // [m] slacks off on the rock
      }
      const auto run = [&](int count) {
        BitForce force(bit, model);
        return measure(string, rest, networks ? bit_excitation(force) : no_excitation(), h, count);
      };
      const Row row = run(rounds);
      const std::uint64_t first = run(1).hash;
      string.plain_vectors = true;
      same = same && run(1).hash == first;
      fmt::print("| {} | {} | {:g} | {:.0f} | {:.0f} | {:.1f} | {:016x} |\n", segments,
                 networks ? "networks" : "nothing", 1e3 * h, 1e9 * row.best / steps_a_round / segments,
                 1e9 * row.median / steps_a_round / segments, steps_a_round * h / row.best, row.hash);
    }
  }
  if (same) return 0;
  fmt::print("plain vectors gave another state\n");
  return 1;
}
