#include "dem2d/step/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/pairs.hpp"
#include "dem2d/step/removal.hpp"
#include "dem2d/step/stages.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

// Skin as a share of the smallest radius. Larger: longer lists; smaller: lists looked at more often. The result of a
// run does not depend on it, but for the instants at which finished joints are noticed.
constexpr double skin_per_radius = 0.3;

// A disc may move half the skin before it is listed anew, and a fast one as far as it gets in so many steps, but no
// farther than the smallest radius: else a single chip that flies off would make everybody look for neighbours.
constexpr double steps_of_a_fast_disc = 100.0;

// When some disc has used up its margin, those that have used this share of theirs are listed anew along with it.
constexpr double used_share = 0.5;

/// Which discs are to be listed anew. From now on they are listed where they are.
std::vector<char> mark_moved_discs(World& world, const std::vector<Handover>& freed) {
  const Discs& discs = world.discs;
  const double least = 0.5 * world.lists.skin, most = world.lists.skin / skin_per_radius;
  const std::size_t count = discs.x.size();
  std::vector<char> marked(count, world.lists.valid ? 0 : 1);
  for (const Handover& pair : freed)
    marked[static_cast<std::size_t>(pair.disc1)] = marked[static_cast<std::size_t>(pair.disc2)] = 1;
  for (std::vector<double>* values : {&world.lists.listed_x, &world.lists.listed_y, &world.lists.listed_margin})
    values->resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double dx = discs.x[i] - world.lists.listed_x[i], dy = discs.y[i] - world.lists.listed_y[i];
    const double used = used_share * world.lists.listed_margin[i];
    if (dx * dx + dy * dy > used * used) marked[i] = 1;
    if (marked[i] == 0) continue;
    const double speed =
        std::sqrt(discs.velocity_x[i] * discs.velocity_x[i] + discs.velocity_y[i] * discs.velocity_y[i]);
    world.lists.listed_x[i] = discs.x[i];
    world.lists.listed_y[i] = discs.y[i];
    world.lists.listed_margin[i] = std::clamp(steps_of_a_fast_disc * speed * world.step, least, most);
  }
  return marked;
}

void list_joints_of_discs(World& world) {
  const FlatJoints& joints = world.joints;
  constexpr std::size_t places = JointsOfDiscs::places, each = JointsOfDiscs::places_each;
  const auto zero = static_cast<int>(joints.disc1.size());
  world.room.joint_forces.assign(joints.disc1.size() + 1, {});
  JointsOfDiscs& lists = world.lists.joints_of_discs;
  lists.joint.assign(places * world.discs.x.size(), zero);
  lists.more.clear();
  const auto enter = [&](int disc, std::size_t joint, bool as_disc1) {
    int* const begin = &lists.joint[places * static_cast<std::size_t>(disc) + (as_disc1 ? 0 : each)];
    int* const place = std::find(begin, begin + each, zero);
    if (place != begin + each) {
      *place = static_cast<int>(joint);
    } else {
      lists.more.push_back({disc, static_cast<int>(joint), as_disc1});
    }
  };
  for (std::size_t k = 0; k < joints.disc1.size(); ++k) {
    enter(joints.disc1[k], k, true);
    enter(joints.disc2[k], k, false);
  }
  std::stable_sort(lists.more.begin(), lists.more.end(),
                   [](const JointsOfDiscs::Entry& a, const JointsOfDiscs::Entry& b) { return a.disc < b.disc; });
}

bool are_joined(const World& world, int i, int j) {
  const FlatJoints& joints = world.joints;
  const auto is_it = [&joints, i, j](int joint) {
    const auto k = static_cast<std::size_t>(joint);
    return k < joints.disc1.size() && std::minmax(joints.disc1[k], joints.disc2[k]) == std::minmax(i, j);
  };
  const JointsOfDiscs& lists = world.lists.joints_of_discs;
  const auto begin = lists.joint.begin() + static_cast<std::ptrdiff_t>(JointsOfDiscs::places) * i;
  return std::any_of(begin, begin + JointsOfDiscs::places, is_it) ||
         std::any_of(lists.more.begin(), lists.more.end(), [&is_it](const auto& entry) { return is_it(entry.joint); });
}

/// What a contact brings along.
struct History {
  double spring = 0.0, reference_overlap = 0.0;
  char touching = 0;
  double last_normal_dashpot = 0.0, last_shear_dashpot = 0.0;
};

History history_of(const LinearContacts& contacts, std::size_t place) {
  History history{contacts.spring[place], contacts.reference_overlap[place], contacts.touching[place]};
  if (!contacts.last_normal_dashpot.empty()) {
    history.last_normal_dashpot = contacts.last_normal_dashpot[place];
    history.last_shear_dashpot = contacts.last_shear_dashpot[place];
  }
  return history;
}

/// Of a pair that was on no list: that of the joint it had until now, or none.
History history_of(const std::vector<Handover>& handovers, const std::pair<int, int>& discs) {
  const auto before = [](const Handover& a, const std::pair<int, int>& b) { return std::pair(a.disc1, a.disc2) < b; };
  const auto found = std::lower_bound(handovers.begin(), handovers.end(), discs, before);
  if (found == handovers.end() || std::pair(found->disc1, found->disc2) != discs) return {};
  return {found->spring, found->reference_overlap, static_cast<char>(found->touching ? 1 : 0)};
}

void add_contact(World& world, LinearContacts& to, int i, int j, const History& history) {
  const Discs& discs = world.discs;
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const double kn = linear_normal_stiffness(world.materials.contact_modulus, discs.radius[a], discs.radius[b]);
  const double reduced_mass = discs.mass[a] * discs.mass[b] / (discs.mass[a] + discs.mass[b]);
  to.disc1.push_back(i);
  to.disc2.push_back(j);
  to.normal_stiffness.push_back(kn);
  to.dashpot.push_back(dashpot_constant(world.materials.contact_damping_ratio, reduced_mass, kn));
  to.shear_dashpot.push_back(dashpot_constant(world.materials.contact_shear_damping_ratio, reduced_mass,
                                              kn / world.materials.contact_stiffness_ratio));
  to.spring.push_back(history.spring);
  to.reference_overlap.push_back(history.reference_overlap);
  to.touching.push_back(history.touching);
  if (!world.ledger.measured) return;
  to.last_normal_dashpot.push_back(history.last_normal_dashpot);
  to.last_shear_dashpot.push_back(history.last_shear_dashpot);
  to.friction_loss.push_back(0.0);
  to.dashpot_loss.push_back(0.0);
  to.switching_loss.push_back(0.0);
}

/// Pairs of discs that are not marked stay; those with a marked disc are found anew.
void list_contacts(World& world, const std::vector<char>& marked, const std::vector<Handover>& handovers) {
  std::vector<double> reach = world.discs.radius;
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] += world.lists.listed_margin[i];
  const Pairs found = marked_pairs(world.lists.listed_x, world.lists.listed_y, reach, marked);
  book_contact_losses(world);
  const LinearContacts& old = world.contacts;
  LinearContacts fresh;
  const auto pair = [](const auto& list, std::size_t k) {
    return k < list.disc1.size() ? std::pair(list.disc1[k], list.disc2[k])
                                 : std::pair(std::numeric_limits<int>::max(), 0);
  };
  std::size_t place = 0, k = 0;  // both lists are sorted by (disc1, disc2): one pass merges them
  while (place < old.disc1.size() || k < found.disc1.size()) {
    const auto kept = pair(old, place), seen = pair(found, k);
    if (seen <= kept) {
      if (seen == kept || !are_joined(world, seen.first, seen.second)) {
        const History history = seen == kept ? history_of(old, place) : history_of(handovers, seen);
        add_contact(world, fresh, seen.first, seen.second, history);
      }
      ++k;
      if (seen == kept) ++place;
      continue;
    }
    const bool stays =
        marked[static_cast<std::size_t>(kept.first)] == 0 && marked[static_cast<std::size_t>(kept.second)] == 0;
    if (stays) add_contact(world, fresh, kept.first, kept.second, history_of(old, place));
    ++place;
  }
  world.contacts = std::move(fresh);
}

struct Box {
  double x_low, y_low, x_high, y_high;

  bool holds(double x, double y) const { return x >= x_low && x <= x_high && y >= y_low && y <= y_high; }
};

Box box_around(const ConvexPolygon& shape, double margin) {
  const auto [x_low, x_high] = std::minmax_element(shape.x.begin(), shape.x.end());
  const auto [y_low, y_high] = std::minmax_element(shape.y.begin(), shape.y.end());
  return {*x_low - margin, *y_low - margin, *x_high + margin, *y_high + margin};
}

void list_boundary_neighbours(World& world) {
  const Discs& discs = world.discs;
  const double largest_radius = *std::max_element(discs.radius.begin(), discs.radius.end());
  const double largest_margin = *std::max_element(world.lists.listed_margin.begin(), world.lists.listed_margin.end());
  for (Boundary& boundary : world.boundaries) {
    for (std::vector<double>* values :
         {&boundary.spring, &boundary.reference_overlap, &boundary.last_normal_dashpot, &boundary.last_shear_dashpot}) {
      values->resize(discs.x.size(), 0.0);
    }
    boundary.displaced = 0.0;
    const std::vector<int> old = std::move(boundary.near);
    boundary.near.clear();
    const Box box = box_around(boundary.shape, largest_radius + largest_margin + 0.5 * world.lists.skin);
    for (std::size_t i = 0; i < discs.x.size(); ++i) {
      const double x = world.lists.listed_x[i], y = world.lists.listed_y[i];
      if (!box.holds(x, y)) continue;
      if (nearest_point(boundary.shape, x, y).distance <
          discs.radius[i] + world.lists.listed_margin[i] + 0.5 * world.lists.skin) {
        boundary.near.push_back(static_cast<int>(i));
      }
    }
    for (const int disc : old) {
      if (std::binary_search(boundary.near.begin(), boundary.near.end(), disc)) continue;
      boundary.spring[static_cast<std::size_t>(disc)] = 0.0;
      boundary.reference_overlap[static_cast<std::size_t>(disc)] = 0.0;  // it comes back as a stranger
    }
    for (std::vector<double>* values :
         {&boundary.contact_force_x, &boundary.contact_force_y, &boundary.contact_moment}) {
      values->resize(boundary.near.size());
    }
  }
}

bool lists_hold(const World& world) {
  if (!world.lists.valid) return false;
  const auto moved_far = [&world](const Boundary& boundary) { return boundary.displaced > 0.5 * world.lists.skin; };
  if (std::any_of(world.boundaries.begin(), world.boundaries.end(), moved_far)) return false;
  return std::all_of(world.lists.most_strayed.begin(), world.lists.most_strayed.end(),
                     [](double s) { return s <= 0.0; });
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
  world.lists.skin = skin_per_radius * *std::min_element(discs.radius.begin(), discs.radius.end());
  world.room.fresh_cracks.assign(static_cast<std::size_t>(world.threads), {});
  world.room.slow_joints.assign(static_cast<std::size_t>(world.threads), {});
  world.lists.most_strayed.assign(static_cast<std::size_t>(world.threads), 0.0);
  // Every element can break once: with this much room, recording a crack never allocates during a step.
  const std::size_t elements = world.joints.state.size();
  world.cracks.reserve(world.cracks.size() + elements);
  for (std::vector<Crack>& fresh : world.room.fresh_cracks) fresh.reserve(elements);
  if (world.ledger.measured) {
    world.discs.damping_loss.resize(discs.x.size(), 0.0);
    world.joints.friction_loss.resize(world.joints.disc1.size(), 0.0);
    world.joints.switching_loss.resize(world.joints.disc1.size(), 0.0);
    world.joints.breaking_loss.resize(world.joints.disc1.size(), 0.0);
  }
  world.lists.valid = false;
  refresh_neighbours(world);
}

void refresh_neighbours(World& world) {
  if (lists_hold(world)) return;
  require_finite(world);
  const bool discs_left = remove_lost_discs(world);
  if (world.discs.count() == 0) throw base::SimulationError("every disc has left the domain");
  const std::vector<Handover> freed = end_finished_joints(world);
  const std::vector<char> marked = mark_moved_discs(world, freed);
  if (!world.lists.valid || discs_left || !freed.empty()) {
    list_joints_of_discs(world);
  }
  world.room.motion.resize(world.discs.x.size());
  list_contacts(world, marked, freed);
  world.room.contact_forces.assign(world.contacts.disc1.size(), {});
  list_boundary_neighbours(world);
  std::fill(world.lists.most_strayed.begin(), world.lists.most_strayed.end(), 0.0);
  world.lists.valid = true;
  ++world.lists.version;
}

}  // namespace bitrock::dem2d
