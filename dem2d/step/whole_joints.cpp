// See whole_joints.hpp. This file is compiled once for each vector unit (Highway's foreach_target).
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include "dem2d/step/whole_joints.hpp"

#include <bit>

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/whole_joints.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dem2d/step/lanes-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace bitrock::dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Where the numbers of discs and joints begin. Read from the world each time, the compiler would fetch them after each
/// store anew.
struct Arrays {
  const double *x, *y, *velocity_x, *velocity_y, *angle, *spin;
  const MotionRow* motion;
  std::size_t discs;
  const int *disc1, *disc2, *bonded, *softened;
  const double *radius_difference, *touching_distance, *stress_free_rotation, *half_length;
  const double *normal_stiffness, *shear_stiffness, *tensile_strength, *cohesion, *tan_friction_angle;
  double* shear_stress;
  PairForce* forces;
};

Arrays arrays_of(World& world) {
  const Discs& d = world.discs;
  FlatJoints& j = world.joints;
  return {.x = d.x.data(),
          .y = d.y.data(),
          .velocity_x = d.velocity_x.data(),
          .velocity_y = d.velocity_y.data(),
          .angle = d.angle.data(),
          .spin = d.spin.data(),
          .motion = world.room.motion.data(),
          .discs = d.x.size(),
          .disc1 = j.disc1.data(),
          .disc2 = j.disc2.data(),
          .bonded = j.bonded.data(),
          .softened = j.softened.data(),
          .radius_difference = j.radius_difference.data(),
          .touching_distance = j.touching_distance.data(),
          .stress_free_rotation = j.stress_free_rotation.data(),
          .half_length = j.half_length.data(),
          .normal_stiffness = j.normal_stiffness.data(),
          .shear_stiffness = j.shear_stiffness.data(),
          .tensile_strength = j.tensile_strength.data(),
          .cohesion = j.cohesion.data(),
          .tan_friction_angle = j.tan_friction_angle.data(),
          .shear_stress = j.shear_stress.data(),
          .forces = world.room.joint_forces.data()};
}

/// Of the joints from `first` on. They are sorted by disc 1, so a few neighbouring discs serve all lanes: one load and
/// a shuffle for each quantity beat rows.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Motion<V> motion_of_disc1(const Arrays& a, std::size_t first, D d) {
  const int* const disc1 = a.disc1 + first;
  const hn::Rebind<int, D> numbers;
  const hn::RebindToUnsigned<decltype(numbers)> naturals;  // a negative offset is a large one there
  const auto base = static_cast<std::size_t>(disc1[0]);
  const auto offset = hn::LoadU(numbers, disc1) - hn::Set(numbers, disc1[0]);
  const auto lanes = hn::Set(naturals, static_cast<std::uint32_t>(hn::Lanes(d)));
  const bool near =
      base + hn::Lanes(d) <= a.discs && hn::AllTrue(naturals, hn::Lt(hn::BitCast(naturals, offset), lanes));
  if (!near) return motion_of(d, a.motion, disc1);
  const auto lane = hn::IndicesFromVec(d, hn::PromoteTo(hn::RebindToSigned<D>(), offset));
  const auto of = [&](const double* v) HWY_ATTR { return hn::TableLookupLanes(hn::LoadU(d, v + base), lane); };
  return {of(a.x), of(a.y), of(a.velocity_x), of(a.velocity_y), of(a.angle), of(a.spin)};
}

/// The same for all joints.
struct Constants {
  int elements;
  double step, outermost_centre;  ///< [s]; of the outermost element over R [1]
};

constexpr int lane_numbers[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/// As many joints as D has lanes, from `first` on. Adds those that are left to the reference path to `left`.
template <bool softens, class D>
HWY_INLINE void a_vector_of_joints(const Arrays& a, const Constants& constants, std::size_t first, int*& left, D d) {
  const hn::RebindToSigned<D> indices;
  const hn::Rebind<int, D> numbers;
  const auto load = [&](const double* values) HWY_ATTR { return hn::LoadU(d, values + first); };
  const auto one = motion_of_disc1(a, first, d), two = motion_of(d, a.motion, a.disc2 + first);
  const auto pair = pair_of(d, one, two, load(a.radius_difference));

  // flat_joint.hpp, "a wholly bonded joint"
  const auto gap = pair.distance - load(a.touching_distance);
  const auto rotation = two.angle - one.angle - load(a.stress_free_rotation);
  const auto R = load(a.half_length), kn = load(a.normal_stiffness);
  const auto to_outermost_centre = hn::Set(d, constants.outermost_centre) * R;
  const auto largest = kn * (gap + hn::Abs(rotation) * to_outermost_centre);
  const auto shear_stress =
      load(a.shear_stress) + load(a.shear_stiffness) * (pair.shear_speed * hn::Set(d, constants.step));
  const auto margin = hn::Set(d, whole_joint_margin);
  const auto below_tension = hn::Lt(largest, margin * load(a.tensile_strength));
  const auto below_shear =
      hn::Lt(hn::Abs(shear_stress), margin * (load(a.cohesion) - largest * load(a.tan_friction_angle)));
  auto sound = hn::LoadU(numbers, a.bonded + first);
  if constexpr (softens) sound = sound - hn::LoadU(numbers, a.softened + first);
  const auto whole = hn::Eq(hn::PromoteTo(indices, sound), hn::Set(indices, constants.elements));
  const auto done = hn::And(hn::And(below_tension, below_shear), hn::RebindMask(d, whole));
  hn::BlendedStore(shear_stress, done, d, a.shear_stress + first);

  const auto length = R + R;
  const auto pull = length * kn * gap, shear = length * shear_stress;
  const auto moment = hn::Set(d, -2.0 / 3.0) * R * R * R * kn * rotation;
  store_pair_forces(d, pair, pull, shear, moment, a.forces + first);

  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, hn::Not(done), bits);
  // Not compressed into memory at once, which is slower on AMD's (docs/results/performance.md).
  const auto joint = hn::LoadU(numbers, lane_numbers) + hn::Set(numbers, static_cast<int>(first));
  hn::StoreU(hn::CompressBits(joint, bits), numbers, left);
  left += std::popcount(bits[0]);
}

template <bool softens>
std::size_t joints_in(World& world, const Range& range, int* left) {
  const hn::ScalableTag<double> all_lanes;
  const hn::CappedTag<double, 1> one_lane;
  const std::size_t lanes = hn::Lanes(all_lanes);
  const Arrays arrays = arrays_of(world);
  const Constants constants{world.joints.elements, world.step, 1.0 - 1.0 / world.joints.elements};
  int* end = left;
  std::size_t joint = range.begin;
  for (; joint + lanes <= range.end; joint += lanes)
    a_vector_of_joints<softens>(arrays, constants, joint, end, all_lanes);
  for (; joint < range.end; ++joint) a_vector_of_joints<softens>(arrays, constants, joint, end, one_lane);
  return static_cast<std::size_t>(end - left);
}

std::size_t WholeJointForces(World& world, const Range& range, int* left) {
  return world.joints.softened.empty() ? joints_in<false>(world, range, left) : joints_in<true>(world, range, left);
}

}  // namespace bitrock::dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace bitrock::dem2d {

HWY_EXPORT(WholeJointForces);

std::span<int> whole_joint_forces(World& world, const Range& range, std::vector<int>& room) {
  // Vector units write whole vectors of numbers, of which only the first count.
  const std::size_t most = range.end - range.begin + HWY_MAX_BYTES / sizeof(int);
  if (room.size() < most) room.resize(most);
  return {room.data(), HWY_DYNAMIC_DISPATCH(WholeJointForces)(world, range, room.data())};
}

}  // namespace bitrock::dem2d
#endif
