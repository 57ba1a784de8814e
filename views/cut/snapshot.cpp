#include "views/cut/snapshot.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"
#include "dem2d/tool/cutter.hpp"
#include "views/cut/picture.hpp"

namespace bitrock::views {

namespace {

// Layout of the page [px].
constexpr double left_px = 80.0, right_px = 20.0, top_px = 84.0, bottom_px = 64.0;
constexpr double force_px = 130.0, gap_px = 22.0;

/// The bed and some room for the cutter and flying chips above it. A bed higher than long gets a square, so that the
/// page stays on the screen.
Picture rock_panel(const dem2d::CutCase& cut, int width_px) {
  const double above = std::min(cut.domain_margin, std::max(0.6 * cut.bed_height, 0.12 * cut.bed_length));
  const double height = cut.bed_height + above, x_low = -0.05 * cut.bed_length;
  return Picture::of_world({.x_low = x_low,
                            .y_low = 0.0,
                            .x_high = std::max(1.02 * cut.bed_length, x_low + height),
                            .y_high = height,
                            .left = left_px,
                            .top = top_px,
                            .right = right_px,
                            .bottom = 2.0 * (gap_px + force_px) + bottom_px},
                           width_px);
}

struct ForceCurve {
  const char* label;
  Colour colour, pale;
  const std::vector<double>* force;  ///< [N/m]
  double low, high;                  ///< [N/m] of the panel
};

/// Part of `values` from `begin`, of `count` values.
std::span<const double> part(const std::vector<double>& values, std::size_t begin, std::size_t count) {
  return std::span<const double>(values).subspan(begin, count);
}

/// Forces up to the instant of the frame in full colour, with a line there unless it is the end of the cut.
void draw_force(const Picture& panel, const ForceCurve& curve, const std::vector<double>& tip_x,
                const dem2d::Frame& frame) {
  const std::size_t samples = tip_x.size();
  const auto done = static_cast<std::size_t>(std::upper_bound(tip_x.begin(), tip_x.end(), frame.tip_x) - tip_x.begin());
  panel.clipped([&] {
    cairo_t* cairo = panel.cairo();
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, 1.0);
    panel.use(rock_line);
    panel.line(panel.px(panel.frame().x_low), panel.py(0.0), panel.px(panel.frame().x_high), panel.py(0.0));
    cairo_set_line_width(cairo, 1.3);
    const std::size_t joint = done > 0 ? done - 1 : 0;  // both parts hold this sample
    panel.use(curve.pale);
    draw_curve(panel, part(tip_x, joint, samples - joint), part(*curve.force, joint, samples - joint));
    panel.use(curve.colour);
    draw_curve(panel, part(tip_x, 0, done), part(*curve.force, 0, done));
    if (done == samples) return;
    panel.use(ink);
    panel.line(panel.px(frame.tip_x), panel.py(panel.frame().y_low), panel.px(frame.tip_x),
               panel.py(panel.frame().y_high));
  });
}

void draw_forces(const Picture& rock, const dem2d::RunFile& file, const dem2d::Frame& frame, const ForceScale& scale) {
  // the cutter moves at constant speed: its place at each sample follows from the place in the frame. Half a
  // millionth of the travel keeps the sample that ends with the frame on this side of it.
  const double speed = file.cut.cutter_speed, tolerance = 5e-7 * file.run.cut_length;
  std::vector<double> tip_x;
  tip_x.reserve(file.run.time.size());
  for (const double time : file.run.time) tip_x.push_back(frame.tip_x + speed * (time - frame.time) - tolerance);

  const ForceCurve curves[] = {
      {"Fx [kN/m]", blue_line, {0.75, 0.86, 0.93}, &file.run.force_x, scale.low_x, scale.high_x},
      {"Fy [kN/m]", orange_line, {0.96, 0.85, 0.76}, &file.run.force_y, scale.low_y, scale.high_y}};
  double top = rock.py(rock.frame().y_low) + gap_px;
  for (const ForceCurve& curve : curves) {
    const double low = curve.low, high = curve.high > low ? curve.high : low + 1.0;
    Picture::Frame region = rock.frame();
    region.y_low = low - 0.03 * (high - low);
    region.y_high = high + 0.06 * (high - low);
    region.top = top;
    region.bottom = rock.height_px() - top - force_px;
    const Picture panel = rock.panel(region);
    draw_force(panel, curve, tip_x, frame);
    const bool lowest_panel = &curve == std::end(curves) - 1;
    draw_axes(panel, {1e3, tick_of(1e3 * (region.x_high - region.x_low)), lowest_panel ? "x along the cut [mm]" : ""},
              {1e-3, tick_of(1e-3 * (region.y_high - region.y_low), 2), curve.label});
    top += force_px + gap_px;
  }
}

void annotate(const Picture& picture, const dem2d::RunFile& run, const dem2d::Frame& frame,
              std::span<const dem2d::Crack> cracks) {
  const dem2d::CutCase& cut = run.cut;
  const auto tensile = std::count_if(cracks.begin(), cracks.end(), [](const dem2d::Crack& crack) {
    return crack.mode == dem2d::ElementState::broken_in_tension;
  });
  const auto shear = static_cast<std::ptrdiff_t>(cracks.size()) - tensile;
  const LegendEntry entries[] = {{rock_fill, false, "rock"},
                                 {chip_fills[0], false, "chips"},
                                 {dust_fill, false, "loose grains"},
                                 {tension_line, true, fmt::format("tension cracks ({})", tensile)},
                                 {shear_line, true, fmt::format("shear cracks ({})", shear)}};
  draw_legend(picture, entries);
  const double travelled = cut.cutter_speed * frame.time;
  const std::string mud = cut.mud_pressure > 0.0
                              ? fmt::format(", {:g} MPa of mud", base::in_units(cut.mud_pressure, base::MPa))
                              : std::string();
  const std::string title = fmt::format("{}: {:g} m/s, {:g} mm deep, {:g}\u00b0 back rake{}, after {:.1f} mm of cut",
                                        cut.rock.name, cut.cutter_speed, base::in_units(cut.depth_of_cut, base::mm),
                                        base::in_units(cut.back_rake, base::deg), mud, travelled * 1e3);
  picture.use(ink);
  picture.font_size(20.0);
  const double room = picture.width_px() - left_px - right_px;
  picture.font_size(20.0 * std::min(1.0, room / picture.text_width(title)));  // a rock may have a long name
  picture.text(left_px, 32.0, title);
}

void widen(const std::vector<double>& force, double& low, double& high) {
  for (const double value : force) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
}

}  // namespace

ForceScale force_scale(std::span<const dem2d::RunFile> runs) {
  ForceScale scale;
  for (const dem2d::RunFile& run : runs) {
    widen(run.run.force_x, scale.low_x, scale.high_x);
    widen(run.run.force_y, scale.low_y, scale.high_y);
  }
  return scale;
}

std::string draw_snapshot(const dem2d::RunFile& run, const dem2d::Frame& frame, int width_px) {
  return draw_snapshot(run, frame, width_px, force_scale(std::span(&run, 1)));
}

std::string draw_snapshot(const dem2d::RunFile& run, const dem2d::Frame& frame, int width_px, const ForceScale& scale) {
  const dem2d::CutCase& cut = run.cut;
  const Picture picture = rock_panel(cut, width_px);
  const std::vector<dem2d::Crack> cracks = cracks_until(run.run.cracks, frame.time);
  const DrawnDiscs discs{frame.x, frame.y, frame.radius, frame.id, frame.fragment, run.run.discs};
  picture.clipped([&] {
    draw_discs(picture, discs);
    draw_cracks(picture, discs, cracks);
    draw_polygon(picture,
                 dem2d::cutter_outline(dem2d::cutter_shape(cut), frame.tip_x, cut.bed_height - cut.depth_of_cut),
                 tool_fill);
  });
  picture.font_size(17.0);
  draw_axes(picture, {1e3, tick_of(1e3 * (picture.frame().x_high - picture.frame().x_low)), ""},
            {1e3, tick_of(1e3 * picture.frame().y_high, 3), "height [mm]"});
  draw_forces(picture, run, frame, scale);
  annotate(picture, run, frame, cracks);
  return picture.png();
}

std::string draw_snapshot(const dem2d::RunFile& run, int width_px) {
  return draw_snapshot(run, run.run.frames.back(), width_px);
}

}  // namespace bitrock::views
