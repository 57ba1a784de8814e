#include "cli/drill_parts.hpp"

#include <algorithm>

#include "base/units.hpp"
#include "cli/bit_tallies.hpp"
#include "runtime/bit/asked_range.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

using base::rpm;

nlohmann::json spread_json(const runtime::Spread& spread, double unit) {
  return {{"mean", spread.mean / unit},
          {"sd", spread.deviation / unit},
          {"min", spread.lowest / unit},
          {"max", spread.highest / unit}};
}

}  // namespace

std::optional<surrogate::Model> model_of(const CommonOptions& common, const std::string& flag,
                                         runtime::DrillCase& drill) {
  if (!flag.empty()) drill.source.model_file = flag;
  if (drill.source.kind != runtime::SourceKind::bit) {
    if (!flag.empty()) warn(common, "the source of the case is not 'bit': --model is not used");
    drill.source.model_file.clear();
    return std::nullopt;
  }
  if (drill.source.model_file.empty()) return std::nullopt;
  surrogate::Model model = surrogate::read_model(drill.source.model_file);
  const std::string other = runtime::other_rock(drill, model);
  if (!other.empty()) warn(common, other);
  return model;
}

std::string asked_at_the_mean(const runtime::Bit& bit, const surrogate::Model& model,
                              const runtime::DrillSummary& summary) {
  const std::string asked =
      runtime::asked_outside(bit, model, summary.bit_rotation.mean, std::max(0.0, summary.rop.mean));
  return asked.empty() ? "" : "at the mean speed and ROP " + asked;
}

nlohmann::json as_json(const runtime::DrillSummary& s) {
  return {{"bit_rotation_rpm", spread_json(s.bit_rotation, rpm)},
          {"weight_on_bit_N", spread_json(s.weight_on_bit, 1.0)},
          {"total_force_N", spread_json(s.total_force, 1.0)},
          {"torque_on_bit_N_m", spread_json(s.torque, 1.0)},
          {"source_force_N", spread_json(s.source_force, 1.0)},
          {"source_torque_N_m", spread_json(s.source_torque, 1.0)},
          {"rop_m_per_h", spread_json(s.rop, 1.0 / 3600.0)},
          {"static_weight_on_bit_N", s.static_weight_on_bit},
          {"severity", s.severity},
          {"share_at_rest", s.share_at_rest},
          {"share_backwards", s.share_backwards},
          {"share_off_bottom", s.share_off_bottom},
          {"longest_stop_s", s.longest_stop},
          {"longest_flight_s", s.longest_flight},
          {"drilled_m", s.drilled},
          {"energy_residual_fraction", s.energy_residual},
          {"clamped", as_json(s.clamps)},
          {"windows", as_json(s.draws)}};
}

}  // namespace bitrock::cli
