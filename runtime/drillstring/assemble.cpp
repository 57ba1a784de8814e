#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "runtime/drillstring/drill_case.hpp"
#include "runtime/laws/bit_inertia.hpp"
#include "runtime/laws/hydraulic_force.hpp"

namespace bitrock::runtime {

namespace {

constexpr double ms = 1e-3;

/// Lists as a file gives them, with the missing first spring and wall dampings.
Chain completed(Chain chain) {
  if (chain.size() == 0) return chain;
  if (chain.stiffness.size() + 1 == chain.size()) {
    chain.stiffness.insert(chain.stiffness.begin(), 0.0);
    chain.damping.insert(chain.damping.begin(), 0.0);
  }
  chain.wall_damping.resize(chain.size(), 0.0);
  return chain;
}

double mean_radius(const Bit& bit) {
  double sum = 0.0;
  for (const Cutter& cutter : bit.cutters) sum += cutter.radius;
  return sum / static_cast<double>(bit.cutters.size());
}

/// `control`: its inertia, and the spring and damper to what drives it. `ground` [N m s/rad].
void put_drive_on_top(Chain& chain, const DriveControl& control, double ground) {
  chain.inertia.insert(chain.inertia.begin(), control.inertia);
  chain.stiffness.insert(chain.stiffness.begin(), control.stiffness);
  chain.damping.insert(chain.damping.begin(), control.damping);
  chain.wall_damping.insert(chain.wall_damping.begin(), ground);
}

/// Steepest positive slope of the friction at the bit [N m s/rad]: it acts like a damper on the step.
double steepest_friction(const DrillString& string, double weight) {
  if (string.bit.friction.law != FrictionLaw::smooth) return 0.0;
  return weight * string.bit.friction_radius * friction_slope(string.bit.friction.smooth, 0.0);
}

BitSupport torsional_support(const DrillString& string) {
  return {.stiffness = string.bit.fracture_stiffness,
          .damping = steepest_friction(string, static_weight_on_bit(string))};
}

/// Masses [kg], inertias [kg m2] and stiffnesses whose ratios a solver can handle. A free chain has a spring of 0.
void require_sensible(const std::string& name, const char* direction, const Chain& chain) {
  constexpr double smallest = 1e-9, largest = 1e18;
  const auto check = [&](const char* what, double value) {
    if (value >= smallest && value <= largest) return;
    throw base::InputError(fmt::format("{}: a lump of the {} chain has the {} {:g} (must be from {:g} to {:g}, SI)",
                                       name, direction, what, value, smallest, largest));
  };
  for (const double inertia : chain.inertia) check("inertia", inertia);
  for (const double stiffness : chain.stiffness) {
    if (stiffness != 0.0) check("stiffness", stiffness);
  }
}

/// The hoist of the case: gains of an autodriller by the string, and where the rock of a steady feed is in balance.
Hoist hoist_of(const DrillCase& drill, DrillString string) {
  Hoist& hoist = string.hoist;
  hoist = drill.hoist;
  if (!drill.pipes.empty()) {  // in a row with the line; its damper takes as much of a slow motion as it did
    hoist.stiffness =
        1.0 / (1.0 / drill.hoist.stiffness + compliance_above(drill.pipes, drill.axial_lumps, drill.lumping));
    const double share = hoist.stiffness / drill.hoist.stiffness;
    hoist.damping *= share * share;
  }
  if (hoist.rule == HoistRule::autodriller)
    hoist.autodriller =
        autodriller_for(stiffness_below_block(string), drill.autodriller_time, drill.hoist.autodriller.fastest);
  if (hoist.rule == HoistRule::feed && hoist.weight_on_bit == 0.0 && drill.drive.imposes_speed)
    hoist.weight_on_bit = weight_for_advance(string.bit, drill.drive.rotation, hoist.feed);
  return hoist;
}

}  // namespace

double stiffness_below_block(const DrillString& string) {
  double compliance = 1.0 / string.hoist.stiffness + 1.0 / string.bit.contact.stiffness;
  for (std::size_t i = 1; i < string.axial.size(); ++i) compliance += 1.0 / string.axial.stiffness[i];
  return 1.0 / compliance;
}

double weight_for_advance(const BitRock& bit, double rotation, double speed) {
  const AdvanceLine line = advance_at(bit, rotation);
  if (!(line.slope > 0.0)) return 0.0;
  const double weight = (speed - line.offset) / line.slope;
  return weight > line.threshold ? weight : 0.0;
}

BitRock bit_rock_of(const DrillCase& drill) {
  BitRock bit = drill.bit_rock;
  if (bit.friction_radius == 0.0 && !drill.bit.cutters.empty()) bit.friction_radius = mean_radius(drill.bit);
  bit.hydraulic_force =
      hydraulic_force(drill.pressure_drop, drill.nozzle_area, drill.jets_push_up ? JetForce::up : JetForce::down);
  return bit;
}

double bit_inertia_of(const DrillCase& drill) {
  const bool as_cylinder = drill.bit_inertia == 0.0 && !drill.bit.cutters.empty();
  return as_cylinder ? bit_inertia(drill.bit_mass, 0.5 * drill.bit.diameter) : drill.bit_inertia;
}

DriveControl control_of(const DrillCase& drill, double natural_period) {
  const DriveControlCase& wish = drill.control;
  if (wish.answer == DriveAnswer::stiff) return {};
  const double period = wish.period > 0.0 ? wish.period : natural_period;
  const double own = drill.pipes.empty() ? 0.0 : torsional_impedance(drill.pipes.front());
  if (wish.answer == DriveAnswer::matched)
    return matched(wish.damping > 0.0 ? wish.damping : own, period, wish.reaction_time);
  DriveControl control =
      soft_torque(drill.drive_inertia > 0.0 ? drill.drive_inertia : usual_drive_inertia, own, period);
  if (wish.damping > 0.0) control.damping = wish.damping;
  return control;
}

DrillString assemble(const DrillCase& drill) {
  DrillString string;
  if (drill.pipes.empty()) {
    string.axial = completed(drill.axial);
    string.torsional = completed(drill.torsional);
    for (const double mass : string.axial.inertia) string.weights.push_back(gravity * mass);
  } else {
    string.axial = axial_chain(drill.pipes, drill.axial_lumps, drill.lumping, drill.axial_damping_ratio);
    string.torsional =
        torsional_chain(drill.pipes, drill.torsional_lumps, drill.lumping, drill.torsional_damping_ratio);
    string.weights = lump_weights(drill.pipes, drill.axial_lumps, drill.fluid_density);
  }
  string.bit = bit_rock_of(drill);
  if (string.axial.size() > 0) {
    string.axial.inertia.back() += drill.bit_mass;
    string.weights.back() += gravity * drill.bit_mass;
  }
  string.torsional.inertia.back() += bit_inertia_of(drill);
  string.torsional.wall_damping.back() += drill.bit_damping;

  string.drive = drill.drive;
  if (is_fed(drill.hoist)) string.hoist = hoist_of(drill, string);
  string.wall_friction = drill.wall_friction;
  if (drill.wall_friction.law != FrictionLaw::none) {
    for (const double force : drill.wall_force) string.wall_moment.push_back(force * drill.wall_radius);
  }
  if (drill.control.answer != DriveAnswer::stiff)
    string.drive.control = control_of(drill, 1.0 / natural_frequencies(string.torsional).front());
  if (is_lump(string.drive)) {
    put_drive_on_top(string.torsional,
                     drill.drive.imposes_speed ? string.drive.control : DriveControl{.inertia = drill.drive_inertia},
                     drill.drive.imposes_speed ? 0.0 : drill.drive_damping);
    if (!string.wall_moment.empty()) string.wall_moment.insert(string.wall_moment.begin(), 0.0);
  }
  require_sensible(drill.name, "axial", held_axial_chain(string));
  require_sensible(drill.name, "torsional", string.torsional);
  require_consistent(string);
  return string;
}

BitSupport axial_support(const DrillString& string) {
  return {.stiffness = string.bit.contact.stiffness, .damping = string.bit.contact.damping};
}

DrillModes drill_modes(const DrillString& string) {
  DrillModes modes{.torsional = natural_frequencies(string.torsional)};
  if (string.axial.size() == 0) return modes;
  const Chain held = held_axial_chain(string);
  modes.axial = natural_frequencies(held, axial_support(string));
  modes.axial_off_bottom = natural_frequencies(held);
  return modes;
}

double longest_stable_step(const DrillString& string) {
  double longest = longest_stable_step(string.torsional, torsional_support(string));
  if (string.axial.size() > 0)
    longest = std::min(longest, longest_stable_step(held_axial_chain(string), axial_support(string)));
  return longest;
}

void require_stable(const DrillCase& drill, const DrillString& string) {
  const double step = drill.run.step;
  if (is_stable_step(string.torsional, torsional_support(string), step) &&
      (string.axial.size() == 0 || is_stable_step(held_axial_chain(string), axial_support(string), step)))
    return;
  const double longest = longest_stable_step(string);
  throw base::InputError(
      fmt::format("{}: run.step_ms = {:.6g} (must be at most {:.4g}: the fastest vibration of string and "
                  "rock would grow without limit; a tenth of that is accurate)",
                  drill.name, drill.run.step / ms, longest / ms));
}

}  // namespace bitrock::runtime
