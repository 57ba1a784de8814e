#include "views/json/bit_json.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::ClampTally& clamps) {
  return {{"asked", clamps.asked},
          {"speed_below", clamps.speed_below},
          {"speed_above", clamps.speed_above},
          {"depth_below", clamps.depth_below},
          {"depth_above", clamps.depth_above},
          {"rake_below", clamps.rake_below},
          {"rake_above", clamps.rake_above}};
}

nlohmann::json as_json(const runtime::DrawTally& draws) {
  return {{"drawn", draws.drawn},
          {"mean_missed", draws.mean_missed},
          {"band_left", draws.band_left},
          {"narrowed", draws.narrowed},
          {"capped", draws.capped},
          {"length_clamped", draws.length_clamped},
          {"correlation_clamped", draws.correlation_clamped}};
}

nlohmann::json as_json(const runtime::Bit& bit, const runtime::Signal& signal, runtime::SignalMode mode) {
  const runtime::SignalSummary& s = signal.summary;
  return {{"bit", bit.name},
          {"cutters", bit.cutters.size()},
          {"mean_force_N", s.mean_force_N},
          {"max_force_N", s.max_force_N},
          {"mean_torque_N_m", s.mean_torque_N_m},
          {"max_torque_N_m", s.max_torque_N_m},
          {"depth_of_cut_m", s.depth_of_cut_m},
          {"clamped", as_json(s.clamps)},
          {"mode", runtime::name_of(mode)},
          {"windows", as_json(s.draws)},
          {"samples", signal.time_s.size()}};
}

}  // namespace bitrock::views
