#include "studies/calibrate/calibrated_rock.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "base/version.hpp"

namespace bitrock::studies {

namespace {

constexpr PerProperty<double> fresh_tolerances{0.03, 0.03, 0.02, 0.01, 0.03};

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

/// Bytes of the UTF-8 letter at the beginning of `text` (RFC 3629); 0 when it is none.
std::size_t letter_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xbf; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first >= 0xc2 && first <= 0xdf) return follows(1) ? 2 : 0;
  if (first == 0xe0 && second < 0xa0) return 0;  // could be written shorter
  if (first == 0xed && second > 0x9f) return 0;  // halves of UTF-16 pairs
  if (first >= 0xe0 && first <= 0xef) return follows(1) && follows(2) ? 3 : 0;
  if (first == 0xf0 && second < 0x90) return 0;  // could be written shorter
  if (first == 0xf4 && second > 0x8f) return 0;  // above the last letter
  return first >= 0xf0 && first <= 0xf4 && follows(1) && follows(2) && follows(3) ? 4 : 0;
}

/// A comment ends with its line and has no control characters, whatever a name or a command contains; a file name may
/// even be no text at all.
std::string on_one_line(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = letter_length(text);
    const bool control = length == 1 && (static_cast<unsigned char>(text[0]) < ' ' || text[0] == '\x7f');
    line += length == 0 ? "?" : control ? " " : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return line;
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
      return more ? "a larger strength ratio needs more scatter of the strengths "
                    "(flat_joints.*_deviation_MPa), a denser packing (packing.pressure_MPa) or fewer elements a joint "
                    "(flat_joints.elements) in the start rock"
                  : "a smaller strength ratio needs more elements a joint (flat_joints.elements) in the start rock";
    }
    if (property == Property::poissons_ratio) {
      return more ? "discs in two dimensions hardly give more; a denser packing (packing.pressure_MPa) changes it a "
                    "little"
                  : "a Poisson's ratio this small needs stiffness ratios below those allowed";
    }
    if (property == Property::confined_strength) {
      return more ? "more strength under pressure needs more friction of broken joints "
                    "(flat_joints.friction_coefficient) in the start rock"
                  : "less strength under pressure needs less friction of broken joints "
                    "(flat_joints.friction_coefficient) in the start rock";
    }
  }
  return "";
}

}  // namespace

double fresh_tolerance(Property property) {
  return fresh_tolerances[index_of(property)];
}

dem2d::Rock calibrated_rock(const CalibrationTarget& target, const Calibration& calibration) {
  dem2d::Rock rock = with_micro(target.start, calibration.best.micro);
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

void require_reached(const CalibrationTarget& target, const Calibration& calibration, const std::string& rock_file) {
  if (calibration.end == SearchEnd::reached) return;
  std::string nearest;
  for (const std::string& line : lines_about(target, calibration.best)) nearest += "\n  " + line;
  throw base::SimulationError(fmt::format("the target was not reached: {}; the nearest is kept in {}:{}",
                                          reason_of(target, calibration), rock_file, nearest));
}

std::string calibrated_rock_toml(const CalibrationTarget& target, const Calibration& calibration,
                                 const std::string& command, const std::optional<FreshSpecimens>& fresh) {
  dem2d::Rock rock = calibrated_rock(target, calibration);
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
  text += fmt::format("\n{}", base::to_toml(dem2d::describe(rock)));
  try {
    dem2d::parse_rock(text, "the calibrated rock");
  } catch (const base::InputError& error) {
    throw base::SimulationError(fmt::format("{}: not written, because no command could read it", error.what()));
  }
  return text;
}

}  // namespace bitrock::studies
