#include "studies/well/fatigue_of_joints.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "studies/well/bending_magnification.hpp"

namespace bitrock::studies {

namespace {

constexpr int fibres = 16;

JointDamage damage_of_joint(const runtime::JointHistory& joint, std::size_t begin, const CountedTime& time,
                            const FatigueWish& wish) {
  const runtime::PipeSection ring{.outer_diameter = joint.outer_diameter, .inner_diameter = joint.inner_diameter};
  const double of_moment = stress_of_moment(ring);
  const BetweenToolJoints pipe{joint.bending_stiffness, 0.5 * joint.tool_joint_distance, joint.stand_off};
  std::vector<double> magnification(time.count, 1.0), stress(time.count);
  JointDamage worst;
  for (std::size_t k = 0; k < time.count; ++k) {
    const std::size_t row = begin + k;
    const double moment = std::hypot(joint.moment_2[row], joint.moment_3[row]);
    magnification[k] = bending_magnification(pipe, joint.tension[row], moment / joint.bending_stiffness);
    worst.magnification += (magnification[k] - worst.magnification) / static_cast<double>(k + 1);
  }
  for (int fibre = 0; fibre < fibres; ++fibre) {
    const double angle = 2.0 * std::numbers::pi * fibre / fibres, sine = std::sin(angle), cosine = std::cos(angle);
    for (std::size_t k = 0; k < time.count; ++k) {
      const std::size_t row = begin + k;
      const double moment = joint.moment_2[row] * sine - joint.moment_3[row] * cosine;
      stress[k] = joint.axial[row] + magnification[k] * of_moment * moment;
    }
    const PointDamage damage = damage_of_history("joint", joint.measured_depth, stress, time.hours, wish);
    if (fibre > 0 && damage.damage_per_hour <= worst.damage_per_hour) continue;
    static_cast<PointDamage&>(worst) = damage;
    worst.angle = angle;
  }
  worst.above_bit = joint.above_bit;
  return worst;
}

}  // namespace

std::vector<JointDamage> damage_of_joints(const runtime::StressHistories& run, const FatigueWish& wish,
                                          const std::string& file) {
  if (run.joints.empty())
    throw base::InputError(file + ": the run has not kept its joints (give the case well.every_joint = true)");
  // joints are kept after settling alone
  const std::size_t settled = run.time.size() - run.joints.front().tension.size();
  FatigueWish later = wish;
  if (wish.from < 0.0 && settled < run.time.size()) later.from = run.time[settled];
  const CountedTime time = counted_time(run, later, file);
  if (time.begin < settled)
    throw base::InputError(
        fmt::format("{}: joints are kept after {:g} s only (--from-s must not be before it)", file, run.settling));
  std::vector<JointDamage> damages;
  damages.reserve(run.joints.size());
  for (const runtime::JointHistory& joint : run.joints)
    damages.push_back(damage_of_joint(joint, time.begin - settled, time, wish));
  return damages;
}

std::string damage_csv(const std::vector<JointDamage>& joints) {
  std::vector<std::vector<double>> columns(8);
  for (const JointDamage& joint : joints) {
    const double row[] = {
        joint.measured_depth, joint.above_bit, joint.damage_per_hour, joint.cycles_per_hour,
        joint.largest_range,  joint.mean,      joint.magnification,   joint.angle * 180.0 / std::numbers::pi};
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].push_back(row[c]);
  }
  return base::csv_text({"measured_depth_m", "above_bit_m", "damage_per_hour", "cycles_per_hour", "largest_range_Pa",
                         "mean_Pa", "bending_magnification", "angle_deg"},
                        columns);
}

}  // namespace bitrock::studies
