#include "cli/bit_tallies.hpp"

namespace bitrock::cli {

namespace {

constexpr double seldom_share = 0.1;  // of the questions: the cutter nearest to the axis, or a start and a stop

}  // namespace

void tell_clamps(const CommonOptions& options, const runtime::ClampTally& clamps, const std::string& asked) {
  if (clamps.clamped() == 0) return;
  const auto percent = [&clamps](std::int64_t count) {
    return fmt::format("{:.3g} %", 100.0 * static_cast<double>(count) / static_cast<double>(clamps.asked));
  };
  const std::string text = fmt::format(
      "outside the training range the networks answer for its edge: of {} questions, speed too low {}, too high {}; "
      "depth too low {}, too high {}; rake too low {}, too high {}{}{}",
      clamps.asked, percent(clamps.speed_below), percent(clamps.speed_above), percent(clamps.depth_below),
      percent(clamps.depth_above), percent(clamps.rake_below), percent(clamps.rake_above), asked.empty() ? "" : "; ",
      asked);
  const bool seldom = static_cast<double>(clamps.clamped()) < seldom_share * static_cast<double>(clamps.asked);
  if (seldom) {
    say(options, "{}\n", text);
  } else {
    warn(options, text);
  }
}

}  // namespace bitrock::cli
