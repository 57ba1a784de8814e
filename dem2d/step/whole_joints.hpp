#pragma once
/// The fast path of flat joints: wholly bonded ones by their closed form (contact/flat_joint.hpp), several at a time on
/// the widest vector unit the machine has (AVX-512, AVX2, or plain code), chosen when the program runs. Every lane does
/// what the plain code does, operation by operation and without fused multiply-add: the same bits on all of them.

#include <cstddef>

#include "dem2d/step/world.hpp"

namespace dem2d {

/// Joints `joint` to `joint + 63` at most, of those below `end`: finds the forces of those that are whole and stay
/// below their strength, and keeps their shear stress. `left` has bit k set for joint `joint + k` when it is damaged or
/// may be at its strength: nothing is changed for it, and it is for the reference path. Returns the joint to go on
/// with.
std::size_t whole_joint_forces(World& world, std::size_t joint, std::size_t end, std::uint64_t& left);

}  // namespace dem2d
