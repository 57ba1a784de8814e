// What the numbers of a drilling case say together before it runs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "base/units.hpp"
#include "runtime/drillstring/drill_case.hpp"

namespace bitrock::runtime {

namespace {

using base::kN, base::mm;

// Most weight on bit over the diameter of the bit [N/m]. A rule of thumb: makers' data sheets of 8 1/2 in PDC bits
// allow some 110 to 160 kN, 0.5 to 0.75 kN a mm. Recalled, not from a table.
constexpr double most_weight_per_diameter = 0.75 * kN / mm;

// The wind-up of the string matters when its period is longer than this share of what the summary sees.
constexpr double noticed_share = 0.1;

// Where the friction of a turning bit is looked for its maximum [rad/s]: up to some 480 rpm.
constexpr double fastest = 50.0;
constexpr int speeds = 500;

double weight_of(const DrillString& string) {
  return std::accumulate(string.weights.begin(), string.weights.end(), 0.0);
}

/// Rate of penetration at the static weight on bit and the speed of the drive [m/s].
double advance_at(const DrillString& string) {
  return beginning(string, no_excitation(), true, 0.0).rate_of_penetration;
}

/// Of a hoist that is fed: what the rock asks for cannot be had.
void warn_of_hoist(const DrillString& string, std::vector<std::string>& found) {
  const Hoist& hoist = string.hoist;
  if (!is_fed(hoist)) return;
  const double hanging = hanging_load(string);
  if (hoist.weight_on_bit > hanging)
    found.push_back(
        fmt::format("the bit is to bear {:.4g} kN, and the string hangs with {:.4g} kN: the line will go slack",
                    hoist.weight_on_bit / kN, hanging / kN));
  const bool imposed = string.bit.advance_law == AdvanceLaw::imposed || string.bit.advance_law == AdvanceLaw::none;
  const double rock = string.bit.advance_law == AdvanceLaw::imposed ? string.bit.imposed_advance : 0.0;
  if (hoist.rule == HoistRule::feed && imposed && hoist.feed != rock)
    found.push_back(
        fmt::format("the block goes down with {:.4g} m/h and the rock away with {:.4g} m/h, whatever the weight: "
                    "the weight on bit has no balance",
                    hoist.feed * 3600.0, rock * 3600.0));
  if (hoist.rule == HoistRule::autodriller && hoist.autodriller.fastest < advance_at(string))
    found.push_back(
        fmt::format("slack_off_m_per_s = {:.4g} is slower than the rock goes away under the weight that "
                    "the autodriller is to hold, {:.4g} m/s",
                    hoist.autodriller.fastest, advance_at(string)));
}

void warn_of_weight(const DrillCase& drill, const DrillString& string, double weight, std::vector<std::string>& found) {
  if (string.axial.size() > 0 && weight == 0.0 && !is_fed(string.hoist)) {
    found.push_back(
        fmt::format("hook load {:.4g} kN and jets carry the whole string of {:.4g} kN: the bit will leave the rock and "
                    "not come back",
                    string.drive.hook_load / kN, weight_of(string) / kN));
  } else if (weight <= string.bit.threshold_weight) {
    found.push_back(
        fmt::format("static weight on bit {:.4g} kN does not exceed threshold_weight_kN = {:.4g}: nothing is cut",
                    weight / kN, string.bit.threshold_weight / kN));
  }
  const bool turns = string.drive.imposes_speed && string.drive.rotation > 0.0;
  if (turns && weight > string.bit.threshold_weight && advance_at(string) == 0.0)
    found.push_back(
        fmt::format("[drilling] gives no advance at the static weight on bit, {:.4g} kN, and the speed of the "
                    "drive: nothing is cut",
                    weight / kN));
  const double diameter = drill.bit.diameter;
  if (weight <= most_weight_on_bit(drill.bit)) return;
  std::string origin = "imposed_weight_kN";
  if (is_fed(string.hoist)) {
    origin = "the hoist is fed for that";
  } else if (string.axial.size() > 0) {
    origin = fmt::format("the string weighs {:.4g} kN, of which hook_load_kN = {:.4g} is held", weight_of(string) / kN,
                         string.drive.hook_load / kN);
  }
  found.push_back(
      fmt::format("static weight on bit {:.4g} kN on a bit of {:.4g} mm: {:.3g} kN a mm, where bits bear about {:.2g} "
                  "(rule of thumb, not a maker's table); {}",
                  weight / kN, diameter / mm, weight / diameter * mm / kN, most_weight_per_diameter * mm / kN, origin));
}

/// A string that is not in balance at the beginning: it falls on the rock, or winds up in what the summary sees.
void warn_of_beginning(const DrillCase& drill, const DrillString& string, double weight,
                       std::vector<std::string>& found) {
  const DrillSchedule& run = drill.run;
  if (string.axial.size() > 0 && !is_fed(string.hoist) && run.off_bottom > 0.0 && weight > 0.0) {
    const double mass = std::accumulate(string.axial.inertia.begin(), string.axial.inertia.end(), 0.0);
    const double speed = std::sqrt(2.0 * weight / mass * run.off_bottom);
    found.push_back(
        fmt::format("the string is not in balance at the beginning: run.off_bottom_mm = {:.4g} with {:.4g} kN more "
                    "weight than hook load; the bit falls and meets the rock at {:.3g} m/s",
                    run.off_bottom / mm, weight / kN, speed));
  }
  if (!run.turning || string.drive.rotation == 0.0 || string.torsional.size() == 0) return;
  const std::vector<double> frequencies = natural_frequencies(string.torsional);
  const auto slowest = std::find_if(frequencies.begin(), frequencies.end(), [](double f) { return f > 0.0; });
  if (!string.drive.imposes_speed || slowest == frequencies.end()) return;
  const double period = 1.0 / *slowest;
  if (run.settling >= period || period <= noticed_share * (run.duration - run.settling)) return;
  found.push_back(
      fmt::format("the string begins without twist and winds up within its slowest vibration, {:.3g} s; with "
                  "run.settling_s = {:.4g} and run.duration_s = {:.4g} the summary sees that, not the drilling",
                  period, run.settling, run.duration));
}

double highest_coefficient(const Friction& friction) {
  if (friction.law == FrictionLaw::none) return 0.0;
  if (friction.law == FrictionLaw::stribeck) return friction.stribeck.resting;
  double highest = 0.0;
  for (int i = 1; i <= speeds; ++i)
    highest = std::max(highest, friction_coefficient(friction.smooth, fastest * i / speeds));
  return highest;
}

void warn_of_drive(const DrillString& string, double weight, std::vector<std::string>& found) {
  const TopDrive& drive = string.drive;
  if (drive.imposes_speed) {
    if (drive.rotation == 0.0) found.emplace_back("rotation_rpm = 0: the string does not turn, nothing is cut");
    return;
  }
  const double wall = std::accumulate(string.wall_moment.begin(), string.wall_moment.end(), 0.0);
  const double resisting = weight * string.bit.friction_radius * highest_coefficient(string.bit.friction) +
                           wall * highest_coefficient(string.wall_friction);
  if (drive.torque > resisting) return;
  found.push_back(
      fmt::format("torque_kN_m = {:.4g} does not exceed the {:.4g} kN m of friction at the static weight on bit: the "
                  "bit will not turn freely",
                  drive.torque / kN, resisting / kN));
}

void warn_of_parts(const DrillCase& drill, std::vector<std::string>& found) {
  for (std::size_t i = 0; i < drill.pipes.size() && drill.bit.diameter > 0.0; ++i) {
    if (drill.pipes[i].outer_diameter < drill.bit.diameter) continue;
    found.push_back(fmt::format("pipe {} has an outer diameter of {:.4g} mm: it does not follow a bit of {:.4g} mm",
                                i + 1, drill.pipes[i].outer_diameter / mm, drill.bit.diameter / mm));
  }
  if ((drill.pressure_drop > 0.0) != (drill.nozzle_area > 0.0))
    found.emplace_back(
        "fluid: pressure_drop_MPa and nozzle_area_mm2 go together; with one of them 0 jets have no force");
}

/// Mean axial force of a source while the bit turns steadily at the speed of the drive, and drills as it does at the
/// static weight on bit.
double mean_push(const BitRockSource& load, double rotation, double rate_of_penetration) {
  constexpr int turns = 4, samples = 2000;
  double sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    const double angle = 2.0 * std::numbers::pi * turns * i / samples;
    sum += load({.angle = angle, .rotation = rotation, .rate_of_penetration = rate_of_penetration}).axial_force;
  }
  return sum / samples;
}

}  // namespace

double most_weight_on_bit(const Bit& bit) {
  return bit.diameter > 0.0 ? most_weight_per_diameter * bit.diameter : std::numeric_limits<double>::infinity();
}

std::vector<std::string> warnings_of_load(const DrillString& string, const BitRockSource& load) {
  const double weight = static_weight_on_bit(string), rotation = string.drive.rotation;
  const bool acts = string.axial.size() > 0 && string.bit.axial_source == AxialSource::full;
  if (!acts || weight == 0.0 || !string.drive.imposes_speed || rotation == 0.0) return {};
  const double advance = advance_at(string);
  const double push = mean_push(load, rotation, advance);
  if (push <= weight) return {};
  return {
      fmt::format("there is no balance on the bottom: at the speed of the drive and {:.3g} m/h the rock pushes the bit "
                  "up with {:.4g} kN in the mean, and the static weight on bit is {:.4g} kN; the bit will bounce",
                  advance * 3600.0, push / kN, weight / kN)};
}

std::vector<std::string> warnings(const DrillCase& drill, const DrillString& string) {
  std::vector<std::string> found = warnings(drill.bit);
  const double weight = static_weight_on_bit(string);
  warn_of_weight(drill, string, weight, found);
  warn_of_hoist(string, found);
  warn_of_drive(string, weight, found);
  if (drill.source.kind == SourceKind::bit && string.axial.size() == 0)
    found.emplace_back("without an axial chain the source's axial force has nothing to act on");
  warn_of_parts(drill, found);
  warn_of_beginning(drill, string, weight, found);
  return found;
}

}  // namespace bitrock::runtime
