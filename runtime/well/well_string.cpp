#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

std::size_t segment_count(const WellString& string) {
  std::size_t count = 0;
  for (const StringSection& section : string.sections) count += static_cast<std::size_t>(section.segments);
  return count;
}

const StringSection& section_of(const WellString& string, std::size_t i) {
  for (std::size_t s = string.sections.size() - 1; s > 0; --s) {
    const auto segments = static_cast<std::size_t>(string.sections[s].segments);
    if (i < segments) return string.sections[s];
    i -= segments;
  }
  return string.sections.front();
}

double segment_length_of(const WellString& string, std::size_t i) {
  const StringSection& section = section_of(string, i);
  return section.length / section.segments;
}

void set_segment(const WellString& string, Columns& columns, std::size_t i, double length) {
  const StringSection& section = section_of(string, i);
  const Beam& beam = section.beam;
  const double bit = i == 0 ? string.bit_mass : 0.0, bit_spin = i == 0 ? string.bit_inertia : 0.0;
  const double mass = beam.mass * length + bit, lateral = mass + section.added_mass * length;
  const double spin = beam.polar_inertia * length + bit_spin;
  const double tumble =
      (beam.mass + section.added_mass) * length * length * length / 12.0 + beam.transverse_inertia * length;
  const double turning = section.drag_across * length * length * length / 12.0;
  columns.at(half_length, i) = 0.5 * length;
  columns.at(inverse_mass, i) = 1.0 / lateral;
  columns.at(inverse_mass_along, i) = 1.0 / mass - 1.0 / lateral;
  columns.at(inverse_inertia, i) = 1.0 / tumble;
  columns.at(inverse_inertia_along, i) = 1.0 / spin - 1.0 / tumble;
  columns.at(weight, i) = section.weight * length + gravity * bit;
  columns.at(drag_across, i) = section.drag_across * length;
  columns.at(drag_along, i) = (section.drag_along - section.drag_across) * length;
  columns.at(drag_turning, i) = turning;
  columns.at(drag_spinning, i) = section.drag_spinning * length - turning;
}

void set_joint(const WellString& string, Columns& columns, std::size_t i, bool wall) {
  const StringSection &below = section_of(string, i), &above = section_of(string, i + 1);
  const double lower = columns.at(half_length, i), upper = wall ? 0.0 : columns.at(half_length, i + 1);
  // halves of two segments in a row: their compliances add
  const auto in_a_row = [&](double Beam::*stiffness) {
    return 1.0 / (lower / (below.beam.*stiffness) + upper / (above.beam.*stiffness));
  };
  const MaterialDamping& beta = string.damping;
  const double axial = in_a_row(&Beam::axial), shear = in_a_row(&Beam::shear), torsion = in_a_row(&Beam::torsion),
               bending = in_a_row(&Beam::bending);
  columns.at(axial_stiffness, i) = axial;
  columns.at(shear_stiffness, i) = shear;
  columns.at(torsion_stiffness, i) = torsion;
  columns.at(bending_stiffness, i) = bending;
  columns.at(axial_damping, i) = beta.axial * axial;
  columns.at(shear_damping, i) = beta.shear * shear;
  columns.at(torsion_damping, i) = beta.torsion * torsion;
  columns.at(bending_damping, i) = beta.bending * bending;
  set_vector(columns, bend, i, lower * below.bend + upper * above.bend);
  columns.at(contact_radius, i) =
      below.contact_radius > above.contact_radius ? below.contact_radius : above.contact_radius;
}

void renew_derived(Columns& columns, std::size_t place) {
  Rotation q;
  take(columns, frame, place, q);
  const Vector3 d = direction_of(q);
  Vector3 l;
  take(columns, momentum, place, l);
  put(columns, direction, place, d);
  put(columns, rate, place,
      columns[inverse_inertia][place] * l + (columns[inverse_inertia_along][place] * dot(l, d)) * d);
}

void renew_piece(const WellString& string, Columns& columns, std::size_t i) {
  if (string.hole.empty()) return;
  const Vector3 middle = 0.5 * (lower_end_of(columns, i + 1) + upper_end_of(columns, i));
  const auto from = static_cast<std::size_t>(columns.at(piece, i));
  const std::size_t found = piece_at(string.hole, middle, from);
  const HolePiece& hole = string.hole[found];
  columns.at(piece, i) = static_cast<double>(found);
  columns.at(clearance, i) = hole.radius - columns.at(contact_radius, i);
  columns.at(friction, i) = hole.friction;
  columns.at(friction_more, i) = hole.more_at_rest;
  columns.at(friction_pace, i) = 1.0 / hole.slip_speed;
  set_vector(columns, arc_start, i, hole.arc.start);
  set_vector(columns, arc_tangent, i, hole.arc.tangent);
  set_vector(columns, arc_normal, i, hole.arc.normal);
  columns.at(arc_curvature, i) = hole.arc.curvature;
  set_vector(columns, end_tangent, i, hole.end_tangent);
  columns.at(end_reach, i) = hole.end_reach;
}

Vector3 upper_end_of(const Columns& c, std::size_t i) {
  return vector_at(c, position, i) - c.at(half_length, i) * vector_at(c, direction, i);
}
Vector3 lower_end_of(const Columns& c, std::size_t i) {
  return vector_at(c, position, i) + c.at(half_length, i) * vector_at(c, direction, i);
}
Vector3 upper_velocity_of(const Columns& c, std::size_t i) {
  return vector_at(c, velocity, i) - c.at(half_length, i) * cross(vector_at(c, rate, i), vector_at(c, direction, i));
}
Vector3 lower_velocity_of(const Columns& c, std::size_t i) {
  return vector_at(c, velocity, i) + c.at(half_length, i) * cross(vector_at(c, rate, i), vector_at(c, direction, i));
}
double spin_of(const Columns& c, std::size_t i) {
  return dot(vector_at(c, momentum, i), vector_at(c, direction, i)) *
         (c.at(inverse_inertia, i) + c.at(inverse_inertia_along, i));
}

}  // namespace bitrock::runtime
