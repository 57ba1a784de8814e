#include "cli/drill_parts.hpp"

#include <algorithm>

#include "cli/bit_tallies.hpp"
#include "runtime/bit/asked_range.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

void add_case(CLI::App& command, CaseFlags& flags, const std::string& example) {
  command.add_option("case", flags.file, fmt::format("The drilling case, e.g. campaigns/drill/{}.", example))
      ->required();
  command
      .add_option("--model", flags.model_file,
                  "The bit asks the networks of this model file (model.json), not those that the case names.")
      ->check(not_empty());
  add_mode(command, flags.mode);
}

runtime::DrillCase read_case(const CaseFlags& flags) {
  runtime::DrillCase drill = runtime::read_drill_case(flags.file);
  take_mode(flags.mode, drill.bit);
  return drill;
}

std::vector<std::filesystem::path> inputs_of(const CaseFlags& flags, const runtime::DrillCase& drill) {
  return {flags.file, drill.bit_file, drill.source.model_file};
}

std::optional<surrogate::Model> model_of(const CommonOptions& common, const CaseFlags& flags,
                                         runtime::DrillCase& drill) {
  const std::string& flag = flags.model_file;
  if (!flag.empty()) drill.source.model_file = flag;
  if (drill.source.kind != runtime::SourceKind::bit) {
    if (!flag.empty()) warn(common, "the source of the case is not 'bit': --model is not used");
    drill.source.model_file.clear();
    return std::nullopt;
  }
  if (drill.source.model_file.empty()) return std::nullopt;
  surrogate::Model model = surrogate::read_cut_model(drill.source.model_file);
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

}  // namespace bitrock::cli
