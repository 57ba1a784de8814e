// bitrock specimen: one synthetic rock from a seed.
#include <cmath>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "cli/command.hpp"
#include "dem2d/files/discs_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string rock_file, discs_file, output;
  int seed = 1;
  double width_mm = 0.0, height_mm = 0.0;
};

double critical_step_of(const dem2d::Specimen& specimen) {
  dem2d::World world = dem2d::bonded_world(specimen, 1);
  world.domain = {0.0, 0.0, specimen.width, specimen.height};
  dem2d::prepare(world);
  return dem2d::critical_step(world);
}

bool from_discs(const Options& options) {
  return !options.discs_file.empty();
}

/// The box asked for on the command line or in the rock file.
dem2d::BoxSize box_of(const Options& options, const dem2d::Rock& rock) {
  return {.width = options.width_mm > 0.0 ? options.width_mm * 1e-3 : rock.specimen_width,
          .height = options.height_mm > 0.0 ? options.height_mm * 1e-3 : rock.specimen_height};
}

dem2d::Specimen read_discs(const Options& options, const dem2d::Rock& rock) {
  std::optional<dem2d::BoxSize> box;  // the size in the rock file is for specimens that are packed here
  if ((options.width_mm > 0.0) != (options.height_mm > 0.0)) {
    throw base::InputError("--from-discs: --width-mm and --height-mm go together (the box is given, or it is fitted)");
  }
  if (options.width_mm > 0.0) box = box_of(options, rock);
  return dem2d::specimen_from_discs(options.discs_file, rock, static_cast<std::uint64_t>(options.seed), box);
}

dem2d::Specimen pack(const Options& options, const dem2d::Rock& rock) {
  const dem2d::BoxSize box = box_of(options, rock);
  Progress progress(options.common, "packing", "");
  return dem2d::make_specimen(rock, box.width, box.height, static_cast<std::uint64_t>(options.seed),
                              options.common.threads, progress.callback());
}

void warn_about(const Options& options, const dem2d::Specimen& specimen) {
  if (specimen.packed_elsewhere()) {
    for (const std::string& warning : dem2d::discs_warnings(specimen)) warn(options.common, warning);
  }
  for (const std::string& warning : dem2d::warnings(specimen)) warn(options.common, warning);
}

void check(const Options& options, const dem2d::Rock& rock) {
  require_outputs(options.common, {options.rock_file, options.discs_file}, {});
  const dem2d::BoxSize box = box_of(options, rock);
  nlohmann::json result;
  if (from_discs(options)) {
    const dem2d::Specimen specimen = read_discs(options, rock);
    warn_about(options, specimen);
    result = {{"discs", specimen.x.size()}, {"width_m", specimen.width}, {"height_m", specimen.height}};
  } else {
    const double discs = dem2d::expected_discs(rock, box.width, box.height);
    result = {{"discs", std::llround(discs)}, {"width_m", box.width}, {"height_m", box.height}};
  }
  say(options.common, "{}: {:.4g} x {:.4g} mm, {}{} discs\n", rock.name, result["width_m"].get<double>() * 1e3,
      result["height_m"].get<double>() * 1e3, from_discs(options) ? "" : "about ", result["discs"].get<long long>());
  write_json(options.common, result);
}

void report(const Options& options, const dem2d::Specimen& specimen) {
  const dem2d::Pieces pieces = dem2d::pieces(specimen);
  nlohmann::json result{{"discs", specimen.x.size()},
                        {"joints", specimen.disc1.size()},
                        {"porosity", dem2d::porosity(specimen)},
                        {"coordination_number", dem2d::coordination_number(specimen)},
                        {"floaters", dem2d::floaters(specimen)},
                        {"pieces", pieces.count},
                        {"discs_of_largest_piece", pieces.largest},
                        {"discs_without_joint", pieces.unjoined},
                        {"equilibrium_ratio", specimen.equilibrium_ratio},
                        {"pressure_Pa", specimen.pressure},
                        {"radius_factor", specimen.radius_factor},
                        {"critical_step_s", critical_step_of(specimen)},
                        {"width_m", specimen.width},
                        {"height_m", specimen.height},
                        {"origin", specimen.origin},
                        {"seed", options.seed}};
  std::string packed = fmt::format("packed under {:.4g} MPa (equilibrium ratio {:.2g}, radii x {:.4f})",
                                   specimen.pressure * 1e-6, specimen.equilibrium_ratio, specimen.radius_factor);
  if (specimen.packed_elsewhere()) {
    for (const char* unknown : {"equilibrium_ratio", "pressure_Pa", "radius_factor"}) result[unknown] = nullptr;
    packed = specimen.origin;
  }
  say(options.common, "{}: {:.4g} x {:.4g} mm, {} discs, {} joints, coordination {:.2f}, porosity {:.3f}\n",
      specimen.rock.name, specimen.width * 1e3, specimen.height * 1e3, specimen.x.size(), specimen.disc1.size(),
      result["coordination_number"].get<double>(), result["porosity"].get<double>());
  say(options.common, "{}, {} piece{} joined, {} floaters (less than 3 joints), critical step {:.3g} s -> {}\n", packed,
      pieces.count, pieces.count == 1 ? "" : "s", result["floaters"].get<int>(),
      result["critical_step_s"].get<double>(), options.output);
  write_json(options.common, result);
}

void run(const Options& options) {
  const dem2d::Rock rock = dem2d::read_rock(options.rock_file);
  if (!from_discs(options)) {
    const dem2d::BoxSize box = box_of(options, rock);
    dem2d::check_specimen_size(rock, box.width, box.height, options.rock_file);
  }
  if (options.common.check) return check(options, rock);
  require_outputs(options.common, {options.rock_file, options.discs_file}, {options.output});
  const dem2d::Specimen specimen = from_discs(options) ? read_discs(options, rock) : pack(options, rock);
  dem2d::write_specimen(specimen, options.output);
  report(options, specimen);
  warn_about(options, specimen);
}

}  // namespace

void add_specimen(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("specimen", "Makes one synthetic rock: discs, packed and then joined without stress.");
  command->add_option("rock", options->rock_file, "The rock file, e.g. campaigns/rocks/article.toml.")->required();
  command
      ->add_option("--seed", options->seed,
                   "The seed chooses the rock: another seed packs another one of the same kind.")
      ->check(CLI::Range(0, 2147483647))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "The rock goes to this specimen file (.h5).")
      ->default_val("specimen.h5");
  command
      ->add_option("--width-mm", options->width_mm,
                   "The specimen is so wide, whatever specimen.width_mm of the rock file says.")
      ->check(within("--width-mm", dem2d::specimen_length_mm));
  command
      ->add_option("--height-mm", options->height_mm,
                   "The specimen is so high, whatever specimen.height_mm of the rock file says.")
      ->check(within("--height-mm", dem2d::specimen_length_mm));
  command
      ->add_option("--from-discs", options->discs_file,
                   "The program joins the discs of this table (x_m, y_m, radius_m) instead of packing some. The box is "
                   "fitted to "
                   "them unless --width-mm and --height-mm say where it ends.")
      ->check(not_empty());
  add_computing(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
