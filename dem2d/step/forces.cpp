// The force pass: reads positions and velocities, writes only forces and each contact's own history.
#include <omp.h>

#include <bit>
#include <cmath>

#include "dem2d/step/step.hpp"

namespace dem2d {

namespace {

/// How disc 2 moves against disc 1 at their contact: n from 1 to 2, t = z x n; `lever` from centre to contact point.
struct PairMotion {
  double distance, normal_x, normal_y;
  double lever1, lever2;
  double normal_speed;  ///< opening positive [m/s]
  double shear_speed;   ///< along t [m/s]
};

/// With t = (-n_y, n_x), the velocity of disc 2's material point minus disc 1's, along t, is
/// (v2 - v1).t - w2 lever2 - w1 lever1; a rigid rotation of the pair gives zero because lever1 + lever2 = distance.
inline PairMotion pair_motion(const Discs& discs, std::size_t i, std::size_t j) {
  PairMotion motion;
  const double dx = discs.x[j] - discs.x[i], dy = discs.y[j] - discs.y[i];
  motion.distance = std::sqrt(dx * dx + dy * dy);
  motion.normal_x = dx / motion.distance;
  motion.normal_y = dy / motion.distance;
  const double gap = motion.distance - discs.radius[i] - discs.radius[j];
  motion.lever1 = discs.radius[i] + 0.5 * gap;  // the contact point is the middle of gap or overlap
  motion.lever2 = discs.radius[j] + 0.5 * gap;
  const double du = discs.velocity_x[j] - discs.velocity_x[i], dv = discs.velocity_y[j] - discs.velocity_y[i];
  motion.normal_speed = du * motion.normal_x + dv * motion.normal_y;
  motion.shear_speed =
      dv * motion.normal_x - du * motion.normal_y - discs.spin[j] * motion.lever2 - discs.spin[i] * motion.lever1;
  return motion;
}

/// Writes what a pair force does to both discs: `pull` along n and `shear` along t act on disc 1, their negatives on
/// disc 2; `moment` is the interface's own moment, minus it on disc 1.
inline void write_pair(ForceSlots& slots, std::size_t contact, const PairMotion& motion, double pull, double shear,
                       double moment) {
  const double fx = pull * motion.normal_x - shear * motion.normal_y;
  const double fy = pull * motion.normal_y + shear * motion.normal_x;
  const std::size_t slot = 2 * contact;
  slots.force_x[slot] = fx;
  slots.force_y[slot] = fy;
  slots.moment[slot] = motion.lever1 * shear - moment;
  slots.force_x[slot + 1] = -fx;
  slots.force_y[slot + 1] = -fy;
  slots.moment[slot + 1] = motion.lever2 * shear + moment;
}

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
                     .mode = static_cast<int>(joints.state[element]),
                     .disc1 = world.discs.id[i],
                     .disc2 = world.discs.id[j]});
  }
}

inline void one_joint(World& world, std::size_t joint, std::vector<Crack>& fresh) {
  FlatJoints& joints = world.joints;
  const auto i = static_cast<std::size_t>(joints.disc1[joint]), j = static_cast<std::size_t>(joints.disc2[joint]);
  const PairMotion pair = pair_motion(world.discs, i, j);
  const InterfaceMotion motion{
      .gap = pair.distance - joints.stress_free_distance[joint],
      .rotation = world.discs.angle[j] - world.discs.angle[i] - joints.stress_free_rotation[joint],
      .shear_increment = pair.shear_speed * world.step};
  joints.shear_displacement[joint] += motion.shear_increment;
  const auto first = joint * static_cast<std::size_t>(joints.elements);
  std::uint64_t broken = 0;
  const InterfaceForce force = update_flat_joint(joints.law(static_cast<int>(joint)), motion, &joints.state[first],
                                                 &joints.shear_stress[first], broken);
  if (broken != 0) {
    joints.bonded[joint] -= std::popcount(broken);
    record_cracks(fresh, world, joint, pair, broken);
  }
  write_pair(world.slots, joint, pair, force.normal, force.shear, force.moment);
}

inline void one_contact(World& world, std::size_t contact) {
  LinearContacts& contacts = world.contacts;
  const auto i = static_cast<std::size_t>(contacts.disc1[contact]),
             j = static_cast<std::size_t>(contacts.disc2[contact]);
  const std::size_t place = static_cast<std::size_t>(world.joints.count()) + contact;
  const PairMotion pair = pair_motion(world.discs, i, j);
  const double overlap = world.discs.radius[i] + world.discs.radius[j] - pair.distance;
  const LinearLaw law{.normal_stiffness = contacts.normal_stiffness[contact],
                      .shear_stiffness = contacts.normal_stiffness[contact] / world.contact_stiffness_ratio,
                      .friction = world.contact_friction,
                      .dashpot = contacts.dashpot[contact]};
  const LinearForce force = update_linear_contact(law, overlap, -pair.normal_speed, pair.shear_speed * world.step,
                                                  contacts.shear_force[contact]);
  write_pair(world.slots, place, pair, -force.normal, force.shear, 0.0);
}

/// Disc `i` against a boundary: n from the boundary to the disc, so the disc is "disc 2" and the boundary does not
/// spin.
inline void one_boundary_contact(const World& world, Boundary& boundary, std::size_t place) {
  const auto i = static_cast<std::size_t>(boundary.near[place]);
  const Discs& discs = world.discs;
  const NearestPoint point = nearest_point(boundary.shape, discs.x[i], discs.y[i]);
  const double overlap = discs.radius[i] - point.distance - boundary.reference_overlap[i];
  const double du = discs.velocity_x[i] - boundary.velocity_x, dv = discs.velocity_y[i] - boundary.velocity_y;
  const double lever = 0.5 * (discs.radius[i] + point.distance);  // to the middle of the overlap
  const double normal_speed = du * point.normal_x + dv * point.normal_y;
  const double shear_speed = dv * point.normal_x - du * point.normal_y - discs.spin[i] * lever;
  const double kn = linear_wall_stiffness(boundary.modulus);
  const LinearLaw law{.normal_stiffness = kn,
                      .shear_stiffness = kn / boundary.stiffness_ratio,
                      .friction = boundary.friction,
                      .dashpot = dashpot_constant(boundary.damping_ratio, discs.mass[i], kn)};
  const LinearForce force =
      update_linear_contact(law, overlap, -normal_speed, shear_speed * world.step, boundary.shear_force[i]);
  boundary.contact_force_x[place] = force.normal * point.normal_x + force.shear * point.normal_y;
  boundary.contact_force_y[place] = force.normal * point.normal_y - force.shear * point.normal_x;
  boundary.contact_moment[place] = lever * force.shear;
}

}  // namespace

void joint_forces(World& world) {
  const int count = world.joints.count();
#pragma omp parallel num_threads(world.threads) if (world.threads > 1)
  {
    std::vector<Crack>& fresh = world.fresh_cracks[static_cast<std::size_t>(omp_get_thread_num())];
#pragma omp for schedule(static)
    for (int joint = 0; joint < count; ++joint) one_joint(world, static_cast<std::size_t>(joint), fresh);
  }
}

void contact_forces(World& world) {
  const int count = world.contacts.count();
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static)
  for (int contact = 0; contact < count; ++contact) one_contact(world, static_cast<std::size_t>(contact));
}

void boundary_forces(World& world) {
  for (Boundary& boundary : world.boundaries) {  // few discs are near a boundary: not worth threads
    boundary.force_x = 0.0;
    boundary.force_y = 0.0;
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      one_boundary_contact(world, boundary, place);
      boundary.force_x -= boundary.contact_force_x[place];
      boundary.force_y -= boundary.contact_force_y[place];
    }
  }
}

void sum_forces(World& world) {
  Discs& discs = world.discs;
  const ForceSlots& slots = world.slots;
  const int count = discs.count();
#pragma omp parallel for num_threads(world.threads) if (world.threads > 1) schedule(static)
  for (int disc = 0; disc < count; ++disc) {
    const auto i = static_cast<std::size_t>(disc);
    double fx = 0.0, fy = 0.0, moment = 0.0;
    for (int entry = slots.first[i]; entry < slots.first[i + 1]; ++entry) {
      const auto slot = static_cast<std::size_t>(slots.slot[static_cast<std::size_t>(entry)]);
      fx += slots.force_x[slot];
      fy += slots.force_y[slot];
      moment += slots.moment[slot];
    }
    discs.force_x[i] = fx;
    discs.force_y[i] = fy;
    discs.moment[i] = moment;
  }
  for (const Boundary& boundary : world.boundaries) {
    for (std::size_t place = 0; place < boundary.near.size(); ++place) {
      const auto i = static_cast<std::size_t>(boundary.near[place]);
      discs.force_x[i] += boundary.contact_force_x[place];
      discs.force_y[i] += boundary.contact_force_y[place];
      discs.moment[i] += boundary.contact_moment[place];
    }
  }
}

}  // namespace dem2d
