// How a chain of segments moves: conservation, natural frequencies, rotating shafts.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/well/well_modes.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double pi = std::numbers::pi;

void run(const WellString& string, WellStringState& state, double duration, double h,
         const RigControls& controls = {}) {
  for (long step = std::lround(duration / h); step > 0; --step) advance(string, state, controls, nothing, h);
}

void set_spin(WellStringState& state, std::size_t i, double spin) {
  Columns& columns = state.columns;
  const double inertia = 1.0 / (columns.at(inverse_inertia, i) + columns.at(inverse_inertia_along, i));
  set_vector(columns, momentum, i, (inertia * spin) * vector_at(columns, direction, i));
  renew_derived(columns, columns.place_of(i));
}

Vector3 total_momentum(const WellStringState& state) {
  Vector3 sum;
  for (std::size_t i = 0; i < state.count; ++i)
    sum += (1.0 / state.columns.at(inverse_mass, i)) * vector_at(state.columns, velocity, i);
  return sum;
}

Vector3 total_angular_momentum(const WellStringState& state) {
  Vector3 sum;
  for (std::size_t i = 0; i < state.count; ++i)
    sum += vector_at(state.columns, momentum, i) +
           (1.0 / state.columns.at(inverse_mass, i)) *
               cross(vector_at(state.columns, position, i), vector_at(state.columns, velocity, i));
  return sum;
}

TEST(WellMotion, AFreeSegmentIsASymmetricTop) {
  // precession |L| / I_t about L, spin kept, energy kept; I_t 2227, J .932
  WellString string{.sections = {{.beam = {.axial = 1,
                                           .shear = 1,
                                           .torsion = 1,
                                           .bending = 1,
                                           .mass = 267.0,
                                           .polar_inertia = 0.932,
                                           .transverse_inertia = 2227.0 - 267.0 / 12.0},
                                  .length = 1.0,
                                  .segments = 1}}};
  WellStringState state = unloaded(string, {}, no_rotation);
  const Vector3 momentum_now{11.184, 668.1, 222.7};
  set_vector(state.columns, momentum, 0, momentum_now);
  renew_derived(state.columns, 0);
  const double rate_of_precession = length(momentum_now) / 2227.0;
  EXPECT_NEAR(rate_of_precession, .316268, 1e-6);
  EXPECT_NEAR(spin_of(state.columns, 0), 12.0, 1e-13);
  const double energy = stored_energy(string, state, 1e-3).total();
  const Vector3 axis = unit(momentum_now), before = across(vector_at(state.columns, direction, 0), axis);
  run(string, state, 20.0, 1e-3);
  // 20 000 steps, each right to rounding
  EXPECT_NEAR(spin_of(state.columns, 0), 12.0, 12e-12);
  EXPECT_NEAR(stored_energy(string, state, 1e-3).total(), energy, 1e-12 * energy);
  const Vector3 after = across(vector_at(state.columns, direction, 0), axis);
  const double turned = std::atan2(dot(cross(before, after), axis), dot(before, after));
  EXPECT_NEAR(std::remainder(turned - 20.0 * rate_of_precession, 2.0 * pi), 0.0, 1e-11);
}

/// Eight bars, bent by up to 0.65 rad at a joint, thrown and spinning, without dampers.
WellStringState thrown(const WellString& string) {
  WellStringState state = unloaded(string, {1.0, 2.0, 3.0}, normalised(Rotation{0.8, 0.1, -0.4, 0.2}));
  for (std::size_t i = 0; i < state.count; ++i) {
    const double k = static_cast<double>(i);
    set_vector(state.columns, velocity, i, {1.2 * std::sin(k), 1.0 * std::cos(2.0 * k), 0.4 - 0.1 * k});
    const double inertia = 1.0 / state.columns.at(inverse_inertia, i);
    set_vector(state.columns, momentum, i,
               inertia * Vector3{0.6 * std::cos(k), 0.8 * std::sin(1.3 * k), 1.0 * std::sin(0.7 * k)});
    renew_derived(state.columns, state.columns.place_of(i));
  }
  return state;
}

TEST(WellMotion, AFreeChainKeepsItsMomentum) {
  StringSection pipe = bare(400.0, 8, 8.0);
  pipe.beam.bending = 10.0;
  pipe.beam.torsion = 10.0;
  pipe.beam.polar_inertia = 0.05;
  const WellString string = without_damping({.sections = {pipe}});
  double error[2];
  for (const int part : {0, 1}) {
    const double h = part == 0 ? 2e-3 : 1e-3;
    WellStringState state = thrown(string);
    const Vector3 p = total_momentum(state), l = total_angular_momentum(state);
    double before = 0.0, worst = 0.0, bent = 0.0;
    for (int step = 0; step < 4000 * (part + 1); ++step) {
      advance(string, state, {}, nothing, h);
      const double energy = stored_energy(string, state, h).total();
      if (step == 0) before = energy;
      worst = std::max(worst, std::abs(energy / before - 1.0));
      for (std::size_t i = 0; i + 1 < state.count; ++i)
        bent = std::max(
            bent, angle_between(vector_at(state.columns, direction, i), vector_at(state.columns, direction, i + 1)));
    }
    EXPECT_GT(bent, 0.3);
    EXPECT_LT(length(total_momentum(state) - p), 1e-12 * length(p) + 1e-12);
    EXPECT_LT(length(total_angular_momentum(state) - l), 1e-12 * length(l) + 1e-12);
    error[part] = worst;
  }
  EXPECT_LT(error[0], 2e-2);
  EXPECT_NEAR(error[0] / error[1], 4.0, 0.6);  // second order
}

TEST(WellMotion, RunsBackToWhereItCameFrom) {
  const WellString string = without_damping({.sections = {bare(400.0, 8, 8.0)}});
  WellStringState state = thrown(string);
  const WellStringState first = state;
  const double h = 1e-3;
  run(string, state, 2.0, h);
  drift(state.columns, state.count, -h);  // from (x_n+1, v_n+1/2) to the mirror image (x_n, -v_n+1/2)
  slow_down(state, -1.0);
  run(string, state, 2.0 - h, h);
  drift(state.columns, state.count, h);
  EXPECT_EQ(first.count, state.count);
  double worst = 0.0;
  for (std::size_t i = 0; i < state.count; ++i)
    worst = std::max(worst, length(vector_at(state.columns, position, i) - vector_at(first.columns, position, i)));
  EXPECT_LT(worst, 2e-3);  // first order at the two ends only: the velocities there are half a step off
}

TEST(WellMotion, StrainsAndEnergyDoNotDependOnTheView) {
  // a bent and twisted chain, turned as a whole by any rotation and by a thousand turns
  const WellString string{.sections = {bare(400.0, 8, 8.0)}};
  WellStringState state = thrown(string);
  run(string, state, 0.5, 1e-3);
  forget_motion(state);
  std::vector<double> energies;
  for (std::size_t i = 0; i + 1 < state.count; ++i) energies.push_back(joint_now(state.columns, i).energy);
  Rotation turn = no_rotation;
  for (int k = 0; k < 1000; ++k) turn = normalised(rotation_by_twice(Vector3{0.4, -0.7, 0.3}) * turn);
  const Axes<double> axes = axes_of(turn);
  WellStringState turned = state;
  for (std::size_t i = 0; i < state.count; ++i) {
    set_vector(turned.columns, position, i, to_world(axes, vector_at(state.columns, position, i)));
    Rotation q;
    take(state.columns, frame, state.columns.place_of(i), q);
    put(turned.columns, frame, state.columns.place_of(i), turn * q);
    renew_derived(turned.columns, state.columns.place_of(i));
  }
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    const JointLoad<double> one = joint_now(state.columns, i), other = joint_now(turned.columns, i);
    EXPECT_NEAR(other.energy, energies[i], 1e-12 * (1.0 + energies[i]));
    EXPECT_LT(length(other.section_moment - one.section_moment), 1e-12);
    EXPECT_LT(length(other.section_force - one.section_force), 2e-11);
  }
}

/// Frequency [Hz] of a signal from the first and last of its zeros, risen through.
struct Zeros {
  double first = -1.0, last = -1.0, before = 0.0;
  int count = 0;
  void add(double time, double h, double value) {
    if (before < 0.0 && value >= 0.0 && time > h) {
      last = time - h * value / (value - before);
      if (first < 0.0) first = last;
      ++count;
    }
    before = value;
  }
  double frequency() const { return (count - 1) / (last - first); }
};

/// Lowest frequency of 1000 m drill pipe and 200 m collars that hang from a clamp, started in the first mode of a bar.
double hanging_frequency(bool torsion) {
  WellString string = without_damping({.sections = {section(drill_pipe(), 1000, 100), section(drill_collar(), 200, 20)},
                                       .upper_end = UpperEnd::clamped});
  for (StringSection& s : string.sections) s.weight = 0.0;
  WellStringState state = unloaded(string, {}, rotation_to({0, 0, 1}));
  // kicked by the static shape of a pull at the lower end: nearly the first mode
  for (std::size_t i = 0; i < state.count; ++i) {
    const double depth = vector_at(state.columns, position, i).z;
    const double shape = depth < 1000.0 ? depth / 1000.0 : 1.0 + 0.2 * (depth - 1000.0) / 1000.0;
    if (torsion)
      set_spin(state, i, 0.01 * shape);
    else
      set_vector(state.columns, velocity, i, {0.0, 0.0, 1e-3 * shape});
  }
  Zeros zeros;
  const double h = 5e-4, start = lower_end_of(state.columns, 0).z;
  while (state.time < 30.0) {
    advance(string, state, {}, nothing, h);
    zeros.add(state.time, h, torsion ? state.columns.at(turns, 0) : lower_end_of(state.columns, 0).z - start);
  }
  return zeros.frequency();
}

TEST(WellMotion, FrequenciesOfAStringThatHangs) {
  // transcendental equation of the two-piece bar, solved apart: .68306 and .40708 Hz
  EXPECT_NEAR(hanging_frequency(false), .68306, 2e-4);
  EXPECT_NEAR(hanging_frequency(true), .40708, 2e-4);
}

TEST(WellMotion, FrequenciesOfAChainAreThoseOfItsFormula) {
  // clamped and free, N masses in the middle of their bars: w_k = 2 sqrt(K/m) sin((2k - 1) pi / 4N). Started in the
  // mode of the chain, sin((2k - 1) pi (i + 1/2) / 2N), it has that frequency alone; leapfrog makes it asin(w h/2) 2/h
  const int n = 6;
  WellString string = without_damping({.sections = {bare(100.0, n, n)}, .upper_end = UpperEnd::clamped});
  const double h = 0.01;
  for (const int k : {1, 3, 6}) {
    for (const bool torsion : {false, true}) {
      WellStringState state = unloaded(string, {}, rotation_to({0, 0, 1}));
      const double stiffness = torsion ? 1.0 : 100.0, inertia = torsion ? 0.01 : 1.0;
      const double w = 2.0 * std::sqrt(stiffness / inertia) * std::sin((2 * k - 1) * pi / (4.0 * n));
      const auto shape = [&](std::size_t i) {
        return std::sin((2 * k - 1) * pi * (static_cast<double>(n - i) - 0.5) / (2.0 * n));
      };
      for (std::size_t i = 0; i < state.count; ++i) {
        if (torsion)
          set_spin(state, i, 1e-5 * shape(i));
        else
          set_vector(state.columns, velocity, i, {0.0, 0.0, 1e-5 * shape(i)});
      }
      const Vector3 start = vector_at(state.columns, position, 0);
      Zeros zeros;
      for (int step = 0; step < 20000; ++step) {
        advance(string, state, {}, nothing, h);
        zeros.add(state.time, h,
                  torsion ? state.columns.at(turns, 0) : vector_at(state.columns, position, 0).z - start.z);
      }
      EXPECT_NEAR(2.0 * pi * zeros.frequency(), 2.0 / h * std::asin(0.5 * w * h), 1e-5 * w) << k << torsion;
    }
  }
}

TEST(WellMotion, NaturalFrequenciesOfTheChain) {
  // of N equal bars: below a wall w_k = 2 sqrt(K/m) sin((2k - 1) pi / 4N), free 2 sqrt(K/m) sin((k - 1) pi / 2N)
  const int n = 7;
  for (const bool held : {true, false}) {
    const WellString string{.sections = {bare(100.0, n, n)}, .upper_end = held ? UpperEnd::clamped : UpperEnd::free};
    const DrillModes modes = modes_of(string, 0.0);
    ASSERT_EQ(modes.torsional.size(), 7u);
    EXPECT_TRUE(modes.axial.empty()) << "no rock";
    for (int k = 1; k <= n; ++k) {
      const double sine = std::sin((held ? 2 * k - 1 : 2 * k - 2) * pi / (4.0 * n)), axial = 2.0 * std::sqrt(100.0);
      EXPECT_NEAR(2.0 * pi * modes.axial_off_bottom[static_cast<std::size_t>(k - 1)], axial * sine, 1e-6) << k;
      EXPECT_NEAR(2.0 * pi * modes.torsional[static_cast<std::size_t>(k - 1)], axial * sine, 1e-6) << k;
    }
  }
}

TEST(WellMotion, NaturalFrequenciesOfAStringAtATable) {
  // pipe over 200 m of collars: of the two-piece bar, solved apart; bars of 10 m are lower by (w h / c)^2 / 24
  WellString string{.sections = {section(drill_pipe(), 1000.0, 100), section(drill_collar(), 200.0, 20)},
                    .upper_end = UpperEnd::table};
  const DrillModes begin = modes_of(string, 0.0), later = modes_of(string, 300.0);
  const double axial[] = {.68306, 2.71573, 5.09557}, torsional[] = {.40708, 1.69521, 3.20453};
  const double axial_later[] = {.57711, 2.13934, 3.96222}, torsional_later[] = {.34534, 1.33234, 2.48838};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(begin.axial_off_bottom[k], axial[k], 2e-5 * (k == 0 ? 1.0 : 0.5)) << k;
    EXPECT_NEAR(begin.torsional[k], torsional[k], 2e-5 * (k == 0 ? 1.0 : 0.5)) << k;
    EXPECT_NEAR(later.axial_off_bottom[k], axial_later[k], 2e-4 * axial_later[k]) << k;
    EXPECT_NEAR(later.torsional[k], torsional_later[k], 4e-4 * torsional_later[k]) << k;
  }
  EXPECT_EQ(later.torsional.size(), 150u);
  // one bar that has grown to 310 m passes less: it is one mass in its middle
  string.growth = Growth::grow;
  const DrillModes grown = modes_of(string, 300.0);
  EXPECT_EQ(grown.torsional.size(), 120u);
  EXPECT_NEAR(grown.torsional[0], .34534, 5e-3);
  EXPECT_LT(grown.torsional[2], later.torsional[2]);
}

/// A string between table and guide in a straight vertical hole, without weight: pinned at both ends.
WellString pinned(StringSection section) {
  section.weight = 0.0;
  section.contact_radius = 0.0;
  const double length = section.length;
  return {.sections = {section},
          .hole = straight_hole(0.0, 10.0 * length, 10.0 * length, 0.0),
          .upper_end = UpperEnd::table,
          .guided = true};
}

TEST(WellMotion, ABeamOnTwoPinsSwingsAsItsChainDoes) {
  // mode k, al = k pi / N: w / w_cont = (2 - 2 cos al) / al^2 sqrt(3 / (2 + cos al)), for stiff shear and thin bars
  const struct {
    int n, k;
    double ratio;
  } cases[] = {{4, 1, .999695}, {8, 1, .999983}, {4, 2, .99274}};
  for (const auto& c : cases) {
    StringSection pipe = section(drill_pipe(), 40.0, c.n);
    pipe.beam.shear *= 30.0;
    pipe.beam.transverse_inertia = 1e-6;
    const WellString string = without_damping(pinned(pipe));
    WellStringState state = unloaded(string, {}, rotation_to({0, 0, 1}));
    for (std::size_t i = 0; i < state.count; ++i) {
      // the joints on the half sine, the bars between them
      const double middle = (static_cast<double>(state.count - i) - 0.5) / c.n;
      const double upper = std::sin(c.k * pi * (middle - 0.5 / c.n)), lower = std::sin(c.k * pi * (middle + 0.5 / c.n));
      set_vector(state.columns, velocity, i, {1e-3 * 0.5 * (upper + lower), 0.0, 0.0});
      set_vector(state.columns, momentum, i,
                 {0.0, 1e-3 * (lower - upper) / (40.0 / c.n) / state.columns.at(inverse_inertia, i), 0.0});
      renew_derived(state.columns, state.columns.place_of(i));
    }
    const double h = 0.5 * longest_stable_step(string);
    Zeros zeros;
    while (state.time < 50.0 / (c.k * c.k)) {
      advance(string, state, {}, nothing, h);
      zeros.add(state.time, h, vector_at(state.columns, position, 0).x);
    }
    const double al = c.k * pi / c.n;
    const double ratio = (2.0 - 2.0 * std::cos(al)) / (al * al) * std::sqrt(3.0 / (2.0 + std::cos(al)));
    EXPECT_NEAR(ratio, c.ratio, 6e-6);
    const double wave = c.k * pi / 40.0, continuous = wave * wave * std::sqrt(pipe.beam.bending / pipe.beam.mass);
    // the pins give way: w^2 falls by 4 EI wave^2 / (k L), k = 5e7 N/m; the rest is shear and the step
    const double pins = 2.0 * pipe.beam.bending * wave * wave / (5e7 * 40.0);
    EXPECT_NEAR(2.0 * pi * zeros.frequency() / continuous, ratio * (1.0 - pins), 3e-5) << c.n << " " << c.k;
  }
}

TEST(WellMotion, ABowedShaftWhirlsByItsFormula) {
  // a collar of 20 m with a bow of its own, half a sine: total bow a0 / |1 - (W / w1)^2 + i c W / (m w1^2)|, w1 5.6011
  // rad/s; without drag 1.1625, 1.4590, 2.2690 a0
  const int n = 6;
  StringSection collar = section(drill_collar(), 20.0, n);
  WellString string = pinned(collar);
  string.damping.bending = 2e-3;
  string.sections[0].drag_across = 200.0;  // so that it comes to rest in the turning frame
  WellStringState state = unloaded(string, {}, rotation_to({0, 0, 1}));
  const double a0 = 0.01;
  // corners of the unloaded form at the joints: a0 sin(pi j / N)
  const double step = collar.length / n;
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    const double at = static_cast<double>(i + 1) / n;
    const double turn =
        a0 / step * (2.0 * std::sin(pi * at) - std::sin(pi * (at - 1.0 / n)) - std::sin(pi * (at + 1.0 / n)));
    set_vector(state.columns, bend, i, {0.0, turn, 0.0});
  }
  const double w1 = pi * pi / 400.0 * std::sqrt(collar.beam.bending / collar.beam.mass);
  EXPECT_NEAR(w1, 5.6011, 1e-3);
  const double h = 0.5 * longest_stable_step(string);
  for (const double speed : {20.0, 30.0, 40.0}) {
    run(string, state, 15.0, h, {.drive_speed = speed * rpm});
    const Vector3 middle = lower_end_of(state.columns, n / 2);
    const double bow = std::hypot(middle.x, middle.y), ratio = speed * rpm / w1;
    // the mud does not turn with it: a drag c stands across the bow
    const double drag = 200.0 * speed * rpm / (collar.beam.mass * w1 * w1);
    EXPECT_NEAR(bow / a0 * std::hypot(1.0 - ratio * ratio, drag), 1.0, 6e-3) << speed;
  }
}

}  // namespace
