// See damaged_joints.hpp. This file is compiled once for each vector unit (Highway's foreach_target).
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include "dem2d/step/damaged_joints.hpp"

#include <bit>

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/damaged_joints.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dem2d/step/lanes-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace bitrock::dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class V>
struct Gaps {
  V a, b;  ///< at the two ends of the element [m]
};

/// What one element does and holds, by its normal springs alone.
template <class V>
struct NormalSprings {
  V force, moment;  ///< N, m (flat_joint.hpp)
  V stored;         ///< U without its shear part (flat_joint_energy.hpp)
};

template <class V>
struct Element {
  V kn, length, kn_length;
};

/// `bonded_resultant`, and the energy of an element that is closed or bonded.
template <class D, class V = hn::Vec<D>>
HWY_INLINE NormalSprings<V> closed_springs(D d, const Element<V>& element, const Gaps<V>& gaps) {
  const auto [a, b] = gaps;
  return {element.kn_length * (a + b) * hn::Set(d, 0.5),
          element.kn_length * element.length * (b - a) / hn::Set(d, 12.0),
          element.kn_length * (a * a + a * b + b * b) / hn::Set(d, 6.0)};
}

/// `unbonded_resultant` and `stored_energy` of an element that is not bonded; `closed` are its springs if it were.
template <class D, class V = hn::Vec<D>>
HWY_INLINE NormalSprings<V> unbonded_springs(D d, const Element<V>& element, const Gaps<V>& gaps,
                                             const NormalSprings<V>& closed) {
  const auto [a, b] = gaps;
  const auto zero = hn::Zero(d), half = hn::Set(d, 0.5);
  const auto presses_at_a = hn::Lt(a, zero);
  const auto pressed = hn::IfThenElse(presses_at_a, a, b), open = hn::IfThenElse(presses_at_a, b, a);
  const auto part = element.length * pressed / (pressed - open);  // l, the part that is closed
  const auto force = element.kn * pressed * part * half;
  const auto arm = part / hn::Set(d, 3.0) - element.length * half;
  const NormalSprings<V> partly{force, force * hn::IfThenElse(presses_at_a, arm, hn::Neg(arm)),
                                element.kn * part * pressed * pressed / hn::Set(d, 6.0)};
  const auto all_closed = hn::And(hn::Le(a, zero), hn::Le(b, zero));
  const auto all_open = hn::And(hn::Ge(a, zero), hn::Ge(b, zero));
  const auto choose = [&](V whole, V partial)
                          HWY_ATTR { return hn::IfThenElse(all_closed, whole, hn::IfThenZeroElse(all_open, partial)); };
  return {choose(closed.force, partly.force), choose(closed.moment, partly.moment),
          choose(closed.stored, partly.stored)};
}

/// `sliding_strength` and the clamp to it. Comparisons in the order of std::min and std::max: signs of zeros are kept.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V slide(D d, V trial, V stress, V friction, V cohesion) {
  const auto limit = hn::IfThenElseZero(hn::Lt(stress, hn::Zero(d)), cohesion - friction * stress);
  const auto lower = hn::Neg(limit), above = hn::IfThenElse(hn::Lt(trial, lower), lower, trial);
  return hn::IfThenElse(hn::Lt(limit, above), limit, above);
}

/// `switching` of flat_joint_energy.hpp: the work of the normal springs that is not stored. An element that is closed
/// before and after is linear: nothing to book.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V switching(D d, V length, const Gaps<V>& before, const Gaps<V>& after, const NormalSprings<V>& then,
                       const NormalSprings<V>& now) {
  const auto half = hn::Set(d, 0.5), zero = hn::Zero(d);
  const auto opening = half * (after.a + after.b - before.a - before.b);
  const auto tilting = (after.b - after.a - before.b + before.a) / length;
  const auto work = half * (then.force + now.force) * opening + half * (then.moment + now.moment) * tilting;
  const auto open = hn::Max(hn::Max(before.a, before.b), hn::Max(after.a, after.b));  // somewhere, before or after
  return hn::IfThenElseZero(hn::Gt(open, zero), work - (now.stored - then.stored));
}

/// Lanes whose element `e` is in each state.
template <class M>
struct States {
  M bonded, broken_in_shear;
};

template <class D>
HWY_INLINE States<hn::Mask<D>> states_of(D d, const FlatJoints& joints, const int* joint, int e) {
  std::uint8_t bonded[8] = {}, broken_in_shear[8] = {};
  for (std::size_t lane = 0; lane < hn::MaxLanes(d); ++lane) {
    const auto element =
        static_cast<std::size_t>(joint[lane]) * static_cast<std::size_t>(joints.elements) + static_cast<std::size_t>(e);
    const ElementState state = joints.state[element];
    bonded[0] |= static_cast<std::uint8_t>((state == ElementState::bonded ? 1U : 0U) << lane);
    broken_in_shear[0] |= static_cast<std::uint8_t>((state == ElementState::broken_in_shear ? 1U : 0U) << lane);
  }
  return {hn::LoadMaskBits(d, bonded), hn::LoadMaskBits(d, broken_in_shear)};
}

template <std::size_t lanes>
struct alignas(64) Column {
  double lane[lanes];
};

/// As many joints as D has lanes. Returns the lanes that are left to the reference path.
template <bool measured, class D, class V = hn::Vec<D>>
HWY_INLINE std::uint64_t a_vector_of_joints(World& world, const int* joint, D d) {
  constexpr std::size_t lanes = hn::MaxLanes(D());
  FlatJoints& joints = world.joints;
  const int elements = joints.elements;
  const auto of_joint = [&](const std::vector<double>& v) HWY_ATTR { return pick(d, v.data(), joint); };
  const auto half = hn::Set(d, 0.5), dt = hn::Set(d, world.step), zero = hn::Zero(d);
  int first[lanes], second[lanes];
  std::uint64_t left = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto j = static_cast<std::size_t>(joint[lane]);
    first[lane] = joints.disc1[j];
    second[lane] = joints.disc2[j];
    const bool softens = !joints.softened.empty() && joints.softened[j] > 0;
    left |= (softens || joints.bonded[j] == elements ? std::uint64_t{1} : 0) << lane;
  }
  const auto one = motion_of(d, world.room.motion.data(), first), two = motion_of(d, world.room.motion.data(), second);
  const auto pair = pair_of(d, one, two, of_joint(joints.radius_difference));

  const auto gap = pair.distance - of_joint(joints.touching_distance);
  const auto rotation = two.angle - one.angle - of_joint(joints.stress_free_rotation);
  const auto gap_before = gap - pair.normal_speed * dt, rotation_before = rotation - (two.spin - one.spin) * dt;
  const auto shear_increment = pair.shear_speed * dt;
  const auto R = of_joint(joints.half_length), kn = of_joint(joints.normal_stiffness);
  const auto ks = of_joint(joints.shear_stiffness), friction = of_joint(joints.friction);
  const auto residual_cohesion = hn::Set(d, joints.residual_cohesion);
  const auto length = hn::Set(d, 2.0) * R / hn::Set(d, static_cast<double>(elements));
  const Element<V> element{kn, length, kn * length};

  auto pull = zero, shear = zero, moment = zero, friction_loss = zero, switching_loss = zero;
  if constexpr (measured) {
    friction_loss = of_joint(joints.friction_loss);
    switching_loss = of_joint(joints.switching_loss);
  }
  Column<lanes> fresh_shear[max_elements];
  for (int e = 0; e < elements; ++e) {
    const auto start = length * hn::Set(d, static_cast<double>(e)) - R, end = start + length;
    const Gaps<V> gaps{gap - rotation * start, gap - rotation * end};
    int place[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) place[lane] = joint[lane] * elements + e;
    const auto shear_before = pick(d, joints.element_shear_stress.data(), place);
    const auto [is_bonded, broken_in_shear] = states_of(d, joints, joint, e);

    const auto closed = closed_springs(d, element, gaps), unbonded = unbonded_springs(d, element, gaps, closed);
    const auto force = hn::IfThenElse(is_bonded, closed.force, unbonded.force);
    const auto trial = shear_before + ks * shear_increment, stress = force / length;
    const auto slid = slide(d, trial, stress, friction, hn::IfThenElseZero(broken_in_shear, residual_cohesion));
    const auto shear_after = hn::IfThenElse(is_bonded, trial, slid);
    if (!hn::AllFalse(d, is_bonded)) {
      const auto strength = of_joint(joints.cohesion) - stress * of_joint(joints.tan_friction_angle);
      const auto breaks =
          hn::Or(hn::Ge(stress, of_joint(joints.tensile_strength)), hn::Ge(hn::Abs(trial), hn::Max(zero, strength)));
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, hn::And(is_bonded, breaks), bits);
      left |= bits[0];
    }
    hn::Store(shear_after, d, fresh_shear[e].lane);
    pull = pull + force;
    shear = shear + shear_after * length;
    moment = moment + ((start + length * half) * force + hn::IfThenElse(is_bonded, closed.moment, unbonded.moment));
    if constexpr (measured) {
      const auto slip = shear_increment - (shear_after - shear_before) / ks;
      const auto lost = length * (half * (shear_before + shear_after)) * slip;
      friction_loss = friction_loss + hn::IfThenZeroElse(is_bonded, lost);
      const Gaps<V> before{gap_before - rotation_before * start, gap_before - rotation_before * end};
      const auto then = unbonded_springs(d, element, before, closed_springs(d, element, before));
      switching_loss =
          switching_loss + hn::IfThenZeroElse(is_bonded, switching(d, length, before, gaps, then, unbonded));
    }
  }

  alignas(64) PairForce force[lanes];
  store_pair_forces(d, pair, pull, shear, moment, force);
  Column<lanes> slipped, friction_lost, switching_lost;
  hn::Store(shear_increment, d, slipped.lane);
  hn::Store(friction_loss, d, friction_lost.lane);
  hn::Store(switching_loss, d, switching_lost.lane);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    if ((left >> lane & 1) != 0) continue;
    const auto j = static_cast<std::size_t>(joint[lane]);
    world.room.joint_forces[j] = force[lane];
    double* const shear_stress = &joints.element_shear_stress[j * static_cast<std::size_t>(elements)];
    for (int e = 0; e < elements; ++e) shear_stress[e] = fresh_shear[e].lane[lane];
    joints.shear_stress[j] = shear_stress[0];
    joints.shear_displacement[j] += slipped.lane[lane];
    if constexpr (measured) {
      joints.friction_loss[j] = friction_lost.lane[lane];
      joints.switching_loss[j] = switching_lost.lane[lane];
    }
  }
  return left;
}

/// Returns how many are left.
template <bool measured>
std::size_t listed_joints(World& world, std::span<int> listed) {
  const hn::ScalableTag<double> d;
  constexpr std::size_t lanes = hn::MaxLanes(d);
  if constexpr (lanes == 1) return listed.size();  // the reference path does the same for less
  std::size_t kept = 0, k = 0;
  for (; k + lanes <= listed.size(); k += lanes) {
    std::uint64_t left = a_vector_of_joints<measured>(world, &listed[k], d);
    for (; left != 0; left &= left - 1) listed[kept++] = listed[k + static_cast<std::size_t>(std::countr_zero(left))];
  }
  for (; k < listed.size(); ++k) listed[kept++] = listed[k];
  return kept;
}

std::size_t DamagedJointForces(World& world, std::span<int> listed) {
  return world.ledger.measured ? listed_joints<true>(world, listed) : listed_joints<false>(world, listed);
}

}  // namespace bitrock::dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bitrock::dem2d {

HWY_EXPORT(DamagedJointForces);

std::span<int> damaged_joint_forces(World& world, std::span<int> listed) {
  return listed.first(HWY_DYNAMIC_DISPATCH(DamagedJointForces)(world, listed));
}

}  // namespace bitrock::dem2d
#endif
