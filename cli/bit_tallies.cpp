#include "cli/bit_tallies.hpp"

namespace cli {

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
          {"capped", draws.capped}};
}

void say_clamps(const CommonOptions& options, const runtime::ClampTally& clamps) {
  if (clamps.clamped() == 0) return;
  say(options,
      "outside the training range, answered for its edge: speed too low {}, too high {}; depth too low {}, too high "
      "{}; "
      "rake too low {}, too high {} (of {} questions)\n",
      clamps.speed_below, clamps.speed_above, clamps.depth_below, clamps.depth_above, clamps.rake_below,
      clamps.rake_above, clamps.asked);
}

}  // namespace cli
