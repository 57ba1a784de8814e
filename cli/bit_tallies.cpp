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

void tell_draws(const CommonOptions& options, const runtime::DrawTally& draws) {
  if (draws.length_clamped + draws.correlation_clamped + draws.capped == 0) return;
  say(options,
      "of {} windows of a cutter and a direction, {} hold fewer pulses than the networks say; of the windows of a "
      "cutter, {} have a correlation length too short for a sawtooth, and {} a correlation of x and y that their "
      "deviations do not allow\n",
      draws.drawn, draws.capped, draws.length_clamped, draws.correlation_clamped);
}

void add_mode(CLI::App& command, std::string& mode) {
  command
      .add_option("--mode", mode,
                  "The force is rebuilt by this mode: sawtooth, article, article-literal, or auto (sawtooth when the "
                  "model can, else article). Without it the bit file says it.")
      ->check(CLI::IsMember(std::vector<std::string>{"auto", "sawtooth", "article", "article-literal"}));
}

runtime::SignalMode mode_of_flag(const std::string& mode) {
  for (const runtime::ModeName& known : runtime::mode_names) {
    if (known.name == mode) return known.mode;
  }
  return runtime::SignalMode::automatic;  // the flag was checked
}

}  // namespace bitrock::cli
