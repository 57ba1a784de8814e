#include "views/json/campaign_json.hpp"

namespace bitrock::views {

namespace {

nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

nlohmann::json as_json(const studies::Status& status) {
  return {{"cases", status.cases},
          {"done", status.done},
          {"running", status.running},
          {"failed", status.failed},
          {"remaining", status.remaining},
          {"core_seconds", status.core_seconds},
          {"core_seconds_left", or_null(status.core_left)},
          {"time_left_s", or_null(status.time_left)}};
}

nlohmann::json as_json(const studies::Plan& plan) {
  return {{"cases", plan.cases},
          {"jobs", plan.jobs},
          {"done", plan.done},
          {"failed", plan.failed},
          {"remaining", plan.jobs - plan.done - plan.failed},
          {"core_seconds", plan.core_seconds},
          {"rocks", plan.rocks},
          {"rocks_to_make", plan.rocks_to_make},
          {"most_discs", plan.most_discs},
          {"steps", plan.steps},
          {"disc_steps", plan.disc_steps},
          {"core_hours", plan.core_time / 3600.0},
          {"longest_cut_s", plan.longest_cut}};
}

}  // namespace bitrock::views
