#include "dem2d/lab/load_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/errors.hpp"
#include "dem2d/lab/loading_rate.hpp"
#include "dem2d/lab/notch.hpp"
#include "dem2d/lab/strain.hpp"
#include "dem2d/specimen/bonded_world.hpp"
#include "dem2d/specimen/pieces.hpp"
#include "dem2d/specimen/press.hpp"
#include "dem2d/step/neighbours.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

// Held discs are this much heavier, so that no force moves them: F/m is then lost in rounding against their velocity.
constexpr double held_mass_factor = 1e12;

// Each grip holds at least this many largest diameters, so that no free disc lies beyond it.
constexpr double least_grip_diameters = 1.5;

// Only to start the core with the velocity field of uniform straining, nearly: what is wrong with it dies in waves
// that are the smaller the slower the test is.
constexpr double starting_poissons_ratio = 0.2;

// Pieces that flew this many lengths away are removed; nothing that loads the core comes from there.
constexpr double domain_lengths = 10.0;

/// The discs that lie wholly in the circle inscribed in the specimen's box, with their joints.
Specimen inscribed_disc(const Specimen& box) {
  Specimen disc{.rock = box.rock, .width = box.width, .height = box.height, .seed = box.seed};
  disc.equilibrium_ratio = box.equilibrium_ratio;
  const double middle = 0.5 * box.width;
  std::vector<int> renumbered(box.x.size(), -1);
  for (std::size_t i = 0; i < box.x.size(); ++i) {
    if (std::hypot(box.x[i] - middle, box.y[i] - middle) + box.radius[i] > middle) continue;
    renumbered[i] = static_cast<int>(disc.x.size());
    disc.x.push_back(box.x[i]);
    disc.y.push_back(box.y[i]);
    disc.radius.push_back(box.radius[i]);
  }
  for (std::size_t k = 0; k < box.disc1.size(); ++k) {
    const int first = renumbered[static_cast<std::size_t>(box.disc1[k])],
              second = renumbered[static_cast<std::size_t>(box.disc2[k])];
    if (first < 0 || second < 0) continue;
    disc.disc1.push_back(first);
    disc.disc2.push_back(second);
  }
  return disc;
}

void add_platens(LoadFrame& frame, const Rock& rock, double friction) {
  const Discs& discs = frame.world.discs;
  const auto [left, right] = std::minmax_element(discs.x.begin(), discs.x.end());
  const double x_low = *left - frame.length, x_high = *right + frame.length;
  for (const bool upper : {false, true}) {
    const double y_low = upper ? frame.high : frame.low - frame.length;
    Boundary platen{.shape = rectangle(x_low, y_low, x_high, y_low + frame.length),
                    .velocity_y = (upper ? 1.0 : -1.0) * frame.direction * frame.end_speed,
                    .modulus = rock.contact_modulus,
                    .stiffness_ratio = rock.contact_stiffness_ratio,
                    .friction = friction,
                    .damping_ratio = rock.contact_damping_ratio};
    forgive_overlaps(platen, discs);
    frame.world.boundaries.push_back(platen);
  }
}

void hold_ends(LoadFrame& frame) {
  Discs& discs = frame.world.discs;
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    frame.held[i] = discs.y[i] < frame.low ? 1 : discs.y[i] > frame.high ? 2 : 0;
    if (frame.held[i] == 0) continue;
    set_mass(discs, i, discs.mass[i] * held_mass_factor, discs.inertia[i] * held_mass_factor);
  }
}

/// Discs keep the number they were born with when others leave; their places change.
void find_places(LoadFrame& frame) {
  frame.held_low.clear();
  frame.held_high.clear();
  frame.gauge.clear();
  const Discs& discs = frame.world.discs;
  for (int place = 0; place < discs.count(); ++place) {
    const auto born = static_cast<std::size_t>(discs.id[static_cast<std::size_t>(place)]);
    if (frame.held[born] == 1) frame.held_low.push_back(place);
    if (frame.held[born] == 2) frame.held_high.push_back(place);
    if (frame.measured[born] != 0) frame.gauge.push_back(place);
  }
}

void move_held(LoadFrame& frame) {
  Discs& discs = frame.world.discs;
  const double speed = frame.direction * frame.end_speed;
  const auto move = [&discs](const std::vector<int>& places, double velocity) {
    for (const int place : places) {
      const auto i = static_cast<std::size_t>(place);
      discs.velocity_x[i] = 0.0;
      discs.velocity_y[i] = velocity;
      discs.spin[i] = 0.0;
    }
  };
  move(frame.held_low, -speed);
  move(frame.held_high, speed);
}

void start_straining(LoadFrame& frame) {
  Discs& discs = frame.world.discs;
  const auto [left, right] = std::minmax_element(discs.x.begin(), discs.x.end());
  const double middle_x = 0.5 * (*left + *right);
  const double rate = frame.direction * 2.0 * frame.end_speed / frame.length;
  const double middle_y = 0.5 * (frame.low + frame.high);
  for (std::size_t i = 0; i < discs.x.size(); ++i) {
    discs.velocity_x[i] = -starting_poissons_ratio * rate * (discs.x[i] - middle_x);
    discs.velocity_y[i] = rate * (discs.y[i] - middle_y);
  }
}

/// Platens of the Brazilian test touch the outermost discs; those of a core lie at its flat ends.
void place_ends(LoadFrame& frame, const Specimen& specimen, const LabSettings& settings) {
  frame.low = 0.0;
  frame.high = specimen.height;
  if (pulls(frame.test)) {
    const double grip = grip_height(*std::max_element(specimen.radius.begin(), specimen.radius.end()), settings);
    frame.low = grip;
    frame.high = specimen.height - grip;
  }
  if (frame.test == LabTest::brazilian) {
    frame.low = specimen.height;
    frame.high = 0.0;
    for (std::size_t i = 0; i < specimen.y.size(); ++i) {
      frame.low = std::min(frame.low, specimen.y[i] - specimen.radius[i]);
      frame.high = std::max(frame.high, specimen.y[i] + specimen.radius[i]);
    }
  }
  frame.length = frame.high - frame.low;
}

/// Joints across the cut are as if they had never been bonded.
void saw(World& world, const Notch& notch) {
  FlatJoints& joints = world.joints;
  const auto elements = static_cast<std::size_t>(joints.elements);
  for (std::size_t k = 0; k < joints.bonded.size(); ++k) {
    const auto i = static_cast<std::size_t>(joints.disc1[k]), j = static_cast<std::size_t>(joints.disc2[k]);
    if (!parts(notch, world.discs.x[i], world.discs.y[i], world.discs.x[j], world.discs.y[j])) continue;
    joints.bonded[k] = 0;
    std::fill_n(joints.state.begin() + static_cast<std::ptrdiff_t>(k * elements), elements, ElementState::never_bonded);
  }
}

/// Brings the core to rest in the fluid of the cell; the ends, the section and the start of all strains are then those
/// of the pressed core.
void confine(LoadFrame& frame, const Rock& rock, const LabSettings& settings) {
  World& world = frame.world;
  world.mud.seal_gap = usual_seal_gap_over_radius * rock.radius_min;
  prepare(world);
  world.step = critical_step(world);
  press(world, rock, settings.confining_pressure, "the confining pressure [MPa]");
  const DisplacementGradient strain = fit_gradient(frame.start_x, frame.start_y, world.discs.x, world.discs.y);
  const auto mean = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  };
  const double middle_before = mean(frame.start_y), middle = mean(world.discs.y);
  for (double* end : {&frame.low, &frame.high}) *end = middle + (*end - middle_before) * (1.0 + strain.yy);
  frame.length = frame.high - frame.low;
  frame.section *= 1.0 + strain.xx;
  frame.start_x = world.discs.x;
  frame.start_y = world.discs.y;
}

}  // namespace

double grip_height(double largest_radius, const LabSettings& settings) {
  return std::max(settings.grip_height, least_grip_diameters * 2.0 * largest_radius);
}

LoadFrame make_load_frame(LabTest test, const Specimen& box, const LabSettings& settings) {
  const Specimen specimen = test == LabTest::brazilian ? inscribed_disc(box) : box;
  LoadFrame frame{.test = test};
  place_ends(frame, specimen, settings);
  const double rate =
      settings.strain_rate > 0.0 ? settings.strain_rate : default_strain_rate(test, specimen.rock, settings);
  frame.direction = pulls(test) ? 1.0 : -1.0;
  frame.section = test == LabTest::brazilian ? 0.5 * std::numbers::pi * frame.length : specimen.width;

  World& world = frame.world;
  world = bonded_world(specimen, 1);
  if (test == LabTest::toughness) saw(world, middle_notch(specimen, settings.notch_length));
  world.materials.local_damping = settings.local_damping;
  const double margin = domain_lengths * std::max(specimen.width, specimen.height);
  world.domain = {-margin, -margin, specimen.width + margin, specimen.height + margin};
  frame.start_x = world.discs.x;
  frame.start_y = world.discs.y;
  if (settings.confining_pressure > 0.0) confine(frame, specimen.rock, settings);
  frame.end_speed = 0.5 * rate * frame.length;
  const std::size_t discs = world.discs.x.size();
  frame.held.assign(discs, 0);
  frame.measured.assign(discs, 0);
  const double middle_y = 0.5 * (frame.low + frame.high);
  for (std::size_t i = 0; i < discs; ++i) {
    frame.measured[i] = std::fabs(frame.start_y[i] - middle_y) <= 0.25 * specimen.height ? 1 : 0;
  }
  if (test != LabTest::brazilian) start_straining(frame);
  if (pulls(test)) {
    hold_ends(frame);
  } else {
    add_platens(frame, specimen.rock, settings.platen_friction);
  }
  find_places(frame);
  if (pulls(test) && (frame.held_low.empty() || frame.held_high.empty()))
    throw base::InputError(std::string(name_of(test)) +
                           " test: no disc lies in a grip (the discs must fill the box of the specimen)");
  prepare(world);
  world.step = critical_step(world);
  return frame;
}

void advance(LoadFrame& frame) {
  const int before = frame.world.discs.count();
  move_held(frame);
  advance(frame.world);
  frame.travelled += frame.end_speed * frame.world.step;
  if (frame.world.discs.count() != before) find_places(frame);
}

EndForces end_forces(const LoadFrame& frame) {
  const World& world = frame.world;
  if (!pulls(frame.test)) return {-world.boundaries[0].force_y, world.boundaries[1].force_y};
  const auto sum = [&world](const std::vector<int>& places) {
    double force = 0.0;
    for (const int place : places) force += world.discs.force_y[static_cast<std::size_t>(place)];
    return force;
  };
  return {sum(frame.held_low), -sum(frame.held_high)};
}

CoreStrain core_strain(const LoadFrame& frame) {
  const Discs& discs = frame.world.discs;
  const std::size_t count = frame.gauge.size();
  std::vector<double> start_x(count), start_y(count), x(count), y(count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto place = static_cast<std::size_t>(frame.gauge[k]);
    const auto born = static_cast<std::size_t>(discs.id[place]);
    start_x[k] = frame.start_x[born];
    start_y[k] = frame.start_y[born];
    x[k] = discs.x[place];
    y[k] = discs.y[place];
  }
  const DisplacementGradient gradient = fit_gradient(start_x, start_y, x, y);
  return {frame.direction * gradient.yy, frame.direction * gradient.xx};
}

double end_strain(const LoadFrame& frame) {
  return 2.0 * frame.travelled / frame.length;
}

LabState state_of(const LoadFrame& frame) {
  const Discs& discs = frame.world.discs;
  const double moved = frame.direction * frame.travelled;
  return {.x = discs.x,
          .y = discs.y,
          .radius = discs.radius,
          .id = discs.id,
          .fragment = label_pieces(frame.world),
          .low = frame.low - moved,
          .high = frame.high + moved};
}

}  // namespace bitrock::dem2d
