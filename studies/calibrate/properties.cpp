#include "studies/calibrate/properties.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/units.hpp"

namespace bitrock::studies {

namespace {

constexpr PerProperty<PropertyWords> property_words{{
    {"ucs_MPa", "ucs_Pa", "UCS", "MPa", base::MPa, true},
    {"tensile_strength_MPa", "tensile_strength_Pa", "tensile strength", "MPa", base::MPa, true},
    {"youngs_modulus_GPa", "youngs_modulus_Pa", "E", "GPa", base::GPa, true},
    {"poissons_ratio", "poissons_ratio", "nu", "", 1.0, false},
    {"confined_strengths_MPa", "confined_strength_Pa", "confined strength", "MPa", base::MPa, true},
}};

constexpr std::array<MicroWords, micro_count> micro_words{{
    {"effective_modulus_GPa", "effective modulus", "GPa", base::GPa},
    {"stiffness_ratio", "stiffness ratio", "", 1.0},
    {"tensile_strength_MPa", "tensile strength", "MPa", base::MPa},
    {"cohesion_MPa", "cohesion", "MPa", base::MPa},
    {"friction_coefficient", "friction coefficient", "", 1.0},
    {"friction_angle_deg", "friction angle", "deg", base::deg},
}};

/// The value in its file unit, made a number of four digits by `whole`; in SI again.
double four_digits(MicroParameter parameter, double value, double (*whole)(double)) {
  if (value == 0.0) return value;
  const double unit = words_of(parameter).si_per_unit;
  const double decade = std::pow(10.0, 3.0 - std::floor(std::log10(std::abs(value / unit))));
  return whole(value / unit * decade) / decade * unit;
}

double down(double value) {
  return std::floor(value);
}

double nearest(double value) {
  return std::round(value);
}

/// `companion` in the proportion in which its parameter changed; untouched when it did not. Nothing has a proportion to
/// zero friction.
double carried(MicroParameter parameter, double companion, double before, double after) {
  return after == before || before == 0.0 ? companion : rounded(parameter, companion * (after / before));
}

/// A standard deviation that a rock file may have beside this strength: at most half of it.
double bounded_deviation(MicroParameter strength, double deviation, double value) {
  return deviation > 0.5 * value ? four_digits(strength, 0.5 * value, down) : deviation;
}

/// What a rock file allows of one number of `rock`, in SI.
MicroLimits range_of(dem2d::Rock& rock, const double& number) {
  MicroLimits limits{number, number};
  for (const base::Section& section : dem2d::describe(rock)) {
    for (const base::Field& field : section.fields) {
      const auto* target = std::get_if<double*>(&field.target);
      if (target == nullptr || *target != &number) continue;
      limits = {field.range.low * field.si_per_unit, field.range.high * field.si_per_unit};
    }
  }
  return limits;
}

/// Moves a number of the rock into the range that the rock file allows it.
void keep_in_range(dem2d::Rock& rock, double& number) {
  const MicroLimits limits = range_of(rock, number);
  number = std::clamp(number, limits.low, limits.high);
}

}  // namespace

const PropertyWords& words_of(Property property) {
  return property_words[index_of(property)];
}

const MicroWords& words_of(MicroParameter parameter) {
  return micro_words[index_of(parameter)];
}

Micro micro_of(const dem2d::Rock& rock) {
  return {rock.joint_modulus, rock.joint_stiffness_ratio, rock.tensile_strength, rock.cohesion,
          rock.friction,      rock.friction_angle};
}

dem2d::Rock with_micro(const dem2d::Rock& rock, const Micro& micro) {
  using enum MicroParameter;
  const Micro before = micro_of(rock);
  const auto go_along = [&](MicroParameter parameter, double& companion) {
    const std::size_t i = index_of(parameter);
    companion = carried(parameter, companion, before[i], micro[i]);
  };
  dem2d::Rock changed = rock;
  changed.joint_modulus = micro[index_of(effective_modulus)];
  go_along(effective_modulus, changed.contact_modulus);
  changed.joint_stiffness_ratio = micro[index_of(stiffness_ratio)];
  go_along(stiffness_ratio, changed.contact_stiffness_ratio);
  changed.tensile_strength = micro[index_of(tensile_strength)];
  go_along(tensile_strength, changed.tensile_strength_deviation);
  changed.cohesion = micro[index_of(cohesion)];
  go_along(cohesion, changed.cohesion_deviation);
  go_along(cohesion, changed.residual_cohesion);
  changed.friction = micro[index_of(friction)];
  go_along(friction, changed.contact_friction);
  changed.friction_angle = micro[index_of(friction_angle)];

  changed.tensile_strength_deviation =
      bounded_deviation(tensile_strength, changed.tensile_strength_deviation, changed.tensile_strength);
  changed.cohesion_deviation = bounded_deviation(cohesion, changed.cohesion_deviation, changed.cohesion);
  keep_in_range(changed, changed.contact_modulus);
  keep_in_range(changed, changed.contact_stiffness_ratio);
  keep_in_range(changed, changed.contact_friction);
  keep_in_range(changed, changed.residual_cohesion);
  return changed;
}

MicroLimits limits_of(MicroParameter parameter) {
  dem2d::Rock rock;
  const double* const numbers[micro_count]{&rock.joint_modulus,    &rock.joint_stiffness_ratio,
                                           &rock.tensile_strength, &rock.cohesion,
                                           &rock.friction,         &rock.friction_angle};
  return range_of(rock, *numbers[index_of(parameter)]);
}

double rounded(MicroParameter parameter, double value) {
  return four_digits(parameter, value, nearest);
}

double error_of(Property property, double value, double wanted) {
  return words_of(property).relative_error ? value / wanted - 1.0 : value - wanted;
}

}  // namespace bitrock::studies
