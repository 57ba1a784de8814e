#include "runtime/well/energy.hpp"

#include <cmath>

#include "runtime/well/bit_end.hpp"
#include "runtime/well/segment_motion.hpp"
#include "runtime/well/step.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::runtime {

namespace {

double wall_energy(const WellString& string, const Columns& columns, std::size_t i) {
  const Vector3 middle = 0.5 * (lower_end_of(columns, i + 1) + upper_end_of(columns, i));
  const std::size_t found = piece_at(string.hole, middle, static_cast<std::size_t>(columns.at(piece, i)));
  const HolePiece& hole = string.hole[found];
  const double depth = length(offset_from(hole.arc, middle).offset) - (hole.radius - columns.at(contact_radius, i));
  return wall_push(string.wall, depth, 0.0).energy;
}

double sum_of(const Columns& columns, Column column) {
  double sum = 0.0;
  for (std::size_t place = 0; place < columns.stride(); ++place) sum += columns[column][place];
  return sum;
}

}  // namespace

WellEnergy stored_energy(const WellString& string, const WellStringState& state, double h) {
  WellStringState middle = state;
  Columns& columns = middle.columns;
  drift(columns, middle.count, -0.5 * h);
  middle.top.drive_angle -= 0.5 * h * middle.top.drive_speed;
  WellEnergy energy;
  for (std::size_t i = 0; i < middle.count; ++i) {
    energy.kinetic += kinetic_energy_of(columns, i);
    energy.weight -= columns.at(weight, i) * vector_at(columns, position, i).z;
    const bool joint = i + 1 < middle.count;
    if (joint || string.upper_end == UpperEnd::clamped) energy.springs += joint_now(columns, i).energy;
    if (joint && !string.hole.empty()) energy.wall += wall_energy(string, columns, i);
  }
  if (string.upper_end == UpperEnd::table) energy.springs += table_energy(string, middle);
  energy.kinetic += 0.5 * string.control.inertia * middle.top.drive_speed * middle.top.drive_speed;
  energy.wall += bit_energy(string, middle);
  return energy;
}

double friction_work_of(const WellStringState& state) {
  return sum_of(state.columns, friction_work);
}

double work_taken(const WellStringState& state) {
  double sum = state.work.dampers + state.work.bit;
  for (const Column column : {damper_work, wall_work, friction_work, drag_work}) sum += sum_of(state.columns, column);
  return sum;
}

double energy_residual(const WellString& string, const WellStringState& state, double initial, double h) {
  const double in = state.work.drive + state.work.growth + state.work.tip;
  return in - work_taken(state) - (stored_energy(string, state, h).total() - initial);
}

}  // namespace bitrock::runtime
