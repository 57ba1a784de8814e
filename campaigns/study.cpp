#include "campaigns/study.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/units.hpp"

namespace campaigns {

namespace {

using base::deg, base::mm;

std::vector<base::Section> describe(Study& study) {
  using base::between, base::positive;
  std::vector<base::Section> sections = dem2d::describe(study.common);
  const auto cut = std::find_if(sections.begin(), sections.end(), [](const auto& s) { return s.name == "cut"; });
  std::erase_if(cut->fields, [](const base::Field& field) { return field.name != "cut_length_mm"; });
  sections.front().fields.push_back(
      {"seeds", &study.seeds, 1.0, between(0, 2147483647), "one rock each; every case is cut in every rock"});
  sections.push_back({"grid",
                      {{"cutter_speeds_m_per_s",
                        &study.cutter_speeds,
                        1.0,
                        {.low = 0.0, .high = 50.0, .low_open = true},
                        "of the grid",
                        true},
                       {"depths_of_cut_mm", &study.depths_of_cut, mm, positive(), "of the grid", true},
                       {"back_rakes_deg", &study.back_rakes, deg, between(0.0, 60.0), "of the grid", true}}});
  return sections;
}

template <class T>
bool has_repeats(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

}  // namespace

Study read_study(const std::filesystem::path& path) {
  Study study;
  base::ConfigFile file = base::ConfigFile::read(path);
  for (const base::Section& section : describe(study)) file.fill(section);
  file.refuse_unknown();
  const std::string no_repeats = "each value may appear once";
  if (has_repeats(study.cutter_speeds)) file.refuse("grid", "cutter_speeds_m_per_s", no_repeats);
  if (has_repeats(study.depths_of_cut)) file.refuse("grid", "depths_of_cut_mm", no_repeats);
  if (has_repeats(study.back_rakes)) file.refuse("grid", "back_rakes_deg", no_repeats);
  if (has_repeats(study.seeds)) file.refuse("", "seeds", no_repeats);
  study.common.rock = dem2d::read_rock(file.resolve(study.common.rock_file));
  for (const Job& job : jobs(study)) {
    dem2d::check_cut_case(job.cut, fmt::format("{}: case {}", path.string(), job.case_number));
  }
  return study;
}

std::string resolved_toml(const Study& study) {
  Study copy = study;
  std::vector<base::Section> sections = describe(copy);
  std::erase_if(sections.front().fields, [](const base::Field& field) { return field.name == "rock"; });
  for (base::Section& section : dem2d::describe_material(copy.common.rock)) sections.push_back(std::move(section));
  return base::to_toml(sections);
}

std::vector<Job> jobs(const Study& study) {
  std::vector<Job> all;
  int case_number = 0;
  for (const double speed : study.cutter_speeds) {
    for (const double depth : study.depths_of_cut) {
      for (const double rake : study.back_rakes) {
        ++case_number;
        for (const int seed : study.seeds) {
          Job job{.case_number = case_number, .seed = seed, .cut = study.common};
          job.cut.cutter_speed = speed;
          job.cut.depth_of_cut = depth;
          job.cut.back_rake = rake;
          all.push_back(std::move(job));
        }
      }
    }
  }
  return all;
}

}  // namespace campaigns
