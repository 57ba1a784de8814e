#include "studies/calibrate/target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "dem2d/lab/lab_test.hpp"

namespace bitrock::studies {

namespace {

using base::GPa, base::MPa;

constexpr int largest_seed = std::numeric_limits<int>::max();

// UCS over tensile strength that the shipped start.toml reaches (docs/results/validation.md, "What decides the ratio of
// the strengths").
constexpr double reached_strength_ratio = 14.0;

struct TargetFile {
  std::string rock;
  std::vector<double> pressures_MPa, strengths_MPa;  ///< one strength a pressure
  double tolerance_percent = 1.0;
};

std::vector<base::Section> describe(CalibrationTarget& target, TargetFile& written) {
  using base::any, base::between;
  // Ten times beyond the softest and the strongest rock there is, near enough to catch Pa and kPa written for MPa. Not
  // above 0.5: an elastic body that grows when it is pressed does not exist.
  const base::Range ucs = between(0.01, 5000.0), tension = between(1e-3, 500.0), modulus = between(1e-3, 1000.0);
  const auto wanted = [&target](Property property) { return &target.wanted[index_of(property)]; };
  const base::Range below_half{.low = 0.0, .high = largest_poissons_ratio, .low_open = true};
  const base::Range tolerance{.low = 0.0, .high = 20.0, .low_open = true};
  const base::Range small{.low = 0.0, .high = 0.1, .low_open = true};
  CalibrationSettings& settings = target.settings;
  return {
      {"target",
       {{"name", &target.name, 1.0, any(), "what the calibrated rock will be called", true},
        {"ucs_MPa", wanted(Property::ucs), MPa, ucs, "uniaxial compressive strength"},
        {"tensile_strength_MPa", wanted(Property::tensile_strength), MPa, tension, "in direct tension"},
        {"youngs_modulus_GPa", wanted(Property::youngs_modulus), GPa, modulus, "in direct tension"},
        {"poissons_ratio", wanted(Property::poissons_ratio), 1.0, below_half, "in direct tension"},
        {"confining_pressures_MPa", &written.pressures_MPa, 1.0, dem2d::confining_pressure_MPa,
         "of triaxial tests, e.g. [5, 20]"},
        {"confined_strengths_MPa", &written.strengths_MPa, 1.0, ucs,
         "largest stress along the load under each of these pressures, the pressure included"}}},
      {"start", {{"rock", &written.rock, 1.0, any(), "rock file whose other parameters are kept", true}}},
      {"calibration",
       {{"first_seed", &settings.first_seed, 1.0, between(0, largest_seed), "of the specimens"},
        {"seeds", &settings.seeds, 1.0, between(1, 1000), "specimens whose means are fitted"},
        {"scouting_seeds", &settings.scouting_seeds, 1.0, between(1, 1000), "of them in the first, coarse search"},
        {"most_evaluations", &settings.most_evaluations, 1.0, between(1, 1000), "sets of micro-parameters tested"},
        {"tolerance_percent", &written.tolerance_percent, 1.0, tolerance, "of strengths and Young's modulus"},
        {"poissons_ratio_tolerance", &settings.poissons_ratio_tolerance, 1.0, small, "of Poisson's ratio"}}},
  };
}

/// One strength a pressure, and stronger than without.
void take_confined(const base::ConfigFile& file, const TargetFile& written, CalibrationTarget& target) {
  const std::size_t count = written.pressures_MPa.size();
  if (written.strengths_MPa.size() != count) {
    file.refuse("target", count > 0 ? "confining_pressures_MPa" : "confined_strengths_MPa",
                fmt::format("{} pressures and {} strengths: each confined strength needs its pressure", count,
                            written.strengths_MPa.size()));
  }
  if (count == 0) return;
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    target.pressures.push_back(written.pressures_MPa[k] * MPa);
    const double strength = written.strengths_MPa[k] * MPa;
    sum += strength;
    if (target.pressures.back() <= 0.0)
      file.refuse("target", "confining_pressures_MPa", "must be above 0 (the strength without pressure is ucs_MPa)");
    if (strength <= target.pressures.back() + target.wanted[index_of(Property::ucs)]) {
      file.refuse(
          "target", "confined_strengths_MPa",
          fmt::format("{:g} MPa under {:g} MPa: must be above the pressure and ucs_MPa together (it is the whole "
                      "stress along the load)",
                      written.strengths_MPa[k], written.pressures_MPa[k]));
    }
  }
  target.wanted[index_of(Property::confined_strength)] = sum / static_cast<double>(count);
}

CalibrationTarget checked(base::ConfigFile file) {
  CalibrationTarget target;
  TargetFile written;
  for (const base::Section& section : describe(target, written)) file.fill(section);
  file.refuse_unknown();
  take_confined(file, written, target);
  if (std::none_of(all_properties.begin(), all_properties.end(), [&](Property p) { return is_wanted(target, p); })) {
    throw base::InputError(
        fmt::format("{}: [target] names nothing to calibrate to (at least one of ucs_MPa, tensile_strength_MPa, "
                    "youngs_modulus_GPa, poissons_ratio, confined_strengths_MPa)",
                    file.name()));
  }
  const double compression = target.wanted[index_of(Property::ucs)];
  const double tension = target.wanted[index_of(Property::tensile_strength)];
  if (compression > 0.0 && tension >= compression) {
    file.refuse("target", "tensile_strength_MPa", "must be below target.ucs_MPa: rock is weaker in tension");
  }
  CalibrationSettings& settings = target.settings;
  if (settings.first_seed > largest_seed - settings.seeds) {
    file.refuse("calibration", "first_seed", fmt::format("the last seed would be above {}", largest_seed));
  }
  settings.scouting_seeds = std::min(settings.scouting_seeds, settings.seeds);
  settings.tolerance = written.tolerance_percent / 100.0;
  target.rock_file = file.resolve(written.rock);
  target.start = dem2d::read_rock(target.rock_file);
  return target;
}

}  // namespace

bool is_wanted(const CalibrationTarget& target, Property property) {
  return target.wanted[index_of(property)] > 0.0;
}

double tolerance_of(const CalibrationTarget& target, Property property) {
  return words_of(property).relative_error ? target.settings.tolerance : target.settings.poissons_ratio_tolerance;
}

bool needs_compression(const CalibrationTarget& target) {
  return is_wanted(target, Property::ucs);
}

bool needs_tension(const CalibrationTarget& target) {
  return is_wanted(target, Property::tensile_strength) || is_wanted(target, Property::youngs_modulus) ||
         is_wanted(target, Property::poissons_ratio);
}

std::vector<std::string> warnings(const CalibrationTarget& target) {
  std::vector<std::string> found;
  const double nu = target.wanted[index_of(Property::poissons_ratio)];
  if (nu > dem2d::largest_elastic_ratio) {
    found.push_back(fmt::format(
        "target.poissons_ratio = {:.4g}: bonded discs in two dimensions have less than 1/3, whatever their stiffness "
        "ratio; a plane has another ratio than the body (nu / (1 - nu) in plane strain, nu in plane stress)",
        nu));
  }
  const double compression = target.wanted[index_of(Property::ucs)];
  const double tension = target.wanted[index_of(Property::tensile_strength)];
  if (tension > 0.0 && compression / tension > reached_strength_ratio) {
    found.push_back(fmt::format(
        "target: UCS over tensile strength is {:.3g}; campaigns/rocks/start.toml reaches about {:.2g}, other "
        "start rocks up to 18 (docs/results/validation.md): one of the two may stay out of reach",
        compression / tension, reached_strength_ratio));
  }
  return found;
}

CalibrationTarget read_target(const std::filesystem::path& path) {
  return checked(base::ConfigFile::read(path));
}

CalibrationTarget parse_target(const std::string& text, const std::string& name) {
  return checked(base::ConfigFile::from_text(text, name));
}

std::vector<base::KeyRow> target_keys() {
  CalibrationTarget target;
  TargetFile written;
  return base::key_rows(describe(target, written));
}

}  // namespace bitrock::studies
