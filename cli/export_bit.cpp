// bitrock export bit: a bit and its networks as a C header for bitrock's C interface.
#include <memory>

#include "base/files.hpp"
#include "cli/bit_tallies.hpp"
#include "runtime/source/c_description.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, bit_file, output, prefix;
};

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_cut_model(options.model_file);
  const runtime::Bit bit = runtime::read_bit(options.bit_file);
  warn_of_bit(options.common, bit, model);
  require_outputs(options.common, {options.model_file, options.bit_file}, {options.output});
  base::write_whole(options.output, runtime::c_description(bit, model, options.prefix));
  say(options.common, "{}, rock '{}': the constant {}_description\n-> {}\n", bit.name, model.rock, options.prefix,
      options.output);
  write_json(options.common, {{"files", {options.output}},
                              {"bit", bit.name},
                              {"rock", model.rock},
                              {"constant", options.prefix + "_description"}});
}

}  // namespace

void add_export_bit(CLI::App& export_command) {
  CLI::App* command = export_command.add_subcommand(
      "bit", "Writes a bit and its networks as a C header, for programs that link libbitrock_runtime.so.");
  auto options = std::make_shared<Options>();
  add_model_file(*command, options->model_file);
  add_bit_file(*command, options->bit_file);
  command->add_option("-o,--output", options->output, "The result goes to this file.")
      ->default_val("bit.h")
      ->check(not_empty());
  command->add_option("--prefix", options->prefix, "All names in the header begin with this.")->default_val("bit");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
