// Flat joints: reads positions and velocities, writes only its forces and each joint's own history.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "dem2d/contact/flat_joint_energy.hpp"
#include "dem2d/step/damaged_joints.hpp"
#include "dem2d/step/pair_motion.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/whole_joints.hpp"

namespace bitrock::dem2d {

namespace {

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
                     .mode = joints.state[element],
                     .disc1 = world.discs.id[i],
                     .disc2 = world.discs.id[j]});
  }
}

/// What an element keeps from step to step.
struct History {
  ElementState state;
  double shear_stress, opening;
};

inline History history_of(const FlatJoints& joints, std::size_t element) {
  return {joints.state[element], joints.element_shear_stress[element],
          joints.element_opening.empty() ? 0.0 : joints.element_opening[element]};
}

/// Adds up what the elements of a joint lost in this step, from what they were `before` it.
inline void measure_joint(World& world, std::size_t joint, const FlatJointLaw& law, const PairMotion& pair,
                          const InterfaceMotion& motion, const History* before) {
  FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const double length = 2.0 * law.half_length / law.elements;
  const double gap_before = motion.gap - pair.normal_speed * world.step;
  const double rotation_before = motion.rotation - (world.discs.spin[j] - world.discs.spin[i]) * world.step;
  const auto first = joint * static_cast<std::size_t>(law.elements);
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e, end = start + length;
    const auto element = first + static_cast<std::size_t>(e);
    const History now = history_of(joints, element);
    const ElementLoss loss = element_loss(law, length,
                                          {{gap_before - rotation_before * start, gap_before - rotation_before * end},
                                           before[e].state,
                                           before[e].shear_stress,
                                           before[e].opening},
                                          {{motion.gap - motion.rotation * start, motion.gap - motion.rotation * end},
                                           now.state,
                                           now.shear_stress,
                                           now.opening},
                                          motion.shear_increment);
    joints.friction_loss[joint] += loss.friction;
    joints.switching_loss[joint] += loss.switching;
    joints.breaking_loss[joint] += loss.breaking;
  }
}

template <bool measured>
InterfaceForce element_by_element(World& world, std::size_t joint, const FlatJointLaw& law, const PairMotion& pair,
                                  const InterfaceMotion& motion, std::vector<Crack>& fresh) {
  FlatJoints& joints = world.joints;
  const auto elements = static_cast<std::size_t>(law.elements), first = joint * elements;
  ElementState* const state = &joints.state[first];
  double* const shear_stress = &joints.element_shear_stress[first];
  if (joints.bonded[joint] == law.elements) {  // all have had the same shear so far
    std::fill_n(shear_stress, elements, joints.shear_stress[joint]);
    joints.shear_displacement[joint] = joints.shear_stress[joint] / law.shear_stiffness;
  }
  const bool softens = !joints.element_opening.empty();
  double* const opening = softens ? &joints.element_opening[first] : nullptr;
  std::array<History, max_elements> before;
  if constexpr (measured) {
    for (std::size_t e = 0; e < elements; ++e) before[e] = history_of(joints, first + e);
  }
  std::uint64_t broken = 0;
  const InterfaceForce force = update_flat_joint(law, motion, state, shear_stress, broken, opening);
  joints.shear_stress[joint] = shear_stress[0];
  joints.shear_displacement[joint] += motion.shear_increment;
  if (broken != 0) {
    joints.bonded[joint] -= std::popcount(broken);
    record_cracks(fresh, world, joint, pair, broken);
  }
  if (softens) {
    int softened = 0;
    for (std::size_t e = 0; e < elements; ++e)
      softened += state[e] == ElementState::bonded && opening[e] >= 1.0 ? 1 : 0;
    joints.softened[joint] = softened;
  }
  if constexpr (measured) measure_joint(world, joint, law, pair, motion, before.data());
  return force;
}

/// The reference path, and the only one for a joint that softens or may be at its strength.
template <bool measured>
void one_joint(World& world, std::size_t joint, std::vector<Crack>& fresh) {
  const FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const PairMotion pair = pair_motion(world.discs, i, j);
  const InterfaceMotion motion{
      .gap = pair.distance - joints.touching_distance[joint],
      .rotation = world.discs.angle[j] - world.discs.angle[i] - joints.stress_free_rotation[joint],
      .shear_increment = pair.shear_speed * world.step};
  const InterfaceForce force = element_by_element<measured>(world, joint, joints.law(joint), pair, motion, fresh);
  world.room.joint_forces[joint] = pair_force(pair, force.normal, force.shear, force.moment);
}

template <bool measured>
void joints_of(World& world, const Range& range, std::vector<int>& room, std::vector<Crack>& fresh) {
  if (world.reference_path) {
    for (std::size_t joint = range.begin; joint < range.end; ++joint) one_joint<measured>(world, joint, fresh);
    return;
  }
  const std::span<int> slow = damaged_joint_forces(world, whole_joint_forces(world, range, room));
  for (const int joint : slow) one_joint<measured>(world, static_cast<std::size_t>(joint), fresh);
}

}  // namespace

void joint_forces(World& world, const Share& share) {
  const Range range = part_of(world.joints.disc1.size(), share);
  const auto thread = static_cast<std::size_t>(share.thread);
  std::vector<int>& room = world.room.slow_joints[thread];
  std::vector<Crack>& fresh = world.room.fresh_cracks[thread];
  world.ledger.measured ? joints_of<true>(world, range, room, fresh) : joints_of<false>(world, range, room, fresh);
}

}  // namespace bitrock::dem2d
