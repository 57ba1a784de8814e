#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/number.hpp"
#include "studies/well/survey_rows.hpp"
#include "studies/well/table_text.hpp"

namespace bitrock::studies {

namespace {

enum Quantity : std::size_t { md, inclination, azimuth, tvd, quantities };

struct Meaning {
  const char* what;
  const char* flag;                         ///< that says its unit
  std::vector<std::string_view> spellings;  ///< as `header_name` has them
};

// "azim gn", "azim tn": grid and true north of Petrel.
const std::array<Meaning, quantities> meanings{{
    {"measured depth", "--md-unit", {"md", "depth", "dept", "measured depth"}},
    {"inclination", "--angle-unit", {"inc", "incl", "inclination", "devi"}},
    {"azimuth", "--angle-unit", {"azi", "azim", "azimuth", "hazi", "azim gn", "azim tn"}},
    {"true vertical depth", "--md-unit", {"tvd", "true vertical depth"}},
}};

struct Column {
  std::size_t place = 0;
  std::string name;       ///< as the header has it
  std::string unit_text;  ///< of the header, or of the line below it; empty where there is none
};

using Columns = std::array<std::optional<Column>, quantities>;

[[noreturn]] void refuse(const std::string& source, int line, const std::string& what) {
  throw base::InputError(fmt::format("{}:{}: {}", source, line, what));
}

std::optional<SurveyUnit> unit_of(std::size_t quantity, const std::string& text) {
  return quantity == inclination || quantity == azimuth ? angle_unit(text) : length_unit(text);
}

bool has_name(const TextRow& header, std::string_view words) {
  return std::any_of(header.cells.begin(), header.cells.end(),
                     [words](const std::string& cell) { return header_name(cell).words == words; });
}

/// A dip is measured from the horizontal. Beside an inclination the same word means the dip of the magnetic field.
void refuse_dip(const TableText& table, const TextRow& header) {
  for (const char* word : {"dip", "plunge"}) {
    if (!has_name(header, word)) continue;
    refuse(
        table.source, header.line,
        fmt::format("a column of {}, which is measured from the horizontal (give the inclination, from the vertical: "
                    "90 degrees - {} where down is positive, 90 degrees + {} where down is negative)",
                    word, word, word));
  }
}

void require_names(const TableText& table, const TextRow& header) {
  for (const std::string& cell : header.cells) {
    if (base::number_in(cell)) {
      refuse(table.source, header.line,
             fmt::format("'{}' in the header (the first line gives the columns' names and units{})", cell,
                         table.comments.empty() ? "" : "; a line that begins with # is a comment"));
    }
  }
}

Columns find_columns(const TableText& table, const TextRow& header) {
  require_names(table, header);
  Columns columns;
  for (std::size_t place = 0; place < header.cells.size(); ++place) {
    const std::string& cell = header.cells[place];
    const HeaderName name = header_name(cell);
    if (name.words == "azim tn" && has_name(header, "azim gn")) continue;
    for (std::size_t q = 0; q < quantities; ++q) {
      const auto& spellings = meanings[q].spellings;
      if (std::find(spellings.begin(), spellings.end(), name.words) == spellings.end()) continue;
      if (columns[q]) {
        refuse(table.source, header.line,
               fmt::format("'{}' and '{}' both name the {} (one column is needed)", columns[q]->name, cell,
                           meanings[q].what));
      }
      columns[q] = Column{.place = place, .name = cell, .unit_text = name.unit};
    }
  }
  if (!columns[inclination]) refuse_dip(table, header);
  for (const Quantity q : {md, inclination, azimuth}) {
    if (columns[q]) continue;
    refuse(table.source, header.line,
           fmt::format("no column of {} (named {}); the header has: {}", meanings[q].what,
                       fmt::join(meanings[q].spellings, ", "), base::listed(header.cells)));
  }
  return columns;
}

/// Without brackets around it.
std::string bare(const std::string& cell) {
  const bool brackets = cell.size() > 2 && (cell.front() == '(' || cell.front() == '[');
  return brackets ? cell.substr(1, cell.size() - 2) : cell;
}

/// A line of units below the header, as some programs write it: true, and the columns have them.
bool take_unit_line(const TextRow& row, Columns& columns) {
  for (const Quantity q : {md, inclination, azimuth}) {
    const std::size_t place = columns[q]->place;
    if (place >= row.cells.size() || !unit_of(q, bare(row.cells[place]))) return false;
  }
  for (std::optional<Column>& column : columns) {
    if (column && column->unit_text.empty() && column->place < row.cells.size())
      column->unit_text = bare(row.cells[column->place]);
  }
  return true;
}

/// What the comments of a well trace of Petrel say: "# ANGLES ARE GIVEN IN DEGREES", "# DEPTH (Z, TVD) GIVEN IN
/// m-UNITS".
std::string unit_in_comments(const TableText& table, std::size_t quantity) {
  const bool angle = quantity == inclination || quantity == azimuth;
  for (const std::string& comment : table.comments) {
    const auto says = [&comment](const char* words) { return comment.find(words) != std::string::npos; };
    if (angle && says("ANGLES ARE GIVEN IN DEGREES")) return "deg";
    if (!angle && says("# DEPTH") && says("GIVEN IN m-UNITS")) return "m";
    if (!angle && says("# DEPTH") && says("GIVEN IN ft-UNITS")) return "ft";
  }
  return "";
}

/// The one unit that header, comments and caller agree on.
SurveyUnit agreed_unit(const TableText& table, int line, const Column& column, std::size_t q, const std::string& said) {
  const char* const known = q == inclination || q == azimuth ? "deg, rad" : "m, ft, ftUS";
  const auto unit = [&](const std::string& text) -> std::optional<SurveyUnit> {
    if (text.empty()) return std::nullopt;
    const std::optional<SurveyUnit> found = unit_of(q, text);
    if (!found)
      refuse(table.source, line, fmt::format("'{}': the unit '{}' is not known ({})", column.name, text, known));
    return found;
  };
  const std::optional<SurveyUnit> asked = unit(said), written = unit(column.unit_text),
                                  remarked = unit(unit_in_comments(table, q));
  std::optional<SurveyUnit> agreed;
  for (const std::optional<SurveyUnit>& one : {asked, written, remarked}) {
    if (agreed && one && one->name != agreed->name) {
      refuse(table.source, line,
             fmt::format("'{}': {} is said to be in {}, but also in {}", column.name, meanings[q].what, agreed->name,
                         one->name));
    }
    if (one) agreed = one;
  }
  if (!agreed) {
    refuse(table.source, line,
           fmt::format("'{}': no unit (write it into the header, such as '{} ({})', or say {}; known are {})",
                       column.name, column.name, q == md ? "ft" : "deg", meanings[q].flag, known));
  }
  return *agreed;
}

double number_of(const TableText& table, const TextRow& row, const Column& column) {
  const std::string& cell = row.cells[column.place];
  if (const std::optional<double> value = base::number_in(cell)) return *value;
  const bool header = header_name(cell).words == header_name(column.name).words;
  refuse(table.source, row.line,
         fmt::format("{}: {}{}", column.name, base::why_no_number(cell),
                     header ? " (a second header; a file holds one survey)" : ""));
}

/// Of a column that need not be whole.
double number_if_any(const TextRow& row, const Column& column) {
  return base::number_in(row.cells[column.place]).value_or(std::numeric_limits<double>::quiet_NaN());
}

void require_length(const TableText& table, const TextRow& row, std::size_t columns) {
  std::size_t size = row.cells.size();
  while (size > columns && row.cells[size - 1].empty()) --size;
  if (size == columns) return;
  const char* hint = table.separator == "comma" && size > columns ? "; numbers have a point, not a comma"
                     : table.separator == "blank" ? "; where names have blanks, put commas between the columns"
                                                  : "";
  refuse(table.source, row.line, fmt::format("{} values (the header has {} columns{})", size, columns, hint));
}

}  // namespace

SurveyRows survey_from_table(std::string_view text, const std::string& source, const SaidUnits& said) {
  const TableText table = split_table(text, source);
  TextRow header = table.rows.front();
  while (!header.cells.empty() && header.cells.back().empty()) header.cells.pop_back();
  Columns columns = find_columns(table, header);
  const bool unit_line = table.rows.size() > 1 && take_unit_line(table.rows[1], columns);
  if (columns[tvd] && columns[tvd]->unit_text.empty()) columns[tvd]->unit_text = columns[md]->unit_text;
  const auto unit = [&](Quantity q, const std::string& from_caller) {
    return agreed_unit(table, header.line, *columns[q], q, from_caller);
  };
  SurveyRows rows{.source = source,
                  .format = fmt::format("table, {}s between its columns", table.separator),
                  .length = unit(md, said.md),
                  .inclination = unit(inclination, said.angle),
                  .azimuth = unit(azimuth, said.angle),
                  .stations = {},
                  .tvd = {},
                  .lines = {}};
  const double tvd_unit = columns[tvd] ? unit(tvd, columns[tvd]->unit_text.empty() ? said.md : "").si : 0.0;
  for (std::size_t i = unit_line ? 2 : 1; i < table.rows.size(); ++i) {
    const TextRow& row = table.rows[i];
    require_length(table, row, header.cells.size());
    rows.stations.push_back({.measured_depth = number_of(table, row, *columns[md]) * rows.length.si,
                             .inclination = number_of(table, row, *columns[inclination]) * rows.inclination.si,
                             .azimuth = number_of(table, row, *columns[azimuth]) * rows.azimuth.si});
    if (columns[tvd]) rows.tvd.push_back(number_if_any(row, *columns[tvd]) * tvd_unit);
    rows.lines.push_back(row.line);
  }
  if (rows.stations.empty())
    throw base::InputError(fmt::format("{}: only a header (a row a station is needed)", source));
  return rows;
}

}  // namespace bitrock::studies
