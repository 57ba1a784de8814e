#include "cli/bit_tallies.hpp"

#include "runtime/bit/asked_range.hpp"

namespace bitrock::cli {

void warn_of_bit(const CommonOptions& options, const runtime::Bit& bit, const surrogate::Model& model) {
  for (const std::string& warning : runtime::warnings(bit)) warn(options, warning);
  if (const std::string rakes = runtime::rakes_outside(bit, model); !rakes.empty())
    warn(options, "outside the training range the networks answer for its edge: " + rakes);
}

void tell(const CommonOptions& options, const std::vector<views::BitRemark>& remarks) {
  for (const views::BitRemark& remark : remarks)
    remark.is_warning ? warn(options, remark.text) : say(options, "{}\n", remark.text);
}

void add_mode(CLI::App& command, std::string& mode) {
  std::vector<std::string> names(std::size(runtime::mode_names));
  std::ranges::transform(runtime::mode_names, names.begin(),
                         [](const runtime::ModeName& known) { return std::string(known.name); });
  command
      .add_option("--mode", mode,
                  "The force is rebuilt by this mode: sawtooth, article, article-literal, or auto (sawtooth when the "
                  "model can, else article). Without it the bit file says it.")
      ->check(CLI::IsMember(names));
}

void take_mode(const std::string& mode, runtime::Bit& bit) {
  if (const auto named = runtime::mode_named(mode)) bit.signal.mode = *named;
}

}  // namespace bitrock::cli
