#include "dem2d/lab/lab_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "base/units.hpp"
#include "dem2d/lab/curve.hpp"
#include "dem2d/lab/load_frame.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/lab/notch.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

// The fall of the stress that ends a test, as a share of the peak (lab_test.hpp).
constexpr double stop_fraction_core = 0.8, stop_fraction_brazilian = 0.95;

// Points of the curve until the strength that is expected: enough to draw it, few enough to store it.
constexpr double points_to_expected_strength = 500.0;

// A test without a peak is given up at this many times the expected strain.
// Unbonded joints soften: with half of them slit a core under tension has a twentieth of its modulus.
// Under pressure a core may never fall: what it carries at so many times the expected strain is its strength.
constexpr double strains_given_up = 5.0, strains_given_up_unbonded = 25.0, strains_under_pressure = 2.5;
constexpr double most_strain = 0.5;  // and at this strain at the latest: far beyond any rock [1]

// A core has a diameter of at least ten of its largest grains [IsrmUniaxial1979].
constexpr double least_grains = 10.0;

// About a day on one core for a core of some thousand discs.
constexpr double most_steps = 5e8;

// The user's wish to stop is looked for after this many steps at the latest: a second for ten thousand discs.
constexpr int steps_between_looks = 1000;

// A core with unbonded joints is severed when it has carried less than this share of the peak for so many points of the
// curve, a fifth of the expected strain: longer than any wave.
constexpr double slack_share = 0.1;
constexpr int slack_points = 100;

struct Schedule {
  int steps_per_sample;
  double expected_strain;    ///< of the ends, at the expected strength [1]
  double largest_strain;     ///< of the ends, when the test is given up [1]
  double stop_fraction;      ///< of the peak [1]
  std::size_t least_cracks;  ///< that a fracture through the core has
  bool may_part_unbroken;    ///< along joints that were never bonded
};

double share_bonded(const Rock& rock) {
  return 1.0 - rock.gapped_fraction - rock.slit_fraction;
}

double largest_strain(LabTest test, const Rock& rock, const LabSettings& settings) {
  if (settings.largest_strain > 0.0) return settings.largest_strain;
  const double times = settings.confining_pressure > 0.0 ? strains_under_pressure
                       : share_bonded(rock) < 1.0        ? strains_given_up_unbonded
                                                         : strains_given_up;
  return std::min(times * expected_strain(test, rock, settings.confining_pressure), most_strain);
}

void refuse_endless_test(LabTest test, const Rock& rock, const LabSettings& settings, const std::string& source) {
  const double rate = settings.strain_rate > 0.0 ? settings.strain_rate : default_strain_rate(test, rock, settings);
  const double largest = largest_strain(test, rock, settings), step = expected_step(rock);
  const double steps = largest / (rate * step);
  if (steps <= most_steps) return;
  throw base::InputError(fmt::format(
      "{}: strain rate {:.3g} /s: a test to a strain of {:.3g} would take {:.3g} steps of {:.3g} s (at most {:.0e}; a "
      "faster test takes fewer)",
      source, rate, largest, steps, step, most_steps));
}

Schedule plan(const LoadFrame& frame, const Rock& rock, const LabSettings& settings) {
  const double expected = expected_strain(frame.test, rock, settings.confining_pressure);
  const double rate = 2.0 * frame.end_speed / frame.length;
  const double strain_per_step = rate * frame.world.step;
  const double bonded = share_bonded(rock);
  const double steps = expected / strain_per_step / points_to_expected_strength;
  return {.steps_per_sample = std::max(1, static_cast<int>(std::lround(steps))),
          .expected_strain = expected,
          .largest_strain = largest_strain(frame.test, rock, settings),
          .stop_fraction = settings.stop_fraction > 0.0       ? settings.stop_fraction
                           : frame.test == LabTest::brazilian ? stop_fraction_brazilian
                                                              : stop_fraction_core,
          .least_cracks = static_cast<std::size_t>(
              std::max(1.0, bonded * (settings.width - settings.notch_length) / (2.0 * rock.radius_max))),
          .may_part_unbroken = bonded < 1.0};
}

/// Strength, moduli and crack initiation from the curve.
void fill_results(LabRun& run) {
  const auto refuse = [&run](const std::string& why) {
    throw base::SimulationError(
        fmt::format("{} test of seed {}: {}; the rock is too weak to be tested", name_of(run.test), run.seed, why));
  };
  const auto carries = [](const LabSample& sample) { return sample.stress > 0.0; };
  if (std::none_of(run.curve.begin(), run.curve.end(), carries)) refuse("the core never carried any load");
  const CurveResult result = read_curve(run.curve);
  const bool good = std::isfinite(result.youngs_modulus) && result.youngs_modulus > 0.0 &&
                    std::isfinite(result.poissons_ratio) && result.strain_at_peak > 0.0;
  if (!good)
    refuse(fmt::format("the strain at half the peak of {:.3g} MPa is not positive", result.peak_stress * 1e-6));
  const bool elastic = strains_evenly(run.test);
  run.peak_stress = result.peak_stress;
  run.fracture_toughness =
      run.test == LabTest::toughness ? stress_intensity(result.peak_stress, run.notch_length, run.width) : not_measured;
  run.strain_at_peak = result.strain_at_peak;
  run.youngs_modulus = elastic ? result.youngs_modulus : not_measured;
  run.poissons_ratio = elastic ? result.poissons_ratio : not_measured;
  run.cracks_at_half = result.cracks_at_half;
  run.uncracked_modulus = elastic ? result.uncracked_modulus : not_measured;
  run.uncracked_ratio = elastic ? result.uncracked_ratio : not_measured;
  run.crack_initiation_stress = result.crack_initiation_stress;
  run.cracks_at_peak = result.cracks_at_peak;
}

/// Median height of the cracks over the height of the core.
double fracture_height(const std::vector<Crack>& cracks, double height) {
  std::vector<double> heights;
  heights.reserve(cracks.size());
  for (const Crack& crack : cracks) heights.push_back(crack.y / height);
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

[[noreturn]] void give_up(const LabRun& run, const Schedule& schedule, double peak) {
  throw base::SimulationError(fmt::format(
      "{} test of seed {}: no strength found up to a strain of {:.3g} (largest stress {:.4g} MPa, {} cracks; "
      "the stress never fell to {:g} of its largest value with a fracture through the core); the rock may be too "
      "strong for its stiffness, have too few bonded joints, or carry on by the friction of broken ones",
      name_of(run.test), run.seed, schedule.largest_strain, peak * 1e-6, run.cracks_tensile + run.cracks_shear,
      schedule.stop_fraction));
}

/// What the two ends felt over one interval of the curve.
struct Interval {
  double stress;      ///< mean [Pa]
  double difference;  ///< between the ends, size of its mean [Pa]
};

Interval load_on(LoadFrame& frame, int steps) {
  double low = 0.0, high = 0.0;
  for (int step = 0; step < steps; ++step) {
    if (step % steps_between_looks == 0) base::throw_if_stopped();
    advance(frame);
    const EndForces force = end_forces(frame);
    low += force.low;
    high += force.high;
  }
  const double per = 1.0 / (steps * frame.section);
  return {.stress = 0.5 * (low + high) * per, .difference = std::fabs(low - high) * per};
}

/// Loads until the stress has fallen to the stop fraction of its peak, and fills curve, counts and imbalance.
/// A fracture through the core breaks at least one element for each grain on its way: what fell with fewer was a wave,
/// or a grain crushed at a platen. Where the fracture follows joints that were never bonded it breaks fewer: then a
/// core that stays slack is severed too.
void load_to_failure(LoadFrame& frame, const Schedule& schedule, LabRun& run, const base::ProgressCallback& progress) {
  double peak = 0.0, sum_of_differences = 0.0;
  std::size_t counted = 0;
  int slack = 0;  // points in a row
  bool broken = false;
  while (!broken) {
    const Interval interval = load_on(frame, schedule.steps_per_sample);
    run.steps += schedule.steps_per_sample;
    require_finite(frame.world);
    const std::vector<Crack>& cracks = frame.world.cracks;
    for (; counted < cracks.size(); ++counted)
      ++(cracks[counted].mode == ElementState::broken_in_tension ? run.cracks_tensile : run.cracks_shear);
    const CoreStrain strain = core_strain(frame);
    if (!std::isfinite(strain.along + strain.across))
      throw base::SimulationError(
          fmt::format("{} test of seed {}: the middle of the core is gone, no strain can be measured",
                      name_of(run.test), run.seed));
    const double ends = end_strain(frame);
    run.curve.push_back({.strain = strains_evenly(frame.test) ? strain.along : ends,
                         .lateral_strain = strain.across,
                         .stress = interval.stress,
                         .cracks_tensile = run.cracks_tensile,
                         .cracks_shear = run.cracks_shear});
    sum_of_differences += interval.difference;
    if (interval.stress > peak) {
      peak = interval.stress;
      run.imbalance = sum_of_differences / static_cast<double>(run.curve.size()) / peak;
    }
    if (progress) progress(std::min(ends, schedule.expected_strain), schedule.expected_strain);
    slack = interval.stress <= slack_share * peak ? slack + 1 : 0;
    const bool severed = schedule.may_part_unbroken && counted > 0 && slack >= slack_points;
    broken = severed || (counted >= schedule.least_cracks && interval.stress <= schedule.stop_fraction * peak);
    if (broken || ends < schedule.largest_strain) continue;
    if (run.confining_pressure == 0.0) give_up(run, schedule, peak);
    return;  // it goes on by friction
  }
}

}  // namespace

const char* name_of(LabTest test) {
  switch (test) {
    case LabTest::ucs:
      return "ucs";
    case LabTest::tension:
      return "tension";
    case LabTest::brazilian:
      return "brazilian";
    case LabTest::triaxial:
      return "triaxial";
    case LabTest::toughness:
      return "toughness";
  }
  return "";
}

LabTest lab_test_named(const std::string& name) {
  for (const LabTest test : lab_tests) {
    if (name == name_of(test)) return test;
  }
  throw base::InputError(fmt::format("test '{}' (must be ucs, tension, brazilian, triaxial or toughness)", name));
}

LabBox specimen_box(LabTest test, const LabSettings& settings) {
  return {settings.width, test == LabTest::brazilian ? settings.width : settings.height};
}

void check_lab_settings(LabTest test, const Rock& rock, const LabSettings& settings, const std::string& source) {
  const LabBox box = specimen_box(test, settings);
  check_specimen_size(rock, box.width, box.height, source);
  if (rock.fine_depth > 0.0)
    throw base::InputError(source + ": grading.fine_depth_mm is not 0 (a core for tests is of one size of grains)");
  const auto require = [&source](bool good, const char* name, double seen, const std::string& allowed) {
    if (!good) throw base::InputError(fmt::format("{}: {} = {:g} (must be {})", source, name, seen, allowed));
  };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  require(within(settings.strain_rate, 0.0, 1e4), "strain rate", settings.strain_rate, "0 to 1e4 /s");
  require(within(settings.local_damping, 0.0, 0.95), "local damping", settings.local_damping, "0 to 0.95");
  require(within(settings.platen_friction, 0.0, 10.0), "platen friction", settings.platen_friction, "0 to 10");
  require(within(settings.stop_fraction, 0.0, 0.99), "stop fraction", settings.stop_fraction, "0 to 0.99");
  require(within(settings.largest_strain, 0.0, 0.9), "largest strain", settings.largest_strain, "0 to 0.9");
  require(confining_pressure_MPa.contains(settings.confining_pressure / base::MPa), "confining pressure [Pa]",
          settings.confining_pressure, "0 to 1e9");
  if (test != LabTest::triaxial)
    require(settings.confining_pressure == 0.0, "confining pressure [Pa]", settings.confining_pressure,
            "0 but in a triaxial test");
  if (test == LabTest::toughness) {
    require(
        notch_over_width.contains(settings.notch_length / settings.width), "length of the notch [mm]",
        settings.notch_length / base::mm,
        fmt::format("{:g} to {:g}: {:g} to {:g} of the width", notch_over_width.low * settings.width / base::mm,
                    notch_over_width.high * settings.width / base::mm, notch_over_width.low, notch_over_width.high));
  } else {
    require(settings.notch_length == 0.0, "length of the notch [mm]", settings.notch_length / base::mm,
            "0 but in a toughness test");
  }
  if (pulls(test)) {
    const double grip = grip_height(rock.radius_max, settings);
    require(settings.grip_height >= 0.0 && 2.0 * grip <= 0.5 * settings.height, "grip height [mm]", 1e3 * grip,
            "at most a quarter of the core's height: shorter grips or a longer core");
  }
  refuse_endless_test(test, rock, settings, source);
}

std::vector<std::string> warnings(LabTest test, const Rock& rock, const LabSettings& settings) {
  const double largest = 2.0 * rock.radius_max;
  if (settings.width >= least_grains * largest) return {};
  return {
      fmt::format("{} test: the core is {:.3g} mm wide, {:.2g} of the largest grains (diameter {:.3g} mm); a "
                  "laboratory asks for at least {:g}, and with fewer a strength is that of single grains",
                  name_of(test), settings.width * 1e3, settings.width / largest, largest * 1e3, least_grains)};
}

std::vector<std::string> warnings(const LabRun& run) {
  if (!(run.poissons_ratio > largest_elastic_ratio) || run.cracks_at_half == 0) return {};
  const std::string before = std::isfinite(run.uncracked_ratio)
                                 ? fmt::format("before the first one nu is {:.3f} and E {:.4g} GPa",
                                               run.uncracked_ratio, run.uncracked_modulus * 1e-9)
                                 : std::string("no part of the curve is without them");
  return {fmt::format(
      "{} test of seed {}: nu = {:.3f} is not that of an elastic body: {} cracks lie below half the strength, "
      "to which E and nu are measured, and nu is their opening; {}",
      name_of(run.test), run.seed, run.poissons_ratio, run.cracks_at_half, before)};
}

LabRun run_lab_test(LabTest test, const Specimen& specimen, const LabSettings& settings,
                    const base::ProgressCallback& progress) {
  const auto started = std::chrono::steady_clock::now();
  check_lab_settings(test, specimen.rock, settings, std::string(name_of(test)) + " test");
  const LabBox box = specimen_box(test, settings);
  if (specimen.width != box.width || specimen.height != box.height) {
    throw base::InputError(fmt::format("{} test: the specimen is {:.6g} x {:.6g} mm (wanted is {:.6g} x {:.6g} mm)",
                                       name_of(test), specimen.width * 1e3, specimen.height * 1e3, box.width * 1e3,
                                       box.height * 1e3));
  }
  LoadFrame frame = make_load_frame(test, specimen, settings);
  const Schedule schedule = plan(frame, specimen.rock, settings);
  LabRun run{.test = test, .seed = specimen.seed, .width = specimen.width, .height = specimen.height};
  run.confining_pressure = settings.confining_pressure;
  run.notch_length = settings.notch_length;
  run.discs = frame.world.discs.count();
  run.joints = frame.world.joints.count();
  run.strain_rate = 2.0 * frame.end_speed / frame.length;
  run.step = frame.world.step;
  load_to_failure(frame, schedule, run, progress);
  fill_results(run);
  run.fracture_height = pulls(test) ? fracture_height(frame.world.cracks, specimen.height) : not_measured;
  run.last = state_of(frame);
  run.cracks = std::move(frame.world.cracks);
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return run;
}

}  // namespace bitrock::dem2d
