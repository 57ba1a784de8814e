// bitrock signal: force and torque on a whole bit that turns and advances steadily.
#include <chrono>
#include <memory>
#include <numbers>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "cli/bit_tallies.hpp"
#include "cli/command.hpp"
#include "runtime/bit/asked_range.hpp"
#include "runtime/bit/constant_speed.hpp"
#include "runtime/bit/core_description.hpp"
#include "surrogate/net/model_file.hpp"
#include "views/json/bit_json.hpp"
#include "views/text/signal_lines.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string bit_file, model_file, output, mode;
  double rpm = 0.0, rop_m_per_h = 0.0, duration = 10.0, rate = 5000.0;
};

void run(const Options& options) {
  runtime::Bit bit = runtime::read_bit(options.bit_file);
  take_mode(options.mode, bit);
  const surrogate::Model model = surrogate::read_cut_model(options.model_file);
  for (const std::string& warning : runtime::warnings(bit)) warn(options.common, warning);
  const runtime::ConstantSpeed drive{.rotation = options.rpm * 2.0 * std::numbers::pi / 60.0,
                                     .rate_of_penetration = options.rop_m_per_h / 3600.0,
                                     .duration = options.duration,
                                     .rate = options.rate};
  require_outputs(options.common, {options.bit_file, options.model_file}, {options.output});
  const auto begin = std::chrono::steady_clock::now();
  runtime::Signal signal;
  {
    Progress progress(options.common, "drilling", "s", 1.0 / options.rate);
    signal = runtime::constant_speed_signal(bit, model, drive, progress.callback());
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  base::write_whole(options.output,
                    base::csv_text({"time_s", "angle_rad", "axial_force_N", "torque_N_m"},
                                   {signal.time_s, signal.angle_rad, signal.axial_force_N, signal.torque_N_m}));
  const double times_real_time = options.duration / wall;
  const runtime::SignalMode mode = runtime::mode_for(bit.signal.mode, model);
  const std::string asked = runtime::asked_outside(bit, model, drive.rotation, drive.rate_of_penetration);
  say(options.common, "{}", views::signal_lines(bit, drive, signal.summary));
  tell(options.common, views::remarks(signal.summary.clamps, asked));
  tell(options.common, views::remarks(signal.summary.draws, mode));
  say(options.common, "{} samples, {:.0f} times real time -> {}\n", signal.time_s.size(), times_real_time,
      options.output);
  nlohmann::json result = views::as_json(bit, signal, mode);
  result.update({{"rpm", options.rpm}, {"rop_m_per_h", options.rop_m_per_h}, {"times_real_time", times_real_time}});
  write_json(options.common, result);
}

}  // namespace

void add_signal(CLI::App& app) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("signal", "Computes force and torque on a whole bit that turns and drills at steady speed.");
  add_bit_file(*command, options->bit_file);
  command
      ->add_option("--model", options->model_file,
                   "The model file with the networks, e.g. campaigns/paper240/model.json.")
      ->required();
  add_mode(*command, options->mode);
  command->add_option("--rpm", options->rpm, "The bit turns at this speed.")
      ->required()
      ->check(within("--rpm", base::between(runtime::slowest_rpm, runtime::fastest_rpm)));
  command->add_option("--rop-m-per-h", options->rop_m_per_h, "The bit drills at this rate (ROP).")
      ->required()
      ->check(within("--rop-m-per-h", base::between(0.0, runtime::fastest_m_per_h)));
  command->add_option("--duration-s", options->duration, "The record is so long.")
      ->check(within("--duration-s", base::between(1e-6, 1e7)))
      ->capture_default_str();
  command->add_option("--rate-hz", options->rate, "The record has so many samples a second.")
      ->check(within("--rate-hz", base::between(1e-3, 1e7)))
      ->capture_default_str();
  command->add_option("-o,--output", options->output, "The record goes to this table (.csv).")
      ->default_val("signal.csv");
  add_common(*command, options->common);
  command->callback([options] { run(*options); });
}

}  // namespace bitrock::cli
