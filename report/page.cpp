#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/base64.hpp"
#include "base/errors.hpp"
#include "report/embedded.hpp"
#include "report/encode.hpp"
#include "report/figure_json.hpp"
#include "report/legend.hpp"

namespace bitrock::report {

namespace {

/// "12", "-0.3 MPa", ".5 %"; also "nan" and "inf", which a table of results may hold.
bool is_number(const std::string& cell) {
  const std::size_t first = cell.find_first_not_of("+-.");
  if (first == std::string::npos || first > 2) return false;
  return (cell[first] >= '0' && cell[first] <= '9') || cell.substr(first) == "nan" || cell.substr(first) == "inf";
}

bool is_blank(const std::string& cell) {
  return cell.empty() || cell == "-";
}

/// A column of numbers is set to the right so that digits stand below each other; blanks do not decide.
bool is_number_column(const Table& table, std::size_t column) {
  bool found = false;
  for (const std::vector<std::string>& row : table.rows) {
    if (is_blank(row[column])) continue;
    if (!is_number(row[column])) return false;
    found = true;
  }
  return found;
}

std::string table_row(const std::vector<std::string>& cells, const std::vector<bool>& numeric, const char* element) {
  std::string html = "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    html += fmt::format("<{0}{1}>{2}</{0}>", element, numeric[i] ? " class=\"number\"" : "", html_text(cells[i]));
  }
  return html + "</tr>\n";
}

/// Big-endian 32-bit word of the PNG header.
unsigned png_word(std::string_view bytes, std::size_t at) {
  unsigned word = 0;
  for (std::size_t i = 0; i < 4; ++i) word = (word << 8) | static_cast<unsigned char>(bytes[at + i]);
  return word;
}

/// What stands under a plot: the caller's sentence, and that points were left out, if so.
std::string remark(const Plot& plot) {
  const std::string thinned = thinning_note(plot);
  return plot.caption + (plot.caption.empty() || thinned.empty() ? "" : " ") + thinned;
}

// The last line of defence for "no network": the browser itself refuses to fetch, connect or submit. Pictures may only
// come from within the page, and scripts only from its own text.
constexpr std::string_view content_policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:; "
    "form-action 'none'; base-uri 'none'";

}  // namespace

Page::Page(std::string title, std::string subtitle) : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void Page::section(const std::string& heading, const std::string& text) {
  headings_.push_back(heading);
  body_ += fmt::format("<h2 id=\"section-{}\">{}</h2>\n", headings_.size(), html_text(heading));
  if (!text.empty()) paragraph(text);
}

void Page::paragraph(const std::string& text) {
  body_ += fmt::format("<p>{}</p>\n", html_text(text));
}

void Page::note(const std::string& text) {
  body_ +=
      fmt::format("<aside class=\"note\" role=\"note\"><strong>Please note.</strong> {}</aside>\n", html_text(text));
}

void Page::table(const Table& table) {
  for (const std::vector<std::string>& row : table.rows) {
    if (row.size() == table.header.size()) continue;
    throw base::InputError(fmt::format("table '{}': a row has {} cells (the header has {})", table.caption, row.size(),
                                       table.header.size()));
  }
  std::vector<bool> numeric;
  for (std::size_t i = 0; i < table.header.size(); ++i) numeric.push_back(is_number_column(table, i));
  // The caption stands outside the part that scrolls sideways on a narrow page.
  body_ += fmt::format(
      "<p class=\"table-caption\" id=\"table-{0}\"><b>Table {0}.</b> {1}</p>\n"
      "<div class=\"table\"><table aria-labelledby=\"table-{0}\">\n<thead>{2}</thead>\n<tbody>\n",
      ++tables_, html_text(table.caption), table_row(table.header, numeric, "th"));
  for (const std::vector<std::string>& row : table.rows) body_ += table_row(row, numeric, "td");
  body_ += "</tbody>\n</table></div>\n";
}

void Page::plot(const Plot& plot) {
  check(plot);
  body_ += "<figure>\n" + plot_html(plot, true) + figure_caption(remark(plot)) + "</figure>\n";
}

void Page::plots_in_row(const std::vector<Plot>& plots, const std::string& caption) {
  if (plots.empty()) throw base::InputError("a row of plots is empty (at least one plot is needed)");
  for (const Plot& plot : plots) check(plot);
  const std::string shared = legend_html(plots.front());
  const bool same = std::all_of(plots.begin(), plots.end(), [&](const Plot& p) { return legend_html(p) == shared; });
  body_ += "<figure>\n" + (same ? shared : std::string()) +
           (plots.size() == 2 ? "<div class=\"row pair\">\n" : "<div class=\"row\">\n");
  for (const Plot& plot : plots) {
    body_ += "<div class=\"cell\">\n" + plot_html(plot, !same);
    if (!remark(plot).empty()) body_ += fmt::format("<p class=\"remark\">{}</p>\n", html_text(remark(plot)));
    body_ += "</div>\n";
  }
  body_ += "</div>\n" + figure_caption(caption) + "</figure>\n";
}

void Page::space(const SpaceView& view) {
  body_ += "<figure>\n" + space_html(view, ++spaces_) + figure_caption(view.caption) + "</figure>\n";
}

void Page::picture(std::string_view png_bytes, const std::string& caption, const std::string& alt) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  if (png_bytes.size() < 24 || png_bytes.substr(0, signature.size()) != signature) {
    throw base::InputError(fmt::format("picture '{}': not a PNG file", caption));
  }
  body_ += fmt::format(
      "<figure>\n<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">\n{}</figure>\n",
      html_text(alt), png_word(png_bytes, 16), png_word(png_bytes, 20), base::base64(png_bytes),
      figure_caption(caption));
}

std::string Page::plot_html(const Plot& plot, bool with_legend) {
  const std::string data = figure_json(plot);
  const std::string size = plot.square ? "aspect-ratio:1" : fmt::format("height:{:.0f}px", plot.height_px);
  return fmt::format(
      "<h3>{title}</h3>\n{legend}<div class=\"plot\" id=\"plot-{id}\" role=\"img\" "
      "aria-label=\"{title}: {y} against {x}\" style=\"{size}\"></div>\n"
      "<script type=\"application/json\" id=\"plot-{id}-data\">{data}</script>\n",
      fmt::arg("title", html_text(plot.title)), fmt::arg("legend", with_legend ? legend_html(plot) : ""),
      fmt::arg("id", ++plots_), fmt::arg("x", html_text(plot.x_label)), fmt::arg("y", html_text(plot.y_label)),
      fmt::arg("size", size), fmt::arg("data", data));
}

std::string Page::figure_caption(const std::string& text) {
  return fmt::format("<figcaption><b>Figure {}.</b> {}</figcaption>\n", ++figures_, html_text(text));
}

std::string Page::contents_html() const {
  if (headings_.size() < 2) return {};
  std::string html = "<nav aria-label=\"Contents\"><ol>\n";
  for (std::size_t i = 0; i < headings_.size(); ++i) {
    html += fmt::format("<li><a href=\"#section-{}\">{}</a></li>\n", i + 1, html_text(headings_[i]));
  }
  return html + "</ol></nav>\n";
}

std::string Page::html() const {
  if (!plotly_available()) {
    throw base::InputError(
        "this bitrock was built without the plot library, so it cannot write reports (npm was missing or failed when "
        "it "
        "was configured); install npm (apt-get install npm), then configure and build again");
  }
  return html_with(plotly_script(), plotly_licence());
}

std::string Page::html_with(std::string_view plot_script, std::string_view plot_licence) const {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
      "<meta name=\"generator\" content=\"bitrock\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<header><h1>{}</h1>\n{}</header>\n{}<main>\n{}</main>\n"
      "<noscript><p class=\"note\">The plots need JavaScript; text, tables and pictures do not.</p></noscript>\n"
      "<script>\n/*\n{}*/\n{}\n</script>\n<script>\n{}</script>\n{}</body>\n</html>\n",
      content_policy, html_text(title_), page_style(), html_text(title_),
      subtitle_.empty() ? "" : fmt::format("<p class=\"subtitle\">{}</p>\n", html_text(subtitle_)), contents_html(),
      body_, plot_licence, plot_script, page_script(),
      spaces_ == 0 ? "" : fmt::format("<script>\n{}</script>\n", space_script()));
}

}  // namespace bitrock::report
