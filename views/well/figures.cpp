#include "views/well/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

#include "base/units.hpp"
#include "report/spectrum_plot.hpp"

namespace bitrock::views {

namespace {

using base::kN, base::m_per_h, base::mm, base::MPa, base::rpm;
using runtime::WellSeries, runtime::StringFrames;

// The end of a run is shown again, stretched, so that single vibrations can be seen; of an orbit some turns [s].
constexpr double closer_look_s = 2.0, orbit_look_s = 5.0;
// Sizes of panels [px].
constexpr double panel_px = 480.0, time_px = 260.0, spectrum_px = 300.0, orbit_px = 380.0, log_px = 460.0;

using SeriesMember = std::vector<double> WellSeries::*;

/// What is drawn over time: one quantity, or the sum of two; and another beside it.
struct Quantity {
  const char *title, *y_label;
  double unit;
  SeriesMember values;
  SeriesMember more = nullptr;  ///< added to it
  const char* name = "";
  SeriesMember beside = nullptr;
  const char* beside_name = "";
};
constexpr Quantity quantities[] = {
    {"Hook load", "hook load [kN]", kN, &WellSeries::hook_load_N},
    {"Weight on bit", "WOB [kN]", kN, &WellSeries::weight_on_bit_N, &WellSeries::source_force_N},
    {"Torque", "torque [kN m]", kN, &WellSeries::drive_torque_N_m, nullptr, "drive", &WellSeries::torque_on_bit_N_m,
     "bit"},
    {"Speed", "speed [rpm]", rpm, &WellSeries::bit_rotation_rad_per_s, nullptr, "bit",
     &WellSeries::drive_rotation_rad_per_s, "drive"},
    {"Rate of penetration", "ROP [m/h]", m_per_h, &WellSeries::rop_m_per_s},
    {"Depth of the bit", "measured depth [m]", 1.0, &WellSeries::bit_depth_m}};
constexpr std::size_t closer_quantities = 4;  // what vibrates

std::vector<double> values_of(const WellSeries& series, const Quantity& quantity) {
  std::vector<double> values = series.*quantity.values;
  if (quantity.more == nullptr) return values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += (series.*quantity.more)[i];
  return values;
}

std::string titled(const char* title, const std::vector<ShownWell>& runs, std::size_t run) {
  return runs.size() > 1 ? fmt::format("{}, {}", title, runs[run].label) : title;
}

report::Plot time_plot(const std::vector<ShownWell>& runs, std::size_t run, const Quantity& quantity, double span) {
  const WellSeries& series = runs[run].file.series;
  const std::size_t first = first_of_last(series.time_s, span);
  report::Plot plot{.title = titled(quantity.title, runs, run),
                    .x_label = "time [s]",
                    .y_label = quantity.y_label,
                    .height_px = time_px};
  plot.series.push_back(line_over_time(series.time_s, values_of(series, quantity), quantity.unit, first));
  plot.series.back().name = quantity.name;
  plot.series.back().colour = colour_of_run(run);
  if (quantity.beside != nullptr) {
    plot.series.push_back(line_over_time(series.time_s, series.*quantity.beside, quantity.unit, first));
    plot.series.back().name = quantity.beside_name;
    plot.series.back().colour = report::Colour::black;
  }
  plot.x_range = report::AxisRange{series.time_s[first], series.time_s.back()};
  return plot;
}

/// For one run panels two by two; for several a row a quantity and a column a run.
report::Figure empty_figure(const std::vector<ShownWell>& runs, const std::string& name, const std::string& caption) {
  report::Figure figure{
      .name = name, .caption = caption, .plots = {}, .columns = runs.size() > 1 ? static_cast<int>(runs.size()) : 2};
  if (runs.size() == 1) figure.panel_width_px = panel_px;
  return figure;
}

report::Figure time_figure(const std::vector<ShownWell>& runs, std::span<const Quantity> shown, double span) {
  report::Figure figure = empty_figure(runs, "", "");
  for (const Quantity& quantity : shown) {
    for (std::size_t run = 0; run < runs.size(); ++run) figure.plots.push_back(time_plot(runs, run, quantity, span));
    if (runs.size() > 1) report::share_y_axis(std::span(figure.plots).last(runs.size()));
  }
  return figure;
}

/// What is drawn over the depth, at the end of a run.
struct Along {
  const char *title, *x_label;
  double unit;
  std::vector<float> StringFrames::*values;
};
constexpr Along along[] = {{"Tension", "effective tension [kN]", kN, &StringFrames::tension_N},
                           {"Torque", "torque [kN m]", kN, &StringFrames::torque_N_m},
                           {"Side force", "side force of a joint [kN]", kN, &StringFrames::side_force_N},
                           {"Stress", "largest von Mises stress [MPa]", MPa, &StringFrames::von_mises_Pa}};

report::Figure along_figure(const std::vector<ShownWell>& runs) {
  report::Figure figure{.name = "well_along", .caption = "", .plots = {}, .columns = 2, .panel_width_px = panel_px};
  for (const Along& what : along) {
    report::Plot plot{.title = what.title,
                      .x_label = what.x_label,
                      .y_label = "measured depth [m]",
                      .y_downwards = true,
                      .height_px = log_px};
    for (std::size_t run = 0; run < runs.size(); ++run) {
      const StringFrames& frames = runs[run].file.frames;
      report::Series line{.name = runs.size() > 1 ? runs[run].label : "", .x = {}, .y = {}};
      line.colour = colour_of_run(run);
      for (std::size_t k = frames.north_m.size() - static_cast<std::size_t>(frames.nodes.back());
           k < frames.north_m.size(); ++k) {
        line.x.push_back(static_cast<double>((frames.*what.values)[k]) / what.unit);
        line.y.push_back(frames.measured_depth_m[k]);
      }
      plot.series.push_back(std::move(line));
    }
    figure.plots.push_back(std::move(plot));
  }
  figure.caption = fmt::format(
      "At the last instant, {:.4g} s. Tension is the effective one, which hook load and wall feel; below 0 the string "
      "is "
      "pressed. The stress is that of the most loaded fibre, of tension, bending and torque, without the peak at a "
      "tool "
      "joint.",
      runs.front().file.frames.time_s.back());
  return figure;
}

/// Points that all runs have.
std::size_t points_of(const std::vector<ShownWell>& runs) {
  std::size_t points = runs.front().file.stress.points.size();
  for (const ShownWell& run : runs) points = std::min(points, run.file.stress.points.size());
  return points;
}

std::string name_of(const ShownWell& run, std::size_t point) {
  std::string name = run.file.stress.points[point].name;
  if (!name.empty()) name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

report::Figure stress_figure(const std::vector<ShownWell>& runs) {
  report::Figure figure = empty_figure(runs, "well_stress",
                                       "Tension and bending at a fibre that turns with the pipe, after the settling "
                                       "time: what fatigue counts. Where the "
                                       "hole bends, each turn of the pipe bends the fibre forth and back.");
  for (std::size_t point = 0; point < points_of(runs); ++point) {
    for (std::size_t run = 0; run < runs.size(); ++run) {
      const runtime::StressHistories& stress = runs[run].file.stress;
      const std::size_t first = first_later_than(stress.time, stress.settling);
      report::Plot plot{.title = titled(name_of(runs[run], point).c_str(), runs, run),
                        .x_label = "time [s]",
                        .y_label = "stress [MPa]",
                        .height_px = time_px};
      plot.series.push_back(line_over_time(stress.time, stress.points[point].stress, MPa, first));
      plot.series.back().colour = colour_of_run(run);
      figure.plots.push_back(std::move(plot));
    }
    if (runs.size() > 1) report::share_y_axis(std::span(figure.plots).last(runs.size()));
  }
  return figure;
}

std::string highest_words(const std::vector<ShownWell>& runs, std::size_t point) {
  std::string words;
  for (const ShownWell& run : runs) {
    const double frequency = base::strongest_frequency(run.spectra[point]);
    if (frequency > 0.0)
      words += fmt::format("{}{}{:.3g} Hz", words.empty() ? "Highest: " : ", ",
                           runs.size() > 1 ? run.label + " at " : "", frequency);
  }
  return words.empty() ? "No vibration." : words + ".";
}

report::Figure spectra_figure(const std::vector<ShownWell>& runs) {
  constexpr double decades =
      13.0;  // from the bend of each turn down to what the bit shakes, above what the window leaks
  const base::Spectrum& known = runs.front().spectra.front();
  report::Figure figure{.name = "well_spectra", .caption = "", .plots = {}, .columns = 1};
  figure.panel_width_px = 2.0 * panel_px;
  for (std::size_t point = 0; point < points_of(runs); ++point) {
    std::vector<report::SpectrumLine> lines;
    for (std::size_t run = 0; run < runs.size(); ++run)
      lines.push_back({.name = runs.size() > 1 ? runs[run].label : "",
                       .colour = colour_of_run(run),
                       .spectrum = runs[run].spectra[point],
                       .marks = {runs[run].file.torsional_pass_band, runs[run].file.axial_pass_band}});
    report::Plot plot = report::spectrum_plot(name_of(runs.front(), point), "density [MPa\u00b2/Hz]",
                                              "most that the segments pass", lines, decades);
    plot.height_px = spectrum_px;
    plot.caption = highest_words(runs, point);
    figure.plots.push_back(std::move(plot));
  }
  figure.caption =
      known.frequency.size() < 2
          ? "The run is too short for spectra."
          : welch_words(known) + fmt::format(
                                     " Dashed: the segments at the bit pass nothing above {:.0f} Hz in twist and "
                                     "{:.0f} Hz along; what stands above is not to be trusted.",
                                     runs.front().file.torsional_pass_band, runs.front().file.axial_pass_band);
  return figure;
}

report::Series clearance_circle(double clearance) {
  constexpr int corners = 120;
  report::Series circle{
      .name = "wall", .x = {}, .y = {}, .style = report::Style::dashed, .colour = report::Colour::grey};
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    circle.x.push_back(clearance / mm * std::cos(angle));
    circle.y.push_back(clearance / mm * std::sin(angle));
  }
  return circle;
}

/// `rate` [rpm] of net turns about the middle of the hole.
std::string whirl_words(double rate) {
  constexpr double slow = 0.1;  // a turn in ten minutes
  return std::abs(rate) < slow ? "stays on its side" : fmt::format("goes round the middle {:.2f} times a minute", rate);
}

report::Plot orbit_plot(const std::vector<ShownWell>& runs, std::size_t run, std::size_t point) {
  const runtime::WellFile& file = runs[run].file;
  const runtime::Orbit& orbit = file.orbits[point];
  const double sample = file.well.drill.run.sample;
  const auto shown = std::min(orbit.up_m.size(), static_cast<std::size_t>(orbit_look_s / sample));
  report::Series line{.name = "joint", .x = {}, .y = {}};
  line.colour = colour_of_run(run);
  for (std::size_t i = orbit.up_m.size() - shown; i < orbit.up_m.size(); ++i) {
    line.x.push_back(static_cast<double>(orbit.right_m[i]) / mm);
    line.y.push_back(static_cast<double>(orbit.up_m[i]) / mm);
  }
  report::Series now{.name = "at the end", .x = {line.x.back()}, .y = {line.y.back()}, .style = report::Style::markers};
  now.colour = report::Colour::black;
  return {.title = titled(name_of(runs[run], point).c_str(), runs, run),
          .x_label = "to the right [mm]",
          .y_label = "up [mm]",
          .series = {clearance_circle(orbit.clearance), std::move(line), std::move(now)},
          .caption = fmt::format("The joint at {:.1f} m, the last {:.3g} s; it {}.", orbit.measured_depth,
                                 static_cast<double>(shown) * sample, whirl_words(whirl_rate(orbit, sample) / rpm)),
          .equal_axes = true,
          .height_px = orbit_px};
}

report::Figure orbit_figure(const std::vector<ShownWell>& runs) {
  report::Figure figure = empty_figure(
      runs, "well_orbits",
      "How the axis of the joint nearest to each stress point wanders in its hole, seen down the hole, the high side "
      "above (where the hole leans by less than 3 degrees: north). Dashed: where it is when the pipe touches the wall; "
      "a "
      "joint that is pressed there hardly moves. Turns about the middle count from the settling time on; forward, as "
      "the "
      "drive turns, is positive.");
  for (std::size_t point = 0; point < points_of(runs); ++point)
    for (std::size_t run = 0; run < runs.size(); ++run) figure.plots.push_back(orbit_plot(runs, run, point));
  return figure;
}

report::Figure damage_figure(const std::vector<ShownWell>& runs) {
  report::Plot plot{.title = "Damage over depth",
                    .x_label = "damage an hour [1/h]",
                    .y_label = "measured depth [m]",
                    .caption = "Markers: stress points. Line: the worst fibre of every joint, where the run kept them.",
                    .log_x = true,
                    .y_downwards = true,
                    .height_px = log_px};
  for (std::size_t run = 0; run < runs.size(); ++run) {
    report::Series points{.name = runs.size() > 1 ? runs[run].label : "", .x = {}, .y = {}};
    points.style = report::Style::markers;
    points.colour = colour_of_run(run);
    points.marker = static_cast<report::Marker>(run % 6);
    for (const studies::PointDamage& damage : runs[run].damage) {
      if (!(damage.damage_per_hour > 0.0)) continue;
      points.x.push_back(damage.damage_per_hour);
      points.y.push_back(damage.measured_depth);
      points.labels.push_back(damage.name);
    }
    plot.series.push_back(std::move(points));
    report::Series line{.name = runs.size() > 1 ? runs[run].label + ", every joint" : "every joint", .x = {}, .y = {}};
    line.colour = colour_of_run(run);
    for (const studies::JointDamage& joint : runs[run].joints) {
      line.x.push_back(joint.damage_per_hour > 0.0 ? joint.damage_per_hour : std::numeric_limits<double>::quiet_NaN());
      line.y.push_back(joint.measured_depth);
    }
    if (!line.x.empty()) plot.series.push_back(std::move(line));
  }
  return {.name = "well_damage",
          .caption =
              "Cycles of the stress of each point, counted by rainflow after the settling time, against an S-N "
              "curve of plain steel in air. The pipe is thought to fail when the damage sums up to 1.",
          .plots = {std::move(plot)},
          .columns = 1,
          .panel_width_px = 2.0 * panel_px};
}

bool all(const std::vector<ShownWell>& runs, bool (*has)(const ShownWell&)) {
  return std::all_of(runs.begin(), runs.end(), has);
}

}  // namespace

double whirl_rate(const runtime::Orbit& orbit, double sample) {
  double turned = 0.0;
  for (std::size_t i = 1; i < orbit.up_m.size(); ++i) {
    const double x = orbit.right_m[i - 1], y = orbit.up_m[i - 1], x_now = orbit.right_m[i], y_now = orbit.up_m[i];
    turned -= std::atan2(x * y_now - y * x_now, x * x_now + y * y_now);  // clockwise, seen down the hole
  }
  return orbit.up_m.size() < 2 ? 0.0 : turned / (static_cast<double>(orbit.up_m.size() - 1) * sample);
}

std::vector<ShownWell> shown_wells(const std::vector<std::string>& names, std::vector<runtime::WellFile> files) {
  constexpr double segments_end_to_end = 6.0, longest_segment_s = 2.0;
  const std::vector<std::string> labels = labels_of(names);
  double segment_s = longest_segment_s;
  for (const runtime::WellFile& file : files)
    segment_s = std::min(segment_s, (file.stress.time.back() - file.stress.settling) / segments_end_to_end);
  segment_s = std::max(segment_s, 0.0);  // a run may end before it settles: no spectra
  std::vector<ShownWell> runs;
  for (std::size_t k = 0; k < files.size(); ++k) {
    ShownWell run{
        .label = labels[k], .file = std::move(files[k]), .spectra = {}, .damage = {}, .joints = {}, .no_damage = {}};
    const runtime::StressHistories& stress = run.file.stress;
    for (const runtime::StressHistory& point : stress.points)
      run.spectra.push_back(spectrum_of(point.stress, MPa, first_later_than(stress.time, stress.settling),
                                        run.file.well.drill.run.sample, segment_s));
    if (!stress.points.empty()) {
      try {
        run.damage = studies::damage_of(stress, studies::usual_fatigue_wish(), names[k]);
        if (!stress.joints.empty())
          run.joints = studies::damage_of_joints(stress, studies::usual_fatigue_wish(), names[k]);
      } catch (const std::runtime_error& error) {  // too short, or the steel breaks: the page says so and goes on
        run.no_damage = error.what();
      }
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::vector<report::Figure> well_figures(const std::vector<ShownWell>& runs) {
  std::vector<report::Figure> figures{time_figure(runs, quantities, std::numeric_limits<double>::infinity()),
                                      time_figure(runs, std::span(quantities).first(closer_quantities), closer_look_s)};
  figures[0].name = "well_time";
  figures[0].caption =
      "The whole run: instants, thinned so that no extreme is lost. The weight on bit is all that the rock pushes, its "
      "spring and the source.";
  figures[1].name = "well_closer";
  figures[1].caption = fmt::format("The last {:g} s of it, stretched.", closer_look_s);
  if (all(runs, [](const ShownWell& run) { return !run.file.frames.nodes.empty(); }))
    figures.push_back(along_figure(runs));
  if (points_of(runs) == 0) return figures;
  figures.push_back(stress_figure(runs));
  figures.push_back(spectra_figure(runs));
  if (all(runs, [](const ShownWell& run) { return !run.file.orbits.empty() && !run.file.orbits[0].up_m.empty(); }))
    figures.push_back(orbit_figure(runs));
  if (all(runs, [](const ShownWell& run) { return !run.damage.empty(); })) figures.push_back(damage_figure(runs));
  return figures;
}

}  // namespace bitrock::views
