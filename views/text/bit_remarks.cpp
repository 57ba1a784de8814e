#include "views/text/bit_remarks.hpp"

#include <fmt/format.h>

namespace bitrock::views {

namespace {

constexpr double seldom_share = 0.1;  // of the questions: the cutter nearest to the axis, or a start and a stop

BitRemark remark(std::string text, std::int64_t count, std::int64_t all) {
  const bool seldom = static_cast<double>(count) < seldom_share * static_cast<double>(all);
  return {.text = std::move(text), .is_warning = !seldom};
}

std::vector<BitRemark> sawtooth_remarks(const runtime::DrawTally& draws) {
  if (draws.length_clamped + draws.correlation_clamped + draws.capped == 0) return {};
  return {{.text = fmt::format(
               "of {} windows of a cutter and a direction, {} hold fewer pulses than the networks say; of the windows "
               "of a cutter, {} have correlation lengths that no sawtooth has, and {} a correlation of x and y that "
               "their deviations do not allow",
               draws.drawn, draws.capped, draws.length_clamped, draws.correlation_clamped)}};
}

}  // namespace

std::vector<BitRemark> remarks(const runtime::ClampTally& clamps, const std::string& asked) {
  if (clamps.clamped() == 0) return {};
  const auto percent = [&clamps](std::int64_t count) {
    return fmt::format("{:.3g} %", 100.0 * static_cast<double>(count) / static_cast<double>(clamps.asked));
  };
  const std::string text = fmt::format(
      "outside the training range the networks answer for its edge: of {} questions, speed too low {}, too high {}; "
      "depth too low {}, too high {}; rake too low {}, too high {}{}{}",
      clamps.asked, percent(clamps.speed_below), percent(clamps.speed_above), percent(clamps.depth_below),
      percent(clamps.depth_above), percent(clamps.rake_below), percent(clamps.rake_above), asked.empty() ? "" : "; ",
      asked);
  return {remark(text, clamps.clamped(), clamps.asked)};
}

std::vector<BitRemark> remarks(const runtime::DrawTally& draws, runtime::SignalMode mode) {
  if (mode == runtime::SignalMode::sawtooth) return sawtooth_remarks(draws);
  std::vector<BitRemark> all;
  if (draws.mean_missed > 0) {
    all.push_back(remark(
        fmt::format("of {} windows, {} cannot have the mean peak that the networks say, so the mean force is another: "
                    "their counts and heights of peaks do not fit together (take all five numbers from the same "
                    "records, by `bitrock peaks`; A_mean is the mean height of the peaks, not the mean force)",
                    draws.drawn, draws.mean_missed),
        draws.mean_missed, draws.drawn));
  }
  if (draws.narrowed > 0) {
    all.push_back(
        remark(fmt::format("of {} windows, {} hold so few peaks that these do not fill them, so the mean force is too "
                           "small (widen window_angle_deg in the bit file; were the peaks counted?)",
                           draws.drawn, draws.narrowed),
               draws.narrowed, draws.drawn));
  }
  return all;
}

}  // namespace bitrock::views
