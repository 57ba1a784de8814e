#include "cli/drill_parts.hpp"

#include <algorithm>

#include "runtime/bit/asked_range.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

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

void add_model_of_case(CLI::App& command, std::string& file) {
  command
      .add_option("--model", file,
                  "The bit asks the networks of this model file (model.json), not those that the case names.")
      ->check(not_empty());
}

std::string asked_at_the_mean(const runtime::Bit& bit, const surrogate::Model& model,
                              const runtime::DrillSummary& summary) {
  const std::string asked =
      runtime::asked_outside(bit, model, summary.bit_rotation.mean, std::max(0.0, summary.rop.mean));
  return asked.empty() ? "" : "at the mean speed and ROP " + asked;
}

}  // namespace bitrock::cli
