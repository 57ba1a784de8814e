// bitrock export fmu: the force on a bit for simulation programs that load FMUs.
#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/bit_tallies.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, bit_file, output;
};

void run(const Options& options) {
  const surrogate::Model model = surrogate::read_cut_model(options.model_file);
  const runtime::Bit bit = runtime::read_bit(options.bit_file);
  warn_of_bit(options.common, bit, model);
  if (std::filesystem::path(options.output).extension() != ".fmu")
    throw base::InputError(fmt::format("{} (an FMU must end in .fmu)", options.output));
  require_outputs(options.common, {options.model_file, options.bit_file}, {options.output});
  const fmu::FmuFile file = fmu::fmu_file(bit, model);
  base::write_whole(options.output, file.bytes);
  say(options.common, "{}, rock '{}': FMI 2.0 co-simulation for {}, {:.0f} kB, guid {}\n-> {}\n", bit.name, model.rock,
      fmt::join(file.platforms, " and "), static_cast<double>(file.bytes.size()) / 1e3, file.guid, options.output);
  if (std::find(file.platforms.begin(), file.platforms.end(), "win64") == file.platforms.end()) {
    say(options.common,
        "no library for Windows: this bitrock was built without the compiler for it (install Debian's "
        "g++-mingw-w64-x86-64-posix, and build again)\n");
  }
  write_json(options.common, {{"files", {options.output}},
                              {"guid", file.guid},
                              {"platforms", file.platforms},
                              {"bytes", file.bytes.size()},
                              {"bit", bit.name},
                              {"rock", model.rock}});
}

}  // namespace

void add_export_fmu(CLI::App& export_command) {
  CLI::App* command = export_command.add_subcommand("fmu",
                                                    "Writes the force and torque on a bit as an FMU (FMI 2.0, "
                                                    "co-simulation) for Simulink, 20-sim, OMSimulator and others.");
  auto options = std::make_shared<Options>();
  add_model_file(*command, options->model_file);
  add_bit_file(*command, options->bit_file);
  command->add_option("-o,--output", options->output, "The result goes to this file.")
      ->default_val("bit.fmu")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
