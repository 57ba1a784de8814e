#include "views/lab/lab_picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "views/cut/picture.hpp"

namespace bitrock::views {

namespace {

// Room around the core for platens and pieces, as a share of its width.
constexpr double room_beside = 0.30, room_above = 0.12;

// One colour a specimen; distinct for colour-blind readers [OkabeIto2008].
constexpr Colour curve_lines[] = {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45}, {0.80, 0.47, 0.65},
                                  {0.34, 0.71, 0.91}, {0.90, 0.62, 0.00}, {0.35, 0.35, 0.35}};
constexpr std::size_t most_legend_entries = 12;

const char* title_of(dem2d::LabTest test) {
  switch (test) {
    case dem2d::LabTest::ucs:
      return "uniaxial compression";
    case dem2d::LabTest::tension:
      return "direct tension";
    case dem2d::LabTest::brazilian:
      return "Brazilian test";
    case dem2d::LabTest::triaxial:
      return "triaxial compression";
    case dem2d::LabTest::toughness:
      return "tension of a notched core";
  }
  return "";
}

/// Under which pressure, or with which cut; empty of tests that have neither.
std::string condition_of(const dem2d::LabRun& run) {
  if (run.test == dem2d::LabTest::triaxial) return fmt::format("{:.3g} MPa", run.confining_pressure * 1e-6);
  if (run.test == dem2d::LabTest::toughness) return fmt::format("{:.3g} mm", run.notch_length * 1e3);
  return "";
}

/// Of a test under pressure the strength is told above it.
std::string subtitle_of(const dem2d::LabRun& run) {
  const bool confined = run.confining_pressure > 0.0;
  if (run.test == dem2d::LabTest::toughness) {
    return fmt::format("seed {}, notch {:.3g} mm, strength {:.3g} MPa, toughness {:.3g} MPa sqrt(m)", run.seed,
                       run.notch_length * 1e3, run.peak_stress * 1e-6, run.fracture_toughness * 1e-6);
  }
  return fmt::format("seed {}{}, strength {:.3g} MPa{}, drawn at {:.3g} MPa after the peak", run.seed,
                     confined ? ", under " + condition_of(run) : "", run.peak_stress * 1e-6,
                     confined ? " above it" : "", run.curve.back().stress * 1e-6);
}

/// Platens as solid bars; grips as bars over the discs they hold.
void draw_ends(const Picture& picture, const dem2d::LabRun& run, double width) {
  const double thick = room_above * width;
  const double x_low = -0.12 * width, x_high = 1.12 * width;
  draw_polygon(picture, dem2d::rectangle(x_low, run.last.low - thick, x_high, run.last.low), tool_fill);
  draw_polygon(picture, dem2d::rectangle(x_low, run.last.high, x_high, run.last.high + thick), tool_fill);
}

/// The saw cut, where it was before the ends parted.
void draw_notch(const Picture& picture, const dem2d::LabRun& run) {
  const double middle = 0.5 * (run.last.low + run.last.high);
  const auto px = [&](double side) { return picture.px(0.5 * (run.width + side * run.notch_length)); };
  picture.use(ink);
  cairo_set_line_width(picture.cairo(), 4.0);
  picture.line(px(-1.0), picture.py(middle), px(1.0), picture.py(middle));
}

/// Number of the colour of each curve: one a seed, or one a pressure or cut, in the order in which they come.
std::vector<std::size_t> colours_of(std::span<const dem2d::LabRun> runs, bool by_condition) {
  std::vector<std::size_t> colours(runs.size());
  for (std::size_t k = 1; k < runs.size(); ++k) {
    const bool same = by_condition && condition_of(runs[k]) == condition_of(runs[k - 1]);
    colours[k] = same ? colours[k - 1] : colours[k - 1] + 1;
  }
  return colours;
}

/// Least and greatest strain and greatest stress over all curves.
struct Extent {
  double strain_low = 0.0, strain_high = 0.0, stress_high = 0.0;
};

Extent extent_of(std::span<const dem2d::LabRun> runs) {
  Extent extent;
  for (const dem2d::LabRun& run : runs) {
    // after the peak strains of the middle half may be those of loose pieces: they do not set the scale
    for (const dem2d::LabSample& sample : run.curve) {
      extent.stress_high = std::max(extent.stress_high, sample.stress);
      extent.strain_high = std::max(extent.strain_high, std::min(sample.strain, 1.3 * run.strain_at_peak));
      extent.strain_low = std::min(extent.strain_low, std::max(sample.lateral_strain, -run.strain_at_peak));
    }
  }
  return extent;
}

void draw_line(const Picture& picture, const std::vector<dem2d::LabSample>& curve, bool lateral) {
  cairo_t* cairo = picture.cairo();
  cairo_new_path(cairo);
  cairo_move_to(cairo, picture.px(0.0), picture.py(0.0));
  for (const dem2d::LabSample& sample : curve) {
    cairo_line_to(cairo, picture.px(lateral ? sample.lateral_strain : sample.strain), picture.py(sample.stress));
  }
  cairo_stroke(cairo);
}

}  // namespace

std::string draw_broken_core(const dem2d::LabRun& run, const std::string& rock_name, int width_px) {
  const double width = run.width, height = run.height;
  const Picture picture = Picture::of_world({.x_low = -room_beside * width,
                                             .y_low = -1.5 * room_above * width,
                                             .x_high = (1.0 + room_beside) * width,
                                             .y_high = height + 1.5 * room_above * width,
                                             .left = 80.0,
                                             .top = 112.0,
                                             .right = 20.0,
                                             .bottom = 64.0},
                                            width_px);
  const DrawnDiscs discs{run.last.x, run.last.y, run.last.radius, run.last.id, run.last.fragment, run.discs};
  picture.clipped([&] {
    draw_discs(picture, discs);
    draw_ends(picture, run, width);
    if (run.notch_length > 0.0) draw_notch(picture, run);
    draw_cracks(picture, discs, run.cracks);
  });
  picture.font_size(17.0);
  const double tick = tick_of((picture.frame().x_high - picture.frame().x_low) * 1e3);
  draw_axes(picture, {1e3, tick, "x [mm]"}, {1e3, tick, "height [mm]"});
  std::vector<LegendEntry> entries{{rock_fill, false, "largest piece"},
                                   {chip_fills[0], false, "pieces"},
                                   {dust_fill, false, "loose grains"},
                                   {tension_line, true, fmt::format("tension ({})", run.cracks_tensile)},
                                   {shear_line, true, fmt::format("shear ({})", run.cracks_shear)}};
  if (run.notch_length > 0.0) entries.push_back({ink, true, "saw cut"});
  draw_legend(picture, entries);
  picture.font_size(20.0);
  picture.use(ink);
  picture.text(picture.frame().left, 32.0, fmt::format("{}, {}", rock_name, title_of(run.test)));
  picture.font_size(18.0);
  picture.text(picture.frame().left, 62.0, subtitle_of(run));
  return picture.png();
}

std::string draw_curves(std::span<const dem2d::LabRun> runs, const std::string& rock_name, int width_px) {
  const Extent extent = extent_of(runs);
  const dem2d::LabTest test = runs.front().test;
  const bool confined = test == dem2d::LabTest::triaxial, notched = test == dem2d::LabTest::toughness;
  const std::vector<std::size_t> colours = colours_of(runs, confined || notched);
  const bool lateral = dem2d::strains_evenly(test);
  const double span = extent.strain_high - (lateral ? extent.strain_low : 0.0);
  const Picture picture = Picture::of_curves({.x_low = lateral ? extent.strain_low - 0.03 * span : 0.0,
                                              .y_low = 0.0,
                                              .x_high = extent.strain_high + 0.03 * span,
                                              .y_high = 1.08 * extent.stress_high,
                                              .left = 80.0,
                                              .top = 84.0,
                                              .right = 20.0,
                                              .bottom = 64.0},
                                             width_px, width_px * 2 / 3);
  cairo_t* cairo = picture.cairo();
  picture.clipped([&] {
    cairo_set_line_width(cairo, 2.0);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    for (std::size_t k = 0; k < runs.size(); ++k) {
      picture.use(curve_lines[colours[k] % std::size(curve_lines)]);
      draw_line(picture, runs[k].curve, false);
      if (lateral) draw_line(picture, runs[k].curve, true);
    }
    picture.use(ink);
    cairo_set_line_width(cairo, 1.0);
    picture.line(picture.px(0.0), picture.py(0.0), picture.px(0.0), picture.py(picture.frame().y_high));
  });
  picture.font_size(17.0);
  const std::string along = lateral   ? "lateral strain < 0 < strain along the load [%]"
                            : notched ? "stretching of the core between its grips [%]"
                                      : "shortening of the diameter [%]";
  draw_axes(picture, {1e2, tick_of(1e2 * (picture.frame().x_high - picture.frame().x_low)), along},
            {1e-6, tick_of(1e-6 * picture.frame().y_high),
             dem2d::pulls(test) ? "tension [MPa]"
             : confined         ? "stress above the confining pressure [MPa]"
                                : "stress [MPa]"});
  std::vector<LegendEntry> entries;
  for (std::size_t k = 0; k < runs.size() && entries.size() < most_legend_entries; ++k) {
    if (colours[k] < entries.size()) continue;
    entries.push_back({curve_lines[colours[k] % std::size(curve_lines)], true,
                       confined || notched ? condition_of(runs[k]) : fmt::format("{}", runs[k].seed)});
  }
  draw_legend(picture, entries);
  picture.font_size(20.0);
  picture.use(ink);
  picture.text(picture.frame().left, 32.0,
               fmt::format("{}, {}, by {}", rock_name, title_of(test),
                           confined  ? "confining pressure"
                           : notched ? "length of the notch"
                                     : "seed"));
  return picture.png();
}

}  // namespace bitrock::views
