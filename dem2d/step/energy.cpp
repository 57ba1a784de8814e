#include "dem2d/step/energy.hpp"

#include <algorithm>
#include <cmath>

#include "dem2d/contact/flat_joint_energy.hpp"
#include "dem2d/step/local_damping.hpp"
#include "dem2d/step/pair_motion.hpp"

namespace bitrock::dem2d {

namespace {

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values) total += value;
  return total;
}

/// m v(t - dt/2) v(t + dt/2) / 2 of one component, and the half of the damping of F(t) that belongs to the interval
/// before t (integrate books F(t) whole, with the mean of both velocities, when the step is done).
struct Component {
  double kinetic, damping;
};
Component at_instant(double mass, double inverse_mass, double velocity, double force, double alpha, double dt) {
  const double loss = local_damping(force, velocity, alpha);
  return {.kinetic = 0.5 * mass * velocity * (velocity + (force - loss) * inverse_mass * dt),
          .damping = 0.5 * loss * velocity * dt};
}

double contact_energy(const World& world, std::size_t contact) {
  const auto i = static_cast<std::size_t>(world.contacts.disc1[contact]),
             j = static_cast<std::size_t>(world.contacts.disc2[contact]);
  const double overlap = world.discs.radius[i] + world.discs.radius[j] - centre_distance(world.discs, i, j) -
                         world.contacts.reference_overlap[contact];
  return linear_stored_energy(contact_law(world, contact), overlap, world.contacts.spring[contact]);
}

double boundary_energy(const World& world, const Boundary& boundary, std::size_t i) {
  const double distance = nearest_point(boundary.shape, world.discs.x[i], world.discs.y[i]).distance;
  const double overlap = world.discs.radius[i] - distance - boundary.reference_overlap[i];
  return linear_stored_energy(boundary_law(boundary, world.discs.mass[i]), overlap, boundary.spring[i]);
}

}  // namespace

JointPosition joint_position(const World& world, std::size_t joint) {
  const FlatJoints& joints = world.joints;
  const Discs& d = world.discs;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const double distance = centre_distance(d, i, j);
  return {.gap = distance - joints.touching_distance[joint],
          .rotation = d.angle[j] - d.angle[i] - joints.stress_free_rotation[joint],
          .overlap = d.radius[i] + d.radius[j] - distance};
}

double joint_energy(const World& world, std::size_t joint) {
  const JointPosition now = joint_position(world, joint);
  const FlatJointLaw law = world.joints.law(joint);
  if (world.joints.whole(joint)) {
    return whole_joint_energy(law, now.gap, now.rotation, world.joints.shear_stress[joint]);
  }
  const double length = 2.0 * law.half_length / law.elements;
  double energy = 0.0;
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e;
    const auto element = joint * static_cast<std::size_t>(law.elements) + static_cast<std::size_t>(e);
    energy +=
        stored_energy(law, length,
                      {.gaps = {now.gap - now.rotation * start, now.gap - now.rotation * (start + length)},
                       .state = world.joints.state[element],
                       .shear_stress = world.joints.element_shear_stress[element],
                       .opening = world.joints.element_opening.empty() ? 0.0 : world.joints.element_opening[element]});
  }
  return energy;
}

double contact_strain(const World& world) {
  double sum = 0.0;
  for (std::size_t c = 0; c < world.contacts.disc1.size(); ++c) sum += contact_energy(world, c);
  return sum;
}

Energies read_energies(const World& world) {
  const Discs& d = world.discs;
  const EnergyAccounts& gone = world.ledger.accounts;
  Energies now{.friction = gone.friction + sum(world.joints.friction_loss) + sum(world.contacts.friction_loss),
               .dashpots = gone.dashpots + sum(world.contacts.dashpot_loss),
               .local_damping = gone.local_damping + sum(d.damping_loss),
               .breaking = gone.breaking + sum(world.joints.breaking_loss),
               .switching = gone.switching + sum(world.joints.switching_loss) + sum(world.contacts.switching_loss),
               .removed = gone.removed,
               .injected = gone.injected,
               .entered = gone.entered,
               .mud_work = world.mud.work};
  const double alpha = world.materials.local_damping, dt = world.step;
  for (std::size_t i = 0; i < d.x.size(); ++i) {
    for (const Component& part : {at_instant(d.mass[i], d.inverse_mass[i], d.velocity_x[i], d.force_x[i], alpha, dt),
                                  at_instant(d.mass[i], d.inverse_mass[i], d.velocity_y[i], d.force_y[i], alpha, dt),
                                  at_instant(d.inertia[i], d.inverse_inertia[i], d.spin[i], d.moment[i], alpha, dt)}) {
      now.kinetic += part.kinetic;
      now.local_damping += part.damping;
    }
  }
  for (std::size_t j = 0; j < world.joints.disc1.size(); ++j) now.strain_joints += joint_energy(world, j);
  now.strain_contacts = contact_strain(world);
  for (const Boundary& boundary : world.boundaries) {
    now.boundary_work += boundary.work;
    for (const int disc : boundary.near)
      now.strain_boundaries += boundary_energy(world, boundary, static_cast<std::size_t>(disc));
  }
  return now;
}

Energies since(const Energies& start, const Energies& now) {
  Energies come;
  for (const EnergyEntry& entry : energy_entries) come.*entry.value = now.*entry.value - start.*entry.value;
  return come;
}

double energy_residual(const Energies& start, const Energies& now) {
  const auto found = [](const Energies& e) {
    return e.kinetic + e.strain_joints + e.strain_contacts + e.strain_boundaries + e.friction + e.dashpots +
           e.local_damping + e.breaking + e.switching + e.removed;
  };
  const auto given = [](const Energies& e) { return e.boundary_work + e.mud_work + e.entered + e.injected; };
  return (given(now) - given(start)) - (found(now) - found(start));
}

double energy_residual_fraction(const Energies& start, const Energies& now) {
  const double work = now.boundary_work - start.boundary_work;
  return work != 0.0 ? energy_residual(start, now) / work : 0.0;
}

double energy_injected_fraction(const Energies& start, const Energies& now) {
  const double work = now.boundary_work - start.boundary_work;
  return work != 0.0 ? (now.injected - start.injected) / work : 0.0;
}

double last_half_step(const World& world, const std::vector<PairForce>& forces, std::size_t place, int disc1,
                      int disc2) {
  if (place >= forces.size()) return 0.0;  // no force yet
  const Discs& d = world.discs;
  const PairForce& force = forces[place];
  const auto i = static_cast<std::size_t>(disc1), j = static_cast<std::size_t>(disc2);
  return 0.5 * world.step *
         (force.x * (d.velocity_x[i] - d.velocity_x[j]) + force.y * (d.velocity_y[i] - d.velocity_y[j]) +
          force.moment1 * d.spin[i] + force.moment2 * d.spin[j]);
}

void book_joint_losses(World& world, const std::vector<char>& stays) {
  if (!world.ledger.measured) return;
  for (std::size_t j = 0; j < stays.size(); ++j) {
    if (stays[j] != 0) continue;
    world.ledger.accounts.friction += world.joints.friction_loss[j];
    world.ledger.accounts.switching += world.joints.switching_loss[j];
    world.ledger.accounts.breaking += world.joints.breaking_loss[j];
  }
}

void book_contact_losses(World& world) {
  if (!world.ledger.measured) return;
  world.ledger.accounts.friction += sum(world.contacts.friction_loss);
  world.ledger.accounts.dashpots += sum(world.contacts.dashpot_loss);
  world.ledger.accounts.switching += sum(world.contacts.switching_loss);
  for (std::vector<double>* losses :
       {&world.contacts.friction_loss, &world.contacts.dashpot_loss, &world.contacts.switching_loss}) {
    std::fill(losses->begin(), losses->end(), 0.0);
  }
}

void book_lost_discs(World& world, const std::vector<char>& discs_stay, const std::vector<char>& joints_stay,
                     const std::vector<char>& contacts_stay) {
  const Discs& d = world.discs;
  for (std::size_t i = 0; i < discs_stay.size(); ++i) {
    if (discs_stay[i] != 0) continue;
    world.ledger.accounts.local_damping += d.damping_loss[i];
    world.ledger.accounts.removed +=
        0.5 * d.mass[i] * (d.velocity_x[i] * d.velocity_x[i] + d.velocity_y[i] * d.velocity_y[i]) +
        0.5 * d.inertia[i] * d.spin[i] * d.spin[i];
    for (const Boundary& boundary : world.boundaries) {
      if (i < boundary.spring.size()) world.ledger.accounts.removed += boundary_energy(world, boundary, i);
    }
  }
  for (std::size_t j = 0; j < joints_stay.size(); ++j) {
    if (joints_stay[j] != 0) continue;
    world.ledger.accounts.removed +=
        joint_energy(world, j) +
        last_half_step(world, world.room.joint_forces, j, world.joints.disc1[j], world.joints.disc2[j]);
  }
  for (std::size_t c = 0; c < contacts_stay.size(); ++c) {
    if (contacts_stay[c] != 0) continue;
    world.ledger.accounts.removed +=
        contact_energy(world, c) +
        last_half_step(world, world.room.contact_forces, c, world.contacts.disc1[c], world.contacts.disc2[c]);
  }
  book_joint_losses(world, joints_stay);
  book_contact_losses(world);
}

}  // namespace bitrock::dem2d
