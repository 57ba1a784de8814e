#pragma once
/// Figures for paper as files, for the subcommands that offer `--figures DIR --format png|pdf`: script and table of
/// each always, the picture where gnuplot is installed.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.hpp"
#include "report/gnuplot.hpp"

namespace cli {

struct FigureOptions {
  std::string folder;  ///< empty: no figures are wanted
  std::string format;  ///< "png" or "pdf"
};

/// `--figures` and `--format`.
void add_figure_options(CLI::App& command, FigureOptions& options);

/// Every file that `write_figures` will write, for `require_outputs`.
std::vector<std::filesystem::path> figure_paths(const FigureOptions& options,
                                                const std::vector<report::Figure>& figures);

/// A picture is drawn aside and gets its name when it is whole. Throws `SimulationError` when gnuplot fails; warns
/// where it is not installed.
void write_figures(const CommonOptions& common, const FigureOptions& options,
                   const std::vector<report::Figure>& figures);

}  // namespace cli
