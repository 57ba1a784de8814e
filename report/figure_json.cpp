#include "report/figure_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "base/number.hpp"
#include "base/thin.hpp"
#include "report/encode.hpp"

namespace bitrock::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* ink = "#1d2733";
constexpr const char* muted = "#5b6774";
constexpr const char* grid_line = "#e7ebef";

// More markers than this are drawn smaller.
constexpr std::size_t many_markers = 60;

/// More digits than a screen can show would only make the page longer.
Json number(double value) {
  if (!std::isfinite(value)) return nullptr;
  return base::rounded_to_digits(value, 7);
}

Json numbers(std::span<const double> values, std::span<const std::size_t> kept) {
  Json list = Json::array();
  for (const std::size_t i : kept) list.push_back(number(values[i]));
  return list;
}

/// Text for the hover box, where the library would also replace %{...}.
std::string template_text(const std::string& text) {
  std::string safe = html_text(text);
  for (std::size_t at = 0; (at = safe.find("%{", at)) != std::string::npos;) safe.replace(at, 2, "%&#123;");
  return safe;
}

const char* marker_name(Marker marker) {
  switch (marker) {
    case Marker::square:
      return "square";
    case Marker::diamond:
      return "diamond";
    case Marker::triangle_up:
      return "triangle-up";
    case Marker::triangle_down:
      return "triangle-down";
    case Marker::cross:
      return "x";
    case Marker::circle:
      break;
  }
  return "circle";
}

const char* mode(Style style) {
  if (style == Style::markers) return "markers";
  return style == Style::line_and_markers ? "lines+markers" : "lines";
}

bool is_line(Style style) {
  return style == Style::line || style == Style::dashed || style == Style::line_and_markers;
}

/// Markers, bands and bars are drawn whole.
std::vector<std::size_t> drawn(const Series& series) {
  return base::envelope(series.y, is_line(series.style) ? base::longest_whole_line : series.y.size());
}

Json error_bar(std::span<const double> half, std::span<const std::size_t> kept, const std::string& colour) {
  return {{"type", "data"}, {"array", numbers(half, kept)}, {"color", colour + "80"}, {"thickness", 1.2}, {"width", 3}};
}

/// A closed outline: the lower edge forwards, the upper edge back.
Json band_trace(const Series& series, const std::string& colour) {
  Json x = Json::array(), y = Json::array();
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    x.push_back(number(series.x[i]));
    y.push_back(number(series.y[i]));
  }
  for (std::size_t i = series.x.size(); i-- > 0;) {
    x.push_back(number(series.x[i]));
    y.push_back(number(series.upper[i]));
  }
  return {{"type", "scatter"},
          {"mode", "lines"},
          {"x", x},
          {"y", y},
          {"fill", "toself"},
          {"fillcolor", colour + "26"},
          {"hoverinfo", "skip"},
          {"line", {{"width", 0}, {"color", colour}}}};
}

Json line_or_marker_trace(const Series& series, const std::string& colour) {
  const std::vector<std::size_t> kept = drawn(series);
  Json trace = {{"type", "scatter"},
                {"mode", mode(series.style)},
                {"x", numbers(series.x, kept)},
                {"y", numbers(series.y, kept)}};
  if (series.style != Style::markers) {
    // A dense signal in a heavy pen is a black bar.
    trace["line"] = {{"color", colour}, {"width", kept.size() > 1000 ? 1.1 : 1.8}};
    if (series.style == Style::dashed) trace["line"]["dash"] = "6px,4px";
  }
  if (!is_line(series.style) || series.style == Style::line_and_markers) {
    trace["marker"] = {{"color", colour},
                       {"symbol", marker_name(series.marker)},
                       {"size", kept.size() > many_markers ? 6 : 8},
                       {"line", {{"color", "#ffffff"}, {"width", 0.8}}}};
  }
  if (!series.error_x.empty()) trace["error_x"] = error_bar(series.error_x, kept, colour);
  if (!series.error_y.empty()) trace["error_y"] = error_bar(series.error_y, kept, colour);
  if (!series.labels.empty()) {
    trace["text"] = Json::array();
    for (const std::size_t i : kept) trace["text"].push_back(html_text(series.labels[i]));
  }
  return trace;
}

Json bar_trace(const Series& series, const std::string& colour) {
  const std::vector<std::size_t> kept = drawn(series);
  Json trace = {{"type", "bar"},
                {"x", numbers(series.x, kept)},
                {"y", numbers(series.y, kept)},
                {"marker", {{"color", colour}, {"line", {{"color", "#ffffff"}, {"width", 1}}}}}};
  if (!series.error_y.empty()) trace["error_y"] = error_bar(series.error_y, kept, ink);
  if (!series.labels.empty()) {
    trace["hovertext"] = Json::array();
    for (const std::string& label : series.labels) trace["hovertext"].push_back(html_text(label));
  }
  return trace;
}

Json trace(const Plot& plot, std::size_t index) {
  const Series& series = plot.series[index];
  const std::string colour = colour_code(series.colour, index);
  Json drawn_as;
  if (series.style == Style::band)
    drawn_as = band_trace(series, colour);
  else if (series.style == Style::bars)
    drawn_as = bar_trace(series, colour);
  else
    drawn_as = line_or_marker_trace(series, colour);

  drawn_as["name"] = html_text(series.name);
  drawn_as["showlegend"] = !series.name.empty();
  if (series.style == Style::band) return drawn_as;
  const char* label = series.style == Style::bars ? "<b>%{hovertext}</b><br>" : "<b>%{text}</b><br>";
  drawn_as["hovertemplate"] =
      fmt::format("{}{}: %{{x:,.5~g}}<br>{}: %{{y:,.5~g}}<extra>{}</extra>", series.labels.empty() ? "" : label,
                  template_text(plot.x_label), template_text(plot.y_label), template_text(series.name));
  return drawn_as;
}

/// The range of a logarithmic axis is given in powers of ten.
Json axis(const std::string& label, bool logarithmic, const std::optional<AxisRange>& range) {
  Json axis = {{"title", {{"text", html_text(label)}, {"standoff", 8}}},
               {"type", logarithmic ? "log" : "linear"},
               {"exponentformat", logarithmic ? "power" : "SI"},
               {"separatethousands", true},
               {"automargin", true},
               {"showline", true},
               {"linecolor", "#9aa5b1"},
               {"ticks", "outside"},
               {"ticklen", 4},
               {"tickcolor", "#9aa5b1"},
               {"gridcolor", grid_line},
               {"zerolinecolor", "#c3cbd3"}};
  // Few and round labels: on a logarithmic axis 1, 2 and 5 of a decade instead of every digit.
  if (logarithmic) axis["nticks"] = 6;
  if (!range) return axis;
  axis["range"] = logarithmic ? Json{number(std::log10(range->low)), number(std::log10(range->high))}
                              : Json{number(range->low), number(range->high)};
  return axis;
}

Json shapes(const Plot& plot) {
  Json list = Json::array();
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    const HorizontalBand& band = plot.bands[i];
    const std::string colour = colour_code(band.colour, i);
    list.push_back({{"type", "rect"},
                    {"layer", "below"},
                    {"xref", "paper"},
                    {"x0", 0},
                    {"x1", 1},
                    {"yref", "y"},
                    {"y0", number(band.low)},
                    {"y1", number(band.high)},
                    {"fillcolor", colour + "26"},
                    {"line", {{"width", 0}}},
                    {"name", html_text(band.name)},
                    {"showlegend", !band.name.empty()}});
  }
  return list;
}

/// 1234567 as "1 234 567", with spaces that do not break.
std::string grouped(std::size_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, "\u00a0");
  return digits;
}

bool has_data(const Plot& plot) {
  for (const Series& series : plot.series) {
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) return true;
    }
  }
  return false;
}

Json layout(const Plot& plot) {
  Json layout = {{"autosize", true},
                 {"margin", {{"l", 56}, {"r", 14}, {"t", 30}, {"b", 44}}},
                 {"font",
                  {{"family", "system-ui, -apple-system, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif"},
                   {"size", 13},
                   {"color", ink}}},
                 {"paper_bgcolor", "#ffffff"},
                 {"plot_bgcolor", "#ffffff"},
                 {"showlegend", false},
                 {"hovermode", "closest"},
                 {"hoverlabel", {{"align", "left"}, {"font", {{"size", 13}}}}},
                 {"bargap", 0.06},
                 {"xaxis", axis(plot.x_label, plot.log_x, plot.x_range)},
                 {"yaxis", axis(plot.y_label, plot.log_y, plot.y_range)},
                 {"shapes", shapes(plot)}};
  if (plot.y_downwards) {
    Json& y = layout["yaxis"];
    if (y.contains("range")) {
      std::swap(y["range"][0], y["range"][1]);
    } else {
      y["autorange"] = "reversed";
    }
  }
  if (plot.equal_axes) {
    layout["xaxis"]["constrain"] = "domain";
    layout["yaxis"]["constrain"] = "domain";
    layout["yaxis"]["scaleanchor"] = "x";
    for (const char* side : {"xaxis", "yaxis"}) layout[side]["nticks"] = 6;  // the same steps on both
  }
  if (!has_data(plot)) {
    layout["annotations"] = {{{"text", "no data"},
                              {"showarrow", false},
                              {"xref", "paper"},
                              {"yref", "paper"},
                              {"x", 0.5},
                              {"y", 0.5},
                              {"font", {{"size", 15}, {"color", muted}}}}};
  }
  return layout;
}

}  // namespace

std::string figure_json(const Plot& plot) {
  check(plot);
  Json data = Json::array();
  for (std::size_t i = 0; i < plot.series.size(); ++i) data.push_back(trace(plot, i));
  const Json figure = {{"data", data}, {"layout", layout(plot)}, {"name", slug(plot.title)}};
  return script_json(figure.dump(-1, ' ', false, Json::error_handler_t::replace));
}

std::string thinning_note(const Plot& plot) {
  std::size_t given = 0, kept = 0;
  for (const Series& series : plot.series) {
    if (!is_line(series.style) || series.y.size() <= base::longest_whole_line) continue;
    given += series.y.size();
    kept += drawn(series).size();
  }
  if (given == 0) return {};
  return fmt::format("Drawn with {} of {} points; the highest and lowest of every stretch are kept.", grouped(kept),
                     grouped(given));
}

}  // namespace bitrock::report
