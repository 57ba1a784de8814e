#include "dem2d/step/removal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem2d/step/energy.hpp"

namespace bitrock::dem2d {

namespace {

/// Keeps the entries whose flag is set, in order. Arrays that are not in use are empty and stay so.
template <class T>
void keep(std::vector<T>& values, const std::vector<char>& flags, std::size_t entries_each = 1) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == 0) continue;
    for (std::size_t e = 0; e < entries_each; ++e) values[kept * entries_each + e] = values[i * entries_each + e];
    ++kept;
  }
  values.resize(kept * entries_each);
}

void keep_joints(FlatJoints& joints, const std::vector<char>& flags) {
  for (std::vector<int>* values : integer_arrays(joints)) keep(*values, flags);
  for (std::vector<double>* values : number_arrays(joints)) keep(*values, flags);
  keep(joints.element_shear_stress, flags, static_cast<std::size_t>(joints.elements));
  keep(joints.element_opening, flags, static_cast<std::size_t>(joints.elements));
  keep(joints.state, flags, static_cast<std::size_t>(joints.elements));
}

void keep_contacts(LinearContacts& contacts, const std::vector<char>& flags) {
  keep(contacts.disc1, flags);
  keep(contacts.disc2, flags);
  keep(contacts.touching, flags);
  for (std::vector<double>* values :
       {&contacts.normal_stiffness, &contacts.dashpot, &contacts.shear_dashpot, &contacts.spring,
        &contacts.reference_overlap, &contacts.last_normal_dashpot, &contacts.last_shear_dashpot,
        &contacts.friction_loss, &contacts.dashpot_loss, &contacts.switching_loss}) {
    keep(*values, flags);
  }
}

bool joint_is_over(const World& world, std::size_t joint) {
  const FlatJoints& joints = world.joints;
  if (joints.bonded[joint] > 0) return false;
  const JointPosition now = joint_position(world, joint);
  const double half = joints.half_length[joint];
  if (std::fabs(joints.shear_displacement[joint]) > 2.0 * half || now.gap > 2.0 * half) return true;
  const bool open_everywhere = now.gap - std::fabs(now.rotation) * half > 0.0;
  return open_everywhere && -now.overlap > world.lists.skin;
}

}  // namespace

std::vector<Handover> end_finished_joints(World& world) {
  const FlatJoints& joints = world.joints;
  std::vector<Handover> handovers;
  std::vector<char> stays;
  for (std::size_t joint = 0; joint < joints.disc1.size(); ++joint) {
    if (!joint_is_over(world, joint)) continue;
    stays.resize(joints.disc1.size(), 1);
    stays[joint] = 0;
    handovers.push_back(hand_over(world, joint));
    world.ledger.accounts.injected +=
        handovers.back().injected -
        last_half_step(world, world.room.joint_forces, joint, joints.disc1[joint], joints.disc2[joint]);
  }
  if (handovers.empty()) return handovers;
  book_joint_losses(world, stays);
  keep_joints(world.joints, stays);
  std::sort(handovers.begin(), handovers.end(), [](const Handover& a, const Handover& b) {
    return std::pair(a.disc1, a.disc2) < std::pair(b.disc1, b.disc2);
  });
  return handovers;
}

bool remove_lost_discs(World& world) {
  const Discs& discs = world.discs;
  const Domain& box = world.domain;
  std::vector<char> stays(discs.x.size(), 1);
  for (std::size_t i = 0; i < stays.size(); ++i) {
    // NaN counts as staying, so that require_finite reports it instead of a disc silently vanishing.
    const bool lost =
        discs.x[i] < box.x_low || discs.x[i] > box.x_high || discs.y[i] < box.y_low || discs.y[i] > box.y_high;
    stays[i] = lost ? 0 : 1;
  }
  return remove_discs(world, stays);
}

bool remove_discs(World& world, const std::vector<char>& stays) {
  Discs& discs = world.discs;
  std::vector<int> renumbered(discs.x.size(), -1);
  int kept = 0;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (stays[i] != 0) renumbered[i] = kept++;
  }
  if (kept == discs.count()) return false;
  world.removed_discs += discs.count() - kept;

  const auto both_stay = [&stays](const std::vector<int>& a, const std::vector<int>& b) {
    std::vector<char> flags(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      flags[k] = stays[static_cast<std::size_t>(a[k])] != 0 && stays[static_cast<std::size_t>(b[k])] != 0 ? 1 : 0;
    }
    return flags;
  };
  const auto renumber = [&renumbered](std::vector<int>& indices) {
    for (int& index : indices) index = renumbered[static_cast<std::size_t>(index)];
  };
  const std::vector<char> joints_stay = both_stay(world.joints.disc1, world.joints.disc2),
                          contacts_stay = both_stay(world.contacts.disc1, world.contacts.disc2);
  if (world.ledger.measured) book_lost_discs(world, stays, joints_stay, contacts_stay);
  keep_joints(world.joints, joints_stay);
  keep_contacts(world.contacts, contacts_stay);
  keep(world.room.joint_forces, joints_stay);  // their last half step is still to be looked at
  keep(world.room.contact_forces, contacts_stay);
  for (std::vector<int>* indices :
       {&world.joints.disc1, &world.joints.disc2, &world.contacts.disc1, &world.contacts.disc2}) {
    renumber(*indices);
  }
  for (Boundary& boundary : world.boundaries) {
    for (std::vector<double>* values :
         {&boundary.spring, &boundary.reference_overlap, &boundary.last_normal_dashpot, &boundary.last_shear_dashpot}) {
      keep(*values, stays);
    }
    std::erase_if(boundary.near, [&stays](int disc) { return stays[static_cast<std::size_t>(disc)] == 0; });
    renumber(boundary.near);
  }
  keep(discs.id, stays);
  for (std::vector<double>* values : number_arrays(discs)) keep(*values, stays);
  keep(world.lists.listed_x, stays);
  keep(world.lists.listed_y, stays);
  keep(world.lists.listed_margin, stays);
  return true;
}

}  // namespace bitrock::dem2d
