#pragma once
/// A line in space that moves, as plain data: it is drawn on a canvas of the page, which the reader turns, and takes
/// through time. The plot library of the page draws no space (its bundle that does is larger and wants a graphics
/// card). What is shown is the caller's business: labels, with their units, come from there.

#include <string>
#include <vector>

namespace bitrock::report {

/// Points of a line. The third axis is drawn downwards.
struct SpaceLine {
  std::vector<double> x, y, z;  ///< of one length
};

/// The line at one instant.
struct SpaceFrame {
  std::string label;                        ///< "time 12.3 s"
  SpaceLine line;                           ///< two points or more
  SpaceLine shift;                          ///< part of it that the reader may magnify; as long as `line`
  std::vector<std::vector<double>> values;  ///< of each of the view's `values`, as long as `line`
};

/// What the line may be coloured by.
struct SpaceValue {
  std::string name;  ///< with unit: "side force [kN]"
};

struct SpaceView {
  std::string title;                      ///< above it
  std::string caption = {};               ///< a sentence under it
  std::string x_label, y_label, z_label;  ///< of the axes
  std::string unit;                       ///< of all three: "m"
  std::string shift_label;                ///< what the magnified part is: "offset"
  SpaceLine guide = {};                   ///< drawn thin and grey, two points or more
  std::vector<double> guide_marks = {};   ///< of each of its points, rising: round ones are written beside it
  std::string marks_label;                ///< what they are: "measured depth"
  std::vector<SpaceValue> values = {};    ///< one or more; the first colours at the beginning
  std::vector<SpaceFrame> frames = {};    ///< one or more
  double magnification = 1.0;             ///< of `shift` at the beginning, 1 to `most_magnified`
  double height_px = 560.0;               ///< [px]
};

/// Of `shift`.
inline constexpr double most_magnified = 2000.0;

/// Throws `base::InputError` naming the view when lengths do not match, a number is not finite, or nothing is shown.
void check(const SpaceView& view);

/// The view as JSON for `space_view.js`; it may stand inside a script element.
std::string space_json(const SpaceView& view);

/// The figure without caption: controls, canvas, data. `id` is unique on the page.
std::string space_html(const SpaceView& view, int id);

}  // namespace bitrock::report
