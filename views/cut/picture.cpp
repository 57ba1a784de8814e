#include "views/cut/picture.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/text.hpp"
#include "base/thin.hpp"

namespace bitrock::views {

Picture Picture::of_world(const Frame& frame, int width_px) {
  const int drawn_px = std::max(width_px, least_drawn_width_px);
  const double scale = (drawn_px - frame.left - frame.right) / (frame.x_high - frame.x_low);
  Picture picture(width_px, frame.top + frame.bottom + (frame.y_high - frame.y_low) * scale,
                  static_cast<double>(width_px) / drawn_px);
  picture.show(frame);
  return picture;
}

Picture Picture::of_curves(const Frame& frame, int width_px, int height_px) {
  const double shrink = std::min(1.0, static_cast<double>(width_px) / least_drawn_width_px);
  Picture picture(width_px, height_px / shrink, shrink);
  picture.show(frame);
  return picture;
}

Picture Picture::panel(const Frame& frame) const {
  Picture panel = *this;
  panel.show(frame);
  return panel;
}

Picture::Picture(int width_px, double height_px, double shrink)
    : width_px_(width_px / shrink),
      height_px_(height_px),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, static_cast<int>(height_px * shrink)),
               cairo_surface_destroy) {
  cairo_surface_set_device_scale(surface_.get(), shrink, shrink);
  cairo_ = {cairo_create(surface_.get()), cairo_destroy};
  cairo_set_source_rgb(cairo(), 1.0, 1.0, 1.0);
  cairo_paint(cairo());
  cairo_select_font_face(cairo(), "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

void Picture::show(const Frame& frame) {
  frame_ = frame;
  scale_x_ = (width_px_ - frame.left - frame.right) / (frame.x_high - frame.x_low);
  scale_y_ = (height_px_ - frame.top - frame.bottom) / (frame.y_high - frame.y_low);
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

namespace {

/// A byte that is no UTF-8 would spoil the whole picture.
cairo_text_extents_t extents_of(cairo_t* cairo, const std::string& words) {
  cairo_text_extents_t extents;
  cairo_text_extents(cairo, base::printable(words).c_str(), &extents);
  return extents;
}

}  // namespace

double Picture::text_width(const std::string& words) const {
  return extents_of(cairo(), words).x_advance;
}

void Picture::text(double x, double y, const std::string& text) const {
  cairo_move_to(cairo(), x, y);
  cairo_show_text(cairo(), base::printable(text).c_str());
}

void Picture::centred_text(double x, double y, const std::string& words) const {
  const cairo_text_extents_t extents = extents_of(cairo(), words);
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

std::string Picture::png() const {
  return png_of(surface_.get());
}

namespace {

struct Piece {
  int discs = 0;
  int lowest_id = 0;
};

std::vector<Piece> pieces_of(const DrawnDiscs& discs) {
  const int count = discs.fragment.empty() ? 0 : *std::max_element(discs.fragment.begin(), discs.fragment.end()) + 1;
  std::vector<Piece> pieces(static_cast<std::size_t>(count), Piece{.lowest_id = std::numeric_limits<int>::max()});
  for (std::size_t i = 0; i < discs.fragment.size(); ++i) {
    Piece& piece = pieces[static_cast<std::size_t>(discs.fragment[i])];
    ++piece.discs;
    piece.lowest_id = std::min(piece.lowest_id, discs.id[i]);
  }
  return pieces;
}

const Colour& fill_of(int number, const Piece& piece) {
  if (number == 0) return rock_fill;
  if (piece.discs == 1) return dust_fill;
  return chip_fills[static_cast<std::size_t>(piece.lowest_id) % std::size(chip_fills)];
}

}  // namespace

void draw_discs(const Picture& picture, const DrawnDiscs& discs) {
  cairo_t* cairo = picture.cairo();
  const std::vector<Piece> pieces = pieces_of(discs);
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const double radius_px = discs.radius[i] * picture.pixels_per_unit();
    cairo_new_path(cairo);
    cairo_arc(cairo, picture.px(discs.x[i]), picture.py(discs.y[i]), radius_px, 0.0, 2.0 * std::numbers::pi);
    picture.use(fill_of(discs.fragment[i], pieces[static_cast<std::size_t>(discs.fragment[i])]));
    cairo_fill_preserve(cairo);
    picture.use(rock_line);
    cairo_set_line_width(cairo, std::min(0.6, 0.1 * radius_px));  // small grains keep their colour
    cairo_stroke(cairo);
  }
}

void draw_cracks(const Picture& picture, const DrawnDiscs& discs, std::span<const dem2d::Crack> cracks) {
  const std::vector<std::optional<Segment>> faces = crack_faces(discs, cracks);
  cairo_set_line_cap(picture.cairo(), CAIRO_LINE_CAP_ROUND);
  for (std::size_t k = 0; k < cracks.size(); ++k) {
    if (!faces[k]) continue;
    const Segment& face = *faces[k];
    const double length_px = std::hypot(face.x2 - face.x1, face.y2 - face.y1) * picture.pixels_per_unit();
    cairo_set_line_width(picture.cairo(), std::clamp(0.15 * length_px, 1.0, 2.2));
    picture.use(cracks[k].mode == dem2d::ElementState::broken_in_tension ? tension_line : shear_line);
    picture.line(picture.px(face.x1), picture.py(face.y1), picture.px(face.x2), picture.py(face.y2));
  }
  cairo_set_line_cap(picture.cairo(), CAIRO_LINE_CAP_BUTT);
}

void draw_polygon(const Picture& picture, const dem2d::ConvexPolygon& outline, const Colour& fill) {
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

double tick_of(double span, int at_least) {
  const double most = span / at_least;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double times = most / power;
  return (times < 2.0 ? 1.0 : times < 5.0 ? 2.0 : 5.0) * power;
}

void draw_curve(const Picture& picture, std::span<const double> x, std::span<const double> y) {
  cairo_t* cairo = picture.cairo();
  const double width_px = picture.px(picture.frame().x_high) - picture.px(picture.frame().x_low);
  cairo_new_path(cairo);
  // a line enters, turns twice and leaves in each column of pixels
  for (const std::size_t k : base::envelope(y, 5 * static_cast<std::size_t>(width_px))) {
    cairo_line_to(cairo, picture.px(x[k]), picture.py(y[k]));
  }
  cairo_stroke(cairo);
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
    if (!x_axis.label.empty()) picture.centred_text(x, bottom + 24.0, fmt::format("{:.6g}", at));
  }
  for (const double at : ticks_within(frame.y_low, frame.y_high, y_axis)) {
    const double y = picture.py(at / y_axis.shown_per_unit);
    picture.line(left, y, left - 6.0, y);
    const std::string number = fmt::format("{:.6g}", at);
    // long numbers end before the tick; all others keep one middle
    picture.centred_text(std::min(left - 24.0, left - 9.0 - 0.5 * picture.text_width(number)), y + 5.0, number);
  }
  picture.centred_text(0.5 * (left + right), bottom + 48.0, x_axis.label);
  cairo_save(cairo);
  cairo_translate(cairo, left - 56.0, 0.5 * (bottom + top));
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
    x += 26.0 + picture.text_width(entry.text) + 28.0;
  }
}

}  // namespace bitrock::views
