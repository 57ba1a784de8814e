// bitrock export config: the input of a result as a file, from which the result can be made again.
#include <memory>

#include "base/files.hpp"
#include "cli/command.hpp"
#include "studies/repeat/again.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string result_file, output;
};

void run(const Options& options) {
  const base::Hdf5Reader file(options.result_file);
  const studies::Again how = studies::again(file);
  require_outputs(options.common, {options.result_file}, {options.output});
  const std::string other = studies::made_by_another_program(file);
  if (!other.empty()) warn(options.common, other);
  const std::string besides = how.besides.empty() ? "" : fmt::format("; add {}", how.besides);
  const auto command = [&](const std::string& name) { return fmt::format(fmt::runtime(how.command), name); };
  base::write_whole(options.output, fmt::format("# Made again by: {}{}\n\n{}", command("THIS_FILE"), besides,
                                                file.text_attribute("config_toml")));
  say(options.common, "-> {}\nmade again by: {}{}\n", options.output, command(options.output), besides);
  write_json(options.common,
             {{"files", {options.output}}, {"command", command(options.output)}, {"besides", how.besides}});
}

}  // namespace

void add_export_config(CLI::App& export_command) {
  CLI::App* command = export_command.add_subcommand("config",
                                                    "Writes the input of a cut, a specimen or a drill run, from which "
                                                    "the same version of bitrock makes it again to the last bit.");
  auto options = std::make_shared<Options>();
  command->add_option("result", options->result_file, "The result: a run.h5, specimen.h5 or drill.h5.")->required();
  command->add_option("-o,--output", options->output, "The input goes to this file (.toml).")
      ->default_val("config.toml")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
