#include "dem2d/cut/run_cut.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "base/thread_time.hpp"
#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/order.hpp"
#include "dem2d/step/cost.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"
#include "dem2d/tool/cutter.hpp"

namespace bitrock::dem2d {

namespace {

// About a month on one core for a bed of a thousand discs; also keeps step counts far below what an int holds.
constexpr double most_steps = 1e9;

// Three years on one core: nobody waits for that, whatever the number of threads.
constexpr double most_disc_steps = 1e15;

// Of all frames together, which are held until the cut is done: some 6 GB.
constexpr double most_discs_in_frames = 1e8, bytes_of_a_disc = 65.0;

// In one step the cutter moves no more than this share of the smallest grain's diameter: a grain must feel it come.
constexpr double motion_share = 0.01;

// Of the cutter's work, under mud: above it something went wrong, as where rock enters over displaced rock [1].
constexpr double most_residual = 0.002;

// The cutter starts this far from the edge of the rock, so that nothing touches at the first step [m].
constexpr double start_gap = 1e-6;

/// Where the tip must be so that the leaned face just misses the rock's left edge, at the height of the surface.
double start_x(const CutCase& cut) {
  return -face_ahead_of_tip(cutter_shape(cut), cut.depth_of_cut) - start_gap;
}

Boundary make_cutter(const CutCase& cut, double tip_y) {
  return {.shape = cutter_outline(cutter_shape(cut), start_x(cut), tip_y),
          .velocity_x = cut.cutter_speed,
          .modulus = cut.rock.contact_modulus,
          .stiffness_ratio = cut.rock.contact_stiffness_ratio,
          .friction = cut.cutter_friction,
          .damping_ratio = cut.rock.contact_damping_ratio,
          .shear_damping_ratio = cut.rock.contact_shear_damping_ratio};
}

void hold_sides(World& world, const Specimen& bed, double tip_y) {
  const Discs& discs = world.discs;
  const double column = column_width(discs);
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    const bool at_left = discs.x[i] < column && discs.y[i] < tip_y - 2.0 * column;
    if (at_left || discs.y[i] < column || discs.x[i] > bed.width - column) hold(world.discs, i);
  }
}

double years(double disc_steps) {
  constexpr double seconds_per_year = 3.156e7;
  return expected_core_seconds(disc_steps, 1.0) / seconds_per_year;
}

/// When rock enters the window of a cut under mud. Debris may lie there, and thrust moves the rock there by more than a
/// grain's tolerance now and then: the window waits for calm, as long as three quarters of the rock ahead are left.
class Door {
 public:
  Door(bool waits, double ahead) : waits_(waits), least_ahead_(0.75 * ahead) {}

  /// Counts in when it may not wait any longer.
  bool may_open(const Window& window, const World& world, double tip_x, double thrust, int& forced) {
    ++looks_;
    mean_thrust_ += (thrust - mean_thrust_) / looks_;
    if (!waits_) return true;
    const bool in_time = window.high - tip_x >= least_ahead_;
    if (in_time && thrust > mean_thrust_) return false;
    const AtTheDoor found = at_the_door(window, world.discs);
    if (in_time && found != AtTheDoor::nothing) return false;
    forced += found == AtTheDoor::displaced_rock ? 1 : 0;
    return true;
  }

 private:
  bool waits_;
  double least_ahead_, looks_ = 0.0, mean_thrust_ = 0.0;
};

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

}  // namespace

void check_frames(int frames, double discs) {
  if (frames * discs <= most_discs_in_frames) return;
  throw base::InputError(
      fmt::format("{} frames of about {:.3g} discs are {:.2g} GB in memory (at most {:.2g}; take {:.0f} "
                  "frames or fewer)",
                  frames, discs, frames * discs * bytes_of_a_disc * 1e-9, most_discs_in_frames * bytes_of_a_disc * 1e-9,
                  std::floor(most_discs_in_frames / discs)));
}

World make_cut_world(const CutCase& cut, const Specimen& bed, const CutOptions& options) {
  World world = bonded_world(bed, options.threads);
  order_in_columns(world);
  world.ledger.measured = options.measure_energy;
  world.materials.local_damping = cut.local_damping;
  const double margin = cut.domain_margin;
  world.domain = {-margin, -margin, bed.width + margin, bed.height + margin};

  const double tip_y = bed.height - cut.depth_of_cut;
  Boundary cutter = make_cutter(cut, tip_y);
  forgive_overlaps(cutter, world.discs);  // packed discs reach a little beyond the edge of the bed
  world.boundaries = {cutter};
  hold_sides(world, bed, tip_y);
  prepare(world);
  world.step = critical_step(world, cut.step_factor);
  return world;
}

CutSchedule plan_steps(const CutCase& cut, double critical_step) {
  const double sample_time = cut.sampling_distance / cut.cutter_speed;
  const double wanted = std::ceil(sample_time / critical_step);
  const double samples = (cut.run_in + cut.cut_length) / cut.sampling_distance;
  if (!(critical_step > 0.0) || !(wanted * samples <= most_steps)) {
    throw base::InputError(
        fmt::format("cut.cutter_speed_m_per_s = {:.4g}: the cut would take {:.3g} steps of {:.3g} s (at most {:.0e}; a "
                    "faster or shorter cut takes fewer)",
                    cut.cutter_speed, wanted * samples, critical_step, most_steps));
  }
  const double discs = expected_discs(cut.rock, moving_length(cut), cut.bed_height);
  if (wanted * samples * discs > most_disc_steps) {
    throw base::InputError(fmt::format(
        "cut.cutter_speed_m_per_s = {:.4g}: the cut would take {:.3g} steps of about {:.3g} discs, {:.2g} "
        "years of one core (at most {:.2g}; a faster or shorter cut, or a smaller bed, takes less)",
        cut.cutter_speed, wanted * samples, discs, years(wanted * samples * discs), years(most_disc_steps)));
  }
  const int steps_per_sample = std::max(1, static_cast<int>(wanted));
  const double motion = cut.sampling_distance / steps_per_sample, allowed = motion_share * 2.0 * cut.rock.radius_min;
  if (motion > allowed) {
    throw base::InputError(
        fmt::format("cut.cutter_speed_m_per_s = {:.4g}: the cutter would move {:.3g} um in a step of {:.3g} s (at most "
                    "{:.3g} um, a hundredth of the smallest grain; a slower cut moves less)",
                    cut.cutter_speed, motion * 1e6, motion / cut.cutter_speed, allowed * 1e6));
  }
  return {.step = sample_time / steps_per_sample,
          .steps_per_sample = steps_per_sample,
          .samples = std::llround(samples),
          .run_in_samples = std::llround(cut.run_in / cut.sampling_distance)};
}

std::vector<std::string> warnings(const CutRun& run) {
  std::vector<std::string> found;
  if (run.forced_entries > 0) {
    found.push_back(
        fmt::format("rock entered {} times over rock that the thrust held out of its place: take a larger "
                    "bed.moving_ahead_mm (12 depths and more under mud)",
                    run.forced_entries));
  }
  if (run.energies.empty()) return found;
  if (run.settled.steps > 0 && std::abs(run.energy_residual_fraction) > most_residual) {
    found.push_back(
        fmt::format("{:.2g} % of the cutter's work is not found (at most {:g} % is usual under mud): do not "
                    "trust these forces",
                    100.0 * run.energy_residual_fraction, 100.0 * most_residual));
  }
  if (std::abs(run.energy_injected_fraction) <= most_injected) return found;
  found.push_back(
      fmt::format("{:.2g} % of the cutter's work came from contacts and joints that began under load (at most {:.0f} % "
                  "is usual): do not trust these forces; is the step too long?",
                  100.0 * run.energy_injected_fraction, 100.0 * most_injected));
  return found;
}

CutRun run_cut(const CutCase& cut, const Specimen& bed, const CutOptions& options,
               const base::ProgressCallback& progress) {
  const auto started = std::chrono::steady_clock::now();
  const double thread_started = base::thread_time();
  check_frames(options.frames, static_cast<double>(bed.x.size()));
  World world = make_cut_world(cut, bed, options);
  const CutSchedule schedule = plan_steps(cut, world.step);
  world.step = schedule.step;
  const double interval = schedule.step * schedule.steps_per_sample;
  const int discs = world.discs.count(), joints = world.joints.count();
  CutRun run;
  const bool under_mud = cut.mud_pressure > 0.0;
  if (under_mud) run.settled = settle_under_mud(world, cut, options.settling);
  std::optional<Window> window;
  if (cut.moving_ahead > 0.0 || cut.moving_behind > 0.0) window = open_window(world, cut, start_x(cut));
  const Window* const rock_window = window ? &*window : nullptr;
  Door door(under_mud, cut.moving_ahead);
  Energies start;  // without mud the bed holds nothing
  if (under_mud && options.measure_energy) {
    find_forces(world);
    start = read_energies(world);
  }
  run.bed_origin = bed.origin;
  run.discs = discs;
  run.joints = joints;
  run.step = schedule.step;

  double disc_steps = static_cast<double>(run.settled.steps) * discs;
  for (long long sample = 1; sample <= schedule.samples; ++sample) {
    double impulse_x = 0.0, impulse_y = 0.0;  // in steps times force
    const bool counts = sample > schedule.run_in_samples;
    for (int step = 1; step <= schedule.steps_per_sample; ++step) {
      find_forces(world);
      if (options.measure_energy && counts && step == schedule.steps_per_sample)
        run.energies.push_back(since(start, read_energies(world)));
      move(world);
      impulse_x -= world.boundaries[0].force_x + world.boundaries[0].mud_x;
      impulse_y += world.boundaries[0].force_y + world.boundaries[0].mud_y;
    }
    const double tip_x = start_x(cut) + cut.sampling_distance * static_cast<double>(sample);
    if (window && door.may_open(*window, world, tip_x, impulse_x, run.forced_entries))
      advance_window(*window, world, tip_x);
    base::throw_if_stopped();
    require_finite(world);
    disc_steps += static_cast<double>(world.discs.count()) * schedule.steps_per_sample;
    if (counts) {
      run.time.push_back(static_cast<double>(sample) * interval);
      run.force_x.push_back(impulse_x / schedule.steps_per_sample);
      run.force_y.push_back(impulse_y / schedule.steps_per_sample);
    }
    const bool frame_due = options.frames > 0 && sample * options.frames / schedule.samples !=
                                                     (sample - 1) * options.frames / schedule.samples;
    if (frame_due || sample == schedule.samples) run.frames.push_back(take_frame(world, rock_window, tip_x));
    if (frame_due) add_motion_and_joints(run.frames.back(), world, rock_window);
    if (progress) progress(static_cast<double>(sample) * interval, static_cast<double>(schedule.samples) * interval);
  }

  const auto counted = static_cast<double>(run.time.size());
  run.steps = schedule.steps();
  run.cut_length = cut.sampling_distance * counted;
  run.duration = interval * counted;
  run.mean_force_x = mean(run.force_x);
  run.mean_force_y = mean(run.force_y);
  run.specific_energy = run.mean_force_x / cut.depth_of_cut;
  run.cracks = std::move(world.cracks);
  run.cracks_tensile = static_cast<int>(std::count_if(
      run.cracks.begin(), run.cracks.end(), [](const Crack& c) { return c.mode == ElementState::broken_in_tension; }));
  run.cracks_shear = static_cast<int>(run.cracks.size()) - run.cracks_tensile;
  run.removed_discs = world.removed_discs - (window ? window->left_behind.count() : 0);
  if (options.measure_energy) {
    run.energy_residual_fraction = energy_residual_fraction({}, run.energies.back());
    run.energy_injected_fraction = energy_injected_fraction({}, run.energies.back());
  }
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  run.core_time = options.threads == 1 ? base::thread_time() - thread_started : run.wall_time * options.threads;
  run.nanoseconds_per_disc_step = run.core_time / options.threads * 1e9 / disc_steps;
  return run;
}

}  // namespace bitrock::dem2d
