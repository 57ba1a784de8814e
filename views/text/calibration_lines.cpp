#include "views/text/calibration_lines.hpp"

#include <fmt/format.h>

#include "base/progress.hpp"
#include "base/units.hpp"
#include "base/value_lists.hpp"

namespace bitrock::views {

namespace {

using studies::Property;

std::string micro_text(const studies::Micro& micro) {
  return fmt::format(
      "E* {:.4g} GPa, kappa {:.4g}, tensile {:.4g} MPa, cohesion {:.4g} MPa, friction {:.3g} and {:.3g} "
      "deg",
      base::in_units(micro[0], base::GPa), micro[1], base::in_units(micro[2], base::MPa),
      base::in_units(micro[3], base::MPa), micro[4], base::in_units(micro[5], base::deg));
}

std::string indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "    " + line + "\n";
  return text;
}

}  // namespace

std::string plan_line(const studies::CalibrationTarget& target, const studies::CalibrationCost& cost, int cores) {
  const studies::CalibrationSettings& settings = target.settings;
  const dem2d::LabSettings lab = studies::lab_settings_of(target);
  return fmt::format(
      "{}: cores of {:g} x {:g} mm, about {:.0f} discs; seeds {} to {}, {} of them while scouting; about {:.2g} s of "
      "one core a specimen; usually {} + {} evaluations (at most {}), about {:.2g} minutes on {} cores\n",
      target.name, base::in_units(lab.width, base::mm), base::in_units(lab.height, base::mm), cost.discs,
      settings.first_seed, settings.first_seed + settings.seeds - 1, settings.scouting_seeds,
      cost.core_seconds_per_specimen, studies::usual_coarse_evaluations, studies::usual_fine_evaluations,
      settings.most_evaluations, studies::expected_minutes(cost, cores), cores);
}

std::string evaluation_lines(const studies::CalibrationTarget& target, const studies::Evaluation& evaluation,
                             int number) {
  std::string text;
  int specimens = 0;
  for (const Property property : studies::all_properties) {
    const base::Summary& measured = evaluation.measured[studies::index_of(property)];
    if (!studies::is_wanted(target, property) || measured.count == 0) continue;
    const studies::PropertyWords& words = studies::words_of(property);
    const double error = studies::error_of(property, measured.mean, target.wanted[studies::index_of(property)]);
    text += fmt::format("{}{} {:.4g}{}{} ({})", text.empty() ? "" : ", ", words.name, measured.mean / words.si_per_unit,
                        *words.unit == '\0' ? "" : " ", words.unit,
                        words.relative_error ? fmt::format("{:+.1f} %", 100.0 * error) : fmt::format("{:+.3f}", error));
    specimens = measured.count;
  }
  if (specimens == 0) text = "no result: " + evaluation.failure;
  return fmt::format("evaluation {}: {}\n    {} specimens: {}\n", number, micro_text(evaluation.micro), specimens,
                     text);
}

std::string end_lines(const studies::CalibrationTarget& target, const studies::Calibration& calibration,
                      const studies::LaboratoryCount& count, double wall) {
  return fmt::format("{} after {} evaluations, {} tests ({} more from the journal), {}\n",
                     studies::name_of(calibration.end), calibration.evaluations.size(), count.tests, count.reused,
                     base::readable_duration(wall)) +
         indented(studies::lines_about(target, calibration.best));
}

std::string fresh_lines(const studies::CalibrationTarget& target, const studies::FreshSpecimens& fresh) {
  return fmt::format("on fresh specimens, seeds {}:\n", base::seeds_text(fresh.seeds)) +
         indented(studies::lines_about(target, fresh.result));
}

}  // namespace bitrock::views
