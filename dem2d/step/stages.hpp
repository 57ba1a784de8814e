#pragma once
/// The stages of one step (step.hpp), for the files of this folder, benches and tests.

#include "dem2d/step/share.hpp"
#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

// The stages of `find_forces`, in their order. A thread of a team calls each with its share of the work.
void refresh_neighbours(World& world);                       ///< neighbours.cpp; not for teams
void refresh_mud(World& world);                              ///< mud_forces.cpp; not for teams
void copy_motion(World& world, const Share& share = {});     ///< copy_motion.cpp; before joint_forces of any thread
void joint_forces(World& world, const Share& share = {});    ///< joint_forces.cpp
void contact_forces(World& world, const Share& share = {});  ///< contact_forces.cpp
void boundary_forces(World& world);                          ///< contact_forces.cpp; one thread of a team
void mud_forces(World& world);                               ///< mud_forces.cpp; one thread of a team
void sum_forces(World& world, const Share& share = {});      ///< sum_forces.cpp, after all of the others

/// The stage of `move`, before boundaries move and cracks are collected.
void integrate(World& world, const Share& share = {});  ///< integrate.cpp
void book_mud_work(World& world);                       ///< mud_forces.cpp; after integrate, not for teams

}  // namespace bitrock::dem2d
