#include "report/legend.hpp"

#include <fmt/format.h>

#include "report/encode.hpp"

namespace bitrock::report {

namespace {

/// The markers of the plot library in a sample of 28 x 14 px, centred on (14, 7).
std::string marker_sample(Marker marker, const std::string& colour) {
  const auto polygon = [&](const char* points) {
    return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>", points, colour);
  };
  switch (marker) {
    case Marker::square:
      return polygon("10,3 18,3 18,11 10,11");
    case Marker::diamond:
      return polygon("14,1.5 19.5,7 14,12.5 8.5,7");
    case Marker::triangle_up:
      return polygon("14,2 19,11 9,11");
    case Marker::triangle_down:
      return polygon("14,12 19,3 9,3");
    case Marker::cross:
      return fmt::format("<path d=\"M10 3l8 8M18 3l-8 8\" stroke=\"{}\" stroke-width=\"2.6\"/>", colour);
    case Marker::circle:
      break;
  }
  return fmt::format("<circle cx=\"14\" cy=\"7\" r=\"4.2\" fill=\"{}\"/>", colour);
}

std::string line_sample(const std::string& colour, const char* dashes) {
  return fmt::format("<path d=\"M2 7h24\" stroke=\"{}\" stroke-width=\"2\"{}/>", colour, dashes);
}

std::string area_sample(const std::string& colour) {
  return fmt::format(
      "<rect x=\"3\" y=\"1.5\" width=\"22\" height=\"11\" fill=\"{0}\" fill-opacity=\"0.2\" stroke=\"{0}\" "
      "stroke-opacity=\"0.45\"/>",
      colour);
}

std::string sample(const Series& series, const std::string& colour) {
  switch (series.style) {
    case Style::line:
      return line_sample(colour, "");
    case Style::dashed:
      return line_sample(colour, " stroke-dasharray=\"6 3\"");
    case Style::markers:
      return marker_sample(series.marker, colour);
    case Style::line_and_markers:
      return line_sample(colour, "") + marker_sample(series.marker, colour);
    case Style::band:
      return area_sample(colour);
    case Style::bars:
      break;
  }
  return fmt::format("<rect x=\"8\" y=\"1\" width=\"12\" height=\"12\" fill=\"{}\"/>", colour);
}

/// `kind` is "series" or "band": what the page's script hides.
std::string entry(const char* kind, std::size_t index, const std::string& drawing, const std::string& name) {
  return fmt::format(
      "<button type=\"button\" aria-pressed=\"true\" data-{}=\"{}\">"
      "<svg width=\"28\" height=\"14\" viewBox=\"0 0 28 14\" aria-hidden=\"true\">{}</svg>{}</button>",
      kind, index, drawing, html_text(name));
}

}  // namespace

std::string legend_html(const Plot& plot) {
  std::string entries;
  int named = 0;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    if (series.name.empty()) continue;
    entries += entry("series", i, sample(series, colour_code(series.colour, i)), series.name);
    ++named;
  }
  for (std::size_t i = 0; i < plot.bands.size(); ++i) {
    const HorizontalBand& band = plot.bands[i];
    if (band.name.empty()) continue;
    entries += entry("band", i, area_sample(colour_code(band.colour, i)), band.name);
    ++named;
  }
  return named < 2 ? std::string() : "<div class=\"legend\">" + entries + "</div>\n";
}

}  // namespace bitrock::report
