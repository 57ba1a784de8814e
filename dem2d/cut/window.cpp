#include "dem2d/cut/window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "dem2d/specimen/grading.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/removal.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

// The window moves on by so many columns at a time: lists are made anew then, so not too often.
constexpr double columns_at_a_time = 2.0;

int place_in_bed(const Window& window, int id) {
  return window.place_in_bed[static_cast<std::size_t>(id)];
}

void append_disc(Discs& to, const Discs& from, std::size_t disc) {
  to.id.push_back(from.id[disc]);
  const auto target = number_arrays(to);
  const auto source = number_arrays(from);
  for (std::size_t k = 0; k < target.size(); ++k) {
    if (!source[k]->empty()) target[k]->push_back((*source[k])[disc]);
  }
}

void append_joint(FlatJoints& to, const FlatJoints& from, std::size_t joint, int disc1, int disc2) {
  const auto target = number_arrays(to);
  const auto source = number_arrays(from);
  for (std::size_t k = 0; k < target.size(); ++k) {
    if (!source[k]->empty()) target[k]->push_back((*source[k])[joint]);
  }
  to.disc1.push_back(disc1);
  to.disc2.push_back(disc2);
  to.bonded.push_back(from.bonded[joint]);
  if (!from.softened.empty()) to.softened.push_back(from.softened[joint]);
  const auto elements = static_cast<std::size_t>(from.elements);
  for (std::size_t element = joint * elements; element < (joint + 1) * elements; ++element) {
    to.element_shear_stress.push_back(from.element_shear_stress[element]);
    to.state.push_back(from.state[element]);
    if (!from.element_opening.empty()) to.element_opening.push_back(from.element_opening[element]);
  }
}

/// Rock below `high` that has not entered yet enters. A joint to a disc that has left its place is never made: it would
/// enter torn, with the energy of that. What the others are strained by where they enter is booked as injected.
void let_in(Window& window, World& world, double high) {
  const Discs& rock = window.bed.discs;
  for (; window.entered_discs < rock.x.size() && rock.x[window.entered_discs] < high; ++window.entered_discs) {
    append_disc(world.discs, rock, window.entered_discs);
  }
  std::vector<int> place(rock.x.size(), -1);  // in the world, by place in the bed
  for (std::size_t i = 0; i < world.discs.x.size(); ++i) {
    place[static_cast<std::size_t>(place_in_bed(window, world.discs.id[i]))] = static_cast<int>(i);
  }
  const FlatJoints& joints = window.bed.joints;
  std::vector<std::size_t> entering;
  for (; window.entered_joints < window.joint_order.size(); ++window.entered_joints) {
    const std::size_t joint = window.joint_order[window.entered_joints];
    if (static_cast<std::size_t>(joints.disc2[joint]) >= window.entered_discs) break;
    entering.push_back(joint);
  }
  std::sort(entering.begin(), entering.end());  // as in the bed: by their first disc
  for (const std::size_t joint : entering) {
    const int disc1 = place[static_cast<std::size_t>(joints.disc1[joint])];
    const int disc2 = place[static_cast<std::size_t>(joints.disc2[joint])];
    const auto stands = [&](int disc) {
      return disc >= 0 && is_in_its_place(window, world.discs, static_cast<std::size_t>(disc));
    };
    if (!stands(disc1) || !stands(disc2)) continue;
    append_joint(world.joints, joints, joint, disc1, disc2);
    if (!world.ledger.measured) continue;
    const double in_bed = joint_energy(window.bed, joint);  // 0 without mud
    world.ledger.accounts.entered += in_bed;
    world.ledger.accounts.injected += joint_energy(world, world.joints.disc1.size() - 1) - in_bed;
  }
}

/// What is behind the new low end leaves and is remembered. What lies loose at the old high end or beyond leaves, too:
/// there was no rock to stop it, and rock that enters would be laid over it.
void let_go(Window& window, World& world, double old_high) {
  const Discs& discs = world.discs;
  std::vector<char> stays(discs.x.size(), 1);
  for (std::size_t i = 0; i < stays.size(); ++i) {
    const bool is_behind = discs.x[i] < window.low;
    const bool is_loose_ahead = discs.x[i] > old_high - window.column && !is_in_its_place(window, discs, i);
    if (is_behind) append_disc(window.left_behind, discs, i);
    if (is_behind || is_loose_ahead) stays[i] = 0;
  }
  remove_discs(world, stays);
}

/// Holds the outermost columns as far as their discs are where they were made, and the discs that the bed holds; lets
/// the others go.
void hold_ends(const Window& window, World& world) {
  Discs& discs = world.discs;
  const Discs& rock = window.bed.discs;
  const bool cut_behind = window.low > 0.0, cut_ahead = window.entered_discs < rock.x.size();
  const double low = window.low + window.column, high = window.high - window.column;
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const auto made = static_cast<std::size_t>(place_in_bed(window, discs.id[i]));
    const bool at_an_end = (cut_behind && discs.x[i] < low) || (cut_ahead && discs.x[i] > high);
    if (rock.inverse_mass[made] == 0.0 || (at_an_end && is_in_its_place(window, discs, i))) {
      world.ledger.accounts.removed += hold(discs, i);
    } else {
      release(discs, i);
    }
  }
}

double whole_columns(const Window& window, double x) {
  return std::floor(x / window.column) * window.column;
}

}  // namespace

double moving_length(const CutCase& cut) {
  if (cut.moving_ahead == 0.0 || cut.moving_behind == 0.0) return cut.bed_length;
  const double column = 2.0 * largest_radius(cut.rock, cut.bed_height);
  // the window moves on in steps, so it is longer now and then
  return std::min(cut.bed_length, cut.moving_ahead + cut.moving_behind + (columns_at_a_time + 1.0) * column);
}

bool is_in_its_place(const Window& window, const Discs& discs, std::size_t disc) {
  const Discs& rock = window.bed.discs;
  const auto made = static_cast<std::size_t>(place_in_bed(window, discs.id[disc]));
  return std::hypot(discs.x[disc] - rock.x[made], discs.y[disc] - rock.y[made]) < 0.5 * discs.radius[disc];
}

double hold(Discs& discs, std::size_t disc) {
  const double vx = discs.velocity_x[disc], vy = discs.velocity_y[disc], spin = discs.spin[disc];
  for (std::vector<double>* zero :
       {&discs.inverse_mass, &discs.inverse_inertia, &discs.velocity_x, &discs.velocity_y, &discs.spin}) {
    (*zero)[disc] = 0.0;
  }
  return 0.5 * (discs.mass[disc] * (vx * vx + vy * vy) + discs.inertia[disc] * spin * spin);
}

void release(Discs& discs, std::size_t disc) {
  set_mass(discs, disc, discs.mass[disc], discs.inertia[disc]);
}

AtTheDoor at_the_door(const Window& window, const Discs& discs) {
  constexpr double columns_of_the_door = 2.0;
  const double from = window.high - columns_of_the_door * window.column;
  AtTheDoor found = AtTheDoor::nothing;
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    if (!(discs.x[i] > from) || is_in_its_place(window, discs, i)) continue;
    const double made_x = window.bed.discs.x[static_cast<std::size_t>(place_in_bed(window, discs.id[i]))];
    if (made_x > from) return AtTheDoor::displaced_rock;
    found = AtTheDoor::debris;
  }
  return found;
}

Window open_window(World& world, const CutCase& cut, double tip_x) {
  const auto or_all = [](double length) { return length > 0.0 ? length : std::numeric_limits<double>::infinity(); };
  Window window{.bed = world,
                .column = column_width(world.discs),
                .ahead = or_all(cut.moving_ahead),
                .behind = or_all(cut.moving_behind)};
  const Discs& rock = window.bed.discs;
  window.place_in_bed.resize(rock.id.size());
  for (std::size_t i = 0; i < rock.id.size(); ++i)
    window.place_in_bed[static_cast<std::size_t>(rock.id[i])] = static_cast<int>(i);
  const std::vector<int>& higher = window.bed.joints.disc2;
  window.joint_order.resize(higher.size());
  std::iota(window.joint_order.begin(), window.joint_order.end(), std::size_t{0});
  std::stable_sort(window.joint_order.begin(), window.joint_order.end(),
                   [&higher](std::size_t a, std::size_t b) { return higher[a] < higher[b]; });
  world.discs = {};
  world.joints = {.elements = world.joints.elements,
                  .residual_cohesion = world.joints.residual_cohesion,
                  .drop_to_residual = world.joints.drop_to_residual,
                  .tension_softening = world.joints.tension_softening};
  world.contacts = {};
  for (std::vector<double>* values : {&world.lists.listed_x, &world.lists.listed_y, &world.lists.listed_margin})
    values->clear();
  for (Boundary& boundary : world.boundaries) boundary.near.clear();
  window.low = window.high = -std::numeric_limits<double>::infinity();
  advance_window(window, world, tip_x);
  return window;
}

void advance_window(Window& window, World& world, double tip_x) {
  const double high = whole_columns(window, tip_x + window.ahead) + columns_at_a_time * window.column;
  const double low = whole_columns(window, tip_x - window.behind);
  const bool all_is_there = window.entered_discs == window.bed.discs.x.size() && low <= 0.0;
  const double stride = columns_at_a_time * window.column;
  const bool has_moved_on = std::isfinite(high) ? high >= window.high + stride : low >= window.low + stride;
  if (all_is_there || (window.entered_discs > 0 && !has_moved_on)) return;
  const double old_high = window.high;
  window.high = high;
  window.low = low;
  const bool presses = world.ledger.measured && world.mud.pressure > 0.0;
  if (window.entered_discs > 0) let_go(window, world, old_high);
  const double contacts_before = presses ? contact_strain(world) : 0.0;
  world.domain.x_low = std::max(world.domain.x_low, window.low);
  world.room.joint_forces.clear();  // of the last step, in the numbers of then
  world.room.contact_forces.clear();
  let_in(window, world, high);
  hold_ends(window, world);
  prepare(world);
  if (presses) world.ledger.accounts.entered += contact_strain(world) - contacts_before;
}

}  // namespace bitrock::dem2d
