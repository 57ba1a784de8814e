#include "cli/bit_tallies.hpp"

#include "runtime/bit/asked_range.hpp"

namespace bitrock::cli {

namespace {

constexpr double seldom_share = 0.1;  // of the questions: the cutter nearest to the axis, or a start and a stop

void tell(const CommonOptions& options, const std::string& text, std::int64_t count, std::int64_t all) {
  if (static_cast<double>(count) < seldom_share * static_cast<double>(all)) {
    say(options, "{}\n", text);
  } else {
    warn(options, text);
  }
}

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
  tell(options, text, clamps.clamped(), clamps.asked);
}

void tell_draws(const CommonOptions& options, const runtime::DrawTally& draws) {
  if (draws.mean_missed > 0) {
    tell(options,
         fmt::format("of {} windows, {} cannot have the mean peak that the networks say, so the mean force is another: "
                     "their counts and heights of peaks do not fit together (take all five numbers from the same "
                     "records, by `bitrock peaks`; A_mean is the mean height of the peaks, not the mean force)",
                     draws.drawn, draws.mean_missed),
         draws.mean_missed, draws.drawn);
  }
  if (draws.narrowed > 0) {
    tell(options,
         fmt::format("of {} windows, {} hold so few peaks that these do not fill them, so the mean force is too small "
                     "(widen window_angle_deg in the bit file; were the peaks counted?)",
                     draws.drawn, draws.narrowed),
         draws.narrowed, draws.drawn);
  }
}

void tell_sawtooth_draws(const CommonOptions& options, const runtime::DrawTally& draws) {
  if (draws.length_clamped + draws.correlation_clamped + draws.capped == 0) return;
  say(options,
      "of {} windows of a cutter and a direction, {} hold fewer pulses than the networks say; of the windows of a "
      "cutter, {} have correlation lengths that no sawtooth has, and {} a correlation of x and y that their "
      "deviations do not allow\n",
      draws.drawn, draws.capped, draws.length_clamped, draws.correlation_clamped);
}

void add_mode(CLI::App& command, std::string& mode) {
  std::vector<std::string> names(std::size(runtime::mode_names));
  std::ranges::transform(runtime::mode_names, names.begin(),
                         [](const runtime::ModeName& known) { return std::string(known.name); });
  command
      .add_option("--mode", mode,
                  "The force is rebuilt by this mode: sawtooth, article, article-literal, or auto (sawtooth when the "
                  "model can, else article). Without it the bit file says it.")
      ->check(CLI::IsMember(names));
}

void take_mode(const std::string& mode, runtime::Bit& bit) {
  if (const auto named = runtime::mode_named(mode)) bit.signal.mode = *named;
}

}  // namespace bitrock::cli
