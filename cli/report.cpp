// bitrock report: everything a campaign folder holds, or drill runs side by side, on one HTML page.
#include <algorithm>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/command.hpp"
#include "cli/figure_files.hpp"
#include "cli/report_parts.hpp"
#include "report/embedded.hpp"
#include "surrogate/net/model_file.hpp"

namespace cli {

namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> inputs;  ///< one campaign folder, or files of drill runs
  std::string output;
  FigureOptions figures;
};

// Force histories shown small, side by side; a large campaign has too many for one page.
constexpr std::size_t most_overviews = 12;

bool is_folder(const std::filesystem::path& path) {
  std::error_code no_folder;
  return std::filesystem::is_directory(path, no_folder);
}

std::vector<dem2d::RunFile> read_runs(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (is_folder(folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".h5") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<dem2d::RunFile> runs;
  for (const auto& file : files) runs.push_back(dem2d::read_run(file));
  return runs;
}

void add_cut_chapters(report::Page& page, const std::vector<dem2d::RunFile>& runs) {
  page.section(
      "Cuts",
      fmt::format(
          "One cutter moves in a straight line through a bed of {} discs, one cut at a time. x is along the cut, "
          "y out of the rock; both forces are of the rock on the cutter, per metre of width.",
          runs.front().run.discs));
  add_cut_table(page, runs);
  page.section(
      "Forces and their peaks",
      "Every sample is the mean over one sampling interval. Peaks higher than 1 % of the highest sample count; "
      "the shaded strips are the bands in which they are counted.");
  add_force_history(page, runs.front());
  add_force_overview(page, runs, most_overviews);
  page.section("Fracture");
  add_fracture_picture(page, runs.front());
  const auto deepest = std::max_element(
      runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.cut.depth_of_cut < b.cut.depth_of_cut; });
  if (deepest->cut.depth_of_cut > runs.front().cut.depth_of_cut) add_fracture_picture(page, *deepest);
}

void require_plot_library() {
  if (report::plotly_available()) return;
  throw base::InputError(
      "this program was built without the plot library, so it cannot write reports (install npm, then build again)");
}

void report_campaign(const Options& options) {
  const std::filesystem::path folder = options.inputs.front();
  if (!options.figures.folder.empty())
    throw base::InputError("--figures goes with files of drill runs (a campaign has `bitrock parity --figures`)");
  const auto model_file = folder / "model.json", data_file = folder / "features.csv",
             bit_file = folder / "bit_force.csv";
  const std::vector<dem2d::RunFile> runs = read_runs(folder / "runs");
  const bool has_model = base::is_there(model_file), has_bit = base::is_there(bit_file);
  if (runs.empty() && !has_model && !has_bit) {
    throw base::InputError(fmt::format(
        "{} holds nothing to report (looked for runs/*.h5, model.json and bit_force.csv)", folder.string()));
  }
  require_plot_library();
  require_outputs(options.common, {model_file, data_file, bit_file, folder / "bit_force.json"}, {options.output});

  report::Page page("From lab rock to bit force", runs.empty() ? std::string() : runs.front().cut.rock.name);
  if (!runs.empty()) add_cut_chapters(page, runs);
  if (has_model) {
    const surrogate::Model model = surrogate::read_model(model_file);
    page.section("Learning",
                 "Ten small networks, one for each statistic of each force: speed, depth and rake in, one number out. "
                 "Peak counts are per metre of cut.");
    add_learning_curves(page, model);
    if (base::is_there(data_file)) {
      const surrogate::TrainingData data = surrogate::read_training_data(data_file);
      page.section("Network against DEM");
      add_parity(page, model, surrogate::parity(model, data));
    }
  }
  if (has_bit) {
    page.section(
        "The whole bit",
        "Every cutter rebuilds its own force history from the peak statistics, with its own random numbers; the bit is "
        "their sum. Positive force pushes the bit off the rock, positive torque resists its rotation. These are sharp "
        "cutters in the simulated rock, without friction under worn ones: not the load of a field bit. The rebuilt "
        "mean "
        "is half of A_mean times the pulse width factor, which is not the mean force of the simulated cuts.");
    add_bit_force(page, bit_file, folder / "bit_force.json");
  }
  base::write_whole(options.output, page.html());
  say(options.common, "-> {}\n", options.output);
  write_json(options.common, {{"files", {options.output}}});
}

/// One file twice would look like two runs that agree.
void refuse_equal(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::filesystem::equivalent(names[i], names[j]))
        throw base::InputError(fmt::format("{} and {} are one file (name each run once)", names[j], names[i]));
    }
  }
}

void report_drill(const Options& options) {
  const std::vector<std::string>& names = options.inputs;
  if (names.size() > most_shown_runs)
    throw base::InputError(fmt::format("{} files of drill runs (at most {} can be told apart on one page)",
                                       names.size(), most_shown_runs));
  std::vector<runtime::DrillFile> files;
  for (const std::string& name : names) {
    if (!base::is_there(name))
      throw base::InputError(
          fmt::format("{} is not a folder or a file (a campaign folder is needed, or files of "
                      "`bitrock drill run`)",
                      name));
    if (is_folder(name))
      throw base::InputError(fmt::format("{} is a folder (one campaign folder alone, or files of drill runs)", name));
    files.push_back(runtime::read_drill_run(name));
  }
  refuse_equal(names);
  require_plot_library();
  const std::vector<ShownRun> runs = shown_runs(names, std::move(files));
  const std::vector<report::Figure> figures = drill_figures(runs);
  std::vector<report::Figure> on_paper;
  if (!options.figures.folder.empty()) {
    on_paper = figures;
    if (runs.size() == 1) on_paper.push_back(drill_sheet(runs.front()));
  }
  std::vector<std::filesystem::path> outputs = figure_paths(options.figures, on_paper);
  outputs.insert(outputs.begin(), options.output);
  require_outputs(options.common, {names.begin(), names.end()}, outputs);

  report::Page page(runs.size() == 1 ? "Drill run" : "Drill runs side by side",
                    runs.size() == 1 ? runs.front().file.drill.name : "");
  add_drill_chapters(page, runs, figures);
  base::write_whole(options.output, page.html());
  say(options.common, "-> {}\n", options.output);
  if (!on_paper.empty()) write_figures(options.common, options.figures, on_paper);
  write_json(options.common, {{"files", {options.output}}});
}

void run(const Options& options) {
  if (options.inputs.size() == 1 && is_folder(options.inputs.front()))
    report_campaign(options);
  else
    report_drill(options);
}

}  // namespace

void add_report(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("report", "one HTML page of a campaign folder, or of drill runs side by side");
  command
      ->add_option("input", options->inputs,
                   "campaign folder, which may also hold model.json, bit_force.csv and bit_force.json; or one or more "
                   "files of `bitrock drill run`")
      ->required();
  command->add_option("-o,--output", options->output, "HTML file to write")->default_val("report.html");
  add_figure_options(*command, options->figures);
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace cli
