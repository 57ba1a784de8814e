#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "runtime/drillstring/modes.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/well_case.hpp"
#include "runtime/well/well_modes.hpp"

namespace bitrock::runtime {

namespace {

using base::deg, base::ms;

constexpr double most_segments = 4000;   // a minute of it takes half an hour
constexpr double most_nodes_kept = 2e7;  // 48 bytes each, 1 GB
constexpr double most_joint_rows = 5e7;  // of all joints: 800 MB

/// [kg/m] of mud that moves with a pipe across its axis in a hole: rho (A_i + C A_o), C = (D^2 + d^2) / (D^2 - d^2),
/// the added mass of a cylinder inside another.
double added_mass(const PipeSection& pipe, double hole_diameter, double density) {
  const double quarter = 0.25 * std::numbers::pi;
  const double outer = pipe.outer_diameter * pipe.outer_diameter, inner = pipe.inner_diameter * pipe.inner_diameter;
  const double hole = hole_diameter * hole_diameter;
  return density * quarter * (inner + (hole + outer) / (hole - outer) * outer);
}

/// The loads of every joint must go into memory.
void require_room_for_joints(const WellCase& well, double segments) {
  const DrillSchedule& run = well.drill.run;
  const double rows = (run.duration - run.settling) / run.sample;
  const double joints = segments + well.plan.run_in / well.pipes.front().segment_length;
  if (rows * joints > most_joint_rows)
    throw base::InputError(fmt::format(
        "{}: well.every_joint keeps {:.0f} rows of some {:.0f} joints (at most {:g} in all: raise run.settling_s or "
        "run.sample_ms)",
        well.drill.name, rows, joints, most_joint_rows));
}

}  // namespace

WellString assemble(const WellCase& well) {
  WellString string;
  const DrillCase& drill = well.drill;
  double total = 0.0, segments = 0.0;
  for (const WellPipe& part : well.pipes) {
    const Beam beam = beam_of(part.pipe);
    const double widest = std::max(part.contact_diameter, part.pipe.outer_diameter);
    StringSection section{
        .beam = beam,
        .length = part.pipe.length,
        .segments = static_cast<int>(std::ceil(part.pipe.length / part.segment_length * (1.0 - 1e-12))),
        .contact_radius = 0.5 * widest,
        .weight = gravity * beam.mass * (1.0 - drill.fluid_density / part.pipe.density),
        .drag_across = well.drag_across};
    double narrowest = well.hole.front().diameter;
    for (const HoleSection& hole : well.hole) narrowest = std::min(narrowest, hole.diameter);
    if (well.mud_added_mass && part.pipe.outer_diameter < narrowest)
      section.added_mass = added_mass(part.pipe, narrowest, drill.fluid_density);
    string.sections.push_back(section);
    segments += section.segments;
    total += part.pipe.length;
  }
  if (segments > most_segments)
    throw base::InputError(fmt::format("a string of {:.0f} segments (at most {:.0f}: raise pipe.segment_length_m)",
                                       segments, most_segments));
  if (well.frames * segments > most_nodes_kept)
    throw base::InputError(fmt::format("well.frames = {} of a string of {:.0f} segments (at most {:.0f})", well.frames,
                                       segments, std::floor(most_nodes_kept / segments)));
  if (well.every_joint) require_room_for_joints(well, segments);
  const WellPath path = well_path(well.stations);
  constexpr double most_lean = 5.0 * deg;
  if (well.stations.front().measured_depth != 0.0)
    throw base::InputError(fmt::format("the survey begins at {:g} m (must begin at the rotary table, at 0)",
                                       well.stations.front().measured_depth));
  if (well.stations.front().inclination > most_lean)
    throw base::InputError(fmt::format("the well begins at {:g} degrees (at most 5: the hoist lifts vertically)",
                                       well.stations.front().inclination / deg));
  if (total > end_depth(path))
    throw base::InputError(fmt::format(
        "a string of {:g} m in a well of {:g} m (its survey must reach as deep as the bit)", total, end_depth(path)));
  string.hole = hole_pieces(path, well.hole);
  string.damping = well.damping;
  string.upper_end = UpperEnd::table;
  string.growth = well.growth;
  if (drill.control.answer != DriveAnswer::stiff)  // tuned to the string that drills
    string.control =
        control_of(drill, 1.0 / natural_frequencies(chains_of(string, well.plan.run_in).torsional).front());
  if (drill.drive_inertia > 0.0) string.drive_inertia = drill.drive_inertia;
  // pipe of the trip, of going to bottom, and of drilling
  const double depth = well.bottom_depth > 0.0 ? std::max(0.0, well.bottom_depth - total) : well.plan.run_in;
  const double fastest = well.plan.holds_weight ? well.plan.autodriller.fastest : 2.0 * well.plan.drilling_speed;
  string.longest_grown = depth + well.plan.run_in + 5.0 + fastest * drill.run.duration;
  string.guided = true;
  string.gauge_radius = 0.5 * well.bit_gauge;
  string.on_rock = well.bottom_depth > 0.0;
  string.bit = bit_rock_of(drill);
  string.bit_mass = drill.bit_mass;
  string.bit_inertia = bit_inertia_of(drill);
  require_consistent(string);
  return string;
}

void require_stable(const WellCase& well, const WellString& string) {
  const double longest = longest_allowed_step(string);
  if (well.drill.run.step > longest)
    throw base::InputError(fmt::format("{}: run.step_ms = {:g} (at most {:.3g} for these segments)", well.drill.name,
                                       well.drill.run.step / ms, longest / ms));
}

}  // namespace bitrock::runtime
