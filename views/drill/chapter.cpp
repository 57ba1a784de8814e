// Report chapters about drill runs: one run, or a few side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/units.hpp"

#include "views/drill/chapter.hpp"
#include "views/drill/run_page.hpp"
#include "views/text/source_words.hpp"

namespace bitrock::views {

namespace {

using base::kN, base::m_per_h, base::mm, base::rpm;

using Row = RunRow<ShownRun>;

std::string drive_words(const runtime::TopDrive& drive) {
  return drive.imposes_speed ? fmt::format("{:.4g} rpm", drive.rotation / rpm)
                             : fmt::format("{:.4g} N m", drive.torque);
}

std::string hook_words(const runtime::DrillCase& drill) {
  switch (drill.hoist.rule) {
    case runtime::HoistRule::feed:
      return fmt::format("by a feed of {:.4g} m/h", drill.hoist.feed / m_per_h);
    case runtime::HoistRule::autodriller:
      return fmt::format("by an autodriller for {:.4g} kN", drill.hoist.weight_on_bit / kN);
    case runtime::HoistRule::load:
      break;
  }
  return fmt::format("{:.4g}", drill.drive.hook_load / kN);
}

std::string listed(const std::vector<double>& frequencies) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, frequencies.size()); ++i)
    text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ", frequencies[i]);
  if (text.empty()) return "-";
  return frequencies.size() > most ? text + ", ..." : text;
}

std::string strongest(const base::Spectrum& spectrum) {
  const double frequency = base::strongest_frequency(spectrum);
  return frequency > 0.0 ? fmt::format("{:.3g}", frequency) : "-";
}

std::string share(double value) {
  return fmt::format("{:.3g}", 100.0 * value);
}

report::Table case_table(const std::vector<ShownRun>& runs) {
  return table_of<ShownRun>(
      runs, "What was run. The first seconds, while it settles, are in the plots over time only.",
      {{"case", [](const ShownRun& run) { return run.file.drill.name; }},
       {"rock", [](const ShownRun& run) { return run.file.drill.rock.empty() ? "-" : run.file.drill.rock; }},
       {"top drive", [](const ShownRun& run) { return drive_words(run.file.drill.drive); }},
       {"hook load [kN]", [](const ShownRun& run) { return hook_words(run.file.drill); }},
       {"excitation", [](const ShownRun& run) { return source_words(run.file.drill.source, run.file.model); }},
       {"run, settling [s]",
        [](const ShownRun& run) {
          return fmt::format("{:g}, {:g}", run.file.drill.run.duration, run.file.drill.run.settling);
        }},
       {"step, sample [ms]",
        [](const ShownRun& run) {
          return fmt::format("{:.3g}, {:.3g}", run.file.run.step * 1e3, run.file.drill.run.sample * 1e3);
        }},
       {"natural, torsion, bit free [Hz]", [](const ShownRun& run) { return listed(run.file.modes.torsional); }},
       {"natural, axial, bit on rock [Hz]", [](const ShownRun& run) { return listed(run.file.modes.axial); }},
       {"natural, axial, bit lifted [Hz]",
        [](const ShownRun& run) { return listed(run.file.modes.axial_off_bottom); }}});
}

/// Two rows: mean with standard deviation, and the extremes.
void add_spread(std::vector<Row>& rows, const std::string& name, runtime::Spread runtime::DrillSummary::*spread,
                double unit) {
  rows.push_back({name, [=](const ShownRun& run) {
                    const runtime::Spread& seen = run.file.run.summary.*spread;
                    return fmt::format("{:.4g} \u00b1 {:.3g}", seen.mean / unit, seen.deviation / unit);
                  }});
  rows.push_back({"\u2003lowest to highest", [=](const ShownRun& run) {
                    const runtime::Spread& seen = run.file.run.summary.*spread;
                    return fmt::format("{:.4g} to {:.4g}", seen.lowest / unit, seen.highest / unit);
                  }});
}

report::Table summary_table(const std::vector<ShownRun>& runs) {
  using Summary = runtime::DrillSummary;
  using Clamps = runtime::ClampTally;
  const auto number = [](double Summary::*value, double unit) {
    return [=](const ShownRun& run) { return fmt::format("{:.4g}", run.file.run.summary.*value / unit); };
  };
  const auto percent = [](double Summary::*value) {
    return [=](const ShownRun& run) { return share(run.file.run.summary.*value); };
  };
  std::vector<Row> rows{{"stick-slip severity", number(&Summary::severity, 1.0)},
                        {"bit at rest [% of time]", percent(&Summary::share_at_rest)},
                        {"bit turning back [%]", percent(&Summary::share_backwards)},
                        {"bit off bottom [%]", percent(&Summary::share_off_bottom)}};
  add_spread(rows, "bit speed [rpm]", &Summary::bit_rotation, rpm);
  add_spread(rows, "weight on bit [kN]", &Summary::weight_on_bit, kN);
  add_spread(rows, "rock on bit in all [kN]", &Summary::total_force, kN);
  rows.push_back({"static weight on bit [kN]", number(&Summary::static_weight_on_bit, kN)});
  add_spread(rows, "torque on bit [N m]", &Summary::torque, 1.0);
  add_spread(rows, "force of the source [kN]", &Summary::source_force, kN);
  add_spread(rows, "torque of the source [N m]", &Summary::source_torque, 1.0);
  add_spread(rows, "rate of penetration [m/h]", &Summary::rop, m_per_h);
  const auto fed = [](const ShownRun& run) { return run.file.run.summary.hook_load.has_value(); };
  if (std::any_of(runs.begin(), runs.end(), fed))
    rows.push_back({"hook load [kN]", [fed](const ShownRun& run) {
                      if (!fed(run)) return fmt::format("{:.4g}", run.file.drill.drive.hook_load / kN);
                      const runtime::Spread& seen = *run.file.run.summary.hook_load;
                      return fmt::format("{:.4g} \u00b1 {:.3g}", seen.mean / kN, seen.deviation / kN);
                    }});
  rows.push_back({"drilled [mm]", number(&Summary::drilled, mm)});
  rows.push_back({"strongest in bit speed [Hz]", [](const ShownRun& run) { return strongest(run.bit_speed); }});
  rows.push_back({"strongest in torque [Hz]", [](const ShownRun& run) { return strongest(run.torque); }});
  rows.push_back({"strongest in weight on bit [Hz]", [](const ShownRun& run) { return strongest(run.weight_on_bit); }});
  rows.push_back({"questions to networks", [](const ShownRun& run) {
                    return run.file.run.summary.clamps.asked == 0
                               ? "-"
                               : fmt::format("{}", run.file.run.summary.clamps.asked);
                  }});
  const auto outside = [](std::int64_t Clamps::*below, std::int64_t Clamps::*above) {
    return [=](const ShownRun& run) {
      const Clamps& clamps = run.file.run.summary.clamps;
      const auto count = static_cast<double>(clamps.*below + clamps.*above);
      return clamps.asked == 0 ? "-" : share(count / static_cast<double>(clamps.asked));
    };
  };
  rows.push_back({"\u2003speed outside what the networks have learnt [% of questions]",
                  outside(&Clamps::speed_below, &Clamps::speed_above)});
  rows.push_back({"\u2003depth outside what the networks have learnt [% of questions]",
                  outside(&Clamps::depth_below, &Clamps::depth_above)});
  rows.push_back({"\u2003rake outside what the networks have learnt [% of questions]",
                  outside(&Clamps::rake_below, &Clamps::rake_above)});
  rows.push_back({"energy lost by the solver [%]", percent(&Summary::energy_residual)});
  return table_of<ShownRun>(
      runs,
      "What came out, over all steps after settling: mean \u00b1 standard deviation. Severity: (highest - lowest) / "
      "(2 mean) of the bit's speed, 1 where it just comes to rest. At rest: slower than 1 rpm. Off bottom: no weight "
      "on bit. Rock on bit in all: weight on bit and the force of the source, in the mean the static weight. "
      "Strongest: frequency of the highest value of a spectrum. Outside: of the conditions that networks were asked "
      "for, one question a cutter and window; one question may be outside in several ways. Energy lost: over the work "
      "that went through the "
      "string.",
      rows);
}

/// Says which answers of the networks came from the edge of their training range.
void add_clamp_notes(report::Page& page, const std::vector<ShownRun>& runs) {
  for (const ShownRun& run : runs) {
    const runtime::ClampTally& clamps = run.file.run.summary.clamps;
    if (clamps.clamped() == 0) continue;
    const std::pair<const char*, std::int64_t> reasons[] = {
        {"speed below", clamps.speed_below}, {"speed above", clamps.speed_above}, {"depth below", clamps.depth_below},
        {"depth above", clamps.depth_above}, {"rake below", clamps.rake_below},   {"rake above", clamps.rake_above}};
    std::string said;
    for (const auto& [reason, count] : reasons) {
      if (count == 0) continue;
      said += fmt::format("{}{} the range {} times, {} %", said.empty() ? "" : "; ", reason, count,
                          share(static_cast<double>(count) / static_cast<double>(clamps.asked)));
    }
    page.note(fmt::format(
        "{}: the networks were asked {} times, some of them outside their training range ({}). There the answer is "
        "that of the nearest edge.",
        run.label, clamps.asked, said));
  }
}

}  // namespace

void add_drill_chapters(report::Page& page, const std::vector<ShownRun>& runs,
                        const std::vector<report::Figure>& figures, const std::string& part_of) {
  const auto heading = [&](std::string text) {
    if (!part_of.empty()) text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return part_of + text;
  };
  page.section(heading("Summary"));
  page.table(case_table(runs));
  page.table(summary_table(runs));
  add_clamp_notes(page, runs);
  const char* headings[] = {"Over time", "A closer look", "Spectra", "Orbit"};
  for (std::size_t k = 0; k < figures.size(); ++k) {
    page.section(heading(headings[k]), figures[k].caption);
    add_figure(page, figures[k]);
  }
}

}  // namespace bitrock::views
