#pragma once
/// `--figures DIR --format png|pdf`: figures for paper as files (report/figure_files.hpp).

#include <vector>

#include "cli/command.hpp"
#include "report/figure_files.hpp"

namespace bitrock::cli {

struct FigureOptions {
  std::string folder;  ///< empty: no figures are wanted
  std::string format;  ///< "png" or "pdf"
  report::FigureFolder where() const { return {.folder = folder, .format = format}; }
};

/// `--figures` and `--format`.
void add_figure_options(CLI::App& command, FigureOptions& options);

/// Writes them and says where; warns where gnuplot is not installed, and of figures in the folder that are not of this
/// call.
void write_figures(const CommonOptions& common, const FigureOptions& options,
                   const std::vector<report::Figure>& figures);

/// Throws when this program was built without what pages are drawn with.
void require_plot_library();

}  // namespace bitrock::cli
