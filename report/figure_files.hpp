#pragma once
/// Figures for paper as files in a folder: script and table of each always, the picture where gnuplot is installed.

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "report/gnuplot.hpp"

namespace bitrock::report {

struct FigureFolder {
  std::filesystem::path folder;
  std::string format = "png";  ///< of the pictures, or "pdf"
};

/// Every file that `write_figures` will write.
std::vector<std::filesystem::path> figure_paths(const FigureFolder& where, const std::vector<Figure>& figures);

/// A picture is drawn aside and gets its name when it is whole. Throws `SimulationError` when gnuplot fails; where it
/// is not installed (`can_draw`) nothing is drawn.
void write_figures(const FigureFolder& where, const std::vector<Figure>& figures,
                   const base::ProgressCallback& progress = {});

/// Names of figures in the folder that are not among these. They stay: scripts are there to be changed.
std::vector<std::string> other_figures(const FigureFolder& where, const std::vector<Figure>& figures);

}  // namespace bitrock::report
