#pragma once
/// The fast path of flat joints: wholly bonded ones by their closed form (contact/flat_joint.hpp), several at a time on
/// the widest vector unit the machine has (AVX-512, AVX2, or plain code), chosen when the program runs. Every lane does
/// what the plain code does, operation by operation and without fused multiply-add: the same bits on all of them.

#include <span>
#include <vector>

#include "dem2d/step/share.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Finds the forces of those joints of a range that are whole and stay below their strength, and keeps their shear
/// stress. Returns the others, damaged or perhaps at their strength, ascending; only the place of their force is
/// written. `room` is where they are listed; it grows when it must.
std::span<int> whole_joint_forces(World& world, const Range& range, std::vector<int>& room);

}  // namespace bitrock::dem2d
