#pragma once
/// One HTML page that carries everything it shows: text, tables, pictures and plots one can zoom into. It opens from a
/// mail or a memory stick without any network; the page itself forbids the browser to fetch anything. It is filled from
/// top to bottom. It knows nothing about rock or bits: what to show is decided by the caller.
///
/// All text is plain text and is made safe here. The same calls give the same bytes; there is no date in the page
/// unless the caller writes one. Invalid content throws `base::InputError` at the call that adds it.

#include <string>
#include <string_view>
#include <vector>

#include "report/plot.hpp"
#include "report/space_view.hpp"

namespace bitrock::report {

struct Table {
  std::string caption;
  std::vector<std::string> header;             ///< with units
  std::vector<std::vector<std::string>> rows;  ///< each as long as `header`; columns of numbers are set to the right
};

class Page {
 public:
  explicit Page(std::string title, std::string subtitle = "");

  /// A heading, listed in the table of contents; the paragraph below it may be empty.
  void section(const std::string& heading, const std::string& text = "");
  void paragraph(const std::string& text);
  /// A box that cannot be overlooked: what the reader must know before trusting the figures.
  void note(const std::string& text);
  void table(const Table& table);
  void plot(const Plot& plot);
  /// Side by side as far as the page is wide, one below the other on a telephone. One legend serves all when all have
  /// the same. Up to three stand in a line; a single figure number and caption belong to the whole row.
  void plots_in_row(const std::vector<Plot>& plots, const std::string& caption = "");
  /// A line in space, which the reader turns and takes through time.
  void space(const SpaceView& view);
  /// `alt` says in words what the picture shows, for those who cannot see it. Throws when the bytes are not a PNG.
  void picture(std::string_view png_bytes, const std::string& caption, const std::string& alt);

  /// The whole page. Throws `base::InputError` when the program was built without the plot library.
  std::string html() const;
  /// The same page around another plot library, given as its script and licence.
  std::string html_with(std::string_view plot_script, std::string_view plot_licence) const;

 private:
  std::string plot_html(const Plot& plot, bool with_legend);
  std::string figure_caption(const std::string& text);
  std::string contents_html() const;

  std::string title_, subtitle_;
  std::vector<std::string> headings_;
  std::string body_;  ///< finished HTML
  int plots_ = 0;
  int figures_ = 0;
  int tables_ = 0;
  int spaces_ = 0;
};

}  // namespace bitrock::report
