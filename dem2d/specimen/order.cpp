#include "dem2d/specimen/order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace bitrock::dem2d {

namespace {

template <class Key>
std::vector<std::size_t> order_by(std::size_t count, const Key& key) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// Arrays that are not in use are empty and stay so.
template <class T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& order, std::size_t entries_each = 1) {
  if (values.empty()) return;
  const std::vector<T> old = values;
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(&old[order[i] * entries_each], entries_each, &values[i * entries_each]);
  }
}

}  // namespace

double column_width(const Discs& discs) {
  return 2.0 * *std::max_element(discs.radius.begin(), discs.radius.end());
}

void order_in_columns(World& world) {
  Discs& discs = world.discs;
  if (discs.x.empty()) return;
  const double width = column_width(discs);
  const std::vector<std::size_t> disc_order = order_by(
      discs.x.size(), [&](std::size_t i) { return std::tuple(std::floor(discs.x[i] / width), discs.y[i], i); });
  permute(discs.id, disc_order);
  for (std::vector<double>* values : number_arrays(discs)) permute(*values, disc_order);

  FlatJoints& joints = world.joints;
  std::vector<int> place(discs.x.size());
  for (std::size_t i = 0; i < disc_order.size(); ++i) place[disc_order[i]] = static_cast<int>(i);
  for (std::size_t j = 0; j < joints.disc1.size(); ++j) {
    joints.disc1[j] = place[static_cast<std::size_t>(joints.disc1[j])];
    joints.disc2[j] = place[static_cast<std::size_t>(joints.disc2[j])];
    if (joints.disc1[j] < joints.disc2[j]) continue;
    std::swap(joints.disc1[j], joints.disc2[j]);
    joints.radius_difference[j] = -joints.radius_difference[j];
    joints.stress_free_rotation[j] = -joints.stress_free_rotation[j];
  }
  const std::vector<std::size_t> joint_order =
      order_by(joints.disc1.size(), [&](std::size_t j) { return std::pair(joints.disc1[j], joints.disc2[j]); });
  for (std::vector<int>* values : integer_arrays(joints)) permute(*values, joint_order);
  for (std::vector<double>* values : number_arrays(joints)) permute(*values, joint_order);
  const auto elements = static_cast<std::size_t>(joints.elements);
  permute(joints.element_shear_stress, joint_order, elements);
  permute(joints.element_opening, joint_order, elements);
  permute(joints.state, joint_order, elements);
  world.lists.valid = false;
}

}  // namespace bitrock::dem2d
