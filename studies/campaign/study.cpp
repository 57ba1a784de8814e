#include "studies/campaign/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_set>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/stop.hpp"
#include "base/unit_hint.hpp"
#include "base/units.hpp"
#include "dem2d/specimen/grading.hpp"

namespace bitrock::studies {

namespace {

using base::deg, base::mm, base::MPa;

using dem2d::cutter_speed_m_per_s, dem2d::depth_of_cut_mm, dem2d::back_rake_deg, dem2d::fluid_pressure_MPa;

constexpr double most_jobs = 1e6;  // a year of one core, at the 42 s of a cut of paper240

/// Cut and bed are sized either for all cases, or by the depth of each.
struct Size {
  const char* section;
  const char* key;
};
constexpr Size sizes[]{{"cut", "run_in_mm"}, {"cut", "cut_length_mm"},   {"bed", "length_mm"},
                       {"bed", "height_mm"}, {"bed", "moving_ahead_mm"}, {"bed", "moving_behind_mm"}};

base::Section describe(ByDepth& by_depth) {
  // The longest cut and bed are those of a cut file: 10 m.
  const base::Range depths{.low = 0.0, .high = 1e4, .low_open = true}, from_zero = base::between(0.0, 1e4);
  const base::Range from_three = base::between(3.0, 1e4), least = base::between(0.0, 1e4);
  return {
      "by_depth",
      {{"cut_length_depths", &by_depth.cut_length_depths, 1.0, depths, "travel of the cutter", true},
       {"bed_height_depths", &by_depth.bed_height_depths, 1.0, from_three, "from bottom to surface", true},
       {"bed_beyond_depths", &by_depth.bed_beyond_depths, 1.0, from_three, "rock past the end of the cut", true},
       {"run_in_depths", &by_depth.run_in_depths, 1.0, from_zero, "travel before forces count"},
       {"moving_ahead_depths", &by_depth.moving_ahead_depths, 1.0, from_zero, "rock that moves; 0: all of it"},
       {"moving_behind_depths", &by_depth.moving_behind_depths, 1.0, from_zero, "rock that moves; 0: all of it"},
       {"fine_bed_depths", &by_depth.fine_bed_depths, 1.0, from_zero, "from the surface; larger grains below; 0: none"},
       {"cut_length_least_mm", &by_depth.cut_length_least, mm, least, "however small the depth"},
       {"bed_height_least_mm", &by_depth.bed_height_least, mm, least, "however small the depth"},
       {"bed_beyond_least_mm", &by_depth.bed_beyond_least, mm, least, "however small the depth"},
       {"moving_ahead_least_mm", &by_depth.moving_ahead_least, mm, least, "however small the depth"},
       {"moving_behind_least_mm", &by_depth.moving_behind_least, mm, least, "however small the depth"},
       {"fine_bed_least_mm", &by_depth.fine_bed_least, mm, least, "however small the depth"}}};
}

base::Section describe(Grid& grid) {
  return {"grid",
          {{"cutter_speeds_m_per_s", &grid.cutter_speeds, 1.0, cutter_speed_m_per_s, "of the grid", true},
           {"depths_of_cut_mm", &grid.depths_of_cut, mm, depth_of_cut_mm, "of the grid", true},
           {"back_rakes_deg", &grid.back_rakes, deg, back_rake_deg, "of the grid", true},
           {"fluid_pressures_MPa", &grid.mud_pressures, MPa, fluid_pressure_MPa,
            "of the mud, of the grid; without them fluid.pressure_MPa"}}};
}

/// How the resolved copy of a study holds its table.
base::Section describe(Table& table) {
  return {"table",
          {{"cutter_speed_m_per_s", &table.cutter_speed, 1.0, cutter_speed_m_per_s, "of each case"},
           {"depth_of_cut_mm", &table.depth_of_cut, mm, depth_of_cut_mm, "of each case"},
           {"back_rake_deg", &table.back_rake, deg, back_rake_deg, "of each case"},
           {"fluid_pressure_MPa", &table.mud_pressure, MPa, fluid_pressure_MPa, "of each case, of the mud"}}};
}

base::Section describe_table_file(Study& study) {
  return {"", {{"table", &study.table_file, 1.0, base::any(), "cases as CSV, relative to this file"}}};
}

/// The sections that every study has.
std::vector<base::Section> describe_common(Study& study) {
  std::vector<base::Section> sections = dem2d::describe(study.common);
  const auto cut = std::find_if(sections.begin(), sections.end(), [](const auto& s) { return s.name == "cut"; });
  std::erase_if(cut->fields,
                [](const base::Field& field) { return field.name != "cut_length_mm" && field.name != "run_in_mm"; });
  sections.front().fields.push_back(
      {"seeds", &study.seeds, 1.0, base::between(0, 2147483647), "one rock each; every case is cut in every rock"});
  return sections;
}

/// For a study that holds the tables of its rock.
void leave_out_rock_file(std::vector<base::Section>& sections) {
  std::erase_if(sections.front().fields, [](const base::Field& field) { return field.name == "rock"; });
}

template <class T>
bool has_repeats(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

void read_grid(base::ConfigFile& file, Grid& grid) {
  file.fill(describe(grid));
  const std::string no_repeats = "each value may appear once";
  if (has_repeats(grid.cutter_speeds)) file.refuse("grid", "cutter_speeds_m_per_s", no_repeats);
  if (has_repeats(grid.depths_of_cut)) file.refuse("grid", "depths_of_cut_mm", no_repeats);
  if (has_repeats(grid.back_rakes)) file.refuse("grid", "back_rakes_deg", no_repeats);
  if (has_repeats(grid.mud_pressures)) file.refuse("grid", "fluid_pressures_MPa", no_repeats);
}

void read_by_depth(base::ConfigFile& file, Study& study) {
  for (const Size& size : sizes) {
    if (file.has(size.section, size.key)) {
      file.refuse(size.section, size.key, "[by_depth] sizes each case by its depth; give one of the two");
    }
  }
  study.by_depth.emplace();
  file.fill(describe(*study.by_depth));
  const auto refuse_lone = [&file](const char* key, double least, double depths) {
    if (least > 0.0 && depths == 0.0)
      file.refuse("by_depth", key, "it goes with the key in depths, which is not given");
  };
  refuse_lone("moving_ahead_least_mm", study.by_depth->moving_ahead_least, study.by_depth->moving_ahead_depths);
  refuse_lone("moving_behind_least_mm", study.by_depth->moving_behind_least, study.by_depth->moving_behind_depths);
  refuse_lone("fine_bed_least_mm", study.by_depth->fine_bed_least, study.by_depth->fine_bed_depths);
}

using Conditions = std::tuple<double, double, double, double>;

Conditions conditions(const Table& table, std::size_t i) {
  return {table.cutter_speed[i], table.depth_of_cut[i], table.back_rake[i],
          table.mud_pressure.empty() ? 0.0 : table.mud_pressure[i]};
}

Table read_table(const std::filesystem::path& path) {
  const base::CsvTable csv = base::read_csv(path);
  csv.require({"cutter_speed_m_per_s", "depth_of_cut_mm", "back_rake_deg"});
  const auto column = [&csv](const char* name, const base::Range& range, double unit) {
    std::vector<double> values = csv.column(name);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!range.contains(values[i])) {
        throw base::InputError(fmt::format("{}:{}: {} = {} ({})", csv.source, csv.lines[i], name, values[i],
                                           base::out_of_range(name, values[i], range)));
      }
      values[i] *= unit;
    }
    return values;
  };
  Table table{.cutter_speed = column("cutter_speed_m_per_s", cutter_speed_m_per_s, 1.0),
              .depth_of_cut = column("depth_of_cut_mm", depth_of_cut_mm, mm),
              .back_rake = column("back_rake_deg", back_rake_deg, deg)};
  if (csv.has("fluid_pressure_MPa")) table.mud_pressure = column("fluid_pressure_MPa", fluid_pressure_MPa, MPa);
  std::map<Conditions, int> lines;
  for (std::size_t i = 0; i < csv.rows(); ++i) {
    const auto [first, is_new] = lines.emplace(conditions(table, i), csv.lines[i]);
    if (!is_new) {
      throw base::InputError(fmt::format("{}:{}: the same case as in line {} (each may appear once; seeds repeat them)",
                                         csv.source, csv.lines[i], first->second));
    }
  }
  return table;
}

/// The table of a resolved study stands in the file itself.
void read_inner_table(base::ConfigFile& file, Table& table) {
  file.fill(describe(table));
  const std::size_t cases = table.cutter_speed.size();
  if (cases == 0) file.refuse("table", "cutter_speed_m_per_s", "is empty (needs one entry a case)");
  if (table.depth_of_cut.size() != cases) file.refuse("table", "depth_of_cut_mm", "needs one entry a case");
  if (table.back_rake.size() != cases) file.refuse("table", "back_rake_deg", "needs one entry a case");
  if (!table.mud_pressure.empty() && table.mud_pressure.size() != cases)
    file.refuse("table", "fluid_pressure_MPa", "needs one entry a case");
  std::set<Conditions> different;
  for (std::size_t i = 0; i < cases; ++i) different.insert(conditions(table, i));
  if (different.size() < cases) file.refuse("table", "cutter_speed_m_per_s", "each case may appear once");
}

/// Either a grid or a table.
void read_cases(base::ConfigFile& file, Study& study) {
  const bool has_table = file.has("table");
  if (has_table && file.has("grid")) file.refuse("", "table", "there is a [grid] too; give one of the two");
  if (!has_table) return read_grid(file, study.grid);
  if (file.has_table("table")) return read_inner_table(file, study.table);
  file.fill(describe_table_file(study));
  study.table = read_table(file.resolve(study.table_file));
}

void refuse_two_pressures(base::ConfigFile& file, const Study& study) {
  if (has_pressures(study) && study.common.mud_pressure > 0.0)
    file.refuse("fluid", "pressure_MPa", "the cases have pressures of their own; give one of the two");
}

dem2d::CutCase sized(dem2d::CutCase cut, const ByDepth& by_depth) {
  const double depth = cut.depth_of_cut;
  cut.cut_length = std::max(by_depth.cut_length_depths * depth, by_depth.cut_length_least);
  cut.bed_height = std::max(by_depth.bed_height_depths * depth, by_depth.bed_height_least);
  cut.run_in = by_depth.run_in_depths * depth;
  cut.bed_length =
      cut.run_in + cut.cut_length + std::max(by_depth.bed_beyond_depths * depth, by_depth.bed_beyond_least);
  const auto if_wanted = [depth](double depths, double least) {
    return depths > 0.0 ? std::max(depths * depth, least) : 0.0;
  };
  cut.moving_ahead = if_wanted(by_depth.moving_ahead_depths, by_depth.moving_ahead_least);
  cut.moving_behind = if_wanted(by_depth.moving_behind_depths, by_depth.moving_behind_least);
  if (by_depth.fine_bed_depths > 0.0)
    cut.rock.fine_depth = std::max(by_depth.fine_bed_depths * depth, by_depth.fine_bed_least);
  return cut;
}

std::size_t count_cases(const Study& study) {
  const Grid& grid = study.grid;
  return study.table.cutter_speed.size() + grid.cutter_speeds.size() * grid.depths_of_cut.size() *
                                               grid.back_rakes.size() *
                                               std::max<std::size_t>(grid.mud_pressures.size(), 1);
}

void refuse_too_many(const Study& study, const std::string& source) {
  const std::size_t number = count_cases(study);
  const double all = static_cast<double>(number) * static_cast<double>(study.seeds.size());
  if (all <= most_jobs) return;
  throw base::InputError(fmt::format("{}: {} cases times {} seeds are {:.3g} cuts (at most {:.0e}; split the study)",
                                     source, number, study.seeds.size(), all, most_jobs));
}

/// One cut a case, in order, with its number.
template <class Function>
void for_each_case(const Study& study, const Function& function) {
  int number = 0;
  const double common_pressure = study.common.mud_pressure;
  const auto give = [&](double speed, double depth, double rake, double pressure) {
    base::throw_if_stopped();
    dem2d::CutCase cut = study.common;
    cut.mud_pressure = pressure;
    cut.cutter_speed = speed;
    cut.depth_of_cut = depth;
    cut.back_rake = rake;
    function(++number, study.by_depth ? sized(std::move(cut), *study.by_depth) : std::move(cut));
  };
  const Table& table = study.table;
  for (std::size_t i = 0; i < table.cutter_speed.size(); ++i) {
    give(table.cutter_speed[i], table.depth_of_cut[i], table.back_rake[i],
         table.mud_pressure.empty() ? common_pressure : table.mud_pressure[i]);
  }
  const Grid& grid = study.grid;
  const std::vector<double> pressures =
      grid.mud_pressures.empty() ? std::vector<double>{common_pressure} : grid.mud_pressures;
  for (const double pressure : pressures) {
    for (const double speed : grid.cutter_speeds) {
      for (const double depth : grid.depths_of_cut) {
        for (const double rake : grid.back_rakes) give(speed, depth, rake, pressure);
      }
    }
  }
}

}  // namespace

bool has_pressures(const Study& study) {
  return !study.grid.mud_pressures.empty() || !study.table.mud_pressure.empty();
}

Study read_study(const std::filesystem::path& path) {
  Study study;
  base::ConfigFile file = base::ConfigFile::read(path);
  const bool inside = dem2d::has_rock_inside(file);
  if (inside) study.common.rock = dem2d::rock_inside(file);
  std::vector<base::Section> sections = describe_common(study);
  if (inside) leave_out_rock_file(sections);
  for (const base::Section& section : sections) file.fill(section);
  read_cases(file, study);
  refuse_two_pressures(file, study);
  if (file.has("by_depth")) read_by_depth(file, study);
  file.refuse_unknown();
  if (has_repeats(study.seeds)) file.refuse("", "seeds", "each value may appear once");
  refuse_too_many(study, path.string());
  if (!inside) study.common.rock = dem2d::read_rock(file.resolve(study.common.rock_file));
  for_each_case(study, [&path](int number, const dem2d::CutCase& cut) {
    dem2d::check_cut_case(cut, fmt::format("{}: case {}", path.string(), number));
  });
  return study;
}

std::vector<base::KeyRow> study_keys() {
  Study study;
  ByDepth by_depth;
  std::vector<base::Section> sections = describe_common(study);
  const auto behind_top_level = sections.begin() + 1;
  const std::vector<base::Section> cases{describe_table_file(study), describe(study.grid), describe(study.table),
                                         describe(by_depth)};
  sections.insert(behind_top_level, cases.begin(), cases.end());
  return base::key_rows(sections);
}

namespace {

/// All that a study asks for, with table and rock inside; bound to `study`.
std::vector<base::Section> describe_resolved(Study& study) {
  std::vector<base::Section> sections = describe_common(study);
  leave_out_rock_file(sections);
  if (!has_pressures(study)) dem2d::leave_out_unused(sections, study.common);
  const bool from_table = !study.table.cutter_speed.empty();
  sections.push_back(from_table ? describe(study.table) : describe(study.grid));
  if (!has_pressures(study)) sections.back().fields.pop_back();  // texts of studies without them stay as they were
  if (study.by_depth) {
    sections.push_back(describe(*study.by_depth));
    for (const Size& size : sizes) {
      const auto section =
          std::find_if(sections.begin(), sections.end(), [&size](const auto& s) { return s.name == size.section; });
      std::erase_if(section->fields, [&size](const base::Field& field) { return field.name == size.key; });
    }
  }
  for (base::Section& section : dem2d::describe_material(study.common.rock)) sections.push_back(std::move(section));
  return sections;
}

}  // namespace

std::string resolved_toml(const Study& study) {
  Study copy = study;
  return base::to_toml(describe_resolved(copy));
}

std::string exact_toml(const Study& study) {
  Study copy = study;
  return base::to_exact_toml(describe_resolved(copy));
}

double mean_diameter(const Study& study) {
  return dem2d::mean_diameter(study.common.rock);
}

int count_jobs(const Study& study) {
  return static_cast<int>(count_cases(study) * study.seeds.size());
}

void for_each_job(const Study& study, const std::function<void(const Job&)>& function) {
  for_each_case(study, [&](int number, dem2d::CutCase cut) {
    Job job{.case_number = number, .cut = std::move(cut)};
    for (const int seed : study.seeds) {
      base::throw_if_stopped();
      job.seed = seed;
      function(job);
    }
  });
}

std::vector<Job> jobs(const Study& study) {
  std::vector<Job> all;
  all.reserve(static_cast<std::size_t>(count_jobs(study)));
  for_each_job(study, [&all](const Job& job) { all.push_back(job); });
  return all;
}

std::vector<std::string> warnings(const Study& study) {
  std::vector<std::string> all;
  std::unordered_set<std::string> seen;
  for_each_case(study, [&](int, const dem2d::CutCase& cut) {
    for (std::string& warning : dem2d::warnings(cut)) {
      if (seen.insert(warning).second) all.push_back(std::move(warning));
    }
  });
  return all;
}

}  // namespace bitrock::studies
