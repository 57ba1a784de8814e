#include "dem2d/step/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

// Skin as a share of the smallest radius. Larger: longer lists; smaller: lists made more often. The result of a run
// does not depend on it, but for the instants at which finished joints are noticed.
constexpr double skin_per_radius = 0.3;

/// Discs sorted into square cells: `first` has one entry a cell and one more, `disc` holds the discs of each cell.
struct CellGrid {
  double x_low, y_low, size;
  int columns, rows;
  std::vector<int> first, disc;

  int column(double x) const { return std::clamp(static_cast<int>((x - x_low) / size), 0, columns - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - y_low) / size), 0, rows - 1); }
};

CellGrid sort_into_cells(const Discs& discs, double reach) {
  CellGrid grid{};
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  grid.x_low = *x_low;
  grid.y_low = *y_low;
  grid.size = reach;
  grid.columns = static_cast<int>((*x_high - *x_low) / reach) + 1;
  grid.rows = static_cast<int>((*y_high - *y_low) / reach) + 1;
  const auto cell_of = [&](std::size_t i) {
    return static_cast<std::size_t>(grid.row(discs.y[i]) * grid.columns + grid.column(discs.x[i]));
  };
  grid.first.assign(static_cast<std::size_t>(grid.columns * grid.rows) + 1, 0);
  for (std::size_t i = 0; i < discs.x.size(); ++i) ++grid.first[cell_of(i) + 1];
  for (std::size_t c = 1; c < grid.first.size(); ++c) grid.first[c] += grid.first[c - 1];
  grid.disc.resize(discs.x.size());
  std::vector<int> next(grid.first.begin(), grid.first.end() - 1);
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    grid.disc[static_cast<std::size_t>(next[cell_of(i)]++)] = static_cast<int>(i);
  }
  return grid;
}

/// Keeps the entries whose flag is set, in order.
template <class T>
void keep(std::vector<T>& values, const std::vector<char>& flags, std::size_t entries_each = 1) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == 0) continue;
    for (std::size_t e = 0; e < entries_each; ++e) values[kept * entries_each + e] = values[i * entries_each + e];
    ++kept;
  }
  values.resize(kept * entries_each);
}

void keep_joints(FlatJoints& joints, const std::vector<char>& flags) {
  keep(joints.disc1, flags);
  keep(joints.disc2, flags);
  keep(joints.bonded, flags);
  for (std::vector<double>* values :
       {&joints.half_length, &joints.normal_stiffness, &joints.shear_stiffness, &joints.tensile_strength,
        &joints.cohesion, &joints.tan_friction_angle, &joints.friction, &joints.stress_free_distance,
        &joints.stress_free_rotation, &joints.shear_displacement}) {
    keep(*values, flags);
  }
  keep(joints.shear_stress, flags, static_cast<std::size_t>(joints.elements));
  keep(joints.state, flags, static_cast<std::size_t>(joints.elements));
}

void keep_contacts(LinearContacts& contacts, const std::vector<char>& flags) {
  keep(contacts.disc1, flags);
  keep(contacts.disc2, flags);
  keep(contacts.normal_stiffness, flags);
  keep(contacts.dashpot, flags);
  keep(contacts.shear_force, flags);
}

/// Where the two discs of a joint are to each other.
struct JointGeometry {
  double distance;  ///< between centres [m]
  double overlap;   ///< of the discs, negative when apart [m]
  double opening;   ///< of the faces at their middle [m]
  double rotation;  ///< [rad]
};

JointGeometry joint_geometry(const World& world, std::size_t joint) {
  const FlatJoints& joints = world.joints;
  const Discs& d = world.discs;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const double distance = std::hypot(d.x[j] - d.x[i], d.y[j] - d.y[i]);
  return {.distance = distance,
          .overlap = d.radius[i] + d.radius[j] - distance,
          .opening = distance - joints.stress_free_distance[joint],
          .rotation = d.angle[j] - d.angle[i] - joints.stress_free_rotation[joint]};
}

bool joint_is_over(const World& world, std::size_t joint) {
  const FlatJoints& joints = world.joints;
  if (joints.bonded[joint] > 0) return false;
  const JointGeometry now = joint_geometry(world, joint);
  const double half = joints.half_length[joint];
  if (std::fabs(joints.shear_displacement[joint]) > 2.0 * half || now.opening > 2.0 * half) return true;
  const bool open_everywhere = now.opening - std::fabs(now.rotation) * half > 0.0;
  return open_everywhere && -now.overlap > world.skin;
}

/// Elastic energy in a joint [J/m].
double joint_energy(const World& world, std::size_t joint) {
  const JointGeometry now = joint_geometry(world, joint);
  const FlatJointLaw law = world.joints.law(static_cast<int>(joint));
  const double length = 2.0 * law.half_length / law.elements;
  double energy = 0.0;
  for (int e = 0; e < law.elements; ++e) {
    const double start = -law.half_length + length * e;
    const auto element = joint * static_cast<std::size_t>(law.elements) + static_cast<std::size_t>(e);
    energy +=
        stored_energy(law, length, now.opening - now.rotation * start, now.opening - now.rotation * (start + length),
                      world.joints.state[element], world.joints.shear_stress[element]);
  }
  return energy;
}

/// Elastic energy that the linear contact of two discs starts with when it takes over from a joint [J/m].
double contact_energy(const World& world, std::size_t joint) {
  const double overlap = joint_geometry(world, joint).overlap;
  if (overlap <= 0.0) return 0.0;
  const Discs& d = world.discs;
  const auto i = static_cast<std::size_t>(world.joints.disc1[joint]),
             j = static_cast<std::size_t>(world.joints.disc2[joint]);
  return 0.5 * linear_normal_stiffness(world.contact_modulus, d.radius[i], d.radius[j]) * overlap * overlap;
}

void end_finished_joints(World& world) {
  std::vector<char> stays(world.joints.disc1.size(), 1);
  bool any_over = false;
  for (std::size_t joint = 0; joint < stays.size(); ++joint) {
    if (!joint_is_over(world, joint)) continue;
    stays[joint] = 0;
    any_over = true;
    world.injected_energy += contact_energy(world, joint) - joint_energy(world, joint);
  }
  if (any_over) keep_joints(world.joints, stays);
}

void remove_lost_discs(World& world) {
  Discs& discs = world.discs;
  const Domain& box = world.domain;
  std::vector<char> stays(discs.x.size(), 1);
  std::vector<int> renumbered(discs.x.size(), -1);
  int kept = 0;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    // NaN counts as staying, so that require_finite reports it instead of a disc silently vanishing.
    const bool lost =
        discs.x[i] < box.x_low || discs.x[i] > box.x_high || discs.y[i] < box.y_low || discs.y[i] > box.y_high;
    stays[i] = lost ? 0 : 1;
    if (!lost) renumbered[i] = kept++;
  }
  if (kept == discs.count()) return;
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
  keep_joints(world.joints, both_stay(world.joints.disc1, world.joints.disc2));
  keep_contacts(world.contacts, both_stay(world.contacts.disc1, world.contacts.disc2));
  for (std::vector<int>* indices :
       {&world.joints.disc1, &world.joints.disc2, &world.contacts.disc1, &world.contacts.disc2}) {
    renumber(*indices);
  }
  for (Boundary& boundary : world.boundaries) {
    keep(boundary.shear_force, stays);
    keep(boundary.reference_overlap, stays);
  }
  keep(discs.id, stays);
  for (std::vector<double>* values :
       {&discs.x, &discs.y, &discs.angle, &discs.velocity_x, &discs.velocity_y, &discs.spin, &discs.force_x,
        &discs.force_y, &discs.moment, &discs.radius, &discs.mass, &discs.inertia, &world.listed_x, &world.listed_y}) {
    keep(*values, stays);
  }
}

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
    fresh.shear_force.push_back(known ? old.shear_force[cursor] : 0.0);
  }
  world.contacts = std::move(fresh);
}

void list_boundary_neighbours(World& world) {
  const Discs& discs = world.discs;
  for (Boundary& boundary : world.boundaries) {
    boundary.shear_force.resize(discs.x.size(), 0.0);
    boundary.reference_overlap.resize(discs.x.size(), 0.0);
    boundary.displaced = 0.0;
    boundary.near.clear();
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
      const NearestPoint point = nearest_point(boundary.shape, discs.x[i], discs.y[i]);
      if (point.distance < discs.radius[i] + world.skin) {
        boundary.near.push_back(static_cast<int>(i));
      } else {
        boundary.shear_force[i] = 0.0;
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

Pairs pairs_within(const Discs& discs, double gap) {
  Pairs pairs;
  if (discs.x.empty()) return pairs;
  const double largest = *std::max_element(discs.radius.begin(), discs.radius.end());
  const CellGrid grid = sort_into_cells(discs, 2.0 * largest + gap);
  std::vector<int> found;
  for (int i = 0; i < discs.count(); ++i) {
    const auto a = static_cast<std::size_t>(i);
    found.clear();
    const int column = grid.column(discs.x[a]), row = grid.row(discs.y[a]);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r) {
      // the three cells of one row are neighbours in memory
      const auto left = static_cast<std::size_t>(r * grid.columns + std::max(column - 1, 0));
      const auto right = static_cast<std::size_t>(r * grid.columns + std::min(column + 1, grid.columns - 1));
      for (int entry = grid.first[left]; entry < grid.first[right + 1]; ++entry) {
        const int j = grid.disc[static_cast<std::size_t>(entry)];
        if (j <= i) continue;
        const auto b = static_cast<std::size_t>(j);
        const double dx = discs.x[b] - discs.x[a], dy = discs.y[b] - discs.y[a];
        const double reach = discs.radius[a] + discs.radius[b] + gap;
        if (dx * dx + dy * dy <= reach * reach) found.push_back(j);
      }
    }
    std::sort(found.begin(), found.end());
    for (const int j : found) {
      pairs.disc1.push_back(i);
      pairs.disc2.push_back(j);
    }
  }
  return pairs;
}

void add_joint(World& world, int disc1, int disc2, const JointProperties& properties) {
  FlatJoints& joints = world.joints;
  const Discs& discs = world.discs;
  const auto i = static_cast<std::size_t>(disc1), j = static_cast<std::size_t>(disc2);
  const double kn = properties.modulus / (discs.radius[i] + discs.radius[j]);
  joints.disc1.push_back(disc1);
  joints.disc2.push_back(disc2);
  joints.half_length.push_back(properties.radius_multiplier * std::min(discs.radius[i], discs.radius[j]));
  joints.normal_stiffness.push_back(kn);
  joints.shear_stiffness.push_back(kn / properties.stiffness_ratio);
  joints.tensile_strength.push_back(properties.tensile_strength);
  joints.cohesion.push_back(properties.cohesion);
  joints.tan_friction_angle.push_back(std::tan(properties.friction_angle));
  joints.friction.push_back(properties.friction);
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  joints.stress_free_distance.push_back(std::sqrt(dx * dx + dy * dy));  // rounds as in the force pass: gap exactly 0
  joints.stress_free_rotation.push_back(discs.angle[j] - discs.angle[i]);
  joints.shear_displacement.push_back(0.0);
  joints.bonded.push_back(joints.elements);
  joints.shear_stress.insert(joints.shear_stress.end(), static_cast<std::size_t>(joints.elements), 0.0);
  joints.state.insert(joints.state.end(), static_cast<std::size_t>(joints.elements), ElementState::bonded);
}

void prepare(World& world) {
  const Discs& discs = world.discs;
  world.skin = skin_per_radius * *std::min_element(discs.radius.begin(), discs.radius.end());
  world.fresh_cracks.assign(static_cast<std::size_t>(world.threads), {});
  // Every element can break once: with this much room, recording a crack never allocates during a step.
  const std::size_t elements = world.joints.state.size();
  world.cracks.reserve(world.cracks.size() + elements);
  for (std::vector<Crack>& fresh : world.fresh_cracks) fresh.reserve(elements);
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
