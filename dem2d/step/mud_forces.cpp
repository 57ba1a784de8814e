// What the mud does to the discs (fluid/mud.hpp), and when its faces are looked at anew.
#include <fmt/format.h>

#include <utility>

#include "base/errors.hpp"
#include "dem2d/step/pair_motion.hpp"
#include "dem2d/step/stages.hpp"

namespace bitrock::dem2d {

namespace {

// Faces are found anew with the neighbour lists, and at latest after so many steps: a crack that opens at 1 m/s gets no
// wider than a fiftieth of a radius in that time. A look costs about one step.
constexpr int steps_between_looks = 16;

/// Bonds, and cracks that are narrower than the seal gap at their middle; and closed contacts of debris, measured from
/// where they carry no force, as the joint they took over from was.
void list_seals(const World& world, Mud& mud) {
  mud.disc1.clear();
  mud.disc2.clear();
  const auto add = [&mud](int a, int b) {
    mud.disc1.push_back(a);
    mud.disc2.push_back(b);
  };
  const auto distance = [&discs = world.discs](int a, int b) {
    return centre_distance(discs, static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  };
  const FlatJoints& joints = world.joints;
  for (std::size_t j = 0; j < joints.disc1.size(); ++j) {
    const int a = joints.disc1[j], b = joints.disc2[j];
    if (joints.bonded[j] > 0 || distance(a, b) - joints.touching_distance[j] < mud.seal_gap) add(a, b);
  }
  if (!mud.debris_seals) return;
  const LinearContacts& contacts = world.contacts;
  for (std::size_t c = 0; c < contacts.disc1.size(); ++c) {
    const int a = contacts.disc1[c], b = contacts.disc2[c];
    const double touching = world.discs.radius[static_cast<std::size_t>(a)] +
                            world.discs.radius[static_cast<std::size_t>(b)] - contacts.reference_overlap[c];
    if (distance(a, b) - touching < mud.seal_gap) add(a, b);
  }
}

/// Which discs touch a boundary that seals.
void list_sealed(const World& world, Mud& mud) {
  mud.sealed.resize(world.boundaries.size());
  for (std::size_t k = 0; k < world.boundaries.size(); ++k) {
    const Boundary& boundary = world.boundaries[k];
    mud.sealed[k].clear();
    if (!boundary.seals) continue;
    mud.sealed[k].assign(world.discs.x.size(), 0);
    for (const int disc : boundary.near) {
      const auto i = static_cast<std::size_t>(disc);
      const double gap = nearest_point(boundary.shape, world.discs.x[i], world.discs.y[i]).distance -
                         world.discs.radius[i] + boundary.reference_overlap[i];
      mud.sealed[k][i] = gap < mud.seal_gap ? 1 : 0;
    }
  }
}

/// The boundary that keeps the mud from the side between two discs, or none.
Boundary* that_seals(World& world, int a, int b) {
  for (std::size_t k = 0; k < world.boundaries.size(); ++k) {
    const std::vector<char>& sealed = world.mud.sealed[k];
    if (!sealed.empty() && sealed[static_cast<std::size_t>(a)] != 0 && sealed[static_cast<std::size_t>(b)] != 0)
      return &world.boundaries[k];
  }
  return nullptr;
}

/// A crumb whose edges cross is left out; rock that the mud no longer presses on is another problem.
void refuse_crossings(const World& world) {
  constexpr double most_share = 0.05;  // of all stops
  const OuterFaces& faces = world.mud.faces;
  const double stops = static_cast<double>(faces.stops.size()) + faces.crossing_stops;
  if (faces.crossing_stops <= most_share * stops) return;
  throw base::SimulationError(fmt::format(
      "at t = {:.6g} s the mud does not find its way around {:.2g} % of the rock's faces: edges between discs "
      "cross there (a smaller fluid.seal_gap_over_radius makes fewer edges)",
      world.time, 100.0 * faces.crossing_stops / stops));
}

struct Vector {
  double x, y;
};

/// p/2 perp(b - a): on each of two neighbours of an outer face.
Vector half_side(const World& world, int a, int b) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  const double half = 0.5 * world.mud.pressure;
  return {-half * (world.discs.y[j] - world.discs.y[i]), half * (world.discs.x[j] - world.discs.x[i])};
}

/// Half of a step's work of the forces as they were found last, at the velocities that the discs have now.
void book_half_step(World& world) {
  const Discs& discs = world.discs;
  Mud& mud = world.mud;
  double power = 0.0;
  for (std::size_t k = 0; k < mud.faces.stops.size(); ++k) {
    const auto i = static_cast<std::size_t>(mud.faces.stops[k].disc);
    power += mud.force_x[k] * discs.velocity_x[i] + mud.force_y[k] * discs.velocity_y[i];
  }
  mud.work += 0.5 * power * world.step;
}

bool any_boundary_seals(const World& world) {
  for (const Boundary& boundary : world.boundaries) {
    if (boundary.seals) return true;
  }
  return false;
}

}  // namespace

void refresh_mud(World& world) {
  Mud& mud = world.mud;
  if (mud.pressure == 0.0) return;
  if (mud.lists_version == world.lists.version && ++mud.steps < steps_between_looks) return;
  list_seals(world, mud);
  list_sealed(world, mud);
  find_outer_faces(world.discs.x, world.discs.y, mud.disc1, mud.disc2, mud.search, mud.faces);
  refuse_crossings(world);
  mud.force_x.resize(mud.faces.stops.size());
  mud.force_y.resize(mud.faces.stops.size());
  mud.lists_version = world.lists.version;
  mud.steps = 0;
}

void mud_forces(World& world) {
  Mud& mud = world.mud;
  if (mud.pressure == 0.0) return;
  const bool seals = any_boundary_seals(world);
  for (Boundary& boundary : world.boundaries) boundary.mud_x = boundary.mud_y = 0.0;
  for (std::size_t k = 0; k < mud.faces.stops.size(); ++k) {
    const FaceStop& stop = mud.faces.stops[k];
    Vector force = half_side(world, stop.before, stop.after);
    if (seals) {
      for (const auto& [a, b] : {std::pair(stop.before, stop.disc), std::pair(stop.disc, stop.after)}) {
        Boundary* const boundary = that_seals(world, a, b);
        if (boundary == nullptr) continue;
        const Vector missing = half_side(world, a, b);
        force = {force.x - missing.x, force.y - missing.y};
        boundary->mud_x += missing.x;
        boundary->mud_y += missing.y;
      }
    }
    mud.force_x[k] = force.x;
    mud.force_y[k] = force.y;
  }
  if (world.ledger.measured) book_half_step(world);
}

void book_mud_work(World& world) {
  if (world.mud.pressure != 0.0 && world.ledger.measured) book_half_step(world);
}

}  // namespace bitrock::dem2d
