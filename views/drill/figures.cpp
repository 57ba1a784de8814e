#include "views/drill/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "base/units.hpp"
#include "report/spectrum_plot.hpp"

namespace bitrock::views {

namespace {

using base::kN, base::m_per_h, base::rpm;

// The end of a run is shown again, stretched, so that single vibrations can be seen; on the sheet of one run, some
// more of them [s].
constexpr double closer_look_s = 2.0, sheet_look_s = 3.0;
// Sizes of panels [px].
constexpr double panel_px = 480.0, time_px = 280.0, spectrum_px = 300.0, orbit_px = 380.0;

using SeriesMember = std::vector<double> runtime::DrillSeries::*;

/// What is drawn over time: one quantity, and another beside it.
struct Quantity {
  const char *title, *y_label;
  double unit;
  SeriesMember values;
  const char* name;
  SeriesMember beside = nullptr;
  const char* beside_name = "";
  bool beside_on_top = true;  ///< also over the whole run
};

constexpr Quantity weight{"Weight on bit", "WOB [kN]", kN, &runtime::DrillSeries::weight_on_bit_N, ""};
constexpr Quantity advance{"Rate of penetration", "ROP [m/h]", m_per_h, &runtime::DrillSeries::rop_m_per_s, ""};
constexpr Quantity speed{"Speed", "speed [rpm]",
                         rpm,     &runtime::DrillSeries::bit_rotation_rad_per_s,
                         "bit",   &runtime::DrillSeries::table_rotation_rad_per_s,
                         "table"};
constexpr Quantity torque{"Torque", "torque [N m]",
                          1.0,      &runtime::DrillSeries::torque_on_bit_N_m,
                          "bit",    &runtime::DrillSeries::drive_torque_N_m,
                          "drive",  false};

report::Plot time_plot(const std::vector<ShownRun>& runs, std::size_t run, const Quantity& quantity,
                       std::size_t first) {
  const runtime::DrillSeries& series = runs[run].file.run.series;
  report::Plot plot{.title = quantity.title, .x_label = "time [s]", .y_label = quantity.y_label, .height_px = time_px};
  if (runs.size() > 1) plot.title += ", " + runs[run].label;
  plot.series.push_back(line_over_time(series.time_s, series.*quantity.values, quantity.unit, first));
  plot.series.back().name = quantity.name;
  plot.series.back().colour = colour_of_run(run);
  if (quantity.beside != nullptr) {
    report::Series beside = line_over_time(series.time_s, series.*quantity.beside, quantity.unit, first);
    // Under, where it swings so often that it would hide the other.
    const bool on_top = quantity.beside_on_top || first > 0;
    beside.name = quantity.beside_name;
    beside.colour = on_top ? report::Colour::black : report::Colour::grey;
    plot.series.insert(on_top ? plot.series.end() : plot.series.begin(), std::move(beside));
  }
  plot.x_range = report::AxisRange{series.time_s[first], series.time_s.back()};
  return plot;
}

/// The last `span` [s] of the runs. For one, panels two by two; for several, a row for each quantity and a column for
/// each run.
report::Figure time_figure(const std::vector<ShownRun>& runs, double span) {
  const bool several = runs.size() > 1;
  report::Figure figure{.columns = several ? static_cast<int>(runs.size()) : 2};
  if (!several) figure.panel_width_px = panel_px;
  for (const Quantity& quantity : {weight, advance, speed, torque}) {
    for (std::size_t run = 0; run < runs.size(); ++run) {
      figure.plots.push_back(time_plot(runs, run, quantity, first_of_last(runs[run].file.run.series.time_s, span)));
    }
    if (several) report::share_y_axis(std::span(figure.plots).last(runs.size()));
  }
  return figure;
}

/// A spectrum on its plot: which one, and which natural frequencies are marked.
struct SpectrumOf {
  const char *title, *y_label;
  base::Spectrum ShownRun::*spectrum;
  std::vector<double> runtime::DrillModes::*modes;
};
constexpr SpectrumOf speed_spectrum{"Spectrum of bit speed", "density [rpm\u00b2/Hz]", &ShownRun::bit_speed,
                                    &runtime::DrillModes::torsional};
constexpr SpectrumOf torque_spectrum{"Spectrum of torque on bit", "density [(N m)\u00b2/Hz]", &ShownRun::torque,
                                     &runtime::DrillModes::torsional};
constexpr SpectrumOf weight_spectrum{"Spectrum of weight on bit", "density [kN\u00b2/Hz]", &ShownRun::weight_on_bit,
                                     &runtime::DrillModes::axial};

report::Plot spectrum_plot(const std::vector<ShownRun>& runs, const SpectrumOf& what) {
  std::vector<report::SpectrumLine> lines;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    lines.push_back({.name = runs.size() > 1 ? runs[k].label : "",
                     .colour = colour_of_run(k),
                     .spectrum = runs[k].*what.spectrum,
                     .marks = runs[k].file.modes.*what.modes});
  }
  std::string highest;
  for (const report::SpectrumLine& line : lines) {
    const double frequency = base::strongest_frequency(line.spectrum);
    if (frequency > 0.0)
      highest += fmt::format("{}{}{:.3g} Hz", highest.empty() ? "Highest: " : ", ",
                             line.name.empty() ? "" : line.name + " at ", frequency);
  }
  report::Plot plot = report::spectrum_plot(what.title, what.y_label, "natural frequencies", lines);
  plot.caption = highest.empty() ? "No vibration." : highest + ".";
  plot.height_px = spectrum_px;
  return plot;
}

report::Plot orbit_plot(const std::vector<ShownRun>& runs, std::size_t run) {
  const runtime::DrillSeries& series = runs[run].file.run.series;
  const std::size_t first = first_of_last(series.time_s, closer_look_s);
  report::Plot plot{.title = runs.size() > 1 ? "Orbit, " + runs[run].label : "Orbit of bit speed and torque",
                    .x_label = "bit speed [rpm]",
                    .y_label = "torque on bit [N m]",
                    .caption = fmt::format("The last {:.3g} s.", series.time_s.back() - series.time_s[first]),
                    .height_px = orbit_px};
  plot.series.push_back({.name = "",
                         .x = in_unit(series.bit_rotation_rad_per_s, rpm, first),
                         .y = in_unit(series.torque_on_bit_N_m, 1.0, first),
                         .colour = colour_of_run(run)});
  return plot;
}

/// Where the energy of a run is, and how steady its values are.
std::string spectrum_caption(const std::vector<ShownRun>& runs) {
  const base::Spectrum& first = runs.front().bit_speed;
  if (first.frequency.size() < 2) return "The run is too short for spectra.";
  return welch_words(first) +
         " Dashed: natural frequencies of the string alone, in torsion with the bit free, axially with the bit on the "
         "rock's spring. Vibrations faster than half the sampling rate fold back into the range.";
}

report::Figure spectra_figure(const std::vector<ShownRun>& runs) {
  report::Figure figure{.name = "drill_spectra", .caption = spectrum_caption(runs), .columns = 1};
  figure.panel_width_px = 2.0 * panel_px;
  for (const SpectrumOf& what : {speed_spectrum, torque_spectrum, weight_spectrum})
    figure.plots.push_back(spectrum_plot(runs, what));
  return figure;
}

report::Figure orbit_figure(const std::vector<ShownRun>& runs) {
  report::Figure figure{.name = "drill_orbit",
                        .caption =
                            "Speed of the bit and torque on it at the end of the run, sample after sample. A "
                            "closed loop is a limit cycle, a point steady drilling.",
                        .columns = static_cast<int>(std::min<std::size_t>(3, runs.size()))};
  if (runs.size() == 1) figure.panel_width_px = panel_px;
  for (std::size_t run = 0; run < runs.size(); ++run) figure.plots.push_back(orbit_plot(runs, run));
  report::share_x_axis(figure.plots);
  report::share_y_axis(figure.plots);
  return figure;
}

}  // namespace

std::size_t first_settled(const runtime::DrillFile& file) {
  return first_later_than(file.run.series.time_s, file.drill.run.settling);
}

std::vector<ShownRun> shown_runs(const std::vector<std::string>& names, std::vector<runtime::DrillFile> files) {
  constexpr double segments_end_to_end = 6.0;
  const std::vector<std::string> labels = labels_of(names);
  double shortest = std::numeric_limits<double>::infinity();
  for (const runtime::DrillFile& file : files) {
    const std::size_t samples = file.run.series.time_s.size() - first_settled(file);
    shortest = std::min(shortest, static_cast<double>(samples) * file.drill.run.sample);
  }
  const double segment_s = shortest / segments_end_to_end;
  std::vector<ShownRun> runs;
  for (std::size_t k = 0; k < files.size(); ++k) {
    ShownRun run{.label = labels[k], .file = std::move(files[k])};
    const auto spectrum = [&](SeriesMember member, double unit) {
      return spectrum_of(run.file.run.series.*member, unit, first_settled(run.file), run.file.drill.run.sample,
                         segment_s);
    };
    run.bit_speed = spectrum(&runtime::DrillSeries::bit_rotation_rad_per_s, rpm);
    run.weight_on_bit = spectrum(&runtime::DrillSeries::weight_on_bit_N, kN);
    run.torque = spectrum(&runtime::DrillSeries::torque_on_bit_N_m, 1.0);
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<report::Figure> drill_figures(const std::vector<ShownRun>& runs) {
  report::Figure whole = time_figure(runs, std::numeric_limits<double>::infinity());
  whole.name = "drill_time";
  whole.caption = "The whole run: instants, thinned so that no extreme is lost.";
  report::Figure closer = time_figure(runs, closer_look_s);
  closer.name = "drill_closer";
  closer.caption = fmt::format("The last {:g} s of it, stretched.", closer_look_s);
  return {std::move(whole), std::move(closer), spectra_figure(runs), orbit_figure(runs)};
}

report::Figure drill_sheet(const ShownRun& run) {
  const std::vector<ShownRun> alone{run};
  report::Figure sheet = time_figure(alone, sheet_look_s);
  sheet.name = "drill_run";
  sheet.caption = run.file.drill.name;
  for (const SpectrumOf& what : {speed_spectrum, weight_spectrum}) sheet.plots.push_back(spectrum_plot(alone, what));
  return sheet;
}

}  // namespace bitrock::views
