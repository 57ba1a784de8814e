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
         joints.element_shear_stress[element]},
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
  if (joints.bonded[joint] == law.elements) {  // whole so far
    std::fill_n(shear_stress, elements, joints.shear_stress[joint]);
    joints.shear_displacement[joint] = joints.shear_stress[joint] / law.shear_stiffness;
  }
  std::array<ElementState, max_elements> state_before;
  std::array<double, max_elements> shear_before;
  if constexpr (measured) {
    std::copy_n(state, elements, state_before.begin());
    std::copy_n(shear_stress, elements, shear_before.begin());
  }
  std::uint64_t broken = 0;
  const InterfaceForce force = update_flat_joint(law, motion, state, shear_stress, broken);
  joints.shear_stress[joint] = shear_stress[0];
  joints.shear_displacement[joint] += motion.shear_increment;
  if (broken != 0) {
    joints.bonded[joint] -= std::popcount(broken);
    record_cracks(fresh, world, joint, pair, broken);
  }
  if constexpr (measured) {
    measure_joint(world, joint, law, pair, motion, state_before.data(), shear_before.data());
  }
  return force;
}

/// The reference path, and the only one for a joint that is damaged or may be at its strength.
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
