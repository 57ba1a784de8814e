#include "runtime/fmu/string_file.hpp"

#include "base/text.hpp"
#include "runtime/bit/core_description.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/fmu/string_description.hpp"
#include "runtime/fmu/string_variables.hpp"
#include "runtime/well/well_run.hpp"

namespace bitrock::fmu {

namespace {

std::string words_of(StringContent content) {
  WordCount count;
  pass(count, content);
  std::string words(8 * count.words, '\0');
  WordWriter writer{words.data()};
  pass(writer, content);
  return words;
}

StringContent common_content(const runtime::DrillCase& drill) {
  StringContent content{.step = runtime::step_of(drill.run), .source = drill.source};
  content.source.seed = static_cast<int>(runtime::seed_of(drill));
  content.fluid_density = drill.fluid_density;
  return content;
}

FmuFile file_of(const runtime::DrillCase& drill, const StringContent& content,
                const std::optional<surrogate::Model>& model, const StringNames& names) {
  runtime::require_model(drill, model);
  runtime::CoreDescription core;
  if (content.source.kind == runtime::SourceKind::bit) {
    const runtime::BitForce usable(runtime::seeded_bit(drill), *model);  // or it throws, in words
    core = runtime::describe(runtime::seeded_bit(drill), *model);
  }
  return packed(
      Inside::string, string_identifier, string_block_file,
      [&](const std::string& guid) {
        const bool bit = content.source.kind == runtime::SourceKind::bit;
        return string_block(content, bit ? bit_block(core.plain, 0.0, guid) : "", guid);
      },
      [&](const std::string& guid) { return string_description(content, names, guid); });
}

}  // namespace

std::string string_block(const StringContent& content, const std::string& bit, const std::string& guid) {
  std::string body = guid;
  body.resize(guid_bytes, '\0');
  body += words_of(content);
  std::string head(block_checked_from + 8, '\0');
  WordWriter{head.data() + block_checked_from}.word(std::uint64_t{bit.size()});
  body += head.substr(block_checked_from) + bit;
  WordWriter writer{head.data()};
  writer.word(string_block_magic);
  writer.word(string_block_version);
  writer.word(std::uint64_t{block_checked_from + body.size()});
  writer.word(base::fingerprint(body));
  return head.substr(0, block_checked_from) + body;
}

FmuFile fmu_file(const runtime::DrillCase& drill, const std::optional<surrogate::Model>& model) {
  StringContent content = common_content(drill);
  content.plane = runtime::assemble(drill);
  content.turning = drill.run.turning;
  content.off_bottom = drill.run.off_bottom;
  runtime::require_stable(drill, content.plane);
  return file_of(drill, content, model,
                 {.name = drill.name, .duration = drill.run.duration, .sample = drill.run.sample});
}

FmuFile fmu_file(const runtime::WellCase& well, const std::optional<surrogate::Model>& model) {
  runtime::require_model(well.drill, model);
  StringContent content = common_content(well.drill);
  content.in_well = true;
  content.well = runtime::assemble(well);
  content.plan = well.plan;
  content.stress_points = well.stress_points;
  runtime::require_stable(well, content.well);
  content.at_rest = runtime::brought_to_rest(well, content.well);
  StringNames names{.name = well.drill.name, .duration = well.drill.run.duration, .sample = well.drill.run.sample};
  for (const runtime::StressPoint& point : well.stress_points) names.stress_points.push_back(point.name);
  return file_of(well.drill, content, model, names);
}

}  // namespace bitrock::fmu
