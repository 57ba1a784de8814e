/// Numbers that lie apart in memory, brought into the lanes of a vector. For files that Highway compiles once for each
/// vector unit (foreach_target): include after hwy/highway.h.
///
/// The machines' gather instructions are not used: loads and shuffles are faster on AMD's, and on Intel's a gather
/// waits for what was in its register before (docs/results/performance.md).

#include "dem2d/step/world.hpp"

#if defined(BITROCK_DEM2D_STEP_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef BITROCK_DEM2D_STEP_LANES_INL
#undef BITROCK_DEM2D_STEP_LANES_INL
#else
#define BITROCK_DEM2D_STEP_LANES_INL
#endif

HWY_BEFORE_NAMESPACE();
namespace bitrock::dem2d::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// How the discs of a vector of joints are placed and move (MotionRow).
template <class V>
struct Motion {
  V x, y, velocity_x, velocity_y, angle, spin;  ///< of one disc a lane [m], [m/s], [rad], [rad/s]
};

template <class D>
HWY_INLINE Motion<hn::Vec<D>> motion_of_one(D d, const MotionRow& row) {
  return {hn::Set(d, row.x),          hn::Set(d, row.y),     hn::Set(d, row.velocity_x),
          hn::Set(d, row.velocity_y), hn::Set(d, row.angle), hn::Set(d, row.spin)};
}

#if HWY_TARGET == HWY_SCALAR  // one lane is all there is

template <class D>
HWY_INLINE hn::Vec<D> pick(D d, const double* values, const int* index) {
  return hn::Load(d, values + index[0]);
}

template <class D>
HWY_INLINE Motion<hn::Vec<D>> motion_of(D d, const MotionRow* rows, const int* index) {
  return motion_of_one(d, rows[index[0]]);
}

#else

/// values[index[0]], values[index[1]], ...
template <class D>
HWY_INLINE hn::Vec<D> pick(D d, const double* values, const int* index) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    return hn::Load(d, values + index[0]);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, pick(half, values, index + hn::MaxLanes(half)), pick(half, values, index));
  }
}

/// The numbers `offset` and `offset + 1` of every second row: of rows index[0], index[2], ...
template <class D>
HWY_INLINE hn::Vec<D> pairs_of_rows(D d, const MotionRow* rows, const int* index, std::size_t offset) {
  if constexpr (hn::MaxLanes(D()) == 2) {
    return hn::Load(d, &rows[index[0]].x + offset);
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, pairs_of_rows(half, rows, index + hn::MaxLanes(half), offset),
                       pairs_of_rows(half, rows, index, offset));
  }
}

/// Of discs index[0], index[1], ...
template <class D>
HWY_INLINE Motion<hn::Vec<D>> motion_of(D d, const MotionRow* rows, const int* index) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    return motion_of_one(d, rows[index[0]]);
  } else {
    const auto pairs = [&](std::size_t row, std::size_t offset)
                           HWY_ATTR { return pairs_of_rows(d, rows, index + row, offset); };
    const auto even0 = pairs(0, 0), odd0 = pairs(1, 0);
    const auto even2 = pairs(0, 2), odd2 = pairs(1, 2);
    const auto even4 = pairs(0, 4), odd4 = pairs(1, 4);
    return {hn::InterleaveLower(d, even0, odd0), hn::InterleaveUpper(d, even0, odd0),
            hn::InterleaveLower(d, even2, odd2), hn::InterleaveUpper(d, even2, odd2),
            hn::InterleaveLower(d, even4, odd4), hn::InterleaveUpper(d, even4, odd4)};
  }
}

#endif

/// pair_motion.hpp, one pair a lane.
template <class V>
struct Pair {
  V distance, normal_x, normal_y, lever1, lever2, normal_speed, shear_speed;  ///< of one pair a lane
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE Pair<V> pair_of(D d, const Motion<V>& one, const Motion<V>& two, V radius_difference) {
  const auto dx = two.x - one.x, dy = two.y - one.y;
  const auto distance = hn::Sqrt(dx * dx + dy * dy);
  const auto inverse = hn::Set(d, 1.0) / distance;
  const auto normal_x = dx * inverse, normal_y = dy * inverse, half = hn::Set(d, 0.5);
  const auto lever1 = half * (distance + radius_difference), lever2 = half * (distance - radius_difference);
  const auto du = two.velocity_x - one.velocity_x, dv = two.velocity_y - one.velocity_y;
  return {distance,
          normal_x,
          normal_y,
          lever1,
          lever2,
          du * normal_x + dv * normal_y,
          dv * normal_x - du * normal_y - two.spin * lever2 - one.spin * lever1};
}

/// `pair_force` of pair_motion.hpp, to consecutive places.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void store_pair_forces(D d, const Pair<V>& pair, V pull, V shear, V moment, PairForce* forces) {
  hn::StoreInterleaved4(pull * pair.normal_x - shear * pair.normal_y, pull * pair.normal_y + shear * pair.normal_x,
                        pair.lever1 * shear - moment, pair.lever2 * shear + moment, d, &forces->x);
}

}  // namespace bitrock::dem2d::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
