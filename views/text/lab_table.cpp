#include "views/text/lab_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "base/statistics.hpp"
#include "base/units.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "studies/lab/envelope.hpp"

namespace bitrock::views {

namespace {

constexpr const char* row_format = "{:>6} {:>13} {:>8} {:>7} {:>15} {:>11}  {}\n";

std::string cell(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string row(const std::string& name, double strength, double modulus, double ratio, double initiation,
                double strain, const std::string& rest) {
  return fmt::format(row_format, name, cell(strength * 1e-6, 2), cell(modulus * 1e-9, 3), cell(ratio, 3),
                     cell(initiation * 1e-6, 2), cell(strain * 1e2, 3), rest);
}

/// Mean and scatter of each of `lab_quantities`, in their order.
std::vector<base::Summary> summaries_of(std::span<const dem2d::LabRun> runs) {
  std::vector<base::Summary> summaries;
  for (const studies::LabQuantity& quantity : studies::lab_quantities())
    summaries.push_back(studies::summary_of(quantity, runs));
  return summaries;
}

/// A row a test, and their mean and scatter.
std::string table_of(std::span<const dem2d::LabRun> runs) {
  std::string table = fmt::format(row_format, "seed", "strength MPa", "E GPa", "nu", "cracks from MPa", "at strain %",
                                  "cracks tension + shear");
  for (const dem2d::LabRun& run : runs) {
    table += row(fmt::format("{}", run.seed), run.peak_stress, run.youngs_modulus, run.poissons_ratio,
                 run.crack_initiation_stress, run.strain_at_peak,
                 fmt::format("{} + {}", run.cracks_tensile, run.cracks_shear));
  }
  if (runs.size() == 1) return table;
  const std::vector<base::Summary> s = summaries_of(runs);
  return table +
         row("mean", s[0].mean, s[1].mean, s[2].mean, s[3].mean, s[4].mean,
             fmt::format("{:.0f} + {:.0f}", s[5].mean, s[6].mean)) +
         row("sd", s[0].standard_deviation, s[1].standard_deviation, s[2].standard_deviation, s[3].standard_deviation,
             s[4].standard_deviation, "");
}

constexpr const char* toughness_format = "{:>6} {:>13} {:>18} {:>11}  {}\n";

/// A row a notched core: K_Ic in place of moduli.
std::string toughness_table(std::span<const dem2d::LabRun> runs) {
  const auto row_of = [](const std::string& name, double strength, double toughness, double strain,
                         const std::string& rest) {
    return fmt::format(toughness_format, name, cell(strength * 1e-6, 2), cell(toughness * 1e-6, 3),
                       cell(strain * 1e2, 3), rest);
  };
  std::string table = fmt::format(toughness_format, "seed", "strength MPa", "K_Ic MPa sqrt(m)", "at strain %",
                                  "cracks tension + shear");
  for (const dem2d::LabRun& run : runs) {
    table += row_of(fmt::format("{}", run.seed), run.peak_stress, run.fracture_toughness, run.strain_at_peak,
                    fmt::format("{} + {}", run.cracks_tensile, run.cracks_shear));
  }
  if (runs.size() == 1) return table;
  const std::vector<base::Summary> s = summaries_of(runs);
  return table + row_of("mean", s[0].mean, s[7].mean, s[4].mean, "") +
         row_of("sd", s[0].standard_deviation, s[7].standard_deviation, s[4].standard_deviation, "");
}

}  // namespace

std::string plan_line(const studies::LabSeries& series, const studies::LabCost& cost) {
  const dem2d::LabBox box = dem2d::specimen_box(series.test, series.settings);
  return fmt::format(
      "{} {} tests of {:.4g} x {:.4g} mm, about {:.0f} discs each; strain rate {:.3g} /s, strength expected after "
      "{:.3g} s (about {:.2g} MPa); about {:.2g} minutes on one core, without packing\n",
      studies::cores_of(series).size(), dem2d::name_of(series.test), box.width * 1e3, box.height * 1e3, cost.discs,
      series.settings.strain_rate, cost.duration,
      dem2d::expected_strength(series.test, series.rock, series.pressures.back()) * 1e-6, cost.core_seconds / 60.0);
}

std::string lab_table(const studies::LabResults& results) {
  if (results.runs.empty()) return "";
  const dem2d::LabTest test = results.runs.front().test;
  if (test != dem2d::LabTest::triaxial && test != dem2d::LabTest::toughness) return table_of(results.runs);
  std::string tables;
  for (const std::span<const dem2d::LabRun> runs : studies::by_condition(results.runs)) {
    if (test == dem2d::LabTest::triaxial) {
      tables += fmt::format("confining pressure {:.4g} MPa; strengths and stresses are above it\n",
                            runs.front().confining_pressure * 1e-6) +
                table_of(runs);
    } else {
      tables += fmt::format("notch {:.4g} mm long, {:.3g} of the width\n", runs.front().notch_length * 1e3,
                            runs.front().notch_length / runs.front().width) +
                toughness_table(runs);
    }
  }
  return tables;
}

std::string envelope_lines(const studies::LabResults& results) {
  const studies::EnvelopeOfSeeds envelope = studies::envelope_of(results.runs);
  if (envelope.empty()) return "";
  const auto part = [&](const char* name, double studies::Envelope::*member, double unit, const char* unit_name) {
    const base::Summary s = envelope.of(member);
    const std::string scatter = s.count > 1 ? fmt::format(" +- {:.2g}", s.standard_deviation / unit) : "";
    return fmt::format("{} {:.3g}{}{}", name, s.mean / unit, scatter, unit_name);
  };
  return fmt::format("Mohr-Coulomb line: {}, {}, {}; slope {}{}\n",
                     part("friction angle", &studies::Envelope::friction_angle, base::deg, " deg"),
                     part("cohesion", &studies::Envelope::cohesion, base::MPa, " MPa"),
                     part("strength at no pressure", &studies::Envelope::strength_at_zero, base::MPa, " MPa"),
                     part("of strength over pressure", &studies::Envelope::slope, 1.0, ""),
                     envelope.lines.size() > 1 ? " (+- standard deviation of the seeds)" : "");
}

std::string rate_check_line(double strain_rate, const studies::LabResults& results) {
  const studies::RateCheck check = studies::rate_check_of(results);
  return fmt::format("mean strength at {:.3g} /s {:.4g} MPa, at half of it {:.4g} MPa: {:+.1f} % ({} {:.0f} %)\n",
                     strain_rate, check.mean_strength * 1e-6, check.mean_at_half_rate * 1e-6, check.change * 1e2,
                     check.slow_enough ? "slow enough: less than" : "too fast: not less than",
                     studies::allowed_rate_change * 1e2);
}

}  // namespace bitrock::views
