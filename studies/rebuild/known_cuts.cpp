#include "studies/rebuild/known_cuts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "dem2d/files/run_file.hpp"
#include "dem2d/specimen/grading.hpp"

namespace bitrock::studies {

namespace {

constexpr const char* forces_name = "forces.h5";

/// A cut and the grains it was made in.
struct ReadCut {
  CutForces forces;
  double mean_diameter = 0.0;
};

ReadCut cut_of(const std::filesystem::path& path) {
  const dem2d::RunFile file = dem2d::read_run(path);
  const Job job{.case_number = 0, .seed = static_cast<int>(file.seed), .cut = file.cut};
  return {forces_of(job, file.run), dem2d::mean_diameter(file.cut.rock)};
}

bool same_conditions(const FeatureRow& a, const FeatureRow& b) {
  return a.cutter_speed == b.cutter_speed && a.depth_of_cut == b.depth_of_cut && a.back_rake == b.back_rake &&
         a.mud_pressure == b.mud_pressure;
}

void take(std::vector<KnownCase>& cases, const std::string& file, CutForces forces, double mean_diameter) {
  const auto same = std::find_if(cases.begin(), cases.end(), [&](const KnownCase& known) {
    return same_conditions(known.conditions(), forces.cut) && known.mean_diameter == mean_diameter;
  });
  if (same == cases.end()) {
    cases.push_back({.file = file, .case_number = forces.cut.case_number, .mean_diameter = mean_diameter, .cuts = {}});
    cases.back().cuts.push_back(std::move(forces));
    return;
  }
  const double before = spacing(same->cuts.front()), now = spacing(forces);
  if (std::fabs(before - now) > 1e-6 * before) {
    throw base::InputError(fmt::format(
        "{}: seeds {} and {} of one case are sampled each {:.4g} and {:.4g} um (they must be sampled alike)", file,
        same->conditions().seed, forces.cut.seed, before / base::um, now / base::um));
  }
  same->cuts.push_back(std::move(forces));
}

void take_forces_file(std::vector<KnownCase>& cases, const std::filesystem::path& path) {
  ForcesFile file = read_forces(path);
  for (CutForces& cut : file.cuts) take(cases, path.string(), std::move(cut), file.mean_diameter);
}

void take_folder(std::vector<KnownCase>& cases, const std::filesystem::path& folder) {
  std::error_code none;
  if (std::filesystem::is_regular_file(folder / forces_name, none))
    return take_forces_file(cases, folder / forces_name);
  std::vector<std::filesystem::path> files = base::files_with_ending(folder / "runs", ".h5");
  if (files.empty()) files = base::files_with_ending(folder, ".h5");
  if (files.empty())
    throw base::InputError(fmt::format("{}: no forces.h5 and no runs (*.h5) in this folder", folder.string()));
  for (const std::filesystem::path& path : files) {
    ReadCut cut = cut_of(path);
    take(cases, folder.string(), std::move(cut.forces), cut.mean_diameter);
  }
}

}  // namespace

double spacing(const CutForces& cut) {
  return cut.cut.cut_length / static_cast<double>(cut.x.size());
}

std::vector<KnownCase> read_known_cuts(const std::filesystem::path& path) {
  std::vector<KnownCase> cases;
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) {
    take_folder(cases, path);
  } else if (is_forces_file(path)) {
    take_forces_file(cases, path);
  } else {
    ReadCut cut = cut_of(path);
    take(cases, path.string(), std::move(cut.forces), cut.mean_diameter);
  }
  return cases;
}

}  // namespace bitrock::studies
