#include <algorithm>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "runtime/well/well_string.hpp"

namespace bitrock::runtime {

namespace {

Rotation rotation_at(const Columns& columns, std::size_t i) {
  Rotation q;
  take(columns, frame, columns.place_of(i), q);
  return q;
}

void set_rotation(Columns& columns, std::size_t i, const Rotation& q) {
  put(columns, frame, columns.place_of(i), q);
}

/// Memory for the string at its longest, segments and joints as they are at the beginning, all at 0.
WellStringState without_places(const WellString& string) {
  require_consistent(string);
  WellStringState state;
  state.count = segment_count(string);
  const double usual = segment_length_of(string, state.count - 1);
  const std::size_t added =
      string.growth == Growth::split ? static_cast<std::size_t>(std::ceil(string.longest_grown / usual)) : 0;
  state.columns = columns_for(state.count + added);
  for (std::size_t place = 0; place < state.columns.stride(); ++place) {
    state.columns[frame][place] = 1.0;
    state.columns[clearance][place] = 1e30;
    put(state.columns, arc_normal, place, Vector3{1.0, 0.0, 0.0});
    put(state.columns, arc_tangent, place, Vector3{0.0, 0.0, 1.0});
    put(state.columns, end_tangent, place, Vector3{});
    state.columns[end_reach][place] = std::numeric_limits<double>::infinity();
  }
  for (std::size_t i = 0; i < state.count; ++i) set_segment(string, state.columns, i, segment_length_of(string, i));
  for (std::size_t i = 0; i + 1 < state.count; ++i) set_joint(string, state.columns, i, false);
  if (string.upper_end == UpperEnd::clamped) set_joint(string, state.columns, state.count - 1, true);
  state.top.length = usual;
  state.bit.smooth_rotation.window = state.bit.smooth_advance.window = string.bit.averaging_time;
  return state;
}

void finish(const WellString& string, WellStringState& state) {
  for (std::size_t place = 0; place < state.columns.stride(); ++place) renew_derived(state.columns, place);
  for (std::size_t i = 0; i + 1 < state.count; ++i) renew_piece(string, state.columns, i);
}

}  // namespace

WellStringState unloaded(const WellString& string, const Vector3& origin, const Rotation& upper) {
  WellStringState state = without_places(string);
  Columns& columns = state.columns;
  Vector3 end = origin;
  Rotation q = upper;
  const std::size_t top = state.count - 1;
  if (string.upper_end == UpperEnd::clamped) {
    set_vector(columns, position, state.count, origin);
    set_rotation(columns, state.count, upper);
    q = upper * rotation_by_twice(0.5 * vector_at(columns, bend, top));
  }
  for (std::size_t i = top + 1; i-- > 0;) {
    if (i < top) q = rotation_at(columns, i + 1) * rotation_by_twice(0.5 * vector_at(columns, bend, i));
    q = normalised(q);
    const Vector3 d = direction_of(q);
    set_rotation(columns, i, q);
    set_vector(columns, position, i, end + columns.at(half_length, i) * d);
    end += (2.0 * columns.at(half_length, i)) * d;
  }
  finish(string, state);
  return state;
}

namespace {

/// Measured depth at which a chord of `length` ends that begins on the path at `from`.
double chord_end(const WellPath& path, double from, double length) {
  const Vector3 begin = point_at(path, from).position;
  double to = from + length;
  for (int round = 0; round < 8; ++round) {
    const WellPoint point = point_at(path, to);
    const Vector3 chord = point.position - begin;
    const double is = std::sqrt(dot(chord, chord));
    to += (length - is) * is / dot(chord, point.tangent);
  }
  return to;
}

WellPath path_of(const std::vector<HolePiece>& hole) {
  WellPath path;
  for (const HolePiece& piece : hole) path.arcs.push_back(piece.arc);
  return path;
}

}  // namespace

WellStringState hung_in_hole(const WellString& string) {
  WellStringState state = without_places(string);
  if (string.hole.empty()) throw base::InputError("string in a well: no hole to hang in");
  Columns& columns = state.columns;
  const WellPath path = path_of(string.hole);
  const std::size_t top = state.count - 1;
  // the slope of each segment gives the tension, the tension the stretch, and that moves the segments a little
  for (int round = 0; round < 4; ++round) {
    double tension = 0.0;
    for (std::size_t i = 0; i <= top; ++i) tension += columns.at(weight, i) * vector_at(columns, direction, i).z;
    if (round == 0) tension = 0.0;
    const double hoist = section_of(string, top).beam.axial / columns.at(half_length, top);
    double depth = tension / hoist;
    Vector3 d{0.0, 0.0, 1.0};
    Rotation q = rotation_to(d);  // handed down from segment to segment without a twist
    for (std::size_t i = top + 1; i-- > 0;) {
      const double below = chord_end(path, depth, 2.0 * columns.at(half_length, i));
      const Vector3 from = point_at(path, depth).position, to = point_at(path, below).position;
      set_vector(columns, position, i, 0.5 * (from + to));
      q = normalised(rotation_between(d, unit(to - from)) * q);
      d = unit(to - from);
      set_rotation(columns, i, q);
      set_vector(columns, direction, i, d);
      if (round > 0) tension -= columns.at(weight, i) * d.z;
      depth = below + (i > 0 ? tension / columns.at(axial_stiffness, i - 1) : 0.0);
      if (i == 0) state.bit.depth = below;
    }
  }
  state.bit.face = state.bit.depth;
  finish(string, state);
  return state;
}

}  // namespace bitrock::runtime
