// Each disc adds up what its contacts wrote. Compiled once for each vector unit: a slot is one load.
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include <algorithm>

#include "dem2d/step/step.hpp"

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/sum_forces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The sum of some pair forces, in as few registers as hold four numbers.
struct Sum {
  using D = hn::CappedTag<double, 4>;
  static constexpr std::size_t lanes = hn::MaxLanes(D()), parts = 4 / lanes;
  hn::Vec<D> part[parts];

  Sum() {
    for (auto& p : part) p = hn::Zero(D());
  }
  void add(const PairForce& force) {
    for (std::size_t p = 0; p < parts; ++p) part[p] = part[p] + hn::Load(D(), &force.x + p * lanes);
  }
  PairForce total() const {
    PairForce total;
    for (std::size_t p = 0; p < parts; ++p) hn::Store(part[p], D(), &total.x + p * lanes);
    return total;
  }
};

void SumJoints(World& world, const Range& range) {
  Discs& discs = world.discs;
  const PairForce* const forces = world.joint_forces.data();
  constexpr std::size_t each = JointsOfDiscs::places_each;
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const int* const joint = &world.joints_of_discs.joint[JointsOfDiscs::places * i];
    Sum as_disc1, as_disc2;
    for (std::size_t k = 0; k < each; ++k) as_disc1.add(forces[joint[k]]);
    for (std::size_t k = each; k < 2 * each; ++k) as_disc2.add(forces[joint[k]]);
    const PairForce one = as_disc1.total(), two = as_disc2.total();
    discs.force_x[i] = one.x - two.x;
    discs.force_y[i] = one.y - two.y;
    discs.moment[i] = one.moment1 + two.moment2;
  }
}

}  // namespace dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dem2d {

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
  for (const JointsOfDiscs::Entry& entry : world.joints_of_discs.more) {
    if (!holds(range, entry.disc)) continue;
    const PairForce& force = world.joint_forces[static_cast<std::size_t>(entry.joint)];
    entry.as_disc1 ? add_as_disc1(world.discs, entry.disc, force) : add_as_disc2(world.discs, entry.disc, force);
  }
}

/// Few pairs touch, so going through all of them is cheaper than lists.
void add_contacts(World& world, const Range& range) {
  const LinearContacts& contacts = world.contacts;
  for (std::size_t k = 0; k < contacts.disc1.size(); ++k) {
    if (contacts.touching[k] == 0) continue;
    const PairForce& force = world.contact_forces[k];
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

}  // namespace

void sum_forces(World& world, const Share& share) {
  const Range range = part_of(world.discs.x.size(), share);
  HWY_DYNAMIC_DISPATCH(SumJoints)(world, range);
  add_joints_without_place(world, range);
  add_contacts(world, range);
  add_boundaries(world, range);
}

}  // namespace dem2d
#endif
