// bitrock export fmu: the force on a bit, or a whole drill string, for simulation programs that load FMUs.
#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/drill_parts.hpp"
#include "runtime/fmu/fmu_file.hpp"
#include "runtime/fmu/string_file.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, bit_file, case_file, output;
};

/// Writes the file, and says what it is. `holds` begins the line, `keys` the JSON.
void write(const Options& options, const std::string& output, const fmu::FmuFile& file, const std::string& holds,
           nlohmann::json keys) {
  base::write_whole(output, file.bytes);
  say(options.common, "{}: FMI 2.0 co-simulation for {}, {:.0f} kB, guid {}\n-> {}\n", holds,
      fmt::join(file.platforms, " and "), static_cast<double>(file.bytes.size()) / 1e3, file.guid, output);
  if (std::find(file.platforms.begin(), file.platforms.end(), "win64") == file.platforms.end()) {
    say(options.common,
        "no library for Windows: this bitrock was built without the compiler for it (install Debian's "
        "g++-mingw-w64-x86-64-posix, and build again)\n");
  }
  keys["files"] = {output};
  keys["guid"] = file.guid;
  keys["platforms"] = file.platforms;
  keys["bytes"] = file.bytes.size();
  write_json(options.common, keys);
}

/// The file of the flag, or the usual one.
std::string output_of(const Options& options, const std::string& usual) {
  std::string output = options.output.empty() ? usual : options.output;
  if (std::filesystem::path(output).extension() != ".fmu")
    throw base::InputError(fmt::format("{} (an FMU must end in .fmu)", output));
  return output;
}

void export_bit(const Options& options) {
  if (options.bit_file.empty())
    throw base::InputError("a model file and a bit file are needed (or --drill with a drilling case)");
  const surrogate::Model model = surrogate::read_cut_model(options.model_file);
  const runtime::Bit bit = runtime::read_bit(options.bit_file);
  warn_of_bit(options.common, bit, model);
  const std::string output = output_of(options, "bit.fmu");
  require_outputs(options.common, {options.model_file, options.bit_file}, {output});
  write(options, output, fmu::fmu_file(bit, model), fmt::format("{}, rock '{}'", bit.name, model.rock),
        {{"bit", bit.name}, {"rock", model.rock}});
}

template <class Case>
void export_case(const Options& options, const Case& whole, runtime::DrillCase& drill,
                 const std::filesystem::path& survey) {
  const CaseFlags flags{.file = options.case_file, .model_file = options.model_file};
  const std::optional<surrogate::Model> model = model_of(options.common, flags, drill);
  const std::string output = output_of(options, "string.fmu");
  std::vector<std::filesystem::path> inputs = inputs_of(flags, drill);
  inputs.push_back(survey);
  require_outputs(options.common, inputs, {output});
  write(options, output, fmu::fmu_file(whole, model), drill.name,
        {{"bit", drill.bit.name}, {"rock", model ? model->rock : ""}});
}

void export_string(const Options& options) {
  if (!options.bit_file.empty())
    throw base::InputError(options.bit_file + " (with --drill the case names its bit: give no bit file)");
  if (runtime::has_well(options.case_file)) {
    runtime::WellCase well = read_well(options.common, options.case_file);
    return export_case(options, well, well.drill, well.survey_file);
  }
  runtime::DrillCase drill = runtime::read_drill_case(options.case_file);
  const runtime::DrillString string = runtime::assemble(drill);
  for (const std::string& warning : runtime::warnings(drill, string)) warn(options.common, warning);
  export_case(options, drill, drill, {});
}

}  // namespace

void add_export_fmu(CLI::App& export_command) {
  CLI::App* command = export_command.add_subcommand(
      "fmu",
      "Writes the force and torque on a bit, or a whole drill string, as an FMU (FMI 2.0, co-simulation) for Simulink, "
      "20-sim, OMSimulator and others.");
  auto options = std::make_shared<Options>();
  command->add_option("model", options->model_file,
                      "The model file with the networks, e.g. campaigns/paper240/model.json; with --drill it stands in "
                      "place of the one that the case names.");
  command->add_option("bit", options->bit_file, "The bit file, e.g. campaigns/bits/pdc15.toml.");
  command
      ->add_option("--drill", options->case_file,
                   "The FMU holds the whole drill string of this drilling case, with its bit and well, e.g. "
                   "campaigns/drill/deviated.toml.")
      ->check(not_empty());
  command
      ->add_option("-o,--output", options->output,
                   "The result goes to this file; without the flag to bit.fmu, or with --drill to string.fmu.")
      ->check(not_empty());
  add_common(*command, options->common);
  command->callback([options] { options->case_file.empty() ? export_bit(*options) : export_string(*options); });
}

}  // namespace bitrock::cli
