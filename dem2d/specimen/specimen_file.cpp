#include "dem2d/specimen/specimen_file.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "base/version.hpp"
#include "dem2d/specimen/genesis.hpp"

namespace dem2d {

namespace {
constexpr const char* format_name = "bitrock-specimen";
constexpr long long format_version = 1;
}  // namespace

void write_specimen(const Specimen& specimen, const std::filesystem::path& path) {
  base::Hdf5Writer file;
  file.attribute("format", format_name);
  file.attribute("format_version", format_version);
  file.attribute("version", base::version);
  file.attribute("git_commit", base::git_commit);
  file.attribute("genesis_version", static_cast<long long>(genesis_version));
  Rock rock = specimen.rock;
  rock.specimen_width = specimen.width;  // whatever the rock file says of it: so the text makes this one again
  rock.specimen_height = specimen.height;
  file.attribute("config_toml", base::to_exact_toml(describe(rock)));
  file.attribute("seed", static_cast<long long>(specimen.seed));
  file.attribute("width_m", specimen.width);
  file.attribute("height_m", specimen.height);
  file.attribute("origin", specimen.origin);
  file.attribute("equilibrium_ratio", specimen.equilibrium_ratio);
  file.attribute("pressure_Pa", specimen.pressure);
  file.attribute("radius_factor", specimen.radius_factor);
  file.array("/discs/x_m", specimen.x, "m", "disc centre, along the surface");
  file.array("/discs/y_m", specimen.y, "m", "disc centre, upwards from the bottom");
  file.array("/discs/radius_m", specimen.radius, "m", "disc radius");
  file.array("/joints/disc_1", specimen.disc1, "1", "first disc of a joined pair");
  file.array("/joints/disc_2", specimen.disc2, "1", "second disc of a joined pair");
  file.attribute("status", "complete");
  file.save(path);
}

Specimen read_specimen(const std::filesystem::path& path) {
  const base::Hdf5Reader file(path);
  file.require_format(format_name, format_version);
  const auto refuse = [&](const std::string& why) {
    throw base::InputError(fmt::format("{}: {}", path.string(), why));
  };
  if (file.number_attribute("genesis_version") != genesis_version)
    refuse("made by another version of the packing; make it again");
  Specimen specimen;
  specimen.rock = parse_rock(file.text_attribute("config_toml"), path.string() + " (config_toml)");
  specimen.seed = static_cast<std::uint64_t>(file.number_attribute("seed"));
  specimen.width = file.number_attribute("width_m");
  specimen.height = file.number_attribute("height_m");
  specimen.origin = file.text_attribute("origin");
  specimen.equilibrium_ratio = file.number_attribute("equilibrium_ratio");
  specimen.pressure = file.number_attribute("pressure_Pa");
  specimen.radius_factor = file.number_attribute("radius_factor");
  specimen.x = file.doubles("/discs/x_m");
  specimen.y = file.doubles("/discs/y_m");
  specimen.radius = file.doubles("/discs/radius_m");
  specimen.disc1 = file.ints("/joints/disc_1");
  specimen.disc2 = file.ints("/joints/disc_2");

  const std::size_t discs = specimen.x.size();
  if (discs == 0 || specimen.y.size() != discs || specimen.radius.size() != discs)
    refuse("disc arrays differ in length");
  if (specimen.disc1.size() != specimen.disc2.size()) refuse("joint arrays differ in length");
  for (std::size_t i = 0; i < discs; ++i) {
    if (!std::isfinite(specimen.x[i] + specimen.y[i]) || !(specimen.radius[i] > 0.0))
      refuse(fmt::format("disc {} has no valid place or radius", i));
  }
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    const int a = specimen.disc1[k], b = specimen.disc2[k];
    if (a < 0 || b <= a || b >= static_cast<int>(discs)) refuse(fmt::format("joint {} names discs {} and {}", k, a, b));
  }
  return specimen;
}

}  // namespace dem2d
