#include "runtime/well/string_frames.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/well/stress.hpp"

namespace bitrock::runtime {

namespace {

/// The pipe segment i is cut from.
const PipeSection& pipe_of(const WellString& string, std::span<const PipeSection> pipes, std::size_t i) {
  return pipes[static_cast<std::size_t>(&section_of(string, i) - string.sections.data())];
}

/// Of the fibre that bending and tension load alike, in the weaker of the pipes above and below node k.
double worst_von_mises(const WellString& string, const WellStringState& state, std::span<const PipeSection> pipes,
                       std::size_t k, const SectionLoad& load, double pressure) {
  double worst = 0.0;
  for (const std::size_t i : {k == 0 ? 0 : k - 1, std::min(k, state.count - 1)}) {
    const PipeSection& pipe = pipe_of(string, pipes, i);
    worst = std::max(worst, stress_of(pipe, load, worst_angle(pipe, load, pressure), pressure).von_mises);
  }
  return worst;
}

}  // namespace

void add_frame(const WellString& string, const WellStringState& state, std::span<const PipeSection> pipes,
               double fluid_density, StringFrames& frames) {
  const Columns& columns = state.columns;
  frames.time_s.push_back(state.time);
  frames.nodes.push_back(static_cast<int>(state.count + 1));
  const auto put = [](std::vector<float>& values, double value) { values.push_back(static_cast<float>(value)); };
  for (std::size_t k = 0; k <= state.count; ++k) {
    const bool at_bit = k == 0, at_table = k == state.count;
    const Vector3 place = at_bit     ? lower_end_of(columns, 0)
                          : at_table ? upper_end_of(columns, k - 1)
                                     : 0.5 * (lower_end_of(columns, k) + upper_end_of(columns, k - 1));
    const auto from = static_cast<std::size_t>(columns.at(piece, std::min(k == 0 ? 0 : k - 1, state.count - 2)));
    const WellFoot foot = foot_on(string.hole[piece_at(string.hole, place, from)].arc, place);
    const SectionLoad load = at_bit ? load_at_bit(string, state) : load_above(state, k - 1);
    const double pressure = fluid_density * gravity * std::max(0.0, place.z);
    put(frames.measured_depth_m, foot.measured_depth);
    put(frames.north_m, place.x);
    put(frames.east_m, place.y);
    put(frames.down_m, place.z);
    put(frames.offset_north_m, foot.offset.x);
    put(frames.offset_east_m, foot.offset.y);
    put(frames.offset_down_m, foot.offset.z);
    put(frames.side_force_N, at_bit ? state.bit.side_force : at_table ? 0.0 : columns.at(wall_force, k - 1));
    put(frames.tension_N, load.tension);
    put(frames.torque_N_m, -load.moment.x);
    put(frames.bending_moment_N_m, std::hypot(load.moment.y, load.moment.z));
    put(frames.von_mises_Pa, worst_von_mises(string, state, pipes, k, load, pressure));
  }
}

bool is_kept(long long sample, long long samples, int wished) {
  const long long kept = std::min<long long>(wished, samples);
  return sample * kept / samples > (sample - 1) * kept / samples;
}

}  // namespace bitrock::runtime
