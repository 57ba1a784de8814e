#include "cli/figure_files.hpp"

#include "base/errors.hpp"
#include "report/draw.hpp"
#include "report/embedded.hpp"

namespace bitrock::cli {

void add_figure_options(CLI::App& command, FigureOptions& options) {
  command
      .add_option("--figures", options.folder,
                  "The plots also go to this folder as pictures, each with its gnuplot script and its table.")
      ->check(not_empty());
  command.add_option("--format", options.format, "The pictures have this format.")
      ->check(CLI::IsMember({"png", "pdf"}))
      ->default_val("png");
}

void write_figures(const CommonOptions& common, const FigureOptions& options,
                   const std::vector<report::Figure>& figures) {
  {
    Progress progress(common, "drawing", "figures");
    report::write_figures(options.where(), figures, progress.callback());
  }
  const std::vector<std::string> others = report::other_figures(options.where(), figures);
  if (!others.empty()) {
    warn(common,
         fmt::format("{} also holds figures that are not of this call: {}", options.folder, fmt::join(others, ", ")));
  }
  if (report::can_draw()) {
    say(common, "-> {}: {} figures, each .{} with its .gp and .csv\n", options.folder, figures.size(), options.format);
  } else {
    warn(common, fmt::format("{}, so nothing was drawn; the scripts and tables are in {}: there, gnuplot {}.gp and "
                             "so on will do",
                             report::no_gnuplot, options.folder, figures.front().name));
  }
}

void require_plot_library() {
  if (report::plotly_available()) return;
  throw base::InputError(
      "this program was built without the plot library, so it cannot write reports (install npm, then build again)");
}

}  // namespace bitrock::cli
