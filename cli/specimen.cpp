// bitrock specimen: one synthetic rock from a seed.
#include <cmath>
#include <memory>
#include <optional>

#include "base/errors.hpp"
#include "cli/command.hpp"
#include "dem2d/files/discs_file.hpp"
#include "dem2d/files/specimen_file.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "views/json/specimen_json.hpp"
#include "views/text/specimen_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string rock_file, discs_file, output;
  int seed = 1;
  double width_mm = 0.0, height_mm = 0.0;
};

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
  const dem2d::SpecimenSummary summary = dem2d::summary_of(specimen);
  say(options.common, "{} -> {}\n", views::specimen_lines(specimen, summary), options.output);
  write_json(options.common, views::as_json(specimen, summary));
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
