#include "studies/campaign/plan.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "base/files.hpp"
#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/genesis.hpp"
#include "dem2d/specimen/grading.hpp"
#include "dem2d/step/cost.hpp"
#include "studies/campaign/folder.hpp"
#include "studies/campaign/rocks.hpp"
#include "studies/campaign/status.hpp"

namespace bitrock::studies {

namespace {

constexpr double sample_side =
    20.0;  // of the sample of rock, in mean grain diameters: some 400 discs, a fifth of a second
constexpr double sample_depth = 0.25;  // of a cut into the sample, as a share of its height; the step hardly knows it

double critical_step_of_sample(const Study& study) {
  dem2d::CutCase cut = study.common;
  const double side = sample_side * dem2d::mean_diameter(cut.rock);
  cut.bed_length = cut.bed_height = side;
  cut.depth_of_cut = sample_depth * side;
  cut.cutter_speed = 1.0;
  const auto seed = static_cast<std::uint64_t>(study.seeds.front());
  return dem2d::make_cut_world(cut, dem2d::make_specimen(cut.rock, side, side, seed, 1)).step;
}

PlanPart new_part(const Job& job) {
  return {.depth_of_cut = job.cut.depth_of_cut,
          .cut_length = job.cut.cut_length,
          .bed_length = job.cut.bed_length,
          .bed_height = job.cut.bed_height,
          .discs = dem2d::expected_discs(job.cut.rock, dem2d::moving_length(job.cut), job.cut.bed_height)};
}

/// What tells rocks of one study apart: bed and seed.
std::tuple<double, double, int> rock_of(const Job& job) {
  return {job.cut.bed_length, job.cut.bed_height, job.seed};
}
using Rocks = std::set<std::tuple<double, double, int>>;

/// Adds what is not done to a plan, job by job.
class Cost {
 public:
  Cost(Plan& plan, std::filesystem::path folder, double critical_step, double ns_per_disc_step)
      : plan_(plan), folder_(std::move(folder)), critical_step_(critical_step), ns_(ns_per_disc_step) {}

  void add(const Job& job) {
    const double steps = static_cast<double>(dem2d::plan_steps(job.cut, critical_step_).steps());
    const auto [place, is_new_depth] = parts_.try_emplace(job.cut.depth_of_cut, plan_.parts.size());
    if (is_new_depth) plan_.parts.push_back(new_part(job));
    PlanPart& part = plan_.parts[place->second];
    const double core_time = dem2d::expected_core_seconds(steps, part.discs, ns_);
    ++part.jobs;
    part.steps += steps;
    part.core_time += core_time;
    plan_.steps += steps;
    plan_.disc_steps += steps * part.discs;
    plan_.core_time += core_time;
    plan_.longest_cut = std::max(plan_.longest_cut, core_time);
    plan_.most_discs = std::max(plan_.most_discs, part.discs);
    const bool is_new_rock = rocks_.insert(rock_of(job)).second;
    if (is_new_rock && (folder_.empty() || !has_rock(folder_, job))) ++plan_.rocks_to_make;
  }

 private:
  Plan& plan_;
  std::filesystem::path folder_;
  double critical_step_;                 ///< [s]
  double ns_;                            ///< a disc and step [ns]
  std::map<double, std::size_t> parts_;  ///< by depth
  Rocks rocks_;
};

}  // namespace

double work(const Job& job) {
  return (job.cut.run_in + job.cut.cut_length) / job.cut.cutter_speed * dem2d::moving_length(job.cut) *
         job.cut.bed_height;
}

Plan plan(const Study& study, const std::filesystem::path& folder, double ns_per_disc_step) {
  Plan plan{.jobs = count_jobs(study)};
  plan.cases = plan.jobs / static_cast<int>(study.seeds.size());
  Rocks rocks;
  for_each_job(study, [&rocks](const Job& job) { rocks.insert(rock_of(job)); });
  plan.rocks = static_cast<int>(rocks.size());

  Cost cost(plan, folder, critical_step_of_sample(study), ns_per_disc_step);
  const auto add = [&cost](const Job& job) { cost.add(job); };
  if (folder.empty() || !base::is_there(folder / "study.toml")) {
    for_each_job(study, add);
    return plan;
  }
  const Survey survey = look(study, folder, add);
  plan.done = survey.status.done;
  plan.failed = survey.status.failed;
  plan.core_seconds = survey.status.core_seconds;
  return plan;
}

}  // namespace bitrock::studies
