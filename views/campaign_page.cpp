#include "views/campaign_page.hpp"

#include <fmt/format.h>

#include <optional>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "surrogate/net/further_inputs.hpp"
#include "surrogate/net/model_file.hpp"
#include "views/bit/chapter.hpp"
#include "views/cut/chapter.hpp"
#include "views/drill/chapter.hpp"
#include "views/learn/chapter.hpp"
#include "views/networks/chapter.hpp"
#include "views/rebuild/chapter.hpp"

namespace bitrock::views {

namespace {

std::vector<dem2d::RunFile> read_runs(const std::filesystem::path& folder) {
  std::vector<dem2d::RunFile> runs;
  for (const auto& file : base::files_with_ending(folder, ".h5")) runs.push_back(dem2d::read_run(file));
  return runs;
}

/// Networks that came from elsewhere: against the cuts of the folder, or how they learnt when it holds no cuts.
void add_earlier_networks(report::Page& page, const std::filesystem::path& file,
                          const std::optional<surrogate::TrainingData>& data) {
  const surrogate::Model earlier = surrogate::read_model(file);
  const std::string name = file.filename().string(), learnt_from = earlier.provenance.data_file;
  if (!data) {
    page.section("Learning of the earlier networks",
                 fmt::format("The networks of {}, which learnt from {}. The folder has no features.csv to hold them "
                             "against.",
                             name, learnt_from));
    return add_learning_curves(page, earlier);
  }
  page.section("Networks that have not seen these cuts",
               fmt::format("The networks of {}, which learnt from {}, against the cuts of this page: other conditions, "
                           "other rocks of the same kind. What they miss beside the scatter of the cuts themselves is "
                           "what they would miss in use.",
                           name, learnt_from));
  add_parity(page, earlier, surrogate::parity(earlier, *data, surrogate::CaseNumbers::of_another_study),
             "Cuts not seen");
}

/// `model`: the networks of the folder, or null.
void add_networks(report::Page& page, const CampaignFiles& files, const surrogate::Model* model) {
  std::optional<surrogate::TrainingData> data;
  if (base::is_there(files.data)) data = surrogate::read_training_data(files.data);
  if (base::is_there(files.earlier_model)) add_earlier_networks(page, files.earlier_model, data);
  if (data && base::is_there(files.learn)) add_learnt(page, *data, studies::read_notebook(files.learn.parent_path()));
  if (model == nullptr) return;
  const std::string further = surrogate::further_names(*model);
  page.section(
      "Learning",
      fmt::format("Small networks, one for each statistic of each force: speed, depth and rake{} in, one number out. "
                  "They learnt from {}. Peak counts are per metre of cut.",
                  further.empty() ? further : ", " + further, model->provenance.data_file));
  add_learning_curves(page, *model);
  if (!data) return;
  page.section("Network against DEM");
  add_parity(page, *model, surrogate::parity(*model, *data));
}

/// Enough for a page; `bitrock rebuild` takes more.
constexpr int draws_for_a_page = 32;

void add_rebuilt_forces(report::Page& page, const CampaignFiles& files, const surrogate::Model* model, int jobs,
                        const base::ProgressCallback& progress) {
  if (!base::is_there(files.forces)) return;
  const surrogate::Model* const networks = model != nullptr && surrogate::has_moments(*model) ? model : nullptr;
  const studies::RebuildOptions options{.draws = draws_for_a_page, .jobs = jobs};
  const studies::Rebuilding found =
      studies::rebuild(studies::read_known_cuts(files.forces), networks, options, progress);
  page.section("The force that a drill string gets");
  for (const std::string& left_out : found.left_out) page.note("Left out: " + left_out);
  if (!found.known.empty()) add_rebuild(page, found, networks, options);
}

void add_drill_runs(report::Page& page, const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> names;
  std::vector<runtime::DrillFile> runs;
  for (const auto& file : files) {
    if (runs.size() == most_shown_runs) break;
    names.push_back(file.string());
    runs.push_back(runtime::read_drill_run(file));
  }
  if (runs.empty()) return;
  const std::vector<ShownRun> shown = shown_runs(names, std::move(runs));
  add_drill_chapters(page, shown, drill_figures(shown), "The drill string: ");
}

}  // namespace

CampaignFiles campaign_files(const std::filesystem::path& folder) {
  return {.runs = folder / "runs",
          .model = folder / "model.json",
          .data = folder / "features.csv",
          .forces = folder / "forces.h5",
          .earlier_model = folder / "earlier_model.json",
          .bit_force = folder / "bit_force.csv",
          .bit_force_json = folder / "bit_force.json",
          .drill = folder / "drill",
          .learn = folder / studies::notebook_name};
}

report::Page campaign_page(const std::filesystem::path& folder, int jobs, const base::ProgressCallback& progress) {
  const CampaignFiles files = campaign_files(folder);
  const std::vector<dem2d::RunFile> runs = read_runs(files.runs);
  const std::vector<std::filesystem::path> drill_runs = base::files_with_ending(files.drill, ".h5");
  if (runs.empty() && drill_runs.empty() && !base::is_there(files.model) && !base::is_there(files.earlier_model) &&
      !base::is_there(files.bit_force) && !base::is_there(files.forces)) {
    throw base::InputError(
        fmt::format("{} holds nothing to report (looked for runs/*.h5, model.json, earlier_model.json, forces.h5, "
                    "bit_force.csv and drill/*.h5)",
                    folder.string()));
  }
  report::Page page("From lab rock to bit force", runs.empty() ? std::string() : runs.front().cut.rock.name);
  if (!runs.empty()) add_cut_chapters(page, runs);
  std::optional<surrogate::Model> model;
  if (base::is_there(files.model)) model = surrogate::read_model(files.model);
  const surrogate::Model* const networks = model ? &*model : nullptr;
  add_networks(page, files, networks);
  add_rebuilt_forces(page, files, networks, jobs, progress);
  if (base::is_there(files.bit_force)) {
    page.section(
        "The whole bit",
        "Every cutter rebuilds its own force history from what the networks say, with its own random numbers; the bit "
        "is their sum. Positive force pushes the bit off the rock, positive torque resists its rotation. These are "
        "sharp "
        "cutters in the simulated rock, without friction under worn ones: not the load of a field bit. Where the "
        "networks do not know the mean force (mode article-literal), the rebuilt mean is half of A_mean times the "
        "pulse width factor, which is not the mean force of the simulated cuts.");
    add_bit_force(page, files.bit_force, files.bit_force_json);
  }
  add_drill_runs(page, drill_runs);
  return page;
}

}  // namespace bitrock::views
