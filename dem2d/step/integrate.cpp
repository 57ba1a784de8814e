// The motion pass. Compiled once for each vector unit.
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include <algorithm>
#include <limits>

#include "dem2d/step/stages.hpp"

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/integrate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace bitrock::dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// local_damping.hpp, lane by lane.
template <class D, class V = hn::Vec<D>>
V local_damping(D d, V force, V velocity, V alpha) {
  return hn::IfThenZeroElse(hn::Eq(velocity, hn::Zero(d)), hn::CopySign(alpha * hn::Abs(force), velocity));
}

/// As many discs as D has lanes, from i on. Returns by how much they have strayed from where they
/// were listed (World::lists.most_strayed).
template <bool measured, class D>
hn::Vec<D> move_discs(World& world, std::size_t i, D d) {
  Discs& discs = world.discs;
  const auto load = [d, i](const std::vector<double>& values) HWY_ATTR { return hn::LoadU(d, &values[i]); };
  const auto store = [d, i](auto v, std::vector<double>& values) HWY_ATTR { hn::StoreU(v, d, &values[i]); };
  const auto dt = hn::Set(d, world.step), alpha = hn::Set(d, world.materials.local_damping);
  const auto force_x = load(discs.force_x), force_y = load(discs.force_y), moment = load(discs.moment);
  const auto velocity_x = load(discs.velocity_x), velocity_y = load(discs.velocity_y), spin = load(discs.spin);
  const auto inverse_mass = load(discs.inverse_mass), inverse_inertia = load(discs.inverse_inertia);
  const auto loss_x = local_damping(d, force_x, velocity_x, alpha);
  const auto loss_y = local_damping(d, force_y, velocity_y, alpha);
  const auto loss_moment = local_damping(d, moment, spin, alpha);
  const auto gain_x = (force_x - loss_x) * inverse_mass * dt;
  const auto gain_y = (force_y - loss_y) * inverse_mass * dt;
  const auto gain_spin = (moment - loss_moment) * inverse_inertia * dt;
  if constexpr (measured) {  // force times the mean of the velocities before and after (step/energy.hpp)
    const auto half = hn::Set(d, 0.5);
    store(
        load(discs.damping_loss) + dt * (loss_x * (velocity_x + half * gain_x) + loss_y * (velocity_y + half * gain_y) +
                                         loss_moment * (spin + half * gain_spin)),
        discs.damping_loss);
  }
  const auto new_velocity_x = velocity_x + gain_x, new_velocity_y = velocity_y + gain_y, new_spin = spin + gain_spin;
  const auto x = load(discs.x) + new_velocity_x * dt, y = load(discs.y) + new_velocity_y * dt;
  store(new_velocity_x, discs.velocity_x);
  store(new_velocity_y, discs.velocity_y);
  store(new_spin, discs.spin);
  store(x, discs.x);
  store(y, discs.y);
  store(load(discs.angle) + new_spin * dt, discs.angle);
  const auto dx = x - load(world.lists.listed_x), dy = y - load(world.lists.listed_y),
             margin = load(world.lists.listed_margin);
  return dx * dx + dy * dy - margin * margin;
}

template <bool measured>
double move_range(World& world, const Range& range) {
  const hn::ScalableTag<double> all_lanes;
  const hn::CappedTag<double, 1> one_lane;
  constexpr double nothing = -std::numeric_limits<double>::max();
  auto largest = hn::Set(all_lanes, nothing);
  std::size_t i = range.begin;
  for (; i + hn::Lanes(all_lanes) <= range.end; i += hn::Lanes(all_lanes)) {
    largest = hn::Max(largest, move_discs<measured>(world, i, all_lanes));
  }
  auto rest = hn::Set(one_lane, nothing);
  for (; i < range.end; ++i) rest = hn::Max(rest, move_discs<measured>(world, i, one_lane));
  return std::max(hn::GetLane(hn::MaxOfLanes(all_lanes, largest)), hn::GetLane(rest));
}

double MoveDiscs(World& world, const Range& range) {
  return world.ledger.measured ? move_range<true>(world, range) : move_range<false>(world, range);
}

}  // namespace bitrock::dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bitrock::dem2d {

HWY_EXPORT(MoveDiscs);

void integrate(World& world, const Share& share) {
  const Range range = part_of(world.discs.x.size(), share);
  world.lists.most_strayed[static_cast<std::size_t>(share.thread)] = HWY_DYNAMIC_DISPATCH(MoveDiscs)(world, range);
}

}  // namespace bitrock::dem2d
#endif
