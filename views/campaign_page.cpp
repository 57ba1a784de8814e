#include "views/campaign_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "surrogate/net/model_file.hpp"
#include "views/bit/chapter.hpp"
#include "views/cut/chapter.hpp"
#include "views/networks/chapter.hpp"

namespace bitrock::views {

namespace {

std::vector<dem2d::RunFile> read_runs(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code no_folder;
  if (std::filesystem::is_directory(folder, no_folder)) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".h5") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<dem2d::RunFile> runs;
  for (const auto& file : files) runs.push_back(dem2d::read_run(file));
  return runs;
}

}  // namespace

CampaignFiles campaign_files(const std::filesystem::path& folder) {
  return {.runs = folder / "runs",
          .model = folder / "model.json",
          .data = folder / "features.csv",
          .bit_force = folder / "bit_force.csv",
          .bit_force_json = folder / "bit_force.json"};
}

report::Page campaign_page(const std::filesystem::path& folder) {
  const CampaignFiles files = campaign_files(folder);
  const std::vector<dem2d::RunFile> runs = read_runs(files.runs);
  if (runs.empty() && !base::is_there(files.model) && !base::is_there(files.bit_force)) {
    throw base::InputError(fmt::format(
        "{} holds nothing to report (looked for runs/*.h5, model.json and bit_force.csv)", folder.string()));
  }
  report::Page page("From lab rock to bit force", runs.empty() ? std::string() : runs.front().cut.rock.name);
  if (!runs.empty()) add_cut_chapters(page, runs);
  if (base::is_there(files.model)) {
    const surrogate::Model model = surrogate::read_model(files.model);
    page.section("Learning",
                 "Ten small networks, one for each statistic of each force: speed, depth and rake in, one number out. "
                 "Peak counts are per metre of cut.");
    add_learning_curves(page, model);
    if (base::is_there(files.data)) {
      const surrogate::TrainingData data = surrogate::read_training_data(files.data);
      page.section("Network against DEM");
      add_parity(page, model, surrogate::parity(model, data));
    }
  }
  if (base::is_there(files.bit_force)) {
    page.section(
        "The whole bit",
        "Every cutter rebuilds its own force history from the peak statistics, with its own random numbers; the bit is "
        "their sum. Positive force pushes the bit off the rock, positive torque resists its rotation. These are sharp "
        "cutters in the simulated rock, without friction under worn ones: not the load of a field bit. The rebuilt "
        "mean "
        "is half of A_mean times the pulse width factor, which is not the mean force of the simulated cuts.");
    add_bit_force(page, files.bit_force, files.bit_force_json);
  }
  return page;
}

}  // namespace bitrock::views
