#include "views/text/calibration_lines.hpp"

#include <fmt/format.h>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

using studies::Property;

std::string micro_text(const studies::Micro& micro) {
  return fmt::format("E* {:.4g} GPa, kappa {:.4g}, tensile {:.4g} MPa, cohesion {:.4g} MPa, friction {:.3g}",
                     base::in_units(micro[0], base::GPa), micro[1], base::in_units(micro[2], base::MPa),
                     base::in_units(micro[3], base::MPa), micro[4]);
}

}  // namespace

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

}  // namespace bitrock::views
