#include "dem2d/cut/frame.hpp"

#include <algorithm>
#include <cmath>

#include "dem2d/cut/window.hpp"
#include "dem2d/specimen/pieces.hpp"

namespace bitrock::dem2d {

namespace {

void add_disc(Frame& frame, const Discs& discs, std::size_t i, int fragment) {
  frame.x.push_back(discs.x[i]);
  frame.y.push_back(discs.y[i]);
  frame.radius.push_back(discs.radius[i]);
  frame.id.push_back(discs.id[i]);
  frame.fragment.push_back(fragment);
}

void add_joints(Frame& frame, const World& world, std::size_t from_disc) {
  const FlatJoints& joints = world.joints;
  for (std::size_t k = 0; k < joints.disc1.size(); ++k) {
    const auto i = static_cast<std::size_t>(joints.disc1[k]), j = static_cast<std::size_t>(joints.disc2[k]);
    if (joints.bonded[k] == 0 || std::min(i, j) < from_disc) continue;
    frame.joint_disc1.push_back(world.discs.id[i]);
    frame.joint_disc2.push_back(world.discs.id[j]);
  }
}

}  // namespace

Frame take_frame(const World& world, const Window* window, double tip_x) {
  Frame frame{.time = world.time,
              .tip_x = tip_x,
              .x = world.discs.x,
              .y = world.discs.y,
              .radius = world.discs.radius,
              .id = world.discs.id,
              .fragment = label_pieces(world)};
  if (window == nullptr) return frame;
  for (std::size_t i = window->entered_discs; i < window->bed.discs.x.size(); ++i)
    add_disc(frame, window->bed.discs, i, 0);
  int fragment = *std::max_element(frame.fragment.begin(), frame.fragment.end());
  const Discs& left = window->left_behind;
  for (std::size_t i = 0; i < left.x.size(); ++i) {
    // What stayed in its place is the bed; of the rest nobody knows any more what hung together.
    add_disc(frame, left, i, is_in_its_place(*window, left, i) ? 0 : ++fragment);
  }
  return frame;
}

void add_motion_and_joints(Frame& frame, const World& world, const Window* window) {
  frame.velocity_x = world.discs.velocity_x;
  frame.velocity_y = world.discs.velocity_y;
  frame.velocity_x.resize(frame.x.size(), 0.0);
  frame.velocity_y.resize(frame.x.size(), 0.0);
  add_joints(frame, world, 0);
  if (window != nullptr) add_joints(frame, window->bed, window->entered_discs);
}

}  // namespace bitrock::dem2d
