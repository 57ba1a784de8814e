#include "views/json/bit_json.hpp"

namespace bitrock::views {

nlohmann::json as_json(const runtime::ClampTally& clamps) {
  return {{"asked", clamps.asked},
          {"speed_below", clamps.speed_below},
          {"speed_above", clamps.speed_above},
          {"depth_below", clamps.depth_below},
          {"depth_above", clamps.depth_above},
          {"rake_below", clamps.rake_below},
          {"rake_above", clamps.rake_above}};
}

nlohmann::json as_json(const runtime::DrawTally& draws) {
  return {{"drawn", draws.drawn},
          {"mean_missed", draws.mean_missed},
          {"band_left", draws.band_left},
          {"narrowed", draws.narrowed},
          {"capped", draws.capped},
          {"length_clamped", draws.length_clamped},
          {"correlation_clamped", draws.correlation_clamped}};
}

}  // namespace bitrock::views
