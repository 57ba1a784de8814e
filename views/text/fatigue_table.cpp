#include "views/text/fatigue_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/units.hpp"

namespace bitrock::views {

namespace {

constexpr std::size_t most_rows = 10;  // of joints

std::string table_of(const std::vector<studies::PointDamage>& points) {
  if (points.empty()) return "";
  std::size_t widest = 5;
  for (const studies::PointDamage& point : points) widest = std::max(widest, point.name.size());
  std::string table = fmt::format("{:<{}} {:>9} {:>11} {:>12} {:>9} {:>14} {:>14}\n", "point", widest, "MD m",
                                  "range MPa", "mean MPa", "cycles/h", "damage/h", "hours to 1");
  for (const studies::PointDamage& point : points) {
    table += fmt::format("{:<{}} {:>9.1f} {:>11.1f} {:>12.1f} {:>9.0f} {:>14.3e} {:>14.3g}\n", point.name, widest,
                         point.measured_depth, point.largest_range / base::MPa, point.mean / base::MPa,
                         point.cycles_per_hour, point.damage_per_hour, point.hours_to_failure);
  }
  return table;
}

std::string table_of(std::vector<studies::JointDamage> joints) {
  if (joints.empty()) return "";
  std::stable_sort(joints.begin(), joints.end(),
                   [](const auto& a, const auto& b) { return a.damage_per_hour > b.damage_per_hour; });
  const std::size_t all = joints.size();
  joints.resize(std::min(all, most_rows));
  std::string table = fmt::format(
      "{} joints, with the bending that tool joints draw on themselves; those that suffer most:\n"
      "{:>9} {:>10} {:>11} {:>12} {:>9} {:>14} {:>14}\n",
      all, "MD m", "bending x", "range MPa", "mean MPa", "cycles/h", "damage/h", "hours to 1");
  for (const studies::JointDamage& joint : joints) {
    table += fmt::format("{:>9.1f} {:>10.2f} {:>11.1f} {:>12.1f} {:>9.0f} {:>14.3e} {:>14.3g}\n", joint.measured_depth,
                         joint.magnification, joint.largest_range / base::MPa, joint.mean / base::MPa,
                         joint.cycles_per_hour, joint.damage_per_hour, joint.hours_to_failure);
  }
  return table;
}

}  // namespace

std::string fatigue_table(const studies::FatigueWish& wish, const std::vector<studies::PointDamage>& points,
                          const std::vector<studies::JointDamage>& joints) {
  return table_of(points) + table_of(joints) +
         fmt::format("S-N curve: {} ({}); tensile strength {:.0f} MPa\n", wish.curve.name, wish.curve.source,
                     wish.tensile_strength / base::MPa);
}

}  // namespace bitrock::views
