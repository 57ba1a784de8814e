#include "dem2d/step/handover.hpp"

#include <algorithm>

#include "dem2d/step/energy.hpp"

namespace bitrock::dem2d {

namespace {

/// What the faces of a joint without bonds carry: N_j, compression positive, and T_j.
struct Carried {
  double normal, shear;  ///< [N/m]
};

Carried carried_by(const FlatJoints& joints, std::size_t joint, const JointPosition& now) {
  const FlatJointLaw law = joints.law(joint);
  const double length = 2.0 * law.half_length / law.elements;
  Carried total{0.0, 0.0};
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e;
    const double gap_a = now.gap - now.rotation * start, gap_b = now.gap - now.rotation * (start + length);
    total.normal -= unbonded_resultant(law.normal_stiffness, length, gap_a, gap_b).force;
    total.shear +=
        length *
        joints.element_shear_stress[joint * static_cast<std::size_t>(law.elements) + static_cast<std::size_t>(e)];
  }
  return total;
}

}  // namespace

Handover hand_over(const World& world, std::size_t joint) {
  const FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const JointPosition now = joint_position(world, joint);
  const auto [low, high] = std::minmax(joints.disc1[joint], joints.disc2[joint]);
  Handover next{
      .disc1 = low, .disc2 = high, .reference_overlap = 0.0, .spring = 0.0, .touching = false, .injected = 0.0};
  if (now.overlap > 0.0) {
    const Carried carried = carried_by(joints, joint, now);
    const double kn =
        linear_normal_stiffness(world.materials.contact_modulus, world.discs.radius[i], world.discs.radius[j]);
    const LinearLaw law{.normal_stiffness = kn,
                        .shear_stiffness = kn / world.materials.contact_stiffness_ratio,
                        .friction = world.materials.contact_friction,
                        .dashpot = 0.0,
                        .shear_dashpot = 0.0};
    next.touching = carried.normal > 0.0;
    next.reference_overlap = next.touching ? now.overlap - carried.normal / kn : now.overlap + now.gap;
    next.spring = next.touching ? carried.shear : 0.0;
    next.injected = linear_stored_energy(law, now.overlap - next.reference_overlap, next.spring);
  }
  next.injected -= joint_energy(world, joint);
  return next;
}

}  // namespace bitrock::dem2d
