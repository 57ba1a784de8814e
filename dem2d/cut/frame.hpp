#pragma once
/// The whole bed at one instant, for pictures: what moves, what still waits ahead, what was left behind.

#include <vector>

#include "dem2d/step/world.hpp"

namespace bitrock::dem2d {

struct Window;  // window.hpp

/// All discs at one instant.
struct Frame {
  double time = 0.0;                 ///< [s]
  double tip_x = 0.0;                ///< of the cutter [m]
  std::vector<double> x, y, radius;  ///< [m]
  std::vector<int> id;               ///< a number a disc keeps
  std::vector<int> fragment;         ///< discs with the same number hang together by bonded joints; 0 is the largest

  // only when frames were asked for, because they double the size
  std::vector<double> velocity_x, velocity_y;  ///< half a step before `time` [m/s]
  std::vector<int> joint_disc1, joint_disc2;   ///< ids of the discs that bonded joints hold together
};

/// `window` may be null: everything is in the world.
Frame take_frame(const World& world, const Window* window, double tip_x);

/// Adds velocities and bonded joints, for frames that were asked for.
void add_motion_and_joints(Frame& frame, const World& world, const Window* window);

}  // namespace bitrock::dem2d
