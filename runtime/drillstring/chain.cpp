#include "runtime/drillstring/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bitrock::runtime {

namespace {

/// Where a lump sits in its stretch.
double place_of(Lumping lumping) {
  return lumping == Lumping::middle ? 0.5 : 1.0;
}

double axial_compliance(const PipeSection& pipe) {
  return 1.0 / (pipe.youngs_modulus * area(pipe));
}

double total_length(const std::vector<PipeSection>& pipes) {
  double length = 0.0;
  for (const PipeSection& pipe : pipes) length += pipe.length;
  return length;
}

/// Integral of `density(pipe)` over the string from `from` to `to` [m].
template <class Density>
double integral(const std::vector<PipeSection>& pipes, double from, double to, const Density& density) {
  double sum = 0.0, top = 0.0;
  for (const PipeSection& pipe : pipes) {
    const double bottom = top + pipe.length;
    const double shared = std::min(to, bottom) - std::max(from, top);
    if (shared > 0.0) sum += shared * density(pipe);
    top = bottom;
  }
  return sum;
}

template <class Inertia, class Compliance>
Chain chain_of(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping, double damping_ratio, bool free_top,
               const Inertia& inertia, const Compliance& compliance) {
  Chain chain;
  const double stretch = total_length(pipes) / lumps;
  const double place = place_of(lumping);
  for (int i = 0; i < lumps; ++i) {
    const double above = i == 0 ? 0.0 : (i - 1 + place) * stretch, here = (i + place) * stretch;
    const double mass = integral(pipes, i * stretch, (i + 1) * stretch, inertia);
    const double stiffness = i == 0 && free_top ? 0.0 : 1.0 / integral(pipes, above, here, compliance);
    chain.inertia.push_back(mass);
    chain.stiffness.push_back(stiffness);
    chain.damping.push_back(2.0 * damping_ratio * std::sqrt(stiffness * mass));
    chain.wall_damping.push_back(0.0);
  }
  return chain;
}

}  // namespace

double area(const PipeSection& pipe) {
  return 0.25 * std::numbers::pi *
         (pipe.outer_diameter * pipe.outer_diameter - pipe.inner_diameter * pipe.inner_diameter);
}

double polar_moment(const PipeSection& pipe) {
  return std::numbers::pi / 32.0 * (std::pow(pipe.outer_diameter, 4) - std::pow(pipe.inner_diameter, 4));
}

double stress_of_moment(const PipeSection& pipe) {
  return pipe.outer_diameter / polar_moment(pipe);
}

double mass_per_length(const PipeSection& pipe) {
  return pipe.linear_mass > 0.0 ? pipe.linear_mass : pipe.density * area(pipe);
}

double torsional_impedance(const PipeSection& pipe) {
  return std::sqrt(pipe.density * pipe.shear_modulus) * polar_moment(pipe);
}

Chain axial_chain(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping, double damping_ratio) {
  return chain_of(pipes, lumps, lumping, damping_ratio, true, mass_per_length, axial_compliance);
}

double compliance_above(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping) {
  return integral(pipes, 0.0, place_of(lumping) * total_length(pipes) / lumps, axial_compliance);
}

Chain torsional_chain(const std::vector<PipeSection>& pipes, int lumps, Lumping lumping, double damping_ratio) {
  return chain_of(
      pipes, lumps, lumping, damping_ratio, false,
      [](const PipeSection& pipe) { return pipe.density * polar_moment(pipe); },
      [](const PipeSection& pipe) { return 1.0 / (pipe.shear_modulus * polar_moment(pipe)); });
}

std::vector<double> lump_weights(const std::vector<PipeSection>& pipes, int lumps, double fluid_density) {
  std::vector<double> weights;
  weights.reserve(static_cast<std::size_t>(lumps));
  const double stretch = total_length(pipes) / lumps;
  for (int i = 0; i < lumps; ++i) {
    weights.push_back(integral(pipes, i * stretch, (i + 1) * stretch, [=](const PipeSection& pipe) {
      return gravity * (1.0 - fluid_density / pipe.density) * mass_per_length(pipe);
    }));
  }
  return weights;
}

void set_chain_forces(const Chain& chain, const std::vector<double>& position, const std::vector<double>& velocity,
                      const Drive& drive, std::vector<double>& force) {
  double above = drive.position, speed_above = drive.velocity;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double pull = chain.stiffness[i] * (above - position[i]) + chain.damping[i] * (speed_above - velocity[i]);
    force[i] = pull - chain.wall_damping[i] * velocity[i];
    if (i > 0) force[i - 1] -= pull;
    above = position[i];
    speed_above = velocity[i];
  }
}

double drive_reaction(const Chain& chain, const ChainMotion& motion, const Drive& drive) {
  return chain.stiffness[0] * (drive.position - motion.position[0]) +
         chain.damping[0] * (drive.velocity - motion.velocity[0]);
}

double spring_energy(const Chain& chain, const ChainMotion& motion, const Drive& drive) {
  double sum = 0.0, above = drive.position;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double stretch = above - motion.position[i];
    sum += 0.5 * chain.stiffness[i] * stretch * stretch;
    above = motion.position[i];
  }
  return sum;
}

double damper_power(const Chain& chain, const ChainMotion& motion, const Drive& drive) {
  double sum = 0.0, above = drive.velocity;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const double rate = above - motion.velocity[i];
    sum += chain.damping[i] * rate * rate + chain.wall_damping[i] * motion.velocity[i] * motion.velocity[i];
    above = motion.velocity[i];
  }
  return sum;
}

double kinetic_energy(const Chain& chain, const ChainMotion& motion) {
  double sum = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i)
    sum += 0.5 * chain.inertia[i] * motion.velocity[i] * motion.velocity[i];
  return sum;
}

}  // namespace bitrock::runtime
