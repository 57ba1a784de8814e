#include "dem2d/step/neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/removal.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

// Skin as a share of the smallest radius. Larger: longer lists; smaller: lists made more often. The result of a run
// does not depend on it, but for the instants at which finished joints are noticed.
constexpr double skin_per_radius = 0.3;

/// For each disc the sorted list of the discs it is joined to: `first[i]` .. `first[i + 1]` in `partner`.
struct Partners {
  std::vector<int> first, partner;

  bool joined(int i, int j) const {
    const auto begin = partner.begin() + first[static_cast<std::size_t>(i)];
    const auto end = partner.begin() + first[static_cast<std::size_t>(i) + 1];
    return std::find(begin, end, j) != end;
  }
};

/// Each joint entered under its lower disc.
Partners joint_partners(const World& world) {
  const FlatJoints& joints = world.joints;
  Partners partners;
  partners.first.assign(world.discs.x.size() + 1, 0);
  const auto lower = [&joints](std::size_t k) {
    return static_cast<std::size_t>(std::min(joints.disc1[k], joints.disc2[k]));
  };
  for (std::size_t k = 0; k < joints.disc1.size(); ++k) ++partners.first[lower(k) + 1];
  for (std::size_t i = 1; i < partners.first.size(); ++i) partners.first[i] += partners.first[i - 1];
  partners.partner.resize(joints.disc1.size());
  std::vector<int> next(partners.first.begin(), partners.first.end() - 1);
  for (std::size_t k = 0; k < joints.disc1.size(); ++k) {
    partners.partner[static_cast<std::size_t>(next[lower(k)]++)] = std::max(joints.disc1[k], joints.disc2[k]);
  }
  return partners;
}

void list_contacts(World& world) {
  const Discs& discs = world.discs;
  const Pairs pairs = pairs_within(discs, world.skin);
  const Partners partners = joint_partners(world);
  book_contact_losses(world);
  LinearContacts fresh;
  const LinearContacts& old = world.contacts;
  std::size_t cursor = 0;  // both lists are sorted by (disc1, disc2): one pass carries the histories over
  for (std::size_t k = 0; k < pairs.disc1.size(); ++k) {
    const int i = pairs.disc1[k], j = pairs.disc2[k];
    if (partners.joined(i, j)) continue;
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const double kn = linear_normal_stiffness(world.contact_modulus, discs.radius[a], discs.radius[b]);
    const double reduced_mass = discs.mass[a] * discs.mass[b] / (discs.mass[a] + discs.mass[b]);
    while (cursor < old.disc1.size() && (old.disc1[cursor] < i || (old.disc1[cursor] == i && old.disc2[cursor] < j))) {
      ++cursor;
    }
    const bool known = cursor < old.disc1.size() && old.disc1[cursor] == i && old.disc2[cursor] == j;
    fresh.disc1.push_back(i);
    fresh.disc2.push_back(j);
    fresh.normal_stiffness.push_back(kn);
    fresh.dashpot.push_back(dashpot_constant(world.contact_damping_ratio, reduced_mass, kn));
    fresh.shear_dashpot.push_back(
        dashpot_constant(world.contact_shear_damping_ratio, reduced_mass, kn / world.contact_stiffness_ratio));
    fresh.spring.push_back(known ? old.spring[cursor] : 0.0);
    if (!world.measure_energy) continue;
    fresh.last_normal_dashpot.push_back(known ? old.last_normal_dashpot[cursor] : 0.0);
    fresh.last_shear_dashpot.push_back(known ? old.last_shear_dashpot[cursor] : 0.0);
    fresh.friction_loss.push_back(0.0);
    fresh.dashpot_loss.push_back(0.0);
    fresh.switching_loss.push_back(0.0);
  }
  world.contacts = std::move(fresh);
}

void list_boundary_neighbours(World& world) {
  const Discs& discs = world.discs;
  for (Boundary& boundary : world.boundaries) {
    for (std::vector<double>* values :
         {&boundary.spring, &boundary.reference_overlap, &boundary.last_normal_dashpot, &boundary.last_shear_dashpot}) {
      values->resize(discs.x.size(), 0.0);
    }
    boundary.displaced = 0.0;
    boundary.near.clear();
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
      const NearestPoint point = nearest_point(boundary.shape, discs.x[i], discs.y[i]);
      if (point.distance < discs.radius[i] + world.skin) {
        boundary.near.push_back(static_cast<int>(i));
      } else {
        boundary.spring[i] = 0.0;
        boundary.reference_overlap[i] = 0.0;  // once it has left, it comes back as a stranger
      }
    }
    for (std::vector<double>* values :
         {&boundary.contact_force_x, &boundary.contact_force_y, &boundary.contact_moment}) {
      values->resize(boundary.near.size());
    }
  }
}

void list_slots(World& world) {
  ForceSlots& slots = world.slots;
  const std::size_t contacts = world.joints.disc1.size() + world.contacts.disc1.size();
  for (std::vector<double>* values : {&slots.force_x, &slots.force_y, &slots.moment}) values->resize(2 * contacts);
  slots.first.assign(world.discs.x.size() + 1, 0);
  slots.slot.resize(2 * contacts);
  const auto for_each_slot = [&world](const auto& visit) {
    std::size_t slot = 0;
    for (std::size_t k = 0; k < world.joints.disc1.size(); ++k) {
      visit(static_cast<std::size_t>(world.joints.disc1[k]), slot++);
      visit(static_cast<std::size_t>(world.joints.disc2[k]), slot++);
    }
    for (std::size_t k = 0; k < world.contacts.disc1.size(); ++k) {
      visit(static_cast<std::size_t>(world.contacts.disc1[k]), slot++);
      visit(static_cast<std::size_t>(world.contacts.disc2[k]), slot++);
    }
  };
  for_each_slot([&slots](std::size_t disc, std::size_t) { ++slots.first[disc + 1]; });
  for (std::size_t i = 1; i < slots.first.size(); ++i) slots.first[i] += slots.first[i - 1];
  std::vector<int> next(slots.first.begin(), slots.first.end() - 1);
  for_each_slot([&](std::size_t disc, std::size_t slot) {
    slots.slot[static_cast<std::size_t>(next[disc]++)] = static_cast<int>(slot);
  });
}

}  // namespace

void forgive_overlaps(Boundary& boundary, const Discs& discs) {
  boundary.reference_overlap.resize(discs.x.size());
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const double distance = nearest_point(boundary.shape, discs.x[i], discs.y[i]).distance;
    boundary.reference_overlap[i] = std::max(0.0, discs.radius[i] - distance);
  }
}

void prepare(World& world) {
  const Discs& discs = world.discs;
  world.skin = skin_per_radius * *std::min_element(discs.radius.begin(), discs.radius.end());
  world.fresh_cracks.assign(static_cast<std::size_t>(world.threads), {});
  // Every element can break once: with this much room, recording a crack never allocates during a step.
  const std::size_t elements = world.joints.state.size();
  world.cracks.reserve(world.cracks.size() + elements);
  for (std::vector<Crack>& fresh : world.fresh_cracks) fresh.reserve(elements);
  if (world.measure_energy) {
    world.discs.damping_loss.resize(discs.x.size(), 0.0);
    world.joints.friction_loss.resize(world.joints.disc1.size(), 0.0);
    world.joints.switching_loss.resize(world.joints.disc1.size(), 0.0);
    world.joints.breaking_loss.resize(world.joints.disc1.size(), 0.0);
  }
  world.lists_valid = false;
  refresh_neighbours(world);
}

void refresh_neighbours(World& world) {
  double moved = world.largest_displacement;
  for (const Boundary& boundary : world.boundaries) moved = std::max(moved, boundary.displaced);
  if (world.lists_valid && moved <= 0.5 * world.skin) return;
  require_finite(world);
  remove_lost_discs(world);
  if (world.discs.count() == 0) throw base::SimulationError("every disc has left the domain");
  end_finished_joints(world);
  list_contacts(world);
  list_boundary_neighbours(world);
  list_slots(world);
  world.listed_x = world.discs.x;
  world.listed_y = world.discs.y;
  world.largest_displacement = 0.0;
  world.lists_valid = true;
}

}  // namespace dem2d
