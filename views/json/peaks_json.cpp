#include "views/json/peaks_json.hpp"

#include "views/json/cut_json.hpp"

namespace bitrock::views {

namespace {

template <class Value>
nlohmann::json or_null(bool known, const Value& value) {
  return known ? nlohmann::json(value) : nlohmann::json();
}

nlohmann::json with_count(const peaks::PeakStatistics& statistics) {
  nlohmann::json json = as_json(statistics);
  json["count"] = statistics.count();
  return json;
}

nlohmann::json list_of(const std::vector<peaks::Part>& parts, const std::vector<double>& time) {
  nlohmann::json list = nlohmann::json::array();
  for (const peaks::Part& part : parts) {
    nlohmann::json entry = with_count(part.peaks);
    entry["begin_index"] = part.begin;
    entry["end_index"] = part.end;
    entry["begin_s"] = part.begin < part.end && !time.empty() ? nlohmann::json(time[part.begin]) : nlohmann::json();
    entry["zero_force_share"] = or_null(part.zero_force.samples > 0, part.zero_force.quiet_share());
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::json list_of_peaks(const studies::ForceHistory& history, const peaks::Selection& selection) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::size_t i : peaks::counted_peaks(history.force, selection)) {
    list.push_back({{"index", i},
                    {"time_s", history.time.empty() ? nlohmann::json() : nlohmann::json(history.time[i])},
                    {"height", history.force[i]}});
  }
  return list;
}

}  // namespace

nlohmann::json as_json(const studies::ForceHistory& history, const studies::ForceFindings& found,
                       const peaks::Selection& selection) {
  const bool timed = history.time.size() > 1;
  nlohmann::json result = with_count(found.all);
  result.update({{"column", history.column},
                 {"time_column", or_null(!history.time_column.empty(), history.time_column)},
                 {"samples", history.force.size()},
                 {"not_a_number", found.not_a_number},
                 {"infinite", found.infinite},
                 {"minimum_height", peaks::minimum_height(history.force)},
                 {"zero_force_share", found.zero.quiet_share()},
                 {"not_positive_share", found.zero.not_positive_share()},
                 {"zero_force_periods", found.zero.periods},
                 {"zero_force_mean_samples", found.zero.mean_period()},
                 {"zero_force_mean_s", or_null(timed, found.mean_period)},
                 {"evenly_spaced", or_null(timed, found.even)},
                 {"parts_by", timed ? "time" : "samples"},
                 {"parts", list_of(found.parts, history.time)},
                 {"peaks", list_of_peaks(history, selection)}});
  return result;
}

}  // namespace bitrock::views
