// What comes back of a torsional wave from a top drive, in both strings: the share of its energy against the reflection
// coefficient of the drive's impedance and that of the chain of bars.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>

#include "runtime/drillstring/drill_case.hpp"
#include "tests/verification/well_fixtures.hpp"

using namespace well_test;

namespace {

constexpr double pi = std::numbers::pi, bar = 10.0;

/// A packet of waves that goes up a chain of bars: exp(-(s (q - q0))^2 / 2) over the wave number q [rad/m].
struct Packet {
  double wave_number, width, middle;  // q0 [rad/m], s [m], [m] below the table

  double fast = 2.0 * std::sqrt(79.3e9 / 7850.0) / bar;  // 2 sqrt(K / J) of a joint and a segment
  /// Frequency of a wave on the chain [rad/s].
  double frequency(double q) const { return fast * std::sin(0.5 * q * bar); }
  /// Sum over its waves of a share of each, by amplitude.
  double over_waves(const std::function<double(double q, double amplitude)>& part) const {
    double sum = 0.0;
    for (int k = -200; k <= 200; ++k) {
      const double away = 0.02 * k / width, q = wave_number + away;
      if (q > 0.0) sum += part(q, std::exp(-0.5 * away * away * width * width));
    }
    return sum;
  }
  double angle(double depth) const {
    return over_waves([&](double q, double a) { return 1e-5 * a * std::cos(q * (depth - middle)); });
  }
  double speed(double depth) const {
    return over_waves([&](double q, double a) { return -1e-5 * a * frequency(q) * std::sin(q * (depth - middle)); });
  }
  /// Share of the energy that comes back, with the impedance zeta / sqrt(1 - (w / w_c)^2) of half a spring and the
  /// chain behind it, w_c the highest frequency that the chain passes.
  double returned(const DriveControl& drive, double zeta) const {
    double back = 0.0;
    const double all = over_waves([&](double q, double a) {
      const double w = frequency(q), chain = zeta / std::sqrt(1.0 - w * w / (fast * fast));
      const double energy = a * a * w * w;
      back += energy * (drive.inertia > 0.0 ? std::norm(reflection_of(drive, chain, w)) : 1.0);
      return energy;
    });
    return back / all;
  }
  /// Time in which it goes up and comes back to where it was [s].
  double there_and_back() const { return 2.0 * middle / (fast * 0.5 * bar * std::cos(0.5 * wave_number * bar)); }
};

/// Measured on the string in two dimensions.
double returned_in_plane(const Packet& packet, const DrillCase& drill, int bars, double h) {
  DrillString string = assemble(drill);
  string.axial = {};
  string.weights.clear();
  DrillState state = beginning(string, nothing, false, 0.0);
  const std::size_t drive = is_lump(string.drive) ? 1 : 0;
  for (int i = 0; i < bars; ++i) {
    state.torsional.position[drive + i] = packet.angle((i + 0.5) * bar);
    state.torsional.velocity[drive + i] = packet.speed((i + 0.5) * bar);
  }
  set_chain_forces(string.torsional, state.torsional.position, state.torsional.velocity, {},
                   state.torsional.acceleration);
  for (std::size_t i = 0; i < string.torsional.size(); ++i)
    state.torsional.acceleration[i] /= string.torsional.inertia[i];
  const auto energy = [&] {
    double sum = 0.0;
    const auto& [angle, speed, unused] = state.torsional;
    for (std::size_t i = drive; i < angle.size(); ++i) {
      const double twist = angle[i] - (i > 0 ? angle[i - 1] : 0.0);
      sum += string.torsional.inertia[i] * speed[i] * speed[i] + string.torsional.stiffness[i] * twist * twist;
    }
    return sum;
  };
  const double before = energy();
  while (state.time < packet.there_and_back()) advance(string, state, nothing, h);
  return energy() / before;
}

/// Measured on the string in a well.
double returned_in_well(const Packet& packet, const DriveControl& control, int bars, double h) {
  StringSection pipe = section(drill_pipe(), bars * bar, bars);
  pipe.weight = 0.0;
  WellString string = without_damping({.sections = {pipe}, .upper_end = UpperEnd::table});
  string.control = control;
  WellStringState state = unloaded(string, {}, rotation_to({0.0, 0.0, 1.0}));
  Columns& columns = state.columns;
  for (std::size_t i = 0; i < state.count; ++i) {
    const double depth = vector_at(columns, position, i).z, angle = packet.angle(depth);
    Rotation q;
    take(columns, frame, columns.place_of(i), q);
    const Rotation turned = normalised(rotation_by_twice(Vector3{0.0, 0.0, 0.5 * angle}) * q);
    put(columns, frame, columns.place_of(i), turned);
    columns.at(turns, i) = angle;
    const double inertia = pipe.beam.polar_inertia * bar;
    set_vector(columns, momentum, i, {0.0, 0.0, inertia * packet.speed(depth)});
    renew_derived(columns, columns.place_of(i));
  }
  const auto energy = [&] {
    double sum = table_energy(string, state);
    for (std::size_t i = 0; i < state.count; ++i) {
      const double spin = spin_of(columns, i);
      sum += 0.5 * pipe.beam.polar_inertia * bar * spin * spin;
      if (i + 1 < state.count) sum += joint_now(columns, i).energy;
    }
    return sum;
  };
  const double before = energy();
  while (state.time < packet.there_and_back()) advance(string, state, {}, nothing, h);
  return energy() / before;
}

DrillCase hanging(int bars, const DriveControlCase& control, double inertia) {
  DrillCase drill;
  PipeSection pipe = drill_pipe();
  pipe.length = bars * bar;
  drill.pipes = {pipe};
  drill.torsional_lumps = bars;
  drill.control = control;
  drill.drive_inertia = inertia;
  return drill;
}

TEST(DriveControl, AWaveComesBackAsTheImpedanceOfTheDriveSays) {
  const double zeta = torsional_impedance(drill_pipe());
  EXPECT_NEAR(zeta, 296.4, 0.1);
  const int bars = 500;
  const Packet packet{.wave_number = 2.0 * pi / 600.0, .width = 400.0, .middle = 2400.0};  // 5.3 Hz
  const double period = 600.0 / std::sqrt(79.3e9 / 7850.0);
  const struct {
    const char* name;
    DriveControlCase control;
    double inertia, least, most;  // share of the energy, so that each row tells something
  } rows[] = {{"stiff", {}, 0.0, 1.0, 1.0},
              {"matched", {.answer = DriveAnswer::matched, .period = 2.0}, 0.0, 0.0, 0.01},
              {"matched, slow", {.answer = DriveAnswer::matched, .period = 2.0, .reaction_time = 0.04}, 0.0, 0.2, 0.4},
              {"soft, tuned to the wave",
               {.answer = DriveAnswer::soft_torque, .damping = 3.0 * zeta, .period = period},
               29.0,
               0.25,
               0.5},
              {"soft, as it comes", {.answer = DriveAnswer::soft_torque, .period = 2.0}, 2900.0, 0.95, 1.0}};
  for (const auto& row : rows) {
    const DrillCase drill = hanging(bars, row.control, row.inertia);
    const DriveControl control = control_of(drill, 2.0);
    const double expected = packet.returned(control, zeta);
    EXPECT_TRUE(row.least <= expected && expected <= row.most) << row.name << " " << expected;
    EXPECT_NEAR(returned_in_plane(packet, drill, bars, 5e-4), expected, 2e-3) << row.name;
    EXPECT_NEAR(returned_in_well(packet, control, bars, 5e-4), expected, 4e-3) << row.name;
  }
}

TEST(DriveControl, TheChainOfBarsHasAnImpedanceThatGrowsWithTheFrequency) {
  // at 0.4 of the highest frequency that bars of 10 m pass, 101 Hz, it is zeta / sqrt(1 - 0.4^2): a damper of 0.8 zeta
  // sends back 0.0244 of the energy, not 0.0123
  const double zeta = torsional_impedance(drill_pipe());
  const int bars = 160;
  const double q = 2.0 / bar * std::asin(0.4);
  const Packet packet{.wave_number = q, .width = 120.0, .middle = 780.0};
  const DriveControlCase damper{
      .answer = DriveAnswer::matched, .damping = 0.8 * zeta, .period = 1e3, .reaction_time = 1e-5};
  const DrillCase drill = hanging(bars, damper, 0.0);
  const DriveControl control = control_of(drill, 1e3);
  const double expected = packet.returned(control, zeta);
  EXPECT_NEAR(expected, 0.0244, 5e-4);
  EXPECT_NEAR(returned_in_plane(packet, drill, bars, 4e-6), expected, 5e-4);
  EXPECT_NEAR(returned_in_well(packet, control, bars, 4e-5), expected, 1e-3);
}

TEST(DriveControl, SoftTorqueDampsTheFirstModeAsItsRuleSays) {
  // 1500 m of pipe under a drive of 2900 kg m^2: both modes near the first decay at C / 4J = 0.33 1/s, and the string
  // as a whole no slower than 0.9 of that; with half or twice the gain it is slower
  const int bars = 150;
  const double length = bars * bar, zeta = torsional_impedance(drill_pipe());
  const double period = 4.0 * length / std::sqrt(79.3e9 / 7850.0);
  const auto slowest_decay = [&](double times) {
    const DriveControl best = soft_torque(2900.0, zeta, period);
    const DriveControlCase soft{.answer = DriveAnswer::soft_torque, .damping = times * best.damping, .period = period};
    const DrillString string = assemble(hanging(bars, soft, 2900.0));
    const Chain& chain = string.torsional;
    const auto n = static_cast<Eigen::Index>(chain.size());
    Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    motion.topRightCorner(n, n).setIdentity();
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const auto link = [&](Eigen::Index a, Eigen::Index b, double stiffness, double damping) {
        motion(n + a, b) += stiffness / chain.inertia[static_cast<std::size_t>(a)];
        motion(n + a, n + b) += damping / chain.inertia[static_cast<std::size_t>(a)];
      };
      link(i, i, -chain.stiffness[k], -chain.damping[k]);
      if (i == 0) continue;
      link(i - 1, i - 1, -chain.stiffness[k], -chain.damping[k]);
      link(i - 1, i, chain.stiffness[k], chain.damping[k]);
      link(i, i - 1, chain.stiffness[k], chain.damping[k]);
    }
    double slowest = 1e9;  // of the modes about the first
    const Eigen::VectorXcd roots = Eigen::EigenSolver<Eigen::MatrixXd>(motion, false).eigenvalues();
    for (const std::complex<double>& root : roots)
      if (std::abs(root) < 1.6 * 2.0 * pi / period) slowest = std::min(slowest, -root.real());
    return slowest;
  };
  const DriveControl best = soft_torque(2900.0, zeta, period);
  const double rate = best.damping / (4.0 * best.inertia);
  EXPECT_NEAR(rate, 0.33, 0.01);
  EXPECT_NEAR(slowest_decay(1.0), rate, 0.15 * rate);
  EXPECT_LT(slowest_decay(0.5), 0.75 * slowest_decay(1.0));
  EXPECT_LT(slowest_decay(2.0), 0.75 * slowest_decay(1.0));
}

}  // namespace
