// bitrock hold: networks that also ask for the pressure of the mud or properties of the rock, at fixed values of these.
#include <fmt/ranges.h>

#include <memory>

#include "cli/command.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, output;
  std::vector<std::string> held;
};

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_model(options.model_file);
  const surrogate::Model narrow = surrogate::held(model, surrogate::held_inputs(options.held));
  require_outputs(options.common, {options.model_file}, {options.output});
  surrogate::write_model(options.output, narrow);
  say(options.common, "networks of {} inputs at {}: they ask for speed, depth and rake\n-> {}\n", model.inputs.size(),
      fmt::join(options.held, ", "), options.output);
  write_json(options.common, {{"files", {options.output}}, {"held", options.held}});
}

}  // namespace

void add_hold(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "hold",
      "Fixes further inputs of networks (mud pressure, properties of the rock), for a bit, a string or an export.");
  add_model_file(*command, options->model_file);
  command
      ->add_option("held", options->held, "Each further input has this value: NAME=VALUE, e.g. fluid_pressure_MPa=20.")
      ->required();
  command->add_option("-o,--output", options->output, "The networks go to this model file.")
      ->default_val("held.json")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
