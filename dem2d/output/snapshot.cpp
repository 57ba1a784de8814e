#include "dem2d/output/snapshot.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "dem2d/tool/cutter.hpp"

namespace dem2d {

namespace {

struct Colour {
  double red, green, blue;
};

// Chosen to stay apart for colour-blind readers and in grey: light rock, blue chips, dark cracks in two hues.
constexpr Colour rock_fill{0.93, 0.88, 0.78}, rock_line{0.70, 0.62, 0.48};
constexpr Colour dust_fill{0.62, 0.63, 0.65};
constexpr Colour chip_fills[] = {{0.55, 0.75, 0.90}, {0.40, 0.62, 0.80}, {0.68, 0.84, 0.94}, {0.48, 0.70, 0.75}};
constexpr Colour tension_line{0.84, 0.15, 0.12}, shear_line{0.30, 0.08, 0.52};
constexpr Colour tool_fill{0.22, 0.24, 0.28}, ink{0.15, 0.15, 0.15};

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

/// Millimetres of the world to pixels of the page, y upwards.
struct Page {
  double x_low, y_low, x_high, y_high;  // shown region [m]
  double left, top, pixels_per_metre;
  double px(double x) const { return left + (x - x_low) * pixels_per_metre; }
  double py(double y) const { return top + (y_high - y) * pixels_per_metre; }
};

void ink_colour(cairo_t* cairo, const Colour& colour) {
  cairo_set_source_rgb(cairo, colour.red, colour.green, colour.blue);
}

void centred_text(cairo_t* cairo, double x, double y, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, text.c_str(), &extents);
  cairo_move_to(cairo, x - extents.width / 2.0 - extents.x_bearing, y);
  cairo_show_text(cairo, text.c_str());
}

void draw_discs(cairo_t* cairo, const Page& page, const Frame& frame) {
  const int pieces = frame.fragment.empty() ? 0 : *std::max_element(frame.fragment.begin(), frame.fragment.end()) + 1;
  std::vector<int> size(static_cast<std::size_t>(pieces), 0);
  for (const int piece : frame.fragment) ++size[static_cast<std::size_t>(piece)];
  for (std::size_t i = 0; i < frame.x.size(); ++i) {
    const int piece = frame.fragment[i];
    const bool dust = size[static_cast<std::size_t>(piece)] == 1;
    cairo_arc(cairo, page.px(frame.x[i]), page.py(frame.y[i]), frame.radius[i] * page.pixels_per_metre, 0.0,
              2.0 * std::numbers::pi);
    ink_colour(cairo, piece == 0 ? rock_fill : dust ? dust_fill : chip_fills[piece % std::size(chip_fills)]);
    cairo_fill_preserve(cairo);
    ink_colour(cairo, rock_line);
    cairo_set_line_width(cairo, 0.6);
    cairo_stroke(cairo);
  }
}

/// Cracks whose two discs are still near each other, drawn between where the discs are now; those of flown chips would
/// only cover the picture with lines.
void draw_cracks(cairo_t* cairo, const Page& page, const RunFile& run) {
  const Frame& frame = run.run.frames.back();
  const int born = run.run.discs;
  std::vector<int> place(static_cast<std::size_t>(born), -1);
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    if (frame.id[i] >= 0 && frame.id[i] < born) place[static_cast<std::size_t>(frame.id[i])] = static_cast<int>(i);
  }
  const auto find = [&](int id) { return id >= 0 && id < born ? place[static_cast<std::size_t>(id)] : -1; };
  cairo_set_line_width(cairo, 2.2);
  cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
  for (const Crack& crack : run.run.cracks) {
    const int first = find(crack.disc1), second = find(crack.disc2);
    if (first < 0 || second < 0) continue;
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    const double dx = frame.x[b] - frame.x[a], dy = frame.y[b] - frame.y[a], distance = std::hypot(dx, dy);
    if (distance > 1.25 * (frame.radius[a] + frame.radius[b])) continue;
    // the whole face of the joint: its elements share the line
    const double share = frame.radius[a] / (frame.radius[a] + frame.radius[b]),
                 half = std::min(frame.radius[a], frame.radius[b]);
    const double x = frame.x[a] + share * dx, y = frame.y[a] + share * dy;
    const double tx = -dy / distance * half, ty = dx / distance * half;
    ink_colour(cairo, crack.mode == 1 ? tension_line : shear_line);
    cairo_move_to(cairo, page.px(x - tx), page.py(y - ty));
    cairo_line_to(cairo, page.px(x + tx), page.py(y + ty));
    cairo_stroke(cairo);
  }
}

void draw_cutter(cairo_t* cairo, const Page& page, const RunFile& run, double bed_height) {
  const CutCase& cut = run.cut;
  const ConvexPolygon outline = cutter_outline({cut.cutter_diameter, cut.cutter_thickness, cut.back_rake},
                                               run.run.frames.back().tip_x, bed_height - cut.depth_of_cut);
  for (std::size_t i = 0; i < outline.x.size(); ++i) cairo_line_to(cairo, page.px(outline.x[i]), page.py(outline.y[i]));
  cairo_close_path(cairo);
  ink_colour(cairo, tool_fill);
  cairo_fill(cairo);
}

/// Multiples of `tick` [mm] within `low` to `high` [m]; adding zero turns -0 into 0.
std::vector<double> ticks_within(double low, double high, double tick) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::ceil(low * 1e3 / tick)),
            last = static_cast<int>(std::floor(high * 1e3 / tick));
  for (int k = first; k <= last; ++k) ticks.push_back(k * tick + 0.0);
  return ticks;
}

void draw_axes(cairo_t* cairo, const Page& page) {
  ink_colour(cairo, ink);
  cairo_set_line_width(cairo, 1.0);
  cairo_rectangle(cairo, page.px(page.x_low), page.py(page.y_high), (page.x_high - page.x_low) * page.pixels_per_metre,
                  (page.y_high - page.y_low) * page.pixels_per_metre);
  cairo_stroke(cairo);
  const double span = (page.x_high - page.x_low) * 1e3;
  const double tick = span > 100.0 ? 20.0 : span > 40.0 ? 10.0 : span > 15.0 ? 5.0 : 1.0;  // [mm]
  for (const double at : ticks_within(page.x_low, page.x_high, tick)) {
    const double x = page.px(at * 1e-3), y = page.py(page.y_low);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, x, y + 6.0);
    cairo_stroke(cairo);
    centred_text(cairo, x, y + 24.0, fmt::format("{:g}", at));
  }
  for (const double at : ticks_within(page.y_low, page.y_high, tick)) {
    const double x = page.px(page.x_low), y = page.py(at * 1e-3);
    cairo_move_to(cairo, x, y);
    cairo_line_to(cairo, x - 6.0, y);
    cairo_stroke(cairo);
    centred_text(cairo, x - 24.0, y + 5.0, fmt::format("{:g}", at));
  }
  centred_text(cairo, 0.5 * (page.px(page.x_low) + page.px(page.x_high)), page.py(page.y_low) + 48.0,
               "x along the cut [mm]");
  cairo_save(cairo);
  cairo_translate(cairo, page.left - 48.0, 0.5 * (page.py(page.y_low) + page.py(page.y_high)));
  cairo_rotate(cairo, -0.5 * std::numbers::pi);
  centred_text(cairo, 0.0, 0.0, "height [mm]");
  cairo_restore(cairo);
}

void draw_legend(cairo_t* cairo, const Page& page, const RunFile& run) {
  struct Entry {
    Colour colour;
    bool line;
    std::string text;
  };
  const Entry entries[] = {{rock_fill, false, "rock"},
                           {chip_fills[0], false, "chips"},
                           {dust_fill, false, "loose grains"},
                           {tension_line, true, fmt::format("broken in tension ({})", run.run.cracks_tensile)},
                           {shear_line, true, fmt::format("broken in shear ({})", run.run.cracks_shear)}};
  double x = page.left;
  const double y = page.top - 16.0;
  for (const Entry& entry : entries) {
    ink_colour(cairo, entry.colour);
    if (entry.line) {
      cairo_set_line_width(cairo, 3.0);
      cairo_move_to(cairo, x, y - 5.0);
      cairo_line_to(cairo, x + 18.0, y - 5.0);
      cairo_stroke(cairo);
    } else {
      cairo_new_path(cairo);
      cairo_arc(cairo, x + 9.0, y - 5.0, 8.0, 0.0, 2.0 * std::numbers::pi);
      cairo_fill_preserve(cairo);
      ink_colour(cairo, rock_line);
      cairo_set_line_width(cairo, 0.6);
      cairo_stroke(cairo);
    }
    ink_colour(cairo, ink);
    cairo_move_to(cairo, x + 26.0, y);
    cairo_show_text(cairo, entry.text.c_str());
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, entry.text.c_str(), &extents);
    x += 26.0 + extents.x_advance + 28.0;
  }
}

cairo_status_t append(void* sink, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string draw_snapshot(const RunFile& run, int width_px) {
  const CutCase& cut = run.cut;
  const double left = 80.0, right = 20.0, top = 84.0, bottom = 64.0;
  const double above = std::min(cut.domain_margin, 0.6 * cut.bed_height);  // room for the cutter and flying chips
  Page page{.x_low = -0.05 * cut.bed_length,
            .y_low = 0.0,
            .x_high = 1.02 * cut.bed_length,
            .y_high = cut.bed_height + above,
            .left = left,
            .top = top,
            .pixels_per_metre = 0.0};
  page.pixels_per_metre = (width_px - left - right) / (page.x_high - page.x_low);
  const int height_px = static_cast<int>(top + bottom + (page.y_high - page.y_low) * page.pixels_per_metre);

  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px), cairo_surface_destroy);
  const Context context(cairo_create(surface.get()), cairo_destroy);
  cairo_t* cairo = context.get();
  cairo_set_source_rgb(cairo, 1.0, 1.0, 1.0);
  cairo_paint(cairo);
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);

  cairo_save(cairo);
  cairo_rectangle(cairo, page.px(page.x_low), page.py(page.y_high), (page.x_high - page.x_low) * page.pixels_per_metre,
                  (page.y_high - page.y_low) * page.pixels_per_metre);
  cairo_clip(cairo);
  draw_discs(cairo, page, run.run.frames.back());
  draw_cracks(cairo, page, run);
  draw_cutter(cairo, page, run, cut.bed_height);
  cairo_restore(cairo);

  cairo_set_font_size(cairo, 17.0);
  draw_axes(cairo, page);
  draw_legend(cairo, page, run);
  cairo_set_font_size(cairo, 20.0);
  ink_colour(cairo, ink);
  cairo_move_to(cairo, page.left, 32.0);
  const std::string title = fmt::format("{}: {:g} m/s, {:g} mm deep, {:g}\u00b0 back rake, after {:.3g} mm of cut",
                                        cut.rock.name, cut.cutter_speed, base::in_units(cut.depth_of_cut, base::mm),
                                        base::in_units(cut.back_rake, base::deg), run.run.cut_length * 1e3);
  cairo_show_text(cairo, title.c_str());

  std::string png;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), append, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw base::SimulationError(fmt::format("the picture could not be drawn: {}", cairo_status_to_string(status)));
  return png;
}

}  // namespace dem2d
