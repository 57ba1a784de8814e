#include "runtime/well/step.hpp"

#include "runtime/well/bit_end.hpp"
#include "runtime/well/friction_pass.hpp"
#include "runtime/well/joint_pass.hpp"
#include "runtime/well/segment_pass.hpp"
#include "runtime/well/top_end.hpp"

namespace bitrock::runtime {

namespace {

/// Places in use. Loops go by fours and beyond them: what lies there weighs nothing and is held by nothing.
struct Halves {
  std::size_t even, odd;
};

Halves halves_of(std::size_t count) {
  return {(count + 1) / 2, count / 2};
}

BITROCK_INTO_BOTH void load_all(const WellString& string, Columns& columns, std::size_t joints, double h) {
  const auto renew = [&](std::size_t place, std::size_t width) {
    for (std::size_t lane = 0; lane < width; ++lane) {
      const std::size_t at = place + lane;
      const std::size_t i = at < columns.half ? 2 * at : 2 * (at - columns.half) + 1;
      if (i < joints) renew_piece(string, columns, i);
    }
  };
  const Halves halves = halves_of(joints);
  load_joints<FourNumbers>(string, columns, 0, halves.even, h, renew);
  load_joints<FourNumbers>(string, columns, 1, halves.odd, h, renew);
}

BITROCK_INTO_BOTH void kick_all(Columns& columns, std::size_t count, std::size_t joints, double h, bool rub) {
  const Halves segments = halves_of(count), pairs = halves_of(joints);
  kick_segments<FourNumbers>(columns, 0, segments.even, h);
  kick_segments<FourNumbers>(columns, 1, segments.odd, h);
  if (!rub) return;
  rub_joints<FourNumbers>(columns, 0, pairs.even, h);
  rub_joints<FourNumbers>(columns, 1, pairs.odd, h);
}

BITROCK_INTO_BOTH void drift_all(Columns& columns, std::size_t count, double h) {
  const Halves segments = halves_of(count);
  drift_segments<FourNumbers>(columns, 0, segments.even, h);
  drift_segments<FourNumbers>(columns, 1, segments.odd, h);
}

/// The loops, compiled for one kind of machine.
struct Passes {
  void (*load)(const WellString&, Columns&, std::size_t, double);
  void (*kick)(Columns&, std::size_t, std::size_t, double, bool);
  void (*drift)(Columns&, std::size_t, double);
};

#ifdef BITROCK_WIDE
BITROCK_WIDE void load_wide(const WellString& string, Columns& columns, std::size_t joints, double h) {
  load_all(string, columns, joints, h);
}
BITROCK_WIDE void kick_wide(Columns& columns, std::size_t count, std::size_t joints, double h, bool rub) {
  kick_all(columns, count, joints, h, rub);
}
BITROCK_WIDE void drift_wide(Columns& columns, std::size_t count, double h) {
  drift_all(columns, count, h);
}
#endif
void load_plain(const WellString& string, Columns& columns, std::size_t joints, double h) {
  load_all(string, columns, joints, h);
}
void kick_plain(Columns& columns, std::size_t count, std::size_t joints, double h, bool rub) {
  kick_all(columns, count, joints, h, rub);
}
void drift_plain(Columns& columns, std::size_t count, double h) {
  drift_all(columns, count, h);
}

/// The widest that the machine has, or the plain ones.
const Passes& passes(bool plain) {
  static constexpr Passes plain_passes{load_plain, kick_plain, drift_plain};
#ifdef BITROCK_WIDE
  static constexpr Passes wide_passes{load_wide, kick_wide, drift_wide};
  const bool wide = __builtin_cpu_supports("avx2") != 0;
  if (wide && !plain) return wide_passes;
#endif
  return plain_passes;
}

}  // namespace

void advance(const WellString& string, WellStringState& state, const RigControls& controls, const BitRockSource& source,
             double h) {
  const Passes& pass = passes(string.plain_vectors);
  // half before and half after the forces, which then see the pipe of the middle of the step; a block that is pulled
  // has the speed of half a step before, and then that of half a step after
  RigControls now = controls;
  if (controls.is_pulled) now.feed_speed = state.top.block_speed;
  lengthen_top(string, state, now, 0.5 * h);
  const std::size_t joints = state.count - (string.upper_end == UpperEnd::clamped ? 0 : 1);
  pass.load(string, state.columns, joints, h);
  load_table(string, state, now, h);
  load_bit(string, state, source, h);
  pass.kick(state.columns, state.count, joints, h, !string.hole.empty());
  finish_bit(string, state, h);
  if (controls.is_pulled) now.feed_speed = state.top.block_speed;
  lengthen_top(string, state, now, 0.5 * h);
  pass.drift(state.columns, state.count, h);
  state.time += h;
}

void drift(Columns& columns, std::size_t count, double h) {
  passes(false).drift(columns, count, h);
}

JointLoad<double> joint_now(const Columns& columns, std::size_t i) {
  const JointPlaces at = joint_places(columns, i % 2, i / 2);
  return joint_load(side_of<double>(columns, at.above, 1.0), side_of<double>(columns, at.joint, -1.0),
                    springs_of<double>(columns, at.joint));
}

}  // namespace bitrock::runtime
