// Each disc adds up what its contacts wrote. Compiled once for each vector unit: a slot is one load.
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include <algorithm>

#include "dem2d/step/stages.hpp"

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/sum_forces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace bitrock::dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t each = JointsOfDiscs::places_each;

#if HWY_TARGET <= HWY_AVX2

/// A pair force in one register.
using FourNumbers = hn::CappedTag<double, 4>;

HWY_INLINE hn::Vec<FourNumbers> sum(const PairForce* forces, const int* joint) {
  const FourNumbers d;
  auto total = hn::Load(d, &forces[joint[0]].x);
  for (std::size_t k = 1; k < each; ++k) total = total + hn::Load(d, &forces[joint[k]].x);
  return total;
}

HWY_INLINE void sum_joints_of_disc(Discs& discs, std::size_t i, const PairForce* forces, const int* joint) {
  const FourNumbers d;
  const hn::Half<FourNumbers> half;
  const auto as_disc1 = sum(forces, joint), as_disc2 = sum(forces, joint + each);
  // Whole registers as long as possible: shuffles and additions of single numbers are what this pass waits for.
  const auto force = hn::LowerHalf(half, as_disc1 - as_disc2);
  discs.force_x[i] = hn::GetLane(force);
  discs.force_y[i] = hn::ExtractLane(force, 1);
  discs.moment[i] = hn::GetLane(hn::UpperHalf(half, as_disc1 + hn::Reverse2(d, as_disc2)));  // moment1 + moment2
}

#else

HWY_INLINE PairForce sum(const PairForce* forces, const int* joint) {
  PairForce total = forces[joint[0]];
  for (std::size_t k = 1; k < each; ++k) {
    const PairForce& next = forces[joint[k]];
    total = {total.x + next.x, total.y + next.y, total.moment1 + next.moment1, total.moment2 + next.moment2};
  }
  return total;
}

HWY_INLINE void sum_joints_of_disc(Discs& discs, std::size_t i, const PairForce* forces, const int* joint) {
  const PairForce as_disc1 = sum(forces, joint), as_disc2 = sum(forces, joint + each);
  discs.force_x[i] = as_disc1.x - as_disc2.x;
  discs.force_y[i] = as_disc1.y - as_disc2.y;
  discs.moment[i] = as_disc1.moment1 + as_disc2.moment2;
}

#endif

void SumJoints(World& world, const Range& range) {
  const int* const joint = world.lists.joints_of_discs.joint.data();
  for (std::size_t i = range.begin; i < range.end; ++i) {
    sum_joints_of_disc(world.discs, i, world.room.joint_forces.data(), joint + JointsOfDiscs::places * i);
  }
}

}  // namespace bitrock::dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bitrock::dem2d {

HWY_EXPORT(SumJoints);

namespace {

bool holds(const Range& range, int disc) {
  const auto i = static_cast<std::size_t>(disc);
  return i >= range.begin && i < range.end;
}

void add_as_disc1(Discs& discs, int disc, const PairForce& force) {
  const auto i = static_cast<std::size_t>(disc);
  discs.force_x[i] += force.x;
  discs.force_y[i] += force.y;
  discs.moment[i] += force.moment1;
}

void add_as_disc2(Discs& discs, int disc, const PairForce& force) {
  const auto i = static_cast<std::size_t>(disc);
  discs.force_x[i] -= force.x;
  discs.force_y[i] -= force.y;
  discs.moment[i] += force.moment2;
}

void add_joints_without_place(World& world, const Range& range) {
  for (const JointsOfDiscs::Entry& entry : world.lists.joints_of_discs.more) {
    if (!holds(range, entry.disc)) continue;
    const PairForce& force = world.room.joint_forces[static_cast<std::size_t>(entry.joint)];
    entry.as_disc1 ? add_as_disc1(world.discs, entry.disc, force) : add_as_disc2(world.discs, entry.disc, force);
  }
}

/// Few pairs touch, so going through all of them is cheaper than lists.
void add_contacts(World& world, const Range& range) {
  const LinearContacts& contacts = world.contacts;
  for (std::size_t k = 0; k < contacts.disc1.size(); ++k) {
    if (contacts.touching[k] == 0) continue;
    const PairForce& force = world.room.contact_forces[k];
    if (holds(range, contacts.disc1[k])) add_as_disc1(world.discs, contacts.disc1[k], force);
    if (holds(range, contacts.disc2[k])) add_as_disc2(world.discs, contacts.disc2[k], force);
  }
}

void add_boundaries(World& world, const Range& range) {
  Discs& discs = world.discs;
  for (const Boundary& boundary : world.boundaries) {
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      if (!holds(range, boundary.near[place])) continue;
      const auto i = static_cast<std::size_t>(boundary.near[place]);
      discs.force_x[i] += boundary.contact_force_x[place];
      discs.force_y[i] += boundary.contact_force_y[place];
      discs.moment[i] += boundary.contact_moment[place];
    }
  }
}

void add_mud(World& world, const Range& range) {
  const Mud& mud = world.mud;
  if (mud.pressure == 0.0) return;
  for (std::size_t k = 0; k < mud.faces.stops.size(); ++k) {
    const int disc = mud.faces.stops[k].disc;
    if (!holds(range, disc)) continue;
    world.discs.force_x[static_cast<std::size_t>(disc)] += mud.force_x[k];
    world.discs.force_y[static_cast<std::size_t>(disc)] += mud.force_y[k];
  }
}

}  // namespace

void sum_forces(World& world, const Share& share) {
  const Range range = part_of(world.discs.x.size(), share);
  HWY_DYNAMIC_DISPATCH(SumJoints)(world, range);
  add_joints_without_place(world, range);
  add_contacts(world, range);
  add_boundaries(world, range);
  add_mud(world, range);
}

}  // namespace bitrock::dem2d
#endif
