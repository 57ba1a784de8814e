#include "runtime/drillstring/top_drive_keys.hpp"

#include <algorithm>
#include <array>

namespace bitrock::runtime {

namespace {

bool gives_way(const DrillCase& drill) {
  return drill.control.answer != DriveAnswer::stiff;
}
bool is_matched(const DrillCase& drill) {
  return drill.control.answer == DriveAnswer::matched;
}
bool has_block(const DrillCase& drill) {
  return is_fed(drill.hoist);
}
bool has_feed(const DrillCase& drill) {
  return drill.hoist.rule == HoistRule::feed;
}
bool has_autodriller(const DrillCase& drill) {
  return drill.hoist.rule == HoistRule::autodriller;
}
bool has_load(const DrillCase& drill) {
  return !is_fed(drill.hoist);
}

/// A key, and the cases in which it says something. `needs`: what is missing in others; empty where giving it is no
/// fault, or one that is told otherwise.
struct TopDriveKey {
  const char* name;
  bool (*says_something)(const DrillCase& drill);
  const char* needs;
};
constexpr const char* control_needed = "needs control = 'soft_torque' or 'matched'";
constexpr const char* block_needed = "needs hoist = 'feed' or 'autodriller'";
constexpr std::array<TopDriveKey, 12> keys{{{"control", gives_way, ""},
                                            {"control_damping_N_m_s_per_rad", gives_way, control_needed},
                                            {"control_period_s", gives_way, control_needed},
                                            {"reaction_time_ms", is_matched, "needs control = 'matched'"},
                                            {"hoist", has_block, ""},
                                            {"hook_load_kN", has_load, ""},
                                            {"line_stiffness_N_per_m", has_block, block_needed},
                                            {"line_damping_N_s_per_m", has_block, block_needed},
                                            {"feed_m_per_h", has_feed, "needs hoist = 'feed'"},
                                            {"weight_on_bit_kN", has_block, block_needed},
                                            {"slack_off_m_per_s", has_autodriller, "needs hoist = 'autodriller'"},
                                            {"autodriller_time_s", has_autodriller, "needs hoist = 'autodriller'"}}};

void check_control(const base::ConfigFile& file, const DrillCase& drill) {
  if (gives_way(drill) && !drill.drive.imposes_speed)
    file.refuse("top_drive", "control", "must be 'stiff' for a drive that imposes torque");
  if (is_matched(drill) && drill.drive_inertia > 0.0)
    file.refuse("top_drive", "inertia_kg_m2", "has no meaning with control = 'matched', which gives reaction_time_ms");
  if (gives_way(drill) && drill.pipes.empty() && drill.control.damping == 0.0)
    file.refuse("top_drive", "control",
                "needs control_damping_N_m_s_per_rad where [torsion] and not [[pipe]] gives the string");
}

void check_hoist(const base::ConfigFile& file, const DrillCase& drill, bool axial) {
  if (has_load(drill)) return;
  if (!axial) file.refuse("top_drive", "hoist", "must be 'load' for a string without axial chain");
  if (file.has("top_drive", "hook_load_kN"))
    file.refuse("top_drive", "hook_load_kN", "is a result with hoist = 'feed' or 'autodriller'; take it out");
  if (drill.hoist.stiffness == 0.0)
    file.refuse("top_drive", "hoist", "needs the spring that holds the string (line_stiffness_N_per_m above 0)");
  if (has_autodriller(drill) && drill.hoist.weight_on_bit == 0.0)
    file.refuse("top_drive", "hoist", "needs the weight that the autodriller holds (weight_on_bit_kN)");
}

}  // namespace

void check_top_drive(const base::ConfigFile& file, const DrillCase& drill, bool axial) {
  for (const auto& [name, says_something, needs] : keys) {
    if (*needs != '\0' && !says_something(drill) && file.has("top_drive", name)) file.refuse("top_drive", name, needs);
  }
  check_control(file, drill);
  check_hoist(file, drill, axial);
}

void leave_out_unused_of_top_drive(std::vector<base::Section>& sections, const DrillCase& drill) {
  const auto says_nothing = [&drill](const base::Field& field) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const TopDriveKey& key) { return field.name == key.name && !key.says_something(drill); });
  };
  for (base::Section& section : sections) {
    if (section.name == "top_drive") std::erase_if(section.fields, says_nothing);
  }
}

}  // namespace bitrock::runtime
