#include "report/figure_files.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "report/draw.hpp"

namespace bitrock::report {

namespace {

std::filesystem::path in_folder(const FigureFolder& where, const Figure& figure, const std::string& ending) {
  return where.folder / (figure.name + "." + ending);
}

/// A picture in the other format, of earlier numbers, would lie beside the new script and table.
void remove_other_pictures(const FigureFolder& where, const Figure& figure, bool drawn) {
  for (const std::string ending : {"png", "pdf"}) {
    std::error_code ignored;
    if (ending != where.format || !drawn) std::filesystem::remove(in_folder(where, figure, ending), ignored);
  }
}

}  // namespace

std::vector<std::filesystem::path> figure_paths(const FigureFolder& where, const std::vector<Figure>& figures) {
  std::vector<std::filesystem::path> paths;
  for (const Figure& figure : figures) {
    for (const std::string& ending : {std::string("csv"), std::string("gp"), where.format})
      paths.push_back(in_folder(where, figure, ending));
  }
  return paths;
}

void write_figures(const FigureFolder& where, const std::vector<Figure>& figures,
                   const base::ProgressCallback& progress) {
  const bool drawn = can_draw();
  const PictureFormat format = where.format == "pdf" ? PictureFormat::pdf : PictureFormat::png;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const GnuplotFiles files = gnuplot_files(figures[k], format);
    base::write_whole(in_folder(where, figures[k], "csv"), files.table);
    base::write_whole(in_folder(where, figures[k], "gp"), files.script);
    remove_other_pictures(where, figures[k], drawn);
    if (drawn) draw(files, in_folder(where, figures[k], where.format));
    if (progress) progress(static_cast<double>(k + 1), static_cast<double>(figures.size()));
  }
}

std::vector<std::string> other_figures(const FigureFolder& where, const std::vector<Figure>& figures) {
  std::vector<std::string> others;
  for (const auto& entry : std::filesystem::directory_iterator(where.folder)) {
    const std::string name = entry.path().stem().string();
    const bool ours =
        std::any_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.name == name; });
    if (entry.path().extension() == ".gp" && !ours) others.push_back(name);
  }
  std::sort(others.begin(), others.end());
  return others;
}

}  // namespace bitrock::report
