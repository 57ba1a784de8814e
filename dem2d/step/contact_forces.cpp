// Linear contacts of loose discs, and of discs with boundaries.
#include <algorithm>
#include <cmath>

#include "dem2d/step/pair_motion.hpp"
#include "dem2d/step/stages.hpp"

namespace bitrock::dem2d {

namespace {

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
  const Discs& discs = world.discs;
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  const double reach = discs.radius[i] + discs.radius[j] - contacts.reference_overlap[contact];
  // Most stay apart: their force is zero already.
  if (contacts.touching[contact] == 0 && dx * dx + dy * dy >= reach * reach) return;
  const PairMotion pair = pair_motion(discs, i, j);
  const double overlap = reach - pair.distance;
  contacts.touching[contact] = overlap > 0.0 ? 1 : 0;
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
  world.room.contact_forces[contact] = pair_force(pair, -force.normal, force.shear, 0.0);
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
    world.ledger.accounts.friction += loss.friction;
    world.ledger.accounts.dashpots += loss.dashpots;
    world.ledger.accounts.switching += loss.switching;
  }
  boundary.contact_force_x[place] = force.normal * point.normal_x + force.shear * point.normal_y;
  boundary.contact_force_y[place] = force.normal * point.normal_y - force.shear * point.normal_x;
  boundary.contact_moment[place] = lever * force.shear;
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

void contact_forces(World& world, const Share& share) {
  const Range range = part_of(world.contacts.disc1.size(), share);
  for (std::size_t contact = range.begin; contact < range.end; ++contact) {
    world.ledger.measured ? one_contact<true>(world, contact) : one_contact<false>(world, contact);
  }
}

void boundary_forces(World& world) {
  world.ledger.measured ? all_boundary_contacts<true>(world) : all_boundary_contacts<false>(world);
}

}  // namespace bitrock::dem2d
