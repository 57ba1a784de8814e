#pragma once
/// The four laboratory numbers that a synthetic rock is calibrated to, and the five micro-parameters that answer for
/// them. Both are short arrays, so that the search can loop over them; the names below say which entry is which.
///
/// | number | from | answered mainly by |
/// |---|---|---|
/// | uniaxial compressive strength | compression test | cohesion over tensile strength of the joints |
/// | direct tensile strength | tension test | tensile strength of the joints |
/// | Young's modulus | tension test | effective modulus E* |
/// | Poisson's ratio | tension test | stiffness ratio kappa |

#include <array>
#include <string>

#include "base/statistics.hpp"
#include "dem2d/specimen/rock.hpp"

namespace bitrock::studies {

enum class Property { ucs, tensile_strength, youngs_modulus, poissons_ratio };
inline constexpr int property_count = 4;

template <class Value>
using PerProperty = std::array<Value, property_count>;

/// How one of the four is written: key of the target file and of JSON, name and unit for people.
struct PropertyWords {
  const char* key;      ///< in target files, ends in its unit
  const char* si_key;   ///< in JSON, ends in the SI unit
  const char* name;     ///< "UCS"
  const char* unit;     ///< "MPa"; empty for a plain number
  double si_per_unit;   ///< SI value = written value * si_per_unit
  bool relative_error;  ///< true: judged in percent; false: by the plain difference
};
const PropertyWords& words_of(Property property);

enum class MicroParameter { effective_modulus, stiffness_ratio, tensile_strength, cohesion, friction };
inline constexpr int micro_count = 5;

/// SI values: E* [Pa], kappa [1], tensile strength [Pa], cohesion [Pa], friction coefficient of broken elements [1].
using Micro = std::array<double, micro_count>;

/// Key of the rock file without its section, and the factor of its unit.
struct MicroWords {
  const char* key;
  const char* name;
  const char* unit;
  double si_per_unit;
};
const MicroWords& words_of(MicroParameter parameter);

Micro micro_of(const dem2d::Rock& rock);

/// The rock with these micro-parameters. What belongs to a changed one goes with it in proportion: the modulus, ratio
/// and friction of the linear contacts, the scatter of the strengths, the residual cohesion; but never out of the
/// ranges of a rock file. What is not changed stays as it is, bit for bit.
dem2d::Rock with_micro(const dem2d::Rock& rock, const Micro& micro);

/// What a rock file allows of the parameter, in SI.
struct MicroLimits {
  double low, high;
};
MicroLimits limits_of(MicroParameter parameter);

/// The parameter rounded to four digits of its file unit, so that a rock file holds exactly what was tested.
double rounded(MicroParameter parameter, double value);

/// Above it an elastic body would grow when it is pressed: no target, and no measurement that a search may follow.
inline constexpr double largest_poissons_ratio = 0.5;

/// Measured value against the wanted one, in tolerances' own measure: a share of the wanted value, or the difference.
double error_of(Property property, double value, double wanted);

/// Mean and scatter over the seeds of each number; `count` is 0 for a number that was not measured.
struct Evaluation {
  Micro micro{};
  PerProperty<base::Summary> measured;  ///< [Pa], [Pa], [Pa], [1]
  std::string failure;                  ///< why nothing was measured; empty when it was
};

inline std::size_t index_of(Property property) {
  return static_cast<std::size_t>(property);
}
inline std::size_t index_of(MicroParameter parameter) {
  return static_cast<std::size_t>(parameter);
}

inline constexpr std::array all_properties{Property::ucs, Property::tensile_strength, Property::youngs_modulus,
                                           Property::poissons_ratio};
inline constexpr std::array all_micro_parameters{MicroParameter::effective_modulus, MicroParameter::stiffness_ratio,
                                                 MicroParameter::tensile_strength, MicroParameter::cohesion,
                                                 MicroParameter::friction};

}  // namespace bitrock::studies
