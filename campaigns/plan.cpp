#include "campaigns/plan.hpp"

#include <algorithm>
#include <set>

#include "base/files.hpp"
#include "campaigns/folder.hpp"
#include "campaigns/rocks.hpp"
#include "campaigns/status.hpp"
#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/genesis.hpp"

namespace campaigns {

namespace {

constexpr double sample_side =
    20.0;  // of the sample of rock, in mean grain diameters: some 400 discs, a fifth of a second
constexpr double sample_depth = 0.25;  // of a cut into the sample, as a share of its height; the step hardly knows it

double critical_step_of_sample(const Study& study) {
  dem2d::CutCase cut = study.common;
  const double side = sample_side * (cut.rock.radius_min + cut.rock.radius_max);
  cut.bed_length = cut.bed_height = side;
  cut.depth_of_cut = sample_depth * side;
  cut.cutter_speed = 1.0;
  const auto seed = static_cast<std::uint64_t>(study.seeds.front());
  return dem2d::make_cut_world(cut, dem2d::make_specimen(cut.rock, side, side, seed, 1)).step;
}

PlanPart& part_of(std::vector<PlanPart>& parts, const Job& job) {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const PlanPart& part) { return part.depth_of_cut == job.cut.depth_of_cut; });
  if (found != parts.end()) return *found;
  parts.push_back({.depth_of_cut = job.cut.depth_of_cut,
                   .cut_length = job.cut.cut_length,
                   .bed_length = job.cut.bed_length,
                   .bed_height = job.cut.bed_height,
                   .discs = dem2d::expected_discs(job.cut.rock, dem2d::moving_length(job.cut), job.cut.bed_height)});
  return parts.back();
}

}  // namespace

double work(const Job& job) {
  return (job.cut.run_in + job.cut.cut_length) / job.cut.cutter_speed * dem2d::moving_length(job.cut) *
         job.cut.bed_height;
}

Plan plan(const Study& study, const std::filesystem::path& folder, double ns_per_disc_step) {
  Plan plan;
  std::vector<Job> missing = jobs(study);
  std::set<std::filesystem::path> rocks, rocks_looked_at;
  for (const Job& job : missing) rocks.insert(rock_path(folder, job));
  plan.jobs = static_cast<int>(missing.size());
  plan.cases = plan.jobs / static_cast<int>(study.seeds.size());
  plan.rocks = static_cast<int>(rocks.size());
  if (!folder.empty() && base::is_there(folder / "study.toml")) {
    const Survey survey = look(study, folder);
    plan.done = survey.status.done;
    plan.failed = survey.status.failed;
    plan.core_seconds = survey.status.core_seconds;
    missing = survey.missing;
  }

  const double critical_step = critical_step_of_sample(study);
  for (const Job& job : missing) {
    const dem2d::CutSchedule schedule = dem2d::plan_steps(job.cut, critical_step);
    const double steps = static_cast<double>(schedule.steps());
    PlanPart& part = part_of(plan.parts, job);
    const double core_time = steps * part.discs * ns_per_disc_step * 1e-9;
    ++part.jobs;
    part.steps += steps;
    part.core_time += core_time;
    plan.steps += steps;
    plan.disc_steps += steps * part.discs;
    plan.core_time += core_time;
    plan.longest_cut = std::max(plan.longest_cut, core_time);
    plan.most_discs = std::max(plan.most_discs, part.discs);
    const auto [rock, is_new] = rocks_looked_at.insert(rock_path(folder, job));
    if (is_new && (folder.empty() || !has_rock(folder, job))) ++plan.rocks_to_make;
  }
  return plan;
}

}  // namespace campaigns
