#include "runtime/well/joint_histories.hpp"

#include <array>

#include "runtime/drillstring/series_file.hpp"
#include "runtime/well/step.hpp"

namespace bitrock::runtime {

namespace {

struct JointNumber {
  const char* path;
  double JointHistory::*value;
  const char *units, *meaning;
};
constexpr std::array<JointNumber, 7> joint_numbers{
    {{"/joints/above_bit_m", &JointHistory::above_bit, "m", "along the string, from the bit up"},
     {"/joints/measured_depth_m", &JointHistory::measured_depth, "m", "where the joints were at the end"},
     {"/joints/outer_diameter_m", &JointHistory::outer_diameter, "m", "of the weaker of the two pipes at a joint"},
     {"/joints/inner_diameter_m", &JointHistory::inner_diameter, "m", "of that pipe"},
     {"/joints/bending_stiffness_N_m2", &JointHistory::bending_stiffness, "N m2", "of that pipe"},
     {"/joints/tool_joint_distance_m", &JointHistory::tool_joint_distance, "m", "of that pipe; 0: none that stand out"},
     {"/joints/stand_off_m", &JointHistory::stand_off, "m", "how far its tool joints stand out"}}};

struct JointSeries {
  const char* path;
  std::vector<float> JointHistory::*values;
  const char *units, *meaning;
};
constexpr std::array<JointSeries, 4> joint_series{
    {{"/joints/tension_N", &JointHistory::tension, "N",
      "in the mud, joint after joint, a value a sample after settling"},
     {"/joints/axial_Pa", &JointHistory::axial, "Pa", "stress of the true tension, in the same order"},
     {"/joints/moment_2_N_m", &JointHistory::moment_2, "N m", "bending in the frame that turns with the pipe"},
     {"/joints/moment_3_N_m", &JointHistory::moment_3, "N m", "about the axis across the other"}}};

}  // namespace

std::vector<JointHistory> joints_of(const WellCase& well, const WellStringState& state) {
  constexpr double near = 1e-6;  // [m] to this and to that side
  std::vector<JointHistory> joints;
  double above_bit = 0.0;
  for (std::size_t i = 0; i + 1 < state.count; ++i) {
    above_bit += 2.0 * state.columns.at(half_length, i);
    const WellPipe &below = pipe_at(well, above_bit - near), &above = pipe_at(well, above_bit + near);
    const WellPipe& weaker = stress_of_moment(above.pipe) > stress_of_moment(below.pipe) ? above : below;
    JointHistory joint{.above_bit = above_bit,
                       .outer_diameter = weaker.pipe.outer_diameter,
                       .inner_diameter = weaker.pipe.inner_diameter,
                       .bending_stiffness = beam_of(weaker.pipe).bending,
                       .tool_joint_distance = weaker.tool_joint_distance};
    if (joint.tool_joint_distance > 0.0) joint.stand_off = 0.5 * (weaker.contact_diameter - joint.outer_diameter);
    joints.push_back(joint);
  }
  return joints;
}

void record_joints(const WellString& string, const WellStringState& state, double fluid_density,
                   std::vector<JointHistory>& joints) {
  const Columns& columns = state.columns;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    JointHistory& joint = joints[i];
    const JointLoad<double> load = joint_now(columns, i);
    const Vector3 middle = 0.5 * (lower_end_of(columns, i + 1) + upper_end_of(columns, i));
    const double tension = load.section_force.x;
    const PipeSection ring{.outer_diameter = joint.outer_diameter, .inner_diameter = joint.inner_diameter};
    joint.tension.push_back(static_cast<float>(tension));
    joint.axial.push_back(static_cast<float>(axial_stress(tension, area(ring), fluid_density, middle.z)));
    joint.moment_2.push_back(static_cast<float>(load.section_moment.y));
    joint.moment_3.push_back(static_cast<float>(load.section_moment.z));
    joint.measured_depth =
        foot_on(string.hole[static_cast<std::size_t>(columns.at(piece, i))].arc, middle).measured_depth;
  }
}

void write_joints(const std::vector<JointHistory>& joints, base::Hdf5Writer& file) {
  if (joints.empty()) return;
  for (const JointNumber& number : joint_numbers) {
    std::vector<double> list;
    list.reserve(joints.size());
    for (const JointHistory& joint : joints) list.push_back(joint.*number.value);
    file.array(number.path, list, number.units, number.meaning);
  }
  for (const JointSeries& series : joint_series) {
    std::vector<float> list;
    for (const JointHistory& joint : joints)
      list.insert(list.end(), (joint.*series.values).begin(), (joint.*series.values).end());
    file.array(series.path, list, series.units, series.meaning);
  }
}

std::vector<JointHistory> read_joints(const base::Hdf5Reader& file, std::size_t rows) {
  std::vector<JointHistory> joints;
  if (!file.has(joint_numbers[0].path)) return joints;
  joints.resize(file.doubles(joint_numbers[0].path).size());
  for (const JointNumber& number : joint_numbers) {
    const std::vector<double> list = finite_array(file, number.path, joints.size());
    for (std::size_t i = 0; i < list.size(); ++i) joints[i].*number.value = list[i];
  }
  for (const JointSeries& series : joint_series) {
    const std::vector<double> list = finite_array(file, series.path, joints.size() * rows);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      std::vector<float>& values = joints[i].*series.values;
      values.reserve(rows);
      for (std::size_t k = 0; k < rows; ++k) values.push_back(static_cast<float>(list[i * rows + k]));
    }
  }
  return joints;
}

}  // namespace bitrock::runtime
