// bitrock specimen: one synthetic rock from a seed.
#include <cmath>
#include <memory>

#include "cli/command.hpp"
#include "dem2d/specimen/specimen_file.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::string rock_file, output;
  int seed = 1;
  double width_mm = 0.0, height_mm = 0.0;
};

double critical_step_of(const dem2d::Specimen& specimen) {
  dem2d::World world = dem2d::bonded_world(specimen, 1);
  world.domain = {0.0, 0.0, specimen.width, specimen.height};
  dem2d::prepare(world);
  return dem2d::critical_step(world);
}

void run(const Options& options) {
  const dem2d::Rock rock = dem2d::read_rock(options.rock_file);
  const double width = options.width_mm > 0.0 ? options.width_mm * 1e-3 : rock.specimen_width;
  const double height = options.height_mm > 0.0 ? options.height_mm * 1e-3 : rock.specimen_height;
  dem2d::check_specimen_size(rock, width, height, options.rock_file);
  if (options.common.check) {
    require_outputs(options.common, {options.rock_file}, {});
    const double discs = dem2d::expected_discs(rock, width, height);
    say(options.common, "{}: {:.4g} x {:.4g} mm, about {:.0f} discs\n", rock.name, width * 1e3, height * 1e3, discs);
    write_json(options.common, {{"discs", std::llround(discs)}, {"width_m", width}, {"height_m", height}});
    return;
  }
  require_outputs(options.common, {options.rock_file}, {options.output});
  Progress progress(options.common, "packing", "");
  const dem2d::Specimen specimen = dem2d::make_specimen(rock, width, height, static_cast<std::uint64_t>(options.seed),
                                                        options.common.threads, progress.callback());
  dem2d::write_specimen(specimen, options.output);
  const nlohmann::json result{{"discs", specimen.x.size()},
                              {"joints", specimen.disc1.size()},
                              {"porosity", dem2d::porosity(specimen)},
                              {"coordination_number", dem2d::coordination_number(specimen)},
                              {"floaters", dem2d::floaters(specimen)},
                              {"equilibrium_ratio", specimen.equilibrium_ratio},
                              {"critical_step_s", critical_step_of(specimen)},
                              {"width_m", width},
                              {"height_m", height},
                              {"seed", options.seed}};
  say(options.common, "{}: {} discs, {} joints, coordination {:.2f}, porosity {:.3f}, critical step {:.3g} s -> {}\n",
      rock.name, specimen.x.size(), specimen.disc1.size(), dem2d::coordination_number(specimen),
      dem2d::porosity(specimen), result["critical_step_s"].get<double>(), options.output);
  write_json(options.common, result);
}

}  // namespace

void add_specimen(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("specimen", "make one synthetic rock: packed discs, joined stress-free");
  command->add_option("rock", options->rock_file, "rock file, e.g. campaigns/rocks/article.toml")->required();
  command->add_option("--seed", options->seed, "another seed, another rock")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "specimen file to write (.h5)")->default_val("specimen.h5");
  command->add_option("--width-mm", options->width_mm, "instead of specimen.width_mm of the rock file")
      ->check(finite_positive());
  command->add_option("--height-mm", options->height_mm, "instead of specimen.height_mm of the rock file")
      ->check(finite_positive());
  add_computing(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
