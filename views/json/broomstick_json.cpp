#include "views/json/broomstick_json.hpp"

#include "views/json/number_or_null.hpp"

namespace bitrock::views {

nlohmann::json as_json(const std::vector<studies::BroomstickRow>& rows,
                       const std::vector<studies::MeasuredLoad>& measured, double wall_time) {
  nlohmann::json computed = nlohmann::json::array(), points = nlohmann::json::array();
  for (const studies::BroomstickRow& row : rows) {
    computed.push_back({{"bit_depth_m", row.bit_depth},
                        {"friction", row.friction},
                        {"operation", name_of(row.operation)},
                        {"hook_load_N", number_or_null(row.hook_load)},
                        {"torque_N_m", number_or_null(row.torque)},
                        {"steady", row.steady}});
  }
  for (const studies::MeasuredLoad& load : measured) {
    points.push_back({{"bit_depth_m", load.bit_depth},
                      {"operation", name_of(load.operation)},
                      {"hook_load_N", number_or_null(load.hook_load)},
                      {"torque_N_m", number_or_null(load.torque)}});
  }
  return {{"rows", computed}, {"measured", points}, {"wall_s", wall_time}};
}

}  // namespace bitrock::views
