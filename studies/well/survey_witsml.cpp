#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <pugixml.hpp>

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "studies/well/survey_rows.hpp"

namespace bitrock::studies {

namespace {

/// Lines of a text from places, which the parser gives as bytes. Each byte is looked at once, for places that grow.
struct Lines {
  std::string_view text;
  std::ptrdiff_t at = 0;  ///< where the counting is
  int line = 1;           ///< there

  int of(std::ptrdiff_t place) {
    place = std::clamp<std::ptrdiff_t>(place, 0, static_cast<std::ptrdiff_t>(text.size()));
    if (place < at) at = 0, line = 1;
    line += static_cast<int>(std::count(text.begin() + at, text.begin() + place, '\n'));
    at = place;
    return line;
  }
};

/// A document and where it came from.
struct Document {
  std::string_view text;
  const std::string& source;
  pugi::xml_document xml;

  [[noreturn]] void refuse(std::ptrdiff_t place, const std::string& what) const {
    throw base::InputError(fmt::format("{}:{}: {}", source, Lines{.text = text}.of(place), what));
  }
  [[noreturn]] void refuse(const pugi::xml_node& node, const std::string& what) const {
    refuse(node.offset_debug(), what);
  }
};

/// Without the prefix of its namespace.
std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  return name.substr(name.rfind(':') + 1);  // npos + 1 is 0
}

pugi::xml_node child_of(const pugi::xml_node& parent, std::string_view name) {
  for (const pugi::xml_node& child : parent.children()) {
    if (local_name(child) == name) return child;
  }
  return {};
}

/// The one trajectory of the file.
pugi::xml_node trajectory_of(const Document& document) {
  const pugi::xml_node root = document.xml.document_element();
  if (local_name(root) == "trajectory") return root;
  pugi::xml_node found;
  for (const pugi::xml_node& child : root.children()) {
    if (local_name(child) != "trajectory") continue;
    if (found) document.refuse(child, "a second trajectory (a file holds one survey)");
    found = child;
  }
  if (!found) {
    document.refuse(
        root, fmt::format("<{}> holds no trajectory (a WITSML 1.4.1.1 trajectory is needed, or a table)", root.name()));
  }
  return found;
}

/// A number with its unit, in SI. `unit` is that of the stations above, once it is known.
double quantity(const Document& document, const pugi::xml_node& element,
                std::optional<SurveyUnit> (*unit_named)(std::string_view), std::optional<SurveyUnit>& unit) {
  const std::string_view uom = element.attribute("uom").value();
  if (uom.empty()) document.refuse(element, fmt::format("<{}> without its unit (uom)", element.name()));
  const std::optional<SurveyUnit> found = unit_named(uom);
  if (!found) document.refuse(element, fmt::format("<{}>: the unit uom='{}' is not known here", element.name(), uom));
  if (unit && unit->name != found->name)
    document.refuse(element, fmt::format("<{}> in {}, above in {}", element.name(), found->name, unit->name));
  unit = found;
  const std::string_view text = base::trimmed(element.text().get());
  const std::optional<double> value = base::number_in(text);
  if (!value) document.refuse(element, fmt::format("<{}>: {}", element.name(), base::why_no_number(text)));
  return *value * found->si;
}

}  // namespace

SurveyRows survey_from_witsml(std::string_view text, const std::string& source) {
  Document document{.text = text, .source = source, .xml = {}};
  const pugi::xml_parse_result parsed =
      document.xml.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) document.refuse(parsed.offset, fmt::format("no XML: {}", parsed.description()));
  SurveyRows rows{.source = source,
                  .format = "WITSML trajectory",
                  .length = {},
                  .inclination = {},
                  .azimuth = {},
                  .stations = {},
                  .tvd = {},
                  .lines = {}};
  std::optional<SurveyUnit> length, inclination, azimuth, tvd_length;
  Lines lines{.text = text};
  for (const pugi::xml_node& station : trajectory_of(document).children()) {
    if (local_name(station) != "trajectoryStation") continue;
    const auto required = [&](const char* name, auto* unit_named, std::optional<SurveyUnit>& unit) {
      const pugi::xml_node element = child_of(station, name);
      if (!element) document.refuse(station, fmt::format("a station without <{}>", name));
      return quantity(document, element, unit_named, unit);
    };
    rows.stations.push_back({.measured_depth = required("md", length_unit, length),
                             .inclination = required("incl", angle_unit, inclination),
                             .azimuth = required("azi", angle_unit, azimuth)});
    const pugi::xml_node tvd = child_of(station, "tvd");
    rows.tvd.push_back(tvd ? quantity(document, tvd, length_unit, tvd_length)
                           : std::numeric_limits<double>::quiet_NaN());
    rows.lines.push_back(lines.of(station.offset_debug()));
  }
  if (rows.stations.empty())
    throw base::InputError(fmt::format("{}: a trajectory without stations (trajectoryStation)", source));
  rows.length = *length;
  rows.inclination = *inclination;
  rows.azimuth = *azimuth;
  return rows;
}

}  // namespace bitrock::studies
