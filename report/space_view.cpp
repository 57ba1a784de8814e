#include "report/space_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "report/encode.hpp"

namespace bitrock::report {

namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void refuse(const SpaceView& view, const std::string& why) {
  throw base::InputError(fmt::format("view '{}': {}", view.title, why));
}

void check_numbers(const SpaceView& view, const std::string& what, const std::vector<double>& values,
                   std::size_t length) {
  if (values.size() != length)
    refuse(view, fmt::format("{} has {} values (must have {})", what, values.size(), length));
  if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }))
    refuse(view, fmt::format("{} has a number that is not finite", what));
}

void check_line(const SpaceView& view, const std::string& what, const SpaceLine& line, std::size_t length) {
  if (length < 2) refuse(view, fmt::format("{} has {} points (at least 2)", what, length));
  for (const std::vector<double>* axis : {&line.x, &line.y, &line.z}) check_numbers(view, what, *axis, length);
}

/// More digits than a screen can show would only make the page longer.
Json numbers(const std::vector<double>& values, int digits) {
  Json list = Json::array();
  for (const double value : values) list.push_back(base::rounded_to_digits(value, digits));
  return list;
}

Json line_json(const SpaceLine& line, int digits) {
  return {numbers(line.x, digits), numbers(line.y, digits), numbers(line.z, digits)};
}

std::string slider(const char* name, const std::string& label) {
  return fmt::format(
      "<label>{0}<input type=\"range\" min=\"0\" max=\"1\" step=\"any\" data-role=\"{1}\"><output></output></label>\n",
      html_text(label), name);
}

}  // namespace

void check(const SpaceView& view) {
  check_line(view, "the guide", view.guide, view.guide.x.size());
  check_numbers(view, "the marks of the guide", view.guide_marks, view.guide.x.size());
  if (!std::is_sorted(view.guide_marks.begin(), view.guide_marks.end()))
    refuse(view, "the marks of the guide must rise");
  if (view.frames.empty() || view.values.empty()) refuse(view, "nothing is shown (an instant and a value are needed)");
  if (!(view.magnification >= 1.0 && view.magnification <= most_magnified))
    refuse(view, fmt::format("magnification = {} (1 to {:g})", view.magnification, most_magnified));
  for (const SpaceFrame& frame : view.frames) {
    check_line(view, frame.label, frame.line, frame.line.x.size());
    check_line(view, frame.label + ", shift", frame.shift, frame.line.x.size());
    if (frame.values.size() != view.values.size())
      refuse(view,
             fmt::format("{} has {} values (must have {})", frame.label, frame.values.size(), view.values.size()));
    for (std::size_t k = 0; k < view.values.size(); ++k)
      check_numbers(view, frame.label + ", " + view.values[k].name, frame.values[k], frame.line.x.size());
  }
}

std::string space_json(const SpaceView& view) {
  check(view);
  Json frames = Json::array(), names = Json::array();
  for (const SpaceValue& value : view.values) names.push_back(value.name);
  for (const SpaceFrame& frame : view.frames) {
    Json values = Json::array();
    for (const std::vector<double>& column : frame.values) values.push_back(numbers(column, 4));
    frames.push_back({{"label", frame.label},
                      {"line", line_json(frame.line, 7)},
                      {"shift", line_json(frame.shift, 3)},
                      {"values", values}});
  }
  const Json json = {{"axes", {view.x_label, view.y_label, view.z_label}},
                     {"unit", view.unit},
                     {"guide", line_json(view.guide, 7)},
                     {"marks", numbers(view.guide_marks, 7)},
                     {"names", names},
                     {"magnification", view.magnification},
                     {"most", most_magnified},
                     {"frames", frames}};
  return script_json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string space_html(const SpaceView& view, int id) {
  const std::string data = space_json(view);
  std::string choices;
  for (std::size_t k = 0; k < view.values.size(); ++k)
    choices += fmt::format("<option value=\"{}\">{}</option>", k, html_text(view.values[k].name));
  return fmt::format(
      "<h3>{title}</h3>\n<div class=\"space\" id=\"space-{id}\">\n<div class=\"space-controls\">\n"
      "<label>colour<select data-role=\"value\">{choices}</select></label>\n{time}{shift}{zoom}{middle}"
      "<span><button type=\"button\" data-role=\"play\">play</button> "
      "<button type=\"button\" data-role=\"reset\">reset</button></span>\n</div>\n"
      "<canvas role=\"img\" aria-label=\"{title}\" style=\"height:{height:.0f}px\"></canvas>\n</div>\n"
      "<script type=\"application/json\" id=\"space-{id}-data\">{data}</script>\n",
      fmt::arg("title", html_text(view.title)), fmt::arg("id", id), fmt::arg("choices", choices),
      fmt::arg("time", slider("time", "instant")),
      fmt::arg("shift", slider("magnification", view.shift_label + " magnified")),
      fmt::arg("zoom", slider("zoom", "zoom")), fmt::arg("middle", slider("middle", "look at " + view.marks_label)),
      fmt::arg("height", view.height_px), fmt::arg("data", data));
}

}  // namespace bitrock::report
