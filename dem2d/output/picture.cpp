#include "dem2d/output/picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"

namespace dem2d {

Picture Picture::of_world(const Frame& frame, int width_px) {
  const double scale = (width_px - frame.left - frame.right) / (frame.x_high - frame.x_low);
  const int height_px = static_cast<int>(frame.top + frame.bottom + (frame.y_high - frame.y_low) * scale);
  return {frame, scale, scale, width_px, height_px};
}

Picture Picture::of_curves(const Frame& frame, int width_px, int height_px) {
  return {frame, (width_px - frame.left - frame.right) / (frame.x_high - frame.x_low),
          (height_px - frame.top - frame.bottom) / (frame.y_high - frame.y_low), width_px, height_px};
}

Picture::Picture(const Frame& frame, double scale_x, double scale_y, int width_px, int height_px)
    : frame_(frame),
      scale_x_(scale_x),
      scale_y_(scale_y),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px), cairo_surface_destroy),
      cairo_(cairo_create(surface_.get()), cairo_destroy) {
  cairo_set_source_rgb(cairo(), 1.0, 1.0, 1.0);
  cairo_paint(cairo());
  cairo_select_font_face(cairo(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

double Picture::px(double x) const {
  return frame_.left + (x - frame_.x_low) * scale_x_;
}

double Picture::py(double y) const {
  return frame_.top + (frame_.y_high - y) * scale_y_;
}

void Picture::use(const Colour& colour) const {
  cairo_set_source_rgb(cairo(), colour.red, colour.green, colour.blue);
}

void Picture::font_size(double pixels) const {
  cairo_set_font_size(cairo(), pixels);
}

void Picture::text(double x, double y, const std::string& text) const {
  cairo_move_to(cairo(), x, y);
  cairo_show_text(cairo(), text.c_str());
}

void Picture::centred_text(double x, double y, const std::string& words) const {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo(), words.c_str(), &extents);
  text(x - extents.width / 2.0 - extents.x_bearing, y, words);
}

void Picture::line(double x1, double y1, double x2, double y2) const {
  cairo_move_to(cairo(), x1, y1);
  cairo_line_to(cairo(), x2, y2);
  cairo_stroke(cairo());
}

void Picture::begin_clip() const {
  cairo_save(cairo());
  cairo_rectangle(cairo(), px(frame_.x_low), py(frame_.y_high), (frame_.x_high - frame_.x_low) * scale_x_,
                  (frame_.y_high - frame_.y_low) * scale_y_);
  cairo_clip(cairo());
}

void Picture::end_clip() const {
  cairo_restore(cairo());
}

namespace {

cairo_status_t append(void* sink, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string Picture::png() const {
  std::string png;
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface_.get(), append, &png);
  if (status != CAIRO_STATUS_SUCCESS)
    throw base::SimulationError(fmt::format("the picture could not be drawn: {}", cairo_status_to_string(status)));
  return png;
}

void draw_discs(const Picture& picture, const DrawnDiscs& discs) {
  cairo_t* cairo = picture.cairo();
  const int pieces = discs.fragment.empty() ? 0 : *std::max_element(discs.fragment.begin(), discs.fragment.end()) + 1;
  std::vector<int> size(static_cast<std::size_t>(pieces), 0);
  for (const int piece : discs.fragment) ++size[static_cast<std::size_t>(piece)];
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const int piece = discs.fragment[i];
    const bool dust = size[static_cast<std::size_t>(piece)] == 1;
    cairo_arc(cairo, picture.px(discs.x[i]), picture.py(discs.y[i]), discs.radius[i] * picture.pixels_per_unit(), 0.0,
              2.0 * std::numbers::pi);
    picture.use(piece == 0 ? rock_fill : dust ? dust_fill : chip_fills[piece % std::size(chip_fills)]);
    cairo_fill_preserve(cairo);
    picture.use(rock_line);
    cairo_set_line_width(cairo, 0.6);
    cairo_stroke(cairo);
  }
}

void draw_cracks(const Picture& picture, const DrawnDiscs& discs, std::span<const Crack> cracks) {
  std::vector<int> place(static_cast<std::size_t>(discs.born), -1);
  for (std::size_t i = 0; i < discs.id.size(); ++i) {
    if (discs.id[i] >= 0 && discs.id[i] < discs.born)
      place[static_cast<std::size_t>(discs.id[i])] = static_cast<int>(i);
  }
  const auto find = [&](int id) { return id >= 0 && id < discs.born ? place[static_cast<std::size_t>(id)] : -1; };
  cairo_set_line_width(picture.cairo(), 2.2);
  cairo_set_line_cap(picture.cairo(), CAIRO_LINE_CAP_ROUND);
  for (const Crack& crack : cracks) {
    const int first = find(crack.disc1), second = find(crack.disc2);
    if (first < 0 || second < 0) continue;
    const auto a = static_cast<std::size_t>(first), b = static_cast<std::size_t>(second);
    const double dx = discs.x[b] - discs.x[a], dy = discs.y[b] - discs.y[a], distance = std::hypot(dx, dy);
    if (distance > 1.25 * (discs.radius[a] + discs.radius[b])) continue;
    // the whole face of the joint: its elements share the line
    const double share = discs.radius[a] / (discs.radius[a] + discs.radius[b]),
                 half = std::min(discs.radius[a], discs.radius[b]);
    const double x = discs.x[a] + share * dx, y = discs.y[a] + share * dy;
    const double tx = -dy / distance * half, ty = dx / distance * half;
    picture.use(crack.mode == 1 ? tension_line : shear_line);
    picture.line(picture.px(x - tx), picture.py(y - ty), picture.px(x + tx), picture.py(y + ty));
  }
}

void draw_polygon(const Picture& picture, const ConvexPolygon& outline, const Colour& fill) {
  cairo_t* cairo = picture.cairo();
  for (std::size_t i = 0; i < outline.x.size(); ++i)
    cairo_line_to(cairo, picture.px(outline.x[i]), picture.py(outline.y[i]));
  cairo_close_path(cairo);
  picture.use(fill);
  cairo_fill(cairo);
}

namespace {

/// Multiples of `tick` within `low` to `high`, as shown; adding zero turns -0 into 0.
std::vector<double> ticks_within(double low, double high, const Axis& axis) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::ceil(low * axis.shown_per_unit / axis.tick)),
            last = static_cast<int>(std::floor(high * axis.shown_per_unit / axis.tick));
  for (int k = first; k <= last; ++k) ticks.push_back(k * axis.tick + 0.0);
  return ticks;
}

}  // namespace

double tick_of(double span) {
  const double power = std::pow(10.0, std::floor(std::log10(span / 5.0)));
  const double times = span / 5.0 / power;
  return (times < 2.0 ? 1.0 : times < 5.0 ? 2.0 : 5.0) * power;
}

void draw_axes(const Picture& picture, const Axis& x_axis, const Axis& y_axis) {
  cairo_t* cairo = picture.cairo();
  const Picture::Frame& frame = picture.frame();
  const double left = picture.px(frame.x_low), right = picture.px(frame.x_high);
  const double top = picture.py(frame.y_high), bottom = picture.py(frame.y_low);
  picture.use(ink);
  cairo_set_line_width(cairo, 1.0);
  cairo_rectangle(cairo, left, top, right - left, bottom - top);
  cairo_stroke(cairo);
  for (const double at : ticks_within(frame.x_low, frame.x_high, x_axis)) {
    const double x = picture.px(at / x_axis.shown_per_unit);
    picture.line(x, bottom, x, bottom + 6.0);
    picture.centred_text(x, bottom + 24.0, fmt::format("{:.6g}", at));
  }
  for (const double at : ticks_within(frame.y_low, frame.y_high, y_axis)) {
    const double y = picture.py(at / y_axis.shown_per_unit);
    picture.line(left, y, left - 6.0, y);
    const std::string number = fmt::format("{:.6g}", at);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, number.c_str(), &extents);
    // long numbers end before the tick; all others keep one middle
    picture.centred_text(std::min(left - 24.0, left - 9.0 - 0.5 * extents.width), y + 5.0, number);
  }
  picture.centred_text(0.5 * (left + right), bottom + 48.0, x_axis.label);
  cairo_save(cairo);
  cairo_translate(cairo, left - 48.0, 0.5 * (bottom + top));
  cairo_rotate(cairo, -0.5 * std::numbers::pi);
  picture.centred_text(0.0, 0.0, y_axis.label);
  cairo_restore(cairo);
}

void draw_legend(const Picture& picture, std::span<const LegendEntry> entries) {
  cairo_t* cairo = picture.cairo();
  double x = picture.frame().left;
  const double y = picture.frame().top - 16.0;
  for (const LegendEntry& entry : entries) {
    picture.use(entry.colour);
    if (entry.line) {
      cairo_set_line_width(cairo, 3.0);
      picture.line(x, y - 5.0, x + 18.0, y - 5.0);
    } else {
      cairo_new_path(cairo);
      cairo_arc(cairo, x + 9.0, y - 5.0, 8.0, 0.0, 2.0 * std::numbers::pi);
      cairo_fill_preserve(cairo);
      picture.use(rock_line);
      cairo_set_line_width(cairo, 0.6);
      cairo_stroke(cairo);
    }
    picture.use(ink);
    picture.text(x + 26.0, y, entry.text);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, entry.text.c_str(), &extents);
    x += 26.0 + extents.x_advance + 28.0;
  }
}

}  // namespace dem2d
