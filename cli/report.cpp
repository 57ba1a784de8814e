// bitrock report: everything a campaign folder holds, or drill runs side by side, on one HTML page.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/figure_files.hpp"
#include "views/campaign_page.hpp"
#include "views/drill/chapter.hpp"
#include "views/well/chapter.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> inputs;  ///< one campaign folder, or files of drill runs
  std::string output;
  FigureOptions figures;
};

bool is_folder(const std::filesystem::path& path) {
  std::error_code no_folder;
  return std::filesystem::is_directory(path, no_folder);
}

void report_campaign(const Options& options) {
  const std::filesystem::path folder = options.inputs.front();
  if (!options.figures.folder.empty())
    throw base::InputError("--figures goes with files of drill runs (a campaign has `bitrock parity --figures`)");
  const views::CampaignFiles files = views::campaign_files(folder);
  require_plot_library();
  require_outputs(options.common,
                  {files.model, files.data, files.earlier_model, files.forces, files.bit_force, files.bit_force_json},
                  {options.output});
  Progress progress(options.common, "rebuilding forces", "cases");
  const report::Page page = views::campaign_page(folder, cores(), progress.callback());
  base::write_whole(options.output, page.html());
  say(options.common, "-> {}\n", options.output);
  write_json(options.common, {{"files", {options.output}}});
}

/// Throws when a file is missing or there are more than one page can show.
void require_runs(const std::vector<std::string>& names, std::size_t most) {
  if (names.size() > most)
    throw base::InputError(
        fmt::format("{} files of drill runs (at most {} can be told apart on one page)", names.size(), most));
  for (const std::string& name : names) {
    if (!base::is_there(name))
      throw base::InputError(
          fmt::format("{} is not a folder or a file (a campaign folder is needed, or files of "
                      "`bitrock drill run`)",
                      name));
    if (is_folder(name))
      throw base::InputError(fmt::format("{} is a folder (one campaign folder alone, or files of drill runs)", name));
  }
  refuse_named_twice(names);
  require_plot_library();
}

/// The page, and the figures for paper where they are asked for.
void write_report(const Options& options, const report::Page& page, const std::vector<report::Figure>& on_paper) {
  base::write_whole(options.output, page.html());
  say(options.common, "-> {}\n", options.output);
  if (!on_paper.empty()) write_figures(options.common, options.figures, on_paper);
  write_json(options.common, {{"files", {options.output}}});
}

void require_report_outputs(const Options& options, const std::vector<report::Figure>& on_paper) {
  std::vector<std::filesystem::path> outputs = report::figure_paths(options.figures.where(), on_paper);
  outputs.insert(outputs.begin(), options.output);
  require_outputs(options.common, {options.inputs.begin(), options.inputs.end()}, outputs);
}

void report_wells(const Options& options) {
  const std::vector<std::string>& names = options.inputs;
  require_runs(names, views::most_shown_wells);
  std::vector<runtime::WellFile> files;
  files.reserve(names.size());
  for (const std::string& name : names) files.push_back(runtime::read_well_run(name));
  const std::vector<views::ShownWell> runs = views::shown_wells(names, std::move(files));
  const std::vector<report::Figure> figures = views::well_figures(runs);
  std::vector<report::Figure> on_paper;
  if (!options.figures.folder.empty()) {
    on_paper = figures;
    if (const auto profile = views::well_profile(runs.front())) on_paper.push_back(*profile);
  }
  require_report_outputs(options, on_paper);
  report::Page page(runs.size() == 1 ? "A string in its well" : "Strings in a well side by side",
                    runs.size() == 1 ? runs.front().file.well.drill.name : "");
  views::add_well_chapters(page, runs, figures);
  write_report(options, page, on_paper);
}

void report_drill(const Options& options) {
  const std::vector<std::string>& names = options.inputs;
  require_runs(names, views::most_shown_runs);
  std::vector<runtime::DrillFile> files;
  files.reserve(names.size());
  for (const std::string& name : names) files.push_back(runtime::read_drill_run(name));
  const std::vector<views::ShownRun> runs = views::shown_runs(names, std::move(files));
  const std::vector<report::Figure> figures = views::drill_figures(runs);
  std::vector<report::Figure> on_paper;
  if (!options.figures.folder.empty()) {
    on_paper = figures;
    if (runs.size() == 1) on_paper.push_back(views::drill_sheet(runs.front()));
  }
  require_report_outputs(options, on_paper);
  report::Page page(runs.size() == 1 ? "Drill run" : "Drill runs side by side",
                    runs.size() == 1 ? runs.front().file.drill.name : "");
  views::add_drill_chapters(page, runs, figures);
  write_report(options, page, on_paper);
}

/// Whether the first file is a run in a well; what is no file of ours is left to the readers to refuse.
bool are_wells(const std::vector<std::string>& names) {
  return base::is_there(names.front()) && !is_folder(names.front()) && runtime::holds_well_run(names.front());
}

void run(const Options& options) {
  if (options.inputs.size() == 1 && is_folder(options.inputs.front()))
    report_campaign(options);
  else if (are_wells(options.inputs))
    report_wells(options);
  else
    report_drill(options);
}

}  // namespace

void add_report(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("report", "Writes one HTML page about a campaign folder, or about drill runs side by side.");
  command
      ->add_option(
          "input", options->inputs,
          "The folder of a campaign, which may also hold model.json, earlier_model.json (networks that have not seen "
          "its cuts), forces.h5, bit_force.csv, bit_force.json and drill/*.h5; or one or more files of `bitrock drill "
          "run`, all of cases with a [well] or all without.")
      ->required();
  command->add_option("-o,--output", options->output, "The page goes to this file (.html).")
      ->default_val("report.html");
  add_figure_options(*command, options->figures);
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
