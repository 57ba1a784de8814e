// See whole_joints.hpp. This file is compiled once for each vector unit (Highway's foreach_target).
#include "dem2d/step/vector_targets.hpp"  // before anything of Highway

#include "dem2d/step/whole_joints.hpp"

#include <algorithm>

// clang-format off: the order matters
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dem2d/step/whole_joints.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Values at some indices. The machine's gather keeps lanes that its mask leaves out, so it waits for what was in its
/// result register before: for the joints before these, unless zeros stand there. Compilers drop the zeros when they
/// see that the mask leaves nothing out, so `asm` hides that from them.
template <class D, class I>
HWY_INLINE hn::Vec<D> gather(D d, const std::vector<double>& values, I index) {
#if HWY_TARGET <= HWY_AVX3
  if constexpr (hn::MaxLanes(D()) == 8) {
    __mmask8 all = 0xFF;
    asm("" : "+Yk"(all));
    return {_mm512_mask_i32gather_pd(_mm512_setzero_pd(), all, index.raw, values.data(), 8)};
  }
#endif
  return hn::GatherIndex(d, values.data(), hn::PromoteTo(hn::RebindToSigned<D>(), index));
}

/// As many joints as D has lanes, from `first` on. `outermost_centre` is that of the outermost element over R. Returns
/// the lanes that are left to the reference path.
template <class D>
HWY_INLINE std::uint64_t a_vector_of_joints(World& world, std::size_t first, double outermost_centre, D d) {
  FlatJoints& joints = world.joints;
  const Discs& discs = world.discs;
  const hn::RebindToSigned<D> indices;
  const hn::Rebind<int, D> numbers;
  const auto load = [&](const std::vector<double>& values) HWY_ATTR { return hn::LoadU(d, &values[first]); };
  const auto disc1 = hn::LoadU(numbers, &joints.disc1[first]), disc2 = hn::LoadU(numbers, &joints.disc2[first]);
  // Joints are sorted by disc 1, so a few neighbouring discs serve all lanes: one load and a shuffle beat a gather.
  const auto base = static_cast<std::size_t>(joints.disc1[first]);
  const auto offset = disc1 - hn::Set(numbers, joints.disc1[first]);
  const hn::RebindToUnsigned<decltype(numbers)> naturals;  // a negative offset is a large one there
  const auto lanes = hn::Set(naturals, static_cast<std::uint32_t>(hn::Lanes(d)));
  const bool near =
      base + hn::Lanes(d) <= discs.x.size() && hn::AllTrue(naturals, hn::Lt(hn::BitCast(naturals, offset), lanes));
  const auto lane_of_disc1 = hn::IndicesFromVec(d, near ? hn::PromoteTo(indices, offset) : hn::Zero(indices));
  const auto of_disc1 = [&](const std::vector<double>& v) HWY_ATTR {
    return near ? hn::TableLookupLanes(hn::LoadU(d, &v[base]), lane_of_disc1) : gather(d, v, disc1);
  };
  const auto of_disc2 = [&](const std::vector<double>& v) HWY_ATTR { return gather(d, v, disc2); };

  // pair_motion.hpp
  const auto dx = of_disc2(discs.x) - of_disc1(discs.x), dy = of_disc2(discs.y) - of_disc1(discs.y);
  const auto distance = hn::Sqrt(dx * dx + dy * dy);
  const auto inverse = hn::Set(d, 1.0) / distance;
  const auto normal_x = dx * inverse, normal_y = dy * inverse;
  const auto half = hn::Set(d, 0.5), radius_difference = load(joints.radius_difference);
  const auto lever1 = half * (distance + radius_difference), lever2 = half * (distance - radius_difference);
  const auto du = of_disc2(discs.velocity_x) - of_disc1(discs.velocity_x);
  const auto dv = of_disc2(discs.velocity_y) - of_disc1(discs.velocity_y);
  const auto shear_speed =
      dv * normal_x - du * normal_y - of_disc2(discs.spin) * lever2 - of_disc1(discs.spin) * lever1;

  // flat_joint.hpp, "a wholly bonded joint"
  const auto gap = distance - load(joints.touching_distance);
  const auto rotation = of_disc2(discs.angle) - of_disc1(discs.angle) - load(joints.stress_free_rotation);
  const auto R = load(joints.half_length), kn = load(joints.normal_stiffness);
  const auto to_outermost_centre = hn::Set(d, outermost_centre) * R;
  const auto largest = kn * (gap + hn::Abs(rotation) * to_outermost_centre);
  const auto shear_stress =
      load(joints.shear_stress) + load(joints.shear_stiffness) * (shear_speed * hn::Set(d, world.step));
  const auto margin = hn::Set(d, whole_joint_margin);
  const auto below_tension = hn::Lt(largest, margin * load(joints.tensile_strength));
  const auto below_shear =
      hn::Lt(hn::Abs(shear_stress), margin * (load(joints.cohesion) - largest * load(joints.tan_friction_angle)));
  const auto whole =
      hn::Eq(hn::PromoteTo(indices, hn::LoadU(numbers, &joints.bonded[first])), hn::Set(indices, joints.elements));
  const auto done = hn::And(hn::And(below_tension, below_shear), hn::RebindMask(d, whole));
  hn::BlendedStore(shear_stress, done, d, &joints.shear_stress[first]);

  const auto length = R + R;
  const auto pull = length * kn * gap, shear = length * shear_stress;
  const auto moment = hn::Set(d, -2.0 / 3.0) * R * R * R * kn * rotation;
  const auto x = pull * normal_x - shear * normal_y, y = pull * normal_y + shear * normal_x;
  hn::StoreInterleaved4(x, y, lever1 * shear - moment, lever2 * shear + moment, d, &world.joint_forces[first].x);
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, hn::Not(done), bits);
  return bits[0];
}

std::size_t WholeJointForces(World& world, std::size_t joint, std::size_t end, std::uint64_t& left) {
  const hn::ScalableTag<double> all_lanes;
  const hn::CappedTag<double, 1> one_lane;
  const std::size_t lanes = hn::Lanes(all_lanes), first = joint, stop = std::min(end, first + 64);
  const double outermost = 1.0 - 1.0 / world.joints.elements;
  left = 0;
  for (; joint + lanes <= stop; joint += lanes)
    left |= a_vector_of_joints(world, joint, outermost, all_lanes) << (joint - first);
  for (; joint < stop; ++joint) left |= a_vector_of_joints(world, joint, outermost, one_lane) << (joint - first);
  return stop;
}

}  // namespace dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dem2d {

HWY_EXPORT(WholeJointForces);

std::size_t whole_joint_forces(World& world, std::size_t joint, std::size_t end, std::uint64_t& left) {
  return HWY_DYNAMIC_DISPATCH(WholeJointForces)(world, joint, end, left);
}

}  // namespace dem2d
#endif
