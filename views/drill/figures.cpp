#include "views/drill/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <utility>

#include "base/thin.hpp"
#include "base/units.hpp"
#include "report/spectrum_plot.hpp"

namespace bitrock::views {

namespace {

using base::kN, base::m_per_h, base::rpm;

// A line over the whole time has its envelope drawn: some thousand stretches, one for each column of pixels.
constexpr std::size_t points_of_a_line = 5000;
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

std::vector<double> in_unit(const std::vector<double>& values, double unit, std::size_t first = 0) {
  std::vector<double> shown;
  shown.reserve(values.size() - first);
  for (std::size_t i = first; i < values.size(); ++i) shown.push_back(values[i] / unit);
  return shown;
}

report::Colour colour_of(std::size_t run) {
  constexpr std::array<report::Colour, most_shown_runs> colours{report::Colour::blue,  report::Colour::vermillion,
                                                                report::Colour::green, report::Colour::purple,
                                                                report::Colour::sky,   report::Colour::orange};
  return colours[run % colours.size()];
}

report::Series over_time(const runtime::DrillSeries& series, SeriesMember member, double unit, std::size_t first) {
  const std::vector<double> y = in_unit(series.*member, unit, first);
  report::Series line{.name = {}, .x = {}, .y = {}};
  for (const std::size_t i : base::envelope(y, points_of_a_line)) {
    line.x.push_back(series.time_s[first + i]);
    line.y.push_back(y[i]);
  }
  return line;
}

report::Plot time_plot(const std::vector<ShownRun>& runs, std::size_t run, const Quantity& quantity,
                       std::size_t first) {
  const runtime::DrillSeries& series = runs[run].file.run.series;
  report::Plot plot{.title = quantity.title, .x_label = "time [s]", .y_label = quantity.y_label, .height_px = time_px};
  if (runs.size() > 1) plot.title += ", " + runs[run].label;
  plot.series.push_back(over_time(series, quantity.values, quantity.unit, first));
  plot.series.back().name = quantity.name;
  plot.series.back().colour = colour_of(run);
  if (quantity.beside != nullptr) {
    report::Series beside = over_time(series, quantity.beside, quantity.unit, first);
    // Under, where it swings so often that it would hide the other.
    const bool on_top = quantity.beside_on_top || first > 0;
    beside.name = quantity.beside_name;
    beside.colour = on_top ? report::Colour::black : report::Colour::grey;
    plot.series.insert(on_top ? plot.series.end() : plot.series.begin(), std::move(beside));
  }
  plot.x_range = report::AxisRange{series.time_s[first], series.time_s.back()};
  return plot;
}

/// First sample of the last `span` [s].
std::size_t first_of_last(const runtime::DrillSeries& series, double span) {
  const double begin = series.time_s.back() - span;
  const auto at = std::lower_bound(series.time_s.begin(), series.time_s.end() - 2, begin);
  return static_cast<std::size_t>(at - series.time_s.begin());
}

/// The last `span` [s] of the runs. For one, panels two by two; for several, a row for each quantity and a column for
/// each run.
report::Figure time_figure(const std::vector<ShownRun>& runs, double span) {
  const bool several = runs.size() > 1;
  report::Figure figure{.columns = several ? static_cast<int>(runs.size()) : 2};
  if (!several) figure.panel_width_px = panel_px;
  for (const Quantity& quantity : {weight, advance, speed, torque}) {
    for (std::size_t run = 0; run < runs.size(); ++run) {
      figure.plots.push_back(time_plot(runs, run, quantity, first_of_last(runs[run].file.run.series, span)));
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
                     .colour = colour_of(k),
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
  const std::size_t first = first_of_last(series, closer_look_s);
  report::Plot plot{.title = runs.size() > 1 ? "Orbit, " + runs[run].label : "Orbit of bit speed and torque",
                    .x_label = "bit speed [rpm]",
                    .y_label = "torque on bit [N m]",
                    .caption = fmt::format("The last {:.3g} s.", series.time_s.back() - series.time_s[first]),
                    .height_px = orbit_px};
  plot.series.push_back({.name = "",
                         .x = in_unit(series.bit_rotation_rad_per_s, rpm, first),
                         .y = in_unit(series.torque_on_bit_N_m, 1.0, first),
                         .colour = colour_of(run)});
  return plot;
}

/// Where the energy of a run is, and how steady its values are.
std::string spectrum_caption(const std::vector<ShownRun>& runs) {
  const base::Spectrum& first = runs.front().bit_speed;
  if (first.frequency.size() < 2) return "The run is too short for spectra.";
  return fmt::format(
      "Power spectral densities by Welch's method: {} segments of {:.3g} s, Hann window, half overlap, mean removed; "
      "a value of a noise scatters by {:.0f} %. Their area is the variance. Dashed: natural frequencies of the string "
      "alone, in torsion with the bit free, axially with the bit on the rock's spring. Vibrations faster than half the "
      "sampling rate fold back into the range.",
      first.segments, 1.0 / first.frequency[1], 100.0 * first.relative_deviation);
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

base::Spectrum spectrum_of(const runtime::DrillFile& file, SeriesMember member, double unit, double segment_s) {
  const double rate = 1.0 / file.drill.run.sample;
  const std::size_t segment = base::quick_length(static_cast<std::size_t>(segment_s * rate * (1.0 + 1e-9)));
  return base::welch(in_unit(file.run.series.*member, unit, first_settled(file)), rate,
                     std::max(segment, base::least_segment));
}

}  // namespace

std::size_t first_settled(const runtime::DrillFile& file) {
  const std::vector<double>& time = file.run.series.time_s;
  const auto at = std::upper_bound(time.begin(), time.end() - 1, file.drill.run.settling);
  return static_cast<std::size_t>(at - time.begin());
}

std::vector<ShownRun> shown_runs(const std::vector<std::string>& names, std::vector<runtime::DrillFile> files) {
  constexpr double segments_end_to_end = 6.0;
  std::vector<std::string> labels;
  for (const std::string& name : names) labels.push_back(std::filesystem::path(name).stem().string());
  double shortest = std::numeric_limits<double>::infinity();
  for (const runtime::DrillFile& file : files) {
    const std::size_t samples = file.run.series.time_s.size() - first_settled(file);
    shortest = std::min(shortest, static_cast<double>(samples) * file.drill.run.sample);
  }
  const double segment_s = shortest / segments_end_to_end;
  std::vector<ShownRun> runs;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const bool alone = std::count(labels.begin(), labels.end(), labels[k]) == 1;
    ShownRun run{.label = alone ? labels[k] : names[k], .file = std::move(files[k])};
    const auto spectrum = [&](SeriesMember member, double unit) {
      return spectrum_of(run.file, member, unit, segment_s);
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
