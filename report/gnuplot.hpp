#pragma once
/// Plots for paper: a figure of several panels as a table of numbers and a gnuplot script that draws it, both meant to
/// be edited by people. The same `Plot` gives the panel here and in a page (`figure_json.hpp`). It returns text;
/// writing files and running gnuplot is the caller's business. Needs gnuplot 5.4 or later with its cairo terminals.

#include <string>
#include <vector>

#include "report/plot.hpp"

namespace bitrock::report {

/// Panels in reading order, `columns` of them side by side. When all have the same legend it stands above them once.
struct Figure {
  std::string name;     ///< of its files, without ending: letters, digits, underlines
  std::string caption;  ///< a sentence for the page; a comment in the script
  std::vector<Plot> plots;
  int columns = 3;
  double panel_width_px = 400.0;  ///< [px] of the picture, labels included; on paper, 96 of them are an inch
};

enum class PictureFormat { png, pdf };

/// "png", "pdf": also the ending of the picture's name.
const char* ending(PictureFormat format);

struct GnuplotFiles {
  std::string script;  ///< NAME.gp; reads NAME.csv and writes NAME.png, or what its variables `data`, `picture` name
  std::string table;   ///< NAME.csv: panel, series, x, y, error_x, error_y, upper, label; an empty line is a gap
};

/// The same figure gives the same bytes. Throws `base::InputError` as `check` does, and for a figure without panels,
/// with less than one column, or with a name of other characters.
GnuplotFiles gnuplot_files(const Figure& figure, PictureFormat format);

}  // namespace bitrock::report
