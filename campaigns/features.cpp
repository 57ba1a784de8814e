#include "campaigns/features.hpp"

#include <map>

#include "base/csv.hpp"
#include "base/statistics.hpp"
#include "base/units.hpp"
#include "campaigns/runner.hpp"

namespace campaigns {

namespace {

const std::vector<std::string> condition_names{"cutter_speed_m_per_s", "depth_of_cut_mm", "back_rake_deg",
                                               "cut_length_m", "duration_s"};
const std::vector<std::string> statistic_names{"x_amax_N_per_m", "x_amean_N_per_m", "x_np1", "x_np23", "x_np4",
                                               "y_amax_N_per_m", "y_amean_N_per_m", "y_np1", "y_np23", "y_np4"};

std::vector<double> conditions(const FeatureRow& row) {
  return {row.cutter_speed, base::in_units(row.depth_of_cut, base::mm), base::in_units(row.back_rake, base::deg),
          base::in_units(row.cut_length, 1.0), base::in_units(row.duration, 1.0)};
}

std::vector<double> statistics(const FeatureRow& row) {
  std::vector<double> values;
  for (const peaks::PeakStatistics* s : {&row.x, &row.y}) {
    values.insert(values.end(), {s->amax, s->amean, static_cast<double>(s->np1), static_cast<double>(s->np23),
                                 static_cast<double>(s->np4)});
  }
  return values;
}

/// Rows of values to columns of a table.
std::string table(const std::vector<std::string>& names, const std::vector<std::vector<double>>& rows) {
  std::vector<std::vector<double>> columns(names.size());
  for (const std::vector<double>& row : rows) {
    for (std::size_t i = 0; i < names.size(); ++i) columns[i].push_back(row[i]);
  }
  return base::csv_text(names, columns);
}

void append(std::vector<double>& to, const std::vector<double>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

}  // namespace

std::vector<FeatureRow> collect(const Study& study, const std::filesystem::path& folder) {
  std::vector<FeatureRow> rows;
  for (const Job& job : jobs(study)) {
    const auto file = finished_run(folder, job);
    if (!file) continue;
    const dem2d::CutRun& run = file->run;
    rows.push_back({.case_number = job.case_number,
                    .seed = job.seed,
                    .cutter_speed = job.cut.cutter_speed,
                    .depth_of_cut = job.cut.depth_of_cut,
                    .back_rake = job.cut.back_rake,
                    .cut_length = run.cut_length,
                    .duration = run.duration,
                    .x = peaks::peak_statistics(run.force_x),
                    .y = peaks::peak_statistics(run.force_y)});
  }
  return rows;
}

std::string features_csv(const std::vector<FeatureRow>& rows) {
  std::vector<std::string> names{"case", "seed"};
  names.insert(names.end(), condition_names.begin(), condition_names.end());
  names.insert(names.end(), statistic_names.begin(), statistic_names.end());
  std::vector<std::vector<double>> values;
  for (const FeatureRow& row : rows) {
    values.push_back({static_cast<double>(row.case_number), static_cast<double>(row.seed)});
    append(values.back(), conditions(row));
    append(values.back(), statistics(row));
  }
  return table(names, values);
}

std::string features_mean_csv(const std::vector<FeatureRow>& rows) {
  std::vector<std::string> names{"case", "seeds"};
  names.insert(names.end(), condition_names.begin(), condition_names.end());
  names.insert(names.end(), statistic_names.begin(), statistic_names.end());
  for (const std::string& name : statistic_names) names.push_back(name + "_standard_error");

  std::map<int, std::vector<const FeatureRow*>> by_case;
  for (const FeatureRow& row : rows) by_case[row.case_number].push_back(&row);
  std::vector<std::vector<double>> values;
  for (const auto& [number, members] : by_case) {
    values.push_back({static_cast<double>(number), static_cast<double>(members.size())});
    append(values.back(), conditions(*members.front()));
    std::vector<double> means, errors;
    for (std::size_t i = 0; i < statistic_names.size(); ++i) {
      std::vector<double> sample;
      for (const FeatureRow* row : members) sample.push_back(statistics(*row)[i]);
      const base::Summary summary = base::summarise(sample);
      means.push_back(summary.mean);
      errors.push_back(summary.standard_error);
    }
    append(values.back(), means);
    append(values.back(), errors);
  }
  return table(names, values);
}

}  // namespace campaigns
