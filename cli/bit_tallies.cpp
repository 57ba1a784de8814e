#include "cli/bit_tallies.hpp"

#include "runtime/bit/asked_range.hpp"

namespace bitrock::cli {

namespace {

constexpr double seldom_share = 0.1;  // of the questions: the cutter nearest to the axis, or a start and a stop

}  // namespace

void warn_of_bit(const CommonOptions& options, const runtime::Bit& bit, const surrogate::Model& model) {
  for (const std::string& warning : runtime::warnings(bit)) warn(options, warning);
  if (const std::string rakes = runtime::rakes_outside(bit, model); !rakes.empty())
    warn(options, "outside the training range the networks answer for its edge: " + rakes);
}

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
