#include "dem2d/specimen/press.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/stop.hpp"
#include "dem2d/step/energy.hpp"
#include "dem2d/step/step.hpp"

namespace bitrock::dem2d {

namespace {

// A wave crosses the rock so often while the pressure rises, and at most so often more until it is at rest.
constexpr double transits_of_the_ramp = 10.0, most_transits = 200.0;
constexpr double damping = 0.7;       // of what swings meanwhile [1], the usual local damping of a static problem
constexpr double rest_ratio = 1e-5;   // unbalanced over contact forces [1]
constexpr int check_interval = 100;   // steps between two looks at it
constexpr double most_broken = 0.01;  // of the elements: rock that the pressure alone breaks is another rock [1]

double extent(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// Time that a wave takes along the longer side, by the stiffness of the joints: sqrt(E* / rho) [s].
double transit(const World& world, const Rock& rock) {
  const double length = std::max(extent(world.discs.x), extent(world.discs.y));
  return length / std::sqrt(rock.joint_modulus / rock.density);
}

long long come_to_rest(World& world, const Rock& rock, double pressure, const std::string& key,
                       const base::ProgressCallback& progress) {
  const double time = transit(world, rock);
  const auto ramp = static_cast<long long>(std::ceil(transits_of_the_ramp * time / world.step));
  const auto most = ramp + static_cast<long long>(std::ceil(most_transits * time / world.step));
  double ratio = 1.0;
  for (long long step = 0; step < most; ++step) {
    const double share = std::min(1.0, static_cast<double>(step + 1) / static_cast<double>(ramp));
    world.mud.pressure = share * pressure;
    find_forces(world);
    const bool looks = step % check_interval == 0;
    if (looks && share == 1.0) ratio = equilibrium_ratio(world);
    move(world);
    if (ratio <= rest_ratio) return step + 1;
    if (!looks) continue;
    base::throw_if_stopped();
    if (progress) progress(share, 1.0);
  }
  throw base::SimulationError(
      fmt::format("the rock does not come to rest under {} = {:.4g} in {} steps (unbalanced over contact force {:.2g}, "
                  "wanted {:.0e}); is the pressure more than the rock bears?",
                  key, pressure * 1e-6, most, ratio, rest_ratio));
}

void refuse_broken_rock(const World& world, double pressure, const std::string& key) {
  const auto elements = static_cast<double>(world.joints.state.size());
  const auto broken = static_cast<double>(world.cracks.size());
  if (broken <= most_broken * elements) return;
  throw base::SimulationError(
      fmt::format("{} = {:.4g}: the pressure alone breaks {:.2g} % of the rock (at most {:g} %); take less pressure or "
                  "a stronger rock",
                  key, pressure * 1e-6, 100.0 * broken / elements, 100.0 * most_broken));
}

/// What follows begins here: at rest, at time 0, with nothing lost yet.
void begin_anew(World& world) {
  for (std::vector<double>* zero :
       {&world.discs.velocity_x, &world.discs.velocity_y, &world.discs.spin, &world.discs.damping_loss,
        &world.joints.friction_loss, &world.joints.switching_loss, &world.joints.breaking_loss}) {
    std::fill(zero->begin(), zero->end(), 0.0);
  }
  book_contact_losses(world);
  world.ledger.accounts = {};
  world.mud.work = 0.0;
  world.cracks.clear();
  world.time = 0.0;
}

}  // namespace

Pressed press(World& world, const Rock& rock, double pressure, const std::string& key,
              const base::ProgressCallback& progress) {
  Pressed pressed;
  const double own_damping = world.materials.local_damping;
  world.materials.local_damping = damping;
  pressed.steps = come_to_rest(world, rock, pressure, key, progress);
  refuse_broken_rock(world, pressure, key);
  pressed.cracks = static_cast<int>(world.cracks.size());
  world.materials.local_damping = own_damping;
  begin_anew(world);
  return pressed;
}

}  // namespace bitrock::dem2d
