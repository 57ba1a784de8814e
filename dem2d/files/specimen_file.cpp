#include "dem2d/files/specimen_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "dem2d/specimen/genesis.hpp"

namespace bitrock::dem2d {

namespace {
constexpr const char* format_name = "bitrock-specimen";
constexpr long long format_version = 1;

/// Why the joints cannot be those of the discs, in words; empty when they can.
std::string impossible_joints(const Specimen& specimen) {
  if (specimen.disc1.size() != specimen.disc2.size()) return "joint arrays differ in length";
  const auto discs = static_cast<int>(specimen.x.size());
  const double farthest = specimen.rock.installation_gap + 1e-9;  // rounding [m]
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < specimen.disc1.size(); ++k) {
    const int a = specimen.disc1[k], b = specimen.disc2[k];
    if (a < 0 || b <= a || b >= discs) return fmt::format("joint {} names discs {} and {}", k, a, b);
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    const double distance = std::hypot(specimen.x[j] - specimen.x[i], specimen.y[j] - specimen.y[i]);
    if (distance - specimen.radius[i] - specimen.radius[j] > farthest) {
      return fmt::format("joint {} joins discs {} and {}, which are not neighbours", k, a, b);
    }
    pairs.emplace_back(a, b);
  }
  std::sort(pairs.begin(), pairs.end());
  const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
  return twice == pairs.end() ? "" : fmt::format("discs {} and {} are joined twice", twice->first, twice->second);
}

/// Why the file cannot be a specimen of ours, in words; empty when it can.
std::string impossible(const Specimen& specimen) {
  const std::size_t discs = specimen.x.size();
  if (discs == 0 || specimen.y.size() != discs || specimen.radius.size() != discs)
    return "disc arrays differ in length";
  if (static_cast<double>(discs) > most_discs) return fmt::format("{} discs (at most {:g})", discs, most_discs);
  for (const auto& [name, size] : {std::pair{"width_m", specimen.width}, {"height_m", specimen.height}}) {
    if (!(size > 0.0 && size <= allowed_place.high)) {
      return fmt::format("{} = {} (must be above 0 and at most {:g})", name, size, allowed_place.high);
    }
  }
  for (std::size_t i = 0; i < discs; ++i) {
    const double x = specimen.x[i], y = specimen.y[i];
    const bool inside = x >= 0.0 && x <= specimen.width && y >= 0.0 && y <= specimen.height;
    if (!inside || !allowed_radius.contains(specimen.radius[i])) {
      return fmt::format("disc {} at ({}, {}) m of radius {} m (must lie in the box, its radius be {})", i, x, y,
                         specimen.radius[i], allowed_radius.text());
    }
  }
  if (const auto overlap = absurd_overlap(specimen)) {
    return fmt::format("discs {} and {} overlap by {:.3g} of the smaller radius (at most {})", overlap->disc1,
                       overlap->disc2, overlap->share, largest_overlap);
  }
  return impossible_joints(specimen);
}
}  // namespace

void write_specimen(const Specimen& specimen, const std::filesystem::path& path) {
  base::Hdf5Writer file;
  file.head(format_name, format_version);
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
  specimen.seed = static_cast<std::uint64_t>(file.integer_attribute("seed", 0, std::numeric_limits<long long>::max()));
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

  if (const std::string why = impossible(specimen); !why.empty()) refuse(why);
  return specimen;
}

}  // namespace bitrock::dem2d
