#pragma once
/// What the pictures of the engine share: colours, a page of one or more panels with their scales, discs by fragment,
/// cracks where their discs are now, curves, axes and legend, and the PNG at the end. Each picture (snapshot.cpp,
/// lab/lab_picture.cpp) puts them together in its own way.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dem2d/step/world.hpp"
#include "views/cut/crack_faces.hpp"
#include "views/cut/png.hpp"

// A name of cairo.h, which stays private to the sources.
struct _cairo;  // NOLINT(bugprone-reserved-identifier)

namespace bitrock::views {

struct Colour {
  double red, green, blue;
};

// Chosen to stay apart for colour-blind readers and in grey: light rock, blue chips, dark cracks in two hues.
inline constexpr Colour rock_fill{0.93, 0.88, 0.78}, rock_line{0.70, 0.62, 0.48};
inline constexpr Colour dust_fill{0.62, 0.63, 0.65};
inline constexpr Colour chip_fills[] = {{0.55, 0.75, 0.90}, {0.40, 0.62, 0.80}, {0.68, 0.84, 0.94}, {0.48, 0.70, 0.75}};
inline constexpr Colour tension_line{0.84, 0.15, 0.12}, shear_line{0.30, 0.08, 0.52};
inline constexpr Colour tool_fill{0.22, 0.24, 0.28}, ink{0.15, 0.15, 0.15};
// Of curves, distinct for colour-blind readers [OkabeIto2008].
inline constexpr Colour blue_line{0.00, 0.45, 0.70}, orange_line{0.84, 0.37, 0.00};

/// Letters and margins suit a page at least this wide; a narrower one is drawn so and reduced [px].
inline constexpr int least_drawn_width_px = 900;

/// A panel on a white page and the part of the world it shows, y upwards. The world may be metres, or strain and
/// stress. Copies and panels share the page.
class Picture {
 public:
  struct Frame {
    double x_low, y_low, x_high, y_high;  ///< shown region, in units of the world
    double left, top, right, bottom;      ///< margins of the page [px]
  };
  /// A page with one panel and one scale for both axes: the height of the page follows.
  static Picture of_world(const Frame& frame, int width_px);
  /// With a scale for each axis.
  static Picture of_curves(const Frame& frame, int width_px, int height_px);
  /// Another panel on the same page, with a scale for each axis.
  Picture panel(const Frame& frame) const;

  double px(double x) const;
  double py(double y) const;
  double pixels_per_unit() const { return scale_x_; }  ///< of x
  double width_px() const { return width_px_; }        ///< of the page, as drawn
  double height_px() const { return height_px_; }
  const Frame& frame() const { return frame_; }
  _cairo* cairo() const { return cairo_.get(); }

  void use(const Colour& colour) const;
  void font_size(double pixels) const;
  double text_width(const std::string& text) const;                      ///< [px]
  void text(double x, double y, const std::string& text) const;          ///< begins at (x, y) [px]
  void centred_text(double x, double y, const std::string& text) const;  ///< middle at x [px]
  void line(double x1, double y1, double x2, double y2) const;           ///< [px]
  /// While `draw` runs, nothing is drawn outside the shown region.
  template <class Draw>
  void clipped(const Draw& draw) const {
    begin_clip();
    draw();
    end_clip();
  }
  std::string png() const;

 private:
  /// An empty page; `shrink` turns pixels as drawn into pixels of the file.
  Picture(int width_px, double height_px, double shrink);
  void show(const Frame& frame);
  void begin_clip() const;
  void end_clip() const;

  Frame frame_{};
  double width_px_, height_px_;       // as drawn
  double scale_x_ = 1, scale_y_ = 1;  // [px per unit]
  std::shared_ptr<_cairo_surface> surface_;
  std::shared_ptr<_cairo> cairo_;
};

/// Fragment 0 as rock, single discs as dust, the others as chips, each in the shade of its first disc, so that a chip
/// keeps its colour from frame to frame.
void draw_discs(const Picture& picture, const DrawnDiscs& discs);

/// Cracks whose two discs have not parted, where the discs are now.
void draw_cracks(const Picture& picture, const DrawnDiscs& discs, std::span<const dem2d::Crack> cracks);

void draw_polygon(const Picture& picture, const dem2d::ConvexPolygon& outline, const Colour& fill);

struct Axis {
  double shown_per_unit;  ///< number at a tick = value * this
  double tick;            ///< between two ticks, as shown
  std::string label;      ///< without one, ticks stand without numbers
};

/// The largest of ..., 0.1, 0.2, 0.5, 1, 2, 5, 10, ... that fits at least this many times into `span` (as shown).
double tick_of(double span, int at_least = 5);

/// The line through the points, thinned to what can be seen.
void draw_curve(const Picture& picture, std::span<const double> x, std::span<const double> y);

void draw_axes(const Picture& picture, const Axis& x, const Axis& y);

struct LegendEntry {
  Colour colour;
  bool line;  ///< otherwise a disc
  std::string text;
};
void draw_legend(const Picture& picture, std::span<const LegendEntry> entries);

}  // namespace bitrock::views
