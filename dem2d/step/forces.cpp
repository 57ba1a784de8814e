// The force pass: reads positions and velocities, writes only forces and each contact's own history.
#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "dem2d/contact/flat_joint_energy.hpp"
#include "dem2d/step/pair_motion.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

/// Writes what a pair force does to both discs: `pull` along n and `shear` along t act on disc 1, their negatives on
/// disc 2; `moment` is the interface's own moment, minus it on disc 1.
inline void write_pair(ForceSlots& slots, std::size_t contact, const PairMotion& motion, double pull, double shear,
                       double moment) {
  const double fx = pull * motion.normal_x - shear * motion.normal_y;
  const double fy = pull * motion.normal_y + shear * motion.normal_x;
  const std::size_t slot = 2 * contact;
  slots.force_x[slot] = fx;
  slots.force_y[slot] = fy;
  slots.moment[slot] = motion.lever1 * shear - moment;
  slots.force_x[slot + 1] = -fx;
  slots.force_y[slot + 1] = -fy;
  slots.moment[slot + 1] = motion.lever2 * shear + moment;
}

inline void record_cracks(std::vector<Crack>& fresh, const World& world, std::size_t joint, const PairMotion& motion,
                          std::uint64_t broken) {
  const FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const double length = 2.0 * joints.half_length[joint] / joints.elements;
  for (int e = 0; e < joints.elements; ++e) {
    if ((broken >> e & 1) == 0) continue;
    const auto element = joint * static_cast<std::size_t>(joints.elements) + static_cast<std::size_t>(e);
    const double along = -joints.half_length[joint] + length * (e + 0.5);
    fresh.push_back({.time = world.time,
                     .x = world.discs.x[i] + motion.lever1 * motion.normal_x - along * motion.normal_y,
                     .y = world.discs.y[i] + motion.lever1 * motion.normal_y + along * motion.normal_x,
                     .normal_angle = std::atan2(motion.normal_y, motion.normal_x),
                     .length = length,
                     .mode = static_cast<int>(joints.state[element]),
                     .disc1 = world.discs.id[i],
                     .disc2 = world.discs.id[j]});
  }
}

/// Adds up what the elements of a joint lost in this step. `state` and `shear_stress` are those before the step.
inline void measure_joint(World& world, std::size_t joint, const FlatJointLaw& law, const PairMotion& pair,
                          const InterfaceMotion& motion, const ElementState* state, const double* shear_stress) {
  FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const double length = 2.0 * law.half_length / law.elements;
  const double gap_before = motion.gap - pair.normal_speed * world.step;
  const double rotation_before = motion.rotation - (world.discs.spin[j] - world.discs.spin[i]) * world.step;
  const auto first = joint * static_cast<std::size_t>(law.elements);
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e, end = start + length;
    const auto element = first + static_cast<std::size_t>(e);
    const ElementLoss loss = element_loss(
        law, length,
        {{gap_before - rotation_before * start, gap_before - rotation_before * end}, state[e], shear_stress[e]},
        {{motion.gap - motion.rotation * start, motion.gap - motion.rotation * end},
         joints.state[element],
         joints.shear_stress[element]},
        motion.shear_increment);
    joints.friction_loss[joint] += loss.friction;
    joints.switching_loss[joint] += loss.switching;
    joints.breaking_loss[joint] += loss.breaking;
  }
}

/// The reference path, and the only one for a joint that is damaged or at its strength. Few joints are, so it is kept
/// out of the loop over the others.
template <bool measured>
[[gnu::noinline]] InterfaceForce element_by_element(World& world, std::size_t joint, const FlatJointLaw& law,
                                                    const PairMotion& pair, const InterfaceMotion& motion,
                                                    std::vector<Crack>& fresh) {
  FlatJoints& joints = world.joints;
  const auto elements = static_cast<std::size_t>(law.elements), first = joint * elements;
  std::array<ElementState, max_elements> state_before;
  std::array<double, max_elements> shear_before;
  if constexpr (measured) {
    std::copy_n(&joints.state[first], elements, state_before.begin());
    std::copy_n(&joints.shear_stress[first], elements, shear_before.begin());
  }
  std::uint64_t broken = 0;
  const InterfaceForce force =
      update_flat_joint(law, motion, &joints.state[first], &joints.shear_stress[first], broken);
  if (broken != 0) {
    joints.bonded[joint] -= std::popcount(broken);
    record_cracks(fresh, world, joint, pair, broken);
  }
  if constexpr (measured) {
    measure_joint(world, joint, law, pair, motion, state_before.data(), shear_before.data());
  }
  return force;
}

template <bool measured>
inline void one_joint(World& world, std::size_t joint, std::vector<Crack>& fresh) {
  FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const PairMotion pair = pair_motion(world.discs, i, j);
  const InterfaceMotion motion{
      .gap = pair.distance - joints.touching_distance[joint],
      .rotation = world.discs.angle[j] - world.discs.angle[i] - joints.stress_free_rotation[joint],
      .shear_increment = pair.shear_speed * world.step};
  joints.shear_displacement[joint] += motion.shear_increment;
  const FlatJointLaw law = joints.law(joint);
  const auto elements = static_cast<std::size_t>(law.elements), first = joint * elements;
  InterfaceForce force;
  double shear_stress = joints.shear_stress[first];  // the elements of a whole joint share it
  if (joints.bonded[joint] == law.elements && !world.reference_path &&
      update_whole_joint(law, motion, shear_stress, force)) {
    for (std::size_t e = 0; e < elements; ++e) joints.shear_stress[first + e] = shear_stress;
  } else {
    force = element_by_element<measured>(world, joint, law, pair, motion, fresh);
  }
  write_pair(world.slots, joint, pair, force.normal, force.shear, force.moment);
}

/// What a linear contact lost in this step; its dashpot forces are kept for the next. `opening` is what the overlap has
/// shrunk by, `spring_before` the spring before the step.
inline LinearLoss measure_contact(const LinearLaw& law, double overlap, double opening, double spring_before,
                                  double spring, const LinearForce& force, double shear_increment,
                                  double& last_normal_dashpot, double& last_shear_dashpot) {
  const LinearLoss loss = linear_loss(law, {overlap + opening, spring_before, last_normal_dashpot, last_shear_dashpot},
                                      {overlap, spring, force.normal_dashpot, force.shear_dashpot}, shear_increment);
  last_normal_dashpot = force.normal_dashpot;
  last_shear_dashpot = force.shear_dashpot;
  return loss;
}

template <bool measured>
inline void one_contact(World& world, std::size_t contact) {
  LinearContacts& contacts = world.contacts;
  const auto i = static_cast<std::size_t>(contacts.disc1[contact]),
             j = static_cast<std::size_t>(contacts.disc2[contact]);
  const std::size_t place = static_cast<std::size_t>(world.joints.count()) + contact;
  const PairMotion pair = pair_motion(world.discs, i, j);
  const double overlap = world.discs.radius[i] + world.discs.radius[j] - pair.distance;
  const double shear_increment = pair.shear_speed * world.step;
  const LinearLaw law = contact_law(world, contact);
  double& spring = contacts.spring[contact];
  const double spring_before = spring;
  const LinearForce force =
      update_linear_contact(law, overlap, -pair.normal_speed, shear_increment, pair.shear_speed, spring);
  if constexpr (measured) {
    const LinearLoss loss =
        measure_contact(law, overlap, pair.normal_speed * world.step, spring_before, spring, force, shear_increment,
                        contacts.last_normal_dashpot[contact], contacts.last_shear_dashpot[contact]);
    contacts.friction_loss[contact] += loss.friction;
    contacts.dashpot_loss[contact] += loss.dashpots;
    contacts.switching_loss[contact] += loss.switching;
  }
  write_pair(world.slots, place, pair, -force.normal, force.shear, 0.0);
}

/// Disc `i` against a boundary: n from the boundary to the disc, so the disc is "disc 2" and the boundary does not
/// spin.
template <bool measured>
inline void one_boundary_contact(World& world, Boundary& boundary, std::size_t place) {
  const auto i = static_cast<std::size_t>(boundary.near[place]);
  const Discs& discs = world.discs;
  const NearestPoint point = nearest_point(boundary.shape, discs.x[i], discs.y[i]);
  const double overlap = discs.radius[i] - point.distance - boundary.reference_overlap[i];
  const double du = discs.velocity_x[i] - boundary.velocity_x, dv = discs.velocity_y[i] - boundary.velocity_y;
  const double lever = 0.5 * (discs.radius[i] + point.distance);  // to the middle of the overlap
  const double normal_speed = du * point.normal_x + dv * point.normal_y;
  const double shear_speed = dv * point.normal_x - du * point.normal_y - discs.spin[i] * lever;
  const double shear_increment = shear_speed * world.step;
  const LinearLaw law = boundary_law(boundary, discs.mass[i]);
  double& spring = boundary.spring[i];
  const double spring_before = spring;
  const LinearForce force = update_linear_contact(law, overlap, -normal_speed, shear_increment, shear_speed, spring);
  if constexpr (measured) {
    const LinearLoss loss =
        measure_contact(law, overlap, normal_speed * world.step, spring_before, spring, force, shear_increment,
                        boundary.last_normal_dashpot[i], boundary.last_shear_dashpot[i]);
    world.energy.friction += loss.friction;
    world.energy.dashpots += loss.dashpots;
    world.energy.switching += loss.switching;
  }
  boundary.contact_force_x[place] = force.normal * point.normal_x + force.shear * point.normal_y;
  boundary.contact_force_y[place] = force.normal * point.normal_y - force.shear * point.normal_x;
  boundary.contact_moment[place] = lever * force.shear;
}

template <bool measured>
void all_joints(World& world) {
  const int count = world.joints.count();
#pragma omp parallel num_threads(world.threads) if (world.threads > 1)
  {
    std::vector<Crack>& fresh = world.fresh_cracks[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int joint = 0; joint < count; ++joint) one_joint<measured>(world, static_cast<std::size_t>(joint), fresh);
  }
}

template <bool measured>
void all_contacts(World& world) {
  const int count = world.contacts.count();
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static)
  for (int contact = 0; contact < count; ++contact) one_contact<measured>(world, static_cast<std::size_t>(contact));
}

template <bool measured>
void all_boundary_contacts(World& world) {
  for (Boundary& boundary : world.boundaries) {  // few discs are near a boundary: not worth threads
    const double last_x = boundary.force_x, last_y = boundary.force_y;
    boundary.force_x = 0.0;
    boundary.force_y = 0.0;
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      one_boundary_contact<measured>(world, boundary, place);
      boundary.force_x -= boundary.contact_force_x[place];
      boundary.force_y -= boundary.contact_force_y[place];
    }
    if constexpr (measured) {
      boundary.work -=
          0.5 * ((last_x + boundary.force_x) * boundary.moved_x + (last_y + boundary.force_y) * boundary.moved_y);
    }
  }
}

}  // namespace

void joint_forces(World& world) {
  world.measure_energy ? all_joints<true>(world) : all_joints<false>(world);
}

void contact_forces(World& world) {
  world.measure_energy ? all_contacts<true>(world) : all_contacts<false>(world);
}

void boundary_forces(World& world) {
  world.measure_energy ? all_boundary_contacts<true>(world) : all_boundary_contacts<false>(world);
}

void sum_forces(World& world) {
  Discs& discs = world.discs;
  const ForceSlots& slots = world.slots;
  const int count = discs.count();
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static)
  for (int disc = 0; disc < count; ++disc) {
    const auto i = static_cast<std::size_t>(disc);
    double fx = 0.0, fy = 0.0, moment = 0.0;
    for (int entry = slots.first[i]; entry < slots.first[i + 1]; ++entry) {
      const auto slot = static_cast<std::size_t>(slots.slot[static_cast<std::size_t>(entry)]);
      fx += slots.force_x[slot];
      fy += slots.force_y[slot];
      moment += slots.moment[slot];
    }
    discs.force_x[i] = fx;
    discs.force_y[i] = fy;
    discs.moment[i] = moment;
  }
  for (const Boundary& boundary : world.boundaries) {
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      const auto i = static_cast<std::size_t>(boundary.near[place]);
      discs.force_x[i] += boundary.contact_force_x[place];
      discs.force_y[i] += boundary.contact_force_y[place];
      discs.moment[i] += boundary.contact_moment[place];
    }
  }
}

}  // namespace dem2d
