#pragma once
/// Damaged flat joints several at a time: the law of contact/flat_joint.hpp and, where energy is measured, the losses
/// of contact/flat_joint_energy.hpp, element by element but one joint a lane. Every lane does what the plain code does,
/// operation by operation and without fused multiply-add, so the bits are those of the reference path.

#include <span>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

/// Takes one step of those of the `listed` joints (ascending) that are damaged already and of which no element breaks
/// in this step: forces, shear stresses, slip and, while energy is measured, losses. Returns the beginning of `listed`,
/// where the others stand now, in their order: they are for the reference path, and nothing is changed for them.
std::span<int> damaged_joint_forces(World& world, std::span<int> listed);

}  // namespace bitrock::dem2d
