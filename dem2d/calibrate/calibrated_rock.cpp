#include "dem2d/calibrate/calibrated_rock.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "base/version.hpp"

namespace dem2d {

namespace {

constexpr PerProperty<double> fresh_tolerances{0.03, 0.03, 0.02, 0.01};

std::string with_unit(Property property, const std::string& number) {
  const std::string unit = words_of(property).unit;
  return unit.empty() ? number : number + " " + unit;
}

std::string error_text(Property property, double value, double wanted) {
  const double error = error_of(property, value, wanted);
  return words_of(property).relative_error ? fmt::format("{:+.1f} %", 100.0 * error) : fmt::format("{:+.3f}", error);
}

std::string seeds_text(int first, int last, int count) {
  return count == 1 ? fmt::format("seed {}", first) : fmt::format("seeds {} to {}", first, last);
}

/// A comment ends with its line, whatever a name or a command contains.
std::string on_one_line(std::string text) {
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  }
  return text;
}

/// The number of specimens behind an evaluation.
int specimens_of(const CalibrationTarget& target, const Evaluation& evaluation) {
  for (const Property property : all_properties) {
    if (is_wanted(target, property)) return evaluation.measured[index_of(property)].count;
  }
  return 0;
}

/// What one could change where the search may not, for the first number that is missed.
std::string advice(const CalibrationTarget& target, const Calibration& calibration) {
  for (const Property property : all_properties) {
    const base::Summary& measured = calibration.best.measured[index_of(property)];
    if (!is_wanted(target, property) || is_met(target, property, measured)) continue;
    const bool more = measured.mean < target.wanted[index_of(property)];
    if (property == Property::ucs) {
      return more ? "a larger strength ratio needs fewer elements a joint (flat_joints.elements) in the start rock"
                  : "a smaller strength ratio needs more elements a joint (flat_joints.elements) in the start rock";
    }
    if (property == Property::poissons_ratio) {
      return more ? "discs in two dimensions hardly give more; a denser packing (packing.pressure_MPa) changes it a "
                    "little"
                  : "a Poisson's ratio this small needs stiffness ratios below those allowed";
    }
  }
  return "";
}

}  // namespace

double fresh_tolerance(Property property) {
  return fresh_tolerances[index_of(property)];
}

Rock calibrated_rock(const CalibrationTarget& target, const Calibration& calibration) {
  Rock rock = with_micro(target.start, calibration.best.micro);
  rock.name = target.name + (calibration.end == SearchEnd::reached ? "" : " (nearest, target not reached)");
  return rock;
}

std::vector<std::string> lines_about(const CalibrationTarget& target, const Evaluation& evaluation) {
  std::vector<std::string> lines;
  for (const Property property : all_properties) {
    if (!is_wanted(target, property)) continue;
    const double unit = words_of(property).si_per_unit, wanted = target.wanted[index_of(property)];
    const base::Summary& measured = evaluation.measured[index_of(property)];
    lines.push_back(fmt::format(
        "{}: wanted {}, reached {} ({})", words_of(property).name,
        with_unit(property, fmt::format("{:g}", base::in_units(wanted, unit))),
        with_unit(property, fmt::format("{:.4g} +- {:.2g}", measured.mean / unit, measured.standard_deviation / unit)),
        error_text(property, measured.mean, wanted)));
  }
  return lines;
}

std::string reason_of(const CalibrationTarget& target, const Calibration& calibration) {
  std::string reason;
  switch (calibration.end) {
    case SearchEnd::reached:
      return "";
    case SearchEnd::out_of_reach:
      reason = "out of reach of this model";
      break;
    case SearchEnd::stalled:
      reason = "the last evaluations came no nearer";
      break;
    case SearchEnd::out_of_budget:
      reason = fmt::format("calibration.most_evaluations = {} were not enough", target.settings.most_evaluations);
      break;
  }
  if (calibration.end == SearchEnd::out_of_reach) {
    for (const std::string& limit : calibration.limits) reason += "; " + limit;
    const std::string help = advice(target, calibration);
    if (!help.empty()) reason += "; " + help;
  }
  return reason;
}

std::string calibrated_rock_toml(const CalibrationTarget& target, const Calibration& calibration,
                                 const std::string& command, const std::optional<FreshSpecimens>& fresh) {
  Rock rock = calibrated_rock(target, calibration);
  std::string text = fmt::format("# {}, made by bitrock {} ({}):\n#   {}\n", on_one_line(rock.name), base::version,
                                 base::git_commit, on_one_line(command));
  if (calibration.end != SearchEnd::reached) text += fmt::format("# NOT REACHED: {}\n", reason_of(target, calibration));
  const int count = specimens_of(target, calibration.best), first = target.settings.first_seed;
  text +=
      fmt::format("# Means +- standard deviations over cores of {:g} x {:g} mm, {}:\n",
                  base::in_units(target.start.specimen_width, base::mm),
                  base::in_units(target.start.specimen_height, base::mm), seeds_text(first, first + count - 1, count));
  for (const std::string& line : lines_about(target, calibration.best)) text += "#   " + line + "\n";
  if (fresh) {
    text += fmt::format("# On specimens the calibration has not seen, {}:\n",
                        seeds_text(fresh->seeds.front(), fresh->seeds.back(), static_cast<int>(fresh->seeds.size())));
    for (const std::string& line : lines_about(target, fresh->result)) text += "#   " + line + "\n";
  }
  return text + "\n" + base::to_toml(describe(rock));
}

}  // namespace dem2d
