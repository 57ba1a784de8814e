#include "cli/figure_files.hpp"

#include <algorithm>

#include "base/files.hpp"
#include "cli/draw.hpp"

namespace cli {

namespace {

std::filesystem::path in_folder(const FigureOptions& options, const report::Figure& figure, const std::string& ending) {
  return std::filesystem::path(options.folder) / (figure.name + "." + ending);
}

}  // namespace

void add_figure_options(CLI::App& command, FigureOptions& options) {
  command
      .add_option("--figures", options.folder,
                  "folder for the plots as pictures, with the gnuplot script and the table of each")
      ->check(not_empty());
  command.add_option("--format", options.format, "of the pictures")
      ->check(CLI::IsMember({"png", "pdf"}))
      ->default_val("png");
}

std::vector<std::filesystem::path> figure_paths(const FigureOptions& options,
                                                const std::vector<report::Figure>& figures) {
  std::vector<std::filesystem::path> paths;
  for (const report::Figure& figure : figures) {
    for (const std::string& ending : {std::string("csv"), std::string("gp"), options.format})
      paths.push_back(in_folder(options, figure, ending));
  }
  return paths;
}

namespace {

/// A picture in the other format, of earlier numbers, would lie beside the new script and table.
void remove_other_pictures(const FigureOptions& options, const report::Figure& figure, bool drawn) {
  for (const std::string ending : {"png", "pdf"}) {
    std::error_code ignored;
    if (ending != options.format || !drawn) std::filesystem::remove(in_folder(options, figure, ending), ignored);
  }
}

/// Says which figures in the folder are not of this call. They stay: scripts are there to be changed.
void warn_of_others(const CommonOptions& common, const FigureOptions& options,
                    const std::vector<report::Figure>& figures) {
  std::vector<std::string> others;
  for (const auto& entry : std::filesystem::directory_iterator(options.folder)) {
    const std::string name = entry.path().stem().string();
    const bool ours =
        std::any_of(figures.begin(), figures.end(), [&](const auto& figure) { return figure.name == name; });
    if (entry.path().extension() == ".gp" && !ours) others.push_back(name);
  }
  if (others.empty()) return;
  std::sort(others.begin(), others.end());
  warn(common,
       fmt::format("{} also holds figures that are not of this call: {}", options.folder, fmt::join(others, ", ")));
}

}  // namespace

void write_figures(const CommonOptions& common, const FigureOptions& options,
                   const std::vector<report::Figure>& figures) {
  const bool drawn = can_draw();
  const report::PictureFormat format =
      options.format == "pdf" ? report::PictureFormat::pdf : report::PictureFormat::png;
  {
    Progress progress(common, "drawing", "figures");
    const auto show = progress.callback();
    for (std::size_t k = 0; k < figures.size(); ++k) {
      const report::GnuplotFiles files = report::gnuplot_files(figures[k], format);
      base::write_whole(in_folder(options, figures[k], "csv"), files.table);
      base::write_whole(in_folder(options, figures[k], "gp"), files.script);
      remove_other_pictures(options, figures[k], drawn);
      if (drawn) draw(files, in_folder(options, figures[k], options.format));
      show(static_cast<double>(k + 1), static_cast<double>(figures.size()));
    }
  }
  warn_of_others(common, options, figures);
  if (drawn) {
    say(common, "-> {}: {} figures, each .{} with its .gp and .csv\n", options.folder, figures.size(), options.format);
  } else {
    warn(common, fmt::format("{}, so nothing was drawn; the scripts and tables are in {}: there, gnuplot {}.gp and "
                             "so on will do",
                             no_gnuplot, options.folder, figures.front().name));
  }
}

}  // namespace cli
