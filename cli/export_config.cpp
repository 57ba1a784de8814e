// bitrock export config: the input of a result as a file, from which the result can be made again.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/hdf5_file.hpp"
#include "base/version.hpp"
#include "cli/command.hpp"
#include "dem2d/specimen/specimen.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string result_file, output;
};

/// How the result is made again from the text. `{}` stands for the file with the text.
struct Again {
  std::string command;
  std::string besides;  ///< what the text does not hold
};

std::string seed_flag(const base::Hdf5Reader& file) {
  return fmt::format(" --seed {:.0f}", file.number_attribute("seed"));
}

Again again(const base::Hdf5Reader& file) {
  const std::string format = file.text_attribute("format");
  const auto packed_elsewhere = [&](const char* origin) {
    return file.text_attribute(origin) != dem2d::origin_genesis;
  };
  if (format == "bitrock-run") {
    return {.command = "bitrock cut {}" + seed_flag(file),
            .besides = packed_elsewhere("bed_origin")
                           ? "--specimen and the file of its discs, which were packed elsewhere"
                           : ""};
  }
  if (format == "bitrock-specimen") {
    return {.command = "bitrock specimen {}" + seed_flag(file),
            .besides = packed_elsewhere("origin")
                           ? "--from-discs and the table of its discs, which were packed elsewhere"
                           : ""};
  }
  if (format == "bitrock-drill") return {.command = "bitrock drill run {}", .besides = ""};
  throw base::InputError(
      fmt::format("{}: a file of format '{}' (must be made by cut, specimen or drill run)", file.name(), format));
}

/// Another program may pack, cut and draw in another way.
void warn_of_another_program(const Options& options, const base::Hdf5Reader& file) {
  const auto said = [&](const char* name) {
    return file.has_attribute(name) ? file.text_attribute(name) : std::string("not said");
  };
  const std::string version = said("version"), commit = said("git_commit");
  if (version == base::version && commit == base::git_commit) return;
  warn(options.common,
       fmt::format("{} was made by bitrock {} ({}), this is {} ({}): the same bits only if nothing between the two "
                   "touches results",
                   options.result_file, version, commit, base::version, base::git_commit));
}

void run(const Options& options) {
  const base::Hdf5Reader file(options.result_file);
  const Again how = again(file);
  require_outputs(options.common, {options.result_file}, {options.output});
  warn_of_another_program(options, file);
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
  CLI::App* command = export_command.add_subcommand(
      "config", "the input of a cut, a specimen or a drill run, from which it can be made again to the same bits");
  auto options = std::make_shared<Options>();
  command->add_option("result", options->result_file, "run.h5, specimen.h5 or drill.h5")->required();
  command->add_option("-o,--output", options->output, "file to write (.toml)")
      ->default_val("config.toml")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
